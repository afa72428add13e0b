// Gaps to obstacles of many corners, which are asked by few of their convex parts, against the distances of all edges.
#include "synthesis/problem/obstacle_gap.hpp"

#include <gtest/gtest.h>

#include "geometry/segment_distance.hpp"
#include "tests/workspace/random_linkage.hpp"

namespace kempe {
namespace {

using test::Dice;

/// A star of many convex parts, or a circle: one part of 1440 corners.
Polygon of_many_corners(Dice& dice) {
  const Point centre(dice.between(-250, 250), dice.between(-250, 250));
  const double radius = dice.between(3, 80);
  if (dice.below(2) == 0) return Region::circle(centre, radius).polygons.front();
  Polygon star;
  for (int i = 0; i < 300; ++i)
    star.outer.push_back(centre + as_point(std::polar(radius * dice.between(0.5, 1), 2 * pi * i / 300)));
  return star;
}

/// To the outline; nothing where they overlap, as depths are those of parts.
std::optional<double> distance_to_outline(const JointHull& hull, const Pose& pose, const Polygon& obstacle) {
  const auto corner = [&](int i) { return pose[hull.joints[static_cast<std::size_t>(i % hull.count)]]; };
  const Region region{{obstacle}};
  double least = infinity;
  const Ring& ring = obstacle.outer;
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (int side = 0; side < hull.count; ++side)
      least = std::min(
          least, squared_distance(corner(side), corner(side + 1), ring[i], ring[(i + 1) % ring.size()]));
  const bool within =
      contains(region, corner(0)) ||
      (hull.count == 3 && contains(Region{{{{corner(0), corner(1), corner(2)}, {}}}}, ring[0]));
  if (within || !(least > 0)) return std::nullopt;
  return std::sqrt(least);
}

/// Within reach, beyond it on either side, and at both dead points.
TEST(Reach, DirectionIsThatOfTheOpening) {
  Dice dice(70);
  for (int i = 0; i < 2000; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const Reach reach(linkage.k(), linkage.grounding(), linkage.assembly_mode().number);
    const SideLengths sides = reach.sides({std::log(linkage.VA()), std::log(linkage.VB())});
    const OpeningInterval& openings = linkage.assembly_mode().openings;
    const double farthest = linkage.radius_at(openings.lower) + linkage.radius_at(openings.upper);
    const double within = linkage.radius_at(openings.lower + dice.between(0, 1) * openings.width());
    for (const double radius : {within, dice.between(0, 1.5) * farthest, linkage.radius_at(openings.lower),
                                linkage.radius_at(openings.upper)}) {
      const Complex direction = reach.direction_at(sides, radius);
      EXPECT_NEAR(std::abs(direction), 1, 1e-14) << i;
      EXPECT_LT(std::abs(direction - std::polar(1.0, reach.opening_at(sides, radius))), 1e-14) << i;
    }
  }
}

TEST(ObstacleGap, OfManyCornersIsTheDistanceToTheNearestEdge) {
  Dice dice(71);
  int apart = 0, beyond = 0;
  for (int i = 0; i < 300; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const OpeningInterval& openings = linkage.assembly_mode().openings;
    const double opening = openings.lower + dice.between(0.1, 0.9) * openings.width();
    const Point tracer =
        linkage.pole() + as_point(std::polar(linkage.radius_at(opening), dice.between(-pi, pi)));
    const auto pose = linkage.pose_with_tracer_at(tracer);
    ASSERT_TRUE(pose);
    const Polygon obstacle = of_many_corners(dice);
    const std::vector<Obstruction> obstructions =
        obstructions_of({{.shape = obstacle, .highest_layer = 8}}, {}, {});
    const std::vector<ObstacleShape> shapes = obstacle_shapes(obstructions);
    ASSERT_EQ(shapes.size(), 1U);
    EXPECT_FALSE(shapes.front().groups.empty());
    const Reach reach(linkage.k(), linkage.grounding(), linkage.assembly_mode().number);
    const PlacedJoints joints(reach, roles_of(linkage.grounding()),
                              {std::log(linkage.VA()), std::log(linkage.VB())}, linkage.pole(), tracer);
    for (const ObstacleTerm& term :
         obstacle_terms(linkage, test::random_layers(dice), test::random_style(dice), obstructions)) {
      const auto plain = distance_to_outline(term.piece.hull, *pose, obstacle);
      const double exact = obstacle_gap(term, shapes.front(), joints, infinity);
      const double by_jet = obstacle_gap_jet(term, shapes.front(), joints).value;
      if (!plain) {
        EXPECT_LE(exact, -term.piece.half_width + 1e-9) << i;
        EXPECT_NEAR(by_jet, exact, 1e-9) << i;
        continue;
      }
      ++apart;
      const double gap = *plain - term.piece.half_width;
      EXPECT_NEAR(exact, gap, 1e-9) << i;
      EXPECT_NEAR(by_jet, gap, 1e-9) << i;
      const double enough = gap + dice.between(-20, 20);
      const double any = obstacle_gap(term, shapes.front(), joints, enough, Beyond::anything);
      const double near = obstacle_gap(term, shapes.front(), joints, enough);
      EXPECT_LE(near, gap + 1e-9) << i;
      if (gap <= enough) {
        EXPECT_NEAR(any, gap, 1e-9) << i;
        EXPECT_NEAR(near, gap, 1e-9) << i;
      } else {
        EXPECT_GT(any, enough) << i;
        EXPECT_GT(near, enough) << i;
        ++beyond;
      }
    }
  }
  EXPECT_GT(apart, 1000);
  EXPECT_GT(beyond, 300);
}

}  // namespace
}  // namespace kempe
