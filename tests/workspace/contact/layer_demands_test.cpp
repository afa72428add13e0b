// The assignments worth a look against all there are: written from what links, pins and posts are, tuple by tuple, with
// gaps measured in random poses. Nothing here asks the program which parts meet.
#include "workspace/contact/layer_demands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "tests/samples.hpp"
#include "tests/workspace/random_linkage.hpp"
#include "workspace/contact/self_contact.hpp"

namespace kempe {
namespace {

using test::Dice;
using Tuple = std::array<int, 4>;  // layers of VA, VB, ACX, BCY

// V A B C X Y are 0 .. 5.
const std::array<std::vector<std::size_t>, 4> joints_of_link{{{0, 1}, {0, 2}, {1, 3, 4}, {2, 3, 5}}};
constexpr std::size_t V = 0, X = 4, Y = 5;

bool holds(std::size_t link, std::size_t joint) {
  const auto& joints = joints_of_link[link];
  return std::find(joints.begin(), joints.end(), joint) != joints.end();
}

bool share_a_joint(std::size_t link, std::size_t other) {
  return std::any_of(joints_of_link[link].begin(), joints_of_link[link].end(),
                     [&](std::size_t joint) { return holds(other, joint); });
}

/// Every tuple of layers in which links that share a joint differ.
std::vector<Tuple> all_tuples(int layers) {
  std::vector<Tuple> tuples;
  for (int i = 0; i < layers * layers * layers * layers; ++i) {
    const Tuple one{1 + i % layers, 1 + i / layers % layers, 1 + i / layers / layers % layers,
                    1 + i / layers / layers / layers};
    bool fits = true;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < a; ++b) fits = fits && (!share_a_joint(a, b) || one[a] != one[b]);
    if (fits) tuples.push_back(one);
  }
  return tuples;
}

/// A body in a pose: the corners of a convex axis and half its width.
struct Body {
  std::vector<std::vector<Point>> axes;
  double half_width = 0;
};

double segment_distance(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto to_segment = [](const Point& p, const Point& from, const Point& to) {
    const Point along = to - from;
    const double share =
        along.squaredNorm() > 0 ? std::clamp(along.dot(p - from) / along.squaredNorm(), 0.0, 1.0) : 0;
    return (p - from - share * along).norm();
  };
  const auto side = [](const Point& p, const Point& from, const Point& to) {
    return (to - from).x() * (p - from).y() - (to - from).y() * (p - from).x();
  };
  if (side(a, c, d) * side(b, c, d) < 0 && side(c, a, b) * side(d, a, b) < 0) return 0;
  return std::min({to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
}

bool inside(const std::vector<Point>& corners, const Point& p) {
  bool left = true, right = true;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point along = corners[(i + 1) % corners.size()] - corners[i], to = p - corners[i];
    const double side = along.x() * to.y() - along.y() * to.x();
    left = left && side > 0;
    right = right && side < 0;
  }
  return corners.size() > 2 && (left || right);
}

/// Between convex polygons of one corner and more: 0 if they overlap.
double polygon_distance(const std::vector<Point>& one, const std::vector<Point>& other) {
  if (inside(one, other[0]) || inside(other, one[0])) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t j = 0; j < other.size(); ++j)
      least = std::min(least, segment_distance(one[i], one[(i + 1) % one.size()], other[j],
                                               other[(j + 1) % other.size()]));
  return least;
}

double gap_between(const Body& one, const Body& other) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& a : one.axes)
    for (const auto& b : other.axes) least = std::min(least, polygon_distance(a, b));
  return least - one.half_width - other.half_width;
}

