// limits.longest_strip_mm: no link is longer over its ends, whichever way it is laid; everything else is as it would be with
// longest_mm less the links' width.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/problem/requirements.hpp"
#include "synthesis/search/search.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "workspace/parts.hpp"

namespace kempe {
namespace {

std::optional<FoundDesign> found_of_strips(const Spec& spec) {
  const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
  const auto* design = std::get_if<FoundDesign>(&outcome);
  return design ? std::optional(*design) : std::nullopt;
}

/// The longest of the links' outlines in any of 180 directions, mm.
double longest_outline(const CopyingLinkage& linkage, const LinkStyle& style) {
  double longest = 0;
  const Pose pose = linkage.pose_at(linkage.assembly_mode().openings.middle(), 0);
  for (const Link link : all_links) {
    const Ring corners = flattened(link_outline(link, pose, style), 1e-4, Flatten::shrinks).outer;
    for (int i = 0; i < 180; ++i) {
      const Point way = as_point(std::polar(1.0, pi * i / 180));
      const auto [low, high] =
          std::minmax_element(corners.begin(), corners.end(),
                              [&](const Point& a, const Point& b) { return a.dot(way) < b.dot(way); });
      longest = std::max(longest, (*high - *low).dot(way));
    }
  }
  return longest;
}

/// Specs whose best design without the limit is known to be longer than the strip.
TEST(LongestStrip, IsKeptByTheOutlinesAndCostsWhatLongestDoes) {
  test::SpecDice dice(77);
  int shorter = 0;
  for (int i = 0; i < 40; ++i) {
    Spec spec = dice.spec();
    const auto free = found_of_strips(spec);
    if (!free) continue;
    const double attained = longest_outline(free->linkage, spec.links.style);
    Spec with_strip = spec, with_longest = spec;
    with_strip.limits.longest_strip = attained * dice.uniform(0.8, 1.1);
    with_longest.links.longest = *with_strip.limits.longest_strip - spec.links.style.width;
    if (with_longest.links.longest < spec.links.shortest) continue;
    const auto kept = found_of_strips(with_strip), same = found_of_strips(with_longest);
    ASSERT_EQ(kept.has_value(), same.has_value());
    if (!kept) continue;
    ++shorter;
    EXPECT_EQ(kept->linkage.VA(), same->linkage.VA());
    EXPECT_EQ(kept->linkage.VB(), same->linkage.VB());
    EXPECT_EQ(kept->proven_bound, same->proven_bound);
    EXPECT_LE(longest_outline(kept->linkage, spec.links.style), *with_strip.limits.longest_strip + 1e-6);
  }
  EXPECT_GE(shorter, 15);
}

TEST(LongestStrip, MovesWithALimitThatIsMovedPastIt) {
  Spec spec;
  spec.links.longest = 400;
  spec.limits.longest_strip = 300;
  Requirements limits = requirements_of(spec);
  EXPECT_EQ(limits.longest, 288);
  limits.longest = 350;
  EXPECT_EQ(requirements_of(with_limits(spec, limits)).longest, 350);
  limits.longest = 200;
  EXPECT_EQ(requirements_of(with_limits(spec, limits)).longest, 200);
}

}  // namespace
}  // namespace kempe
