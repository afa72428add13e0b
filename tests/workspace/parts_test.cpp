#include "workspace/parts.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/workspace/random_linkage.hpp"

namespace kempe {
namespace {

using test::Dice;

double distance_to_segment(const Point& point, const Point& a, const Point& b) {
  double least = 1e300;
  const int steps = 2000;
  for (int i = 0; i <= steps; ++i)
    least = std::min(least, (a + (b - a) * (static_cast<double>(i) / steps) - point).norm());
  return least;
}

bool inside(const Ring& ring, const Point& point) {
  bool in = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if ((ring[i].y() > point.y()) != (ring[j].y() > point.y()) &&
        point.x() < (ring[j].x() - ring[i].x()) * (point.y() - ring[i].y()) / (ring[j].y() - ring[i].y()) +
                        ring[i].x())
      in = !in;
  return in;
}

TEST(Parts, TwoLayersHaveTwoAssignments) {
  const auto two = layer_assignments(2);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].of, (std::array{1, 2, 2, 1}));
  EXPECT_EQ(two[1].of, (std::array{2, 1, 1, 2}));
}

TEST(Parts, AssignmentsAreTheColouringsOfAFourCycle) {
  // c(c-1)(c^2-3c+3) colourings with at most c colours; those of exactly 2, 3 and 4 are the ones without an empty
  // layer.
  for (int c = 2; c <= 8; ++c) {
    const auto all = layer_assignments(c);
    EXPECT_EQ(all.size(), static_cast<std::size_t>(c * (c - 1) * (c * c - 3 * c + 3)));
    const auto stacked =
        std::count_if(all.begin(), all.end(), [](const auto& one) { return one.is_stacked(); });
    EXPECT_EQ(stacked, c == 2 ? 2 : c == 3 ? 2 + 12 : 2 + 12 + 24);
    EXPECT_TRUE(
        std::is_partitioned(all.begin(), all.end(), [](const auto& one) { return one.is_stacked(); }));
    for (const LayerAssignment& layers : all) {
      EXPECT_NE(layers[Link::VA], layers[Link::VB]);
      EXPECT_NE(layers[Link::ACX], layers[Link::BCY]);
    }
  }
}

TEST(Parts, PinsFillTheLayersBetweenTheirLinksAndPostsThoseDownToTheTable) {
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  std::set<std::string> names;
  std::map<std::string, std::pair<int, int>> range;
  for (const Part& part : parts_of(linkage, {{1, 4, 3, 2}})) {
    names.insert(name(part));
    range[name(part)] = {part.lowest_layer, part.highest_layer};
  }
  EXPECT_EQ(range["pin V"], std::pair(2, 3));
  EXPECT_EQ(range["pole post V"], std::pair(1, 0));
  EXPECT_EQ(range["tracer X"], std::pair(1, 2));
  EXPECT_EQ(range["pen Y"], std::pair(1, 1));
  EXPECT_EQ(names, (std::set<std::string>{"link VA", "link VB", "link ACX", "link BCY", "pin V", "pin A",
                                          "pin B", "pole post V", "tracer X", "pen Y"}));
}

TEST(Parts, OutlineIsTheAxisGrownByHalfTheWidth) {
  Dice dice(7);
  for (int i = 0; i < 300; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const LinkStyle style = test::random_style(dice);
    const Pose pose = linkage.pose_at(linkage.assembly_mode().openings.middle(), dice.between(-pi, pi));
    const Link link = all_links[static_cast<std::size_t>(dice.below(4))];
    const ArcPolygon outline = link_outline(link, pose, style);
    const Ring ring = flattened(outline, 1e-4, Flatten::shrinks).outer;
    const auto axis = axis_of({Part::Kind::link, link}, linkage.shape(), style.plate);
    for (int sample = 0; sample < 40; ++sample) {
      const Point middle =
          pose[joints_of(link).joints[static_cast<std::size_t>(dice.below(joints_of(link).count))]];
      const Point point =
          middle + as_point(std::polar(style.width * dice.between(0, 3), dice.between(-pi, pi)));
      double from_axis = 1e300;
      for (const JointHull& piece : axis) {
        if (piece.count == 3 &&
            inside({pose[piece.joints[0]], pose[piece.joints[1]], pose[piece.joints[2]]}, point))
          from_axis = 0;
        for (std::size_t j = 0; j < 3; ++j)
          from_axis = std::min(
              from_axis, distance_to_segment(point, pose[piece.joints[j]], pose[piece.joints[(j + 1) % 3]]));
      }
      if (std::abs(from_axis - 0.5 * style.width) < 2e-3)
        continue;  // on the outline, within the oracle's own error
      EXPECT_EQ(inside(ring, point), from_axis < 0.5 * style.width) << i << " " << name(link);
    }
  }
}

TEST(Parts, BarIsAStadium) {
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  const ArcPolygon bar = link_outline(Link::VA, linkage.pose_at(2, 0.3), {12, 6, 4, PlateStyle::bent});
  EXPECT_NEAR(area(bar), 50 * 12 + pi * 36, 1e-9);
}

TEST(Parts, StraightPlateIsTheStadiumOfItsOutermostJoints) {
  for (const PlateStyle plate : {PlateStyle::bent, PlateStyle::triangle})
    for (const double k : {-0.5, 2.5, 0.4}) {
      const CopyingLinkage linkage = *CopyingLinkage::make({k, 0}, Grounding::pole, 50, 40, 1);
      const LinkLengths l = linkage.lengths();
      const double longest = std::max({l.AC, l.AX, l.CX});
      EXPECT_NEAR(area(link_outline(Link::ACX, linkage.pose_at(1, 0.3), {10, 6, 4, plate})),
                  longest * 10 + pi * 25, 1e-9);
    }
}

}  // namespace
}  // namespace kempe