/// Four links, then the discs at the six joints.
std::vector<Body> bodies_in(const Pose& pose, const LinkStyle& style) {
  const std::array<Joint, 6> joints{Joint::V, Joint::A, Joint::B, Joint::C, Joint::X, Joint::Y};
  std::array<Point, 6> at;
  for (std::size_t i = 0; i < 6; ++i) at[i] = pose[joints[i]];
  const double half = style.width / 2;
  std::vector<Body> bodies{{{{at[0], at[1]}}, half}, {{{at[0], at[2]}}, half}};
  if (style.plate == PlateStyle::triangle) {
    bodies.push_back({{{at[1], at[3], at[4]}}, half});
    bodies.push_back({{{at[2], at[3], at[5]}}, half});
  } else {
    bodies.push_back({{{at[3], at[1]}, {at[1], at[4]}}, half});
    bodies.push_back({{{at[3], at[2]}, {at[2], at[5]}}, half});
  }
  for (const Point& joint : at) bodies.push_back({{{joint}}, style.pin_diameter / 2});
  return bodies;
}

/// Which layers each body fills: links one, discs those between the links at their joint; posts those below, too.
std::array<std::vector<int>, 10> filled(const Tuple& layers) {
  std::array<std::vector<int>, 10> result;
  for (std::size_t link = 0; link < 4; ++link) result[link] = {layers[link]};
  for (std::size_t joint = 0; joint < 6; ++joint) {
    int low = 1000, high = 0;
    for (std::size_t link = 0; link < 4; ++link)
      if (holds(link, joint)) low = std::min(low, layers[link]), high = std::max(high, layers[link]);
    for (int layer = low + 1; layer < high; ++layer) result[4 + joint].push_back(layer);
    for (int layer = 1; layer < low && (joint == V || joint == X || joint == Y); ++layer)
      result[4 + joint].push_back(layer);
  }
  return result;
}

bool meet(const std::vector<int>& one, const std::vector<int>& other) {
  return std::any_of(one.begin(), one.end(),
                     [&](int layer) { return std::find(other.begin(), other.end(), layer) != other.end(); });
}

bool is_part_of_the_other(std::size_t body, std::size_t other) {
  if (body > other) std::swap(body, other);
  if (other < 4) return share_a_joint(body, other);
  return body < 4 && holds(body, other - 4);
}

bool is_post(std::size_t body) { return body == 4 + V || body == 4 + X || body == 4 + Y; }

struct Scene {
  std::vector<Body> bodies;
  std::vector<Body> obstacles;
};

struct Stand {
  int lowest, highest;
};

/// The smallest gap of everything that must keep its distance in these layers.
double smallest_gap(const Tuple& layers, const Scene& scene, const std::vector<Stand>& stands,
                    const std::vector<std::vector<double>>& gaps,
                    const std::vector<std::vector<double>>& to_obstacles) {
  const auto in = filled(layers);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (!is_part_of_the_other(j, i) && (meet(in[i], in[j]) || (is_post(i) && is_post(j))))
        least = std::min(least, gaps[i][j]);
    for (std::size_t o = 0; o < stands.size(); ++o)
      for (const int layer : in[i])
        if (stands[o].lowest <= layer && layer <= stands[o].highest)
          least = std::min(least, to_obstacles[i][o]);
  }
  return least;
}

/// Gaps of every tuple in a few random poses of one linkage beside random obstacles.
struct Case {
  int layers;
  std::vector<Obstacle> obstacles;
  std::vector<Tuple> tuples;
  std::vector<std::vector<double>> gaps;  // of each tuple: of each pose
};

