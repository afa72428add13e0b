#include "geometry/edge_tree.hpp"

#include <gtest/gtest.h>

#include "geometry/sector.hpp"
#include "geometry/segment_distance.hpp"
#include "tests/workspace/random_linkage.hpp"

namespace kempe {
namespace {

using test::Dice;

Polygon star(Dice& dice, int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i)
    polygon.outer.push_back(as_point(std::polar(dice.between(10, 50), 2 * pi * i / corners)));
  return polygon;
}

TEST(EdgeTree, WindsAroundWhatThePolygonContains) {
  Dice dice(61);
  for (int i = 0; i < 50; ++i) {
    const Polygon polygon = star(dice, 3 + dice.below(60));
    const Point origin(dice.between(-5, 5), dice.between(-5, 5));
    const EdgeTree tree(polygon, origin);
    for (int sample = 0; sample < 200; ++sample) {
      const Point point(dice.between(-60, 60), dice.between(-60, 60));
      EXPECT_EQ(tree.winds_around(point - origin), contains(Region{{polygon}}, point));
    }
  }
}

TEST(EdgeTree, BothLoopsOfARingThatCrossesItselfAreInside) {
  const EdgeTree tree(Polygon{{{0, 0}, {20, 20}, {20, 0}, {0, 20}}, {}}, Point::Zero());  // a bow tie
  EXPECT_TRUE(tree.winds_around({2, 10}));
  EXPECT_TRUE(tree.winds_around({18, 10}));
  EXPECT_FALSE(tree.winds_around({10, 2}));
}

/// How many nodes with more than one edge have one that is nearly straight.
int check_chords(const EdgeTree& tree) {
  int chords = 0;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    open.pop_back();
    const EdgeTree::Node& node = tree.node(index);
    if (node.edges == 1) continue;
    open.insert(open.end(), {EdgeTree::left(index), tree.right(index)});
    const auto& [chord, stray] = tree.chord(index);
    chords += stray < 0.1 * (node.box.upper - node.box.lower).norm();
    const auto to_edges = [&](const Point& point) {
      double least = infinity;
      for (std::uint32_t i = node.first_edge; i < node.first_edge + node.edges; ++i)
        least = std::min(least, distance(point, tree.edge(i).from, tree.edge(i).to));
      return least;
    };
    for (int k = 0; k <= 20; ++k) {
      const double share = k / 20.0;
      const auto along = [&](const EdgeTree::Edge& edge) {
        return Point(edge.from + share * (edge.to - edge.from));
      };
      EXPECT_LE(to_edges(along(chord)), stray);
      for (std::uint32_t i = node.first_edge; i < node.first_edge + node.edges; ++i)
        EXPECT_LE(distance(along(tree.edge(i)), chord.from, chord.to), stray);
    }
  }
  return chords;
}

TEST(EdgeTree, EdgesAndTheirChordAreNowhereFartherApartThanTheNodeSays) {
  Dice dice(64);
  for (int i = 0; i < 20; ++i) {
    Polygon polygon = star(dice, 3 + dice.below(40));
    if (i % 2 == 0) polygon.holes.push_back({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}});
    check_chords({Region{{polygon}}, {dice.between(-5, 5), dice.between(-5, 5)}, EdgeTree::Chords::kept});
  }
  Polygon circle;
  for (int i = 0; i < 360; ++i)
    circle.outer.push_back(as_point(std::polar(8.0, 2 * pi * i / 360)) + Point(1e4, 0));
  EXPECT_GT(check_chords({Region{{circle}}, Point::Zero(), EdgeTree::Chords::kept}), 300)
      << "of 359 nodes with more than one edge";
}

TEST(EdgeTree, VisitsEveryEdgeNearABoxOnce) {
  Dice dice(62);
  const Polygon polygon = star(dice, 500);
  const EdgeTree tree(polygon, Point::Zero());
  for (int i = 0; i < 50; ++i) {
    const Point at(dice.between(-50, 50), dice.between(-50, 50));
    const Box box{at, at + Point(5, 5)};
    std::size_t visited = 0, expected = 0;
    for_each_edge(
        tree, [&](const Box& there) { return distance(there, box) < 3; }, [&](const auto&) { ++visited; });
    for (std::size_t k = 0; k < polygon.outer.size(); ++k) {
      const Point &a = polygon.outer[k], &b = polygon.outer[(k + 1) % 500];
      expected += distance({a.cwiseMin(b), a.cwiseMax(b)}, box) < 3;
    }
    EXPECT_EQ(visited, expected);
  }
}

TEST(Sector, PointOfAnEdgeLiesInBothAndIsFoundWheneverASamplingFindsOne) {
  Dice dice(63);
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const double inner = dice.between(0, 30), from = dice.between(-pi, pi);
    const Sector sector{inner, inner + dice.between(0.1, 20), from, from + dice.between(0.01, 2)};
    const EdgeTree::Edge edge{{dice.between(-50, 50), dice.between(-50, 50)},
                              {dice.between(-50, 50), dice.between(-50, 50)}};
    const auto inside = [&](const Point& p, double slack) {
      double bearing = std::atan2(p.y(), p.x()) - from;
      bearing -= 2 * pi * std::floor(bearing / (2 * pi));
      if (bearing > 2 * pi - slack) bearing = 0;
      return p.norm() >= sector.inner - slack && p.norm() <= sector.outer + slack &&
             bearing <= sector.to - from + slack;
    };
    const auto found = point_in(sector, edge);
    if (found) {
      EXPECT_TRUE(inside(*found, 1e-9));
    }
    bool sampled = false;
    for (int k = 0; k <= 300; ++k)
      sampled = sampled || inside(edge.from + (edge.to - edge.from) * (k / 300.0), 0);
    if (sampled) {
      EXPECT_TRUE(found);
    }
    met += sampled;
  }
  EXPECT_GT(met, 300);
}

}  // namespace
}  // namespace kempe
