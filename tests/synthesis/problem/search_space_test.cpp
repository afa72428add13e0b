// The gap between original and copy that the search asks for, against that of every corner.
#include "synthesis/problem/search_space.hpp"

#include <gtest/gtest.h>

#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

TEST(SearchSpace, TheSmallestCopyGapIsThatOfTheNearestCorner) {
  test::SpecDice dice(2911);
  int apart = 0, overlapping = 0;
  for (int i = 0; i < test::samples(400); ++i) {
    Spec spec = dice.spec();
    spec.limits.copy_gap = 1;
    const SearchSpace space(spec);
    const double size = space.region().diagonal();
    for (int j = 0; j < 20; ++j) {
      const double away = size * dice.log_uniform(0.01, 10);
      const Point pole = space.region().centre() + as_point(std::polar(away, dice.uniform(-pi, pi)));
      SearchSpace::SmallestCopyGap nearest{infinity, 0};
      for (std::size_t corner = 0; corner < space.gap_corners().size(); ++corner)
        if (const double gap = space.copy_gap(space.gap_corners()[corner], pole).distance;
            gap < nearest.distance)
          nearest = {gap, corner};
      const SearchSpace::SmallestCopyGap found = space.smallest_copy_gap(pole);
      EXPECT_EQ(found.distance, nearest.distance) << i;
      EXPECT_EQ(found.corner, nearest.corner) << i;
      ++(found.distance > 0 ? apart : overlapping);
    }
  }
  EXPECT_GT(apart, test::expected(1000));
  EXPECT_GT(overlapping, test::expected(1000));
}

}  // namespace
}  // namespace kempe