Case random_case(Dice& dice, const CopyingLinkage& linkage, int layers, int obstacles) {
  Case result{layers, {}, all_tuples(layers), {}};
  result.gaps.resize(result.tuples.size());
  LinkStyle style = test::random_style(dice);
  style.pin_diameter = std::min(style.pin_diameter, style.width);
  std::vector<Stand> stands;
  std::vector<Body> bodies;
  for (int i = 0; i < obstacles; ++i) {
    const int lowest = 1 + dice.below(layers), highest = std::min(8, lowest + dice.below(3));
    const double away = linkage.size() * dice.between(0, 0.5), bearing = dice.between(-pi, pi);
    const Point centre = linkage.pole() + as_point(std::polar(away, bearing));
    std::vector<Point> corners;
    const double radius = linkage.size() * dice.between(0.01, 0.1);
    for (int corner = 0; corner < 5; ++corner)
      corners.push_back(centre + as_point(std::polar(radius, 2 * pi * corner / 5)));
    stands.push_back({lowest, highest});
    bodies.push_back({{corners}, 0});
    result.obstacles.push_back({{corners, {}}, lowest, highest, "block"});
  }
  for (int pose = 0; pose < 8; ++pose) {
    const double share = dice.between(0.05, 0.95), turn = dice.between(-pi, pi);
    const OpeningInterval all = linkage.assembly_mode().openings;
    const Scene scene{bodies_in(linkage.pose_at(all.lower + share * all.width(), turn), style), bodies};
    std::vector<std::vector<double>> gaps(10, std::vector<double>(10)), to_obstacles(10);
    for (std::size_t i = 0; i < 10; ++i) {
      for (std::size_t j = 0; j < i; ++j) gaps[i][j] = gap_between(scene.bodies[i], scene.bodies[j]);
      for (const Body& obstacle : bodies) to_obstacles[i].push_back(gap_between(scene.bodies[i], obstacle));
    }
    for (std::size_t t = 0; t < result.tuples.size(); ++t)
      result.gaps[t].push_back(smallest_gap(result.tuples[t], scene, stands, gaps, to_obstacles));
  }
  return result;
}

bool keeps_as_much(const std::vector<double>& kept, const std::vector<double>& other) {
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i] < other[i] - 1e-9 * (1 + std::abs(other[i]))) return false;
  return true;
}

/// For every tuple there is a kept one with no smaller gap in any pose (and, if asked, no higher).
void expect_nothing_is_lost(const Case& all, const std::vector<LayerAssignment>& kept, bool no_higher) {
  std::vector<std::size_t> places;
  for (const LayerAssignment& one : kept) {
    const auto place = std::find(all.tuples.begin(), all.tuples.end(), one.of);
    ASSERT_NE(place, all.tuples.end());
    places.push_back(static_cast<std::size_t>(place - all.tuples.begin()));
  }
  const auto highest = [](const Tuple& tuple) { return *std::max_element(tuple.begin(), tuple.end()); };
  for (std::size_t t = 0; t < all.tuples.size(); ++t)
    EXPECT_TRUE(std::any_of(places.begin(), places.end(),
                            [&](std::size_t place) {
                              return (!no_higher || highest(all.tuples[place]) <= highest(all.tuples[t])) &&
                                     keeps_as_much(all.gaps[place], all.gaps[t]);
                            }))
        << "layers " << all.tuples[t][0] << all.tuples[t][1] << all.tuples[t][2] << all.tuples[t][3];
}

std::size_t body_of(const Part& part) {
  if (part.kind == Part::Kind::link) return static_cast<std::size_t>(part.link);
  return 4 + std::string("VABCXY").find(letter(part.joint));
}

/// In every tuple of up to five layers: the layers each part fills, and the pairs that must keep apart.
TEST(ContactPairs, AreThoseOfTheDefinitionInEveryTuple) {
  for (const Grounding grounding : all_groundings) {
    const CopyingLinkage linkage = *CopyingLinkage::make({0.3, 1.4}, grounding, 50, 35, 0);
    for (const Tuple& tuple : all_tuples(5)) {
      const auto in = filled(tuple);
      std::array<std::set<int>, 10> of_parts;
      for (const Part& part : parts_of(linkage, {tuple}))
        for (int layer = part.lowest_layer; layer <= part.highest_layer; ++layer)
          of_parts[body_of(part)].insert(layer);
      std::set<std::pair<std::size_t, std::size_t>> pairs, by_definition;
      for (const ContactPair& pair : contact_pairs(linkage, {tuple}))
        pairs.insert(std::minmax(body_of(pair.first), body_of(pair.second)));
      for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(of_parts[i], std::set<int>(in[i].begin(), in[i].end()));
        for (std::size_t j = 0; j < i; ++j)
          if (!is_part_of_the_other(j, i) && (meet(in[i], in[j]) || (is_post(i) && is_post(j))))
            by_definition.insert({j, i});
      }
      EXPECT_EQ(pairs, by_definition);
      // Whatever the layers, the disc about the pole is filled in layer 1: by its post, or by a link that it joins.
      const std::size_t pole = std::string("VABCXY").find(letter(linkage.pole_joint()));
      bool covered = meet(in[4 + pole], {1});
      for (std::size_t link = 0; link < 4; ++link)
        covered = covered || (holds(link, pole) && tuple[link] == 1);
      EXPECT_TRUE(covered);
    }
  }
}

TEST(LayerDemands, NoAssignmentLeftOutKeepsMoreThanOneThatIsKept) {
  Dice dice(211);
  int cases = 0, lifted = 0;
  for (int i = 0; i < test::samples(240); ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const int layers = 2 + i % 4, obstacles = dice.below(5);
    const Case all = random_case(dice, linkage, layers, obstacles);
    const auto least = least_demanding_assignments(linkage, layers, all.obstacles);
    const auto worth_trying = assignments_worth_trying(linkage, layers, all.obstacles);
    expect_nothing_is_lost(all, least, false);
    expect_nothing_is_lost(all, worth_trying, true);
    EXPECT_LE(least.size(), worth_trying.size());
    EXPECT_LE(worth_trying.size(), all.tuples.size());
    lifted += std::any_of(least.begin(), least.end(), [](const auto& one) { return !one.is_stacked(); });
    ++cases;
  }
  EXPECT_EQ(cases, test::samples(240));
  EXPECT_GT(lifted, test::expected(60));
}

TEST(LayerDemands, EightLayersLoseNothingEither) {
  Dice dice(223);
  for (int i = 0; i < test::samples(6); ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const Case all = random_case(dice, linkage, 6 + i % 3, 1 + i % 3);
    expect_nothing_is_lost(all, least_demanding_assignments(linkage, all.layers, all.obstacles), false);
    expect_nothing_is_lost(all, assignments_worth_trying(linkage, all.layers, all.obstacles), true);
  }
}

TEST(LayerDemands, WithoutObstaclesNoLayerIsLeftEmptyAndMoreThanFourAreOfNoUse) {
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  for (const LayerAssignment& one : assignments_worth_trying(linkage, 8, {})) EXPECT_TRUE(one.is_stacked());
  EXPECT_EQ(assignments_worth_trying(linkage, 8, {}), assignments_worth_trying(linkage, 4, {}));
  EXPECT_GT(assignments_worth_trying(linkage, 4, {}, {}, SagCounts::yes).size(),
            assignments_worth_trying(linkage, 4, {}).size());
  EXPECT_EQ(assignments_worth_trying(linkage, 2, {}).size(), 2u);
}

TEST(LayerDemands, AnObstacleInEveryLayerOrAboveAllLinksChangesNothing) {
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  const Ring square{{20, 20}, {30, 20}, {30, 30}, {20, 30}};
  const std::vector<Obstacle> above{{{square, {}}, 6, 8, "roof"}};
  EXPECT_EQ(assignments_worth_trying(linkage, 5, above), assignments_worth_trying(linkage, 5, {}));
  const std::vector<Obstacle> column{{{square, {}}, 1, 8, "column"}};
  for (const LayerAssignment& one : assignments_worth_trying(linkage, 8, column))
    EXPECT_TRUE(one.is_stacked());
}

TEST(LayerDemands, LinksAreLiftedOverALowClamp) {
  const CopyingLinkage linkage = *CopyingLinkage::make({-0.5, 0}, Grounding::pole, 50, 35, 0);
  const std::vector<Obstacle> clamp{{{{{20, 20}, {30, 20}, {30, 30}, {20, 30}}, {}}, 1, 1, "clamp"}};
  const auto kept = assignments_worth_trying(linkage, 3, clamp);
  EXPECT_NE(std::find(kept.begin(), kept.end(), LayerAssignment{{2, 3, 3, 2}}), kept.end());
}

}  // namespace
}  // namespace kempe
