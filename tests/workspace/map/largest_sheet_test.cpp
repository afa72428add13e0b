#include "workspace/map/largest_sheet.hpp"

#include <gtest/gtest.h>

#include "geometry/regions/region_algebra.hpp"
#include "tests/workspace/random_linkage.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using test::Dice;

Ring corners_of(const FittingSheet& sheet) {
  Ring ring;
  for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
    ring.push_back(sheet.centre + as_point(Complex(0.5 * x * sheet.width, 0.5 * y * sheet.height) *
                                           std::polar(1.0, sheet.turn)));
  return ring;
}

/// Largest scale of a rectangle width x height in an annulus: one side touches the inner circle in its middle
/// and the far corners the outer circle, (inner + s h)^2 + (s w / 2)^2 = outer^2.
double best_scale(const Annulus& annulus, double width, double height) {
  const auto scale = [&](double w, double h) {
    const double a = h * h + w * w / 4, b = annulus.inner * h,
                 c = annulus.inner * annulus.inner - annulus.outer * annulus.outer;
    return (-b + std::sqrt(b * b - a * c)) / a;
  };
  return std::max(scale(width, height), scale(height, width));
}

TEST(LargestSheet, InAnAnnulusItIsTheClosedFormWithinHalfAPercent) {
  Dice dice(81);
  for (int i = 0; i < 8; ++i) {
    const double outer = dice.between(50, 500);
    const Annulus annulus{{dice.between(-100, 100), 0}, outer * dice.between(0.2, 0.9), outer};
    const double proportion = dice.between(0.5, 3);
    const auto found = largest_rectangle(as_region(annulus), proportion, true);
    ASSERT_TRUE(found);
    const double best = best_scale(annulus, proportion, 1);
    EXPECT_LE(found->height, best * (1 + 1e-6));
    EXPECT_GE(found->height, best * 0.995) << "case " << i;
  }
}

TEST(LargestSheet, LiesInTheRegionExactly) {
  Dice dice(82);
  for (int i = 0; i < 10; ++i) {
    Ring star;
    for (int k = 0; k < 15; ++k) star.push_back(as_point(std::polar(dice.between(60, 200), 2 * pi * k / 15)));
    const ArcRegion region =
        difference(as_arcs({{{star, {}}}}), as_region({{dice.between(-20, 20), 0}, 0, 25}));
    for (const bool turned : {false, true}) {
      const auto found = largest_rectangle(region, dice.between(0.4, 2.5), turned);
      ASSERT_TRUE(found);
      EXPECT_TRUE(contains(region, as_arcs({{{corners_of(*found), {}}}})));
      if (!turned) {
        EXPECT_NEAR(std::sin(2 * found->turn), 0, 1e-12);
      }
    }
  }
}

TEST(LargestSheet, ASheetThatJustFitsIsFoundUpright) {
  const auto rectangle = [](double width, double height) {
    return as_arcs({{{{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}}}});
  };
  const auto a4 = largest_iso_sheet(rectangle(297.5, 210.5));
  ASSERT_TRUE(a4);
  EXPECT_EQ(a4->name, "A4");
  EXPECT_NEAR(a4->turn, 0, 1e-12);
  const auto portrait = largest_iso_sheet(rectangle(105.5, 148.5));
  ASSERT_TRUE(portrait);
  EXPECT_EQ(portrait->name, "A6");
  EXPECT_NEAR(std::abs(portrait->turn), pi / 2, 1e-12);
  EXPECT_EQ(largest_iso_sheet(rectangle(296, 209))->name, "A5");
  EXPECT_FALSE(largest_iso_sheet(rectangle(60, 60)));
}

TEST(LargestSheet, IsTurnedWhereThatHelps) {
  // A strip at 30 degrees: an A6 fits only along it.
  Ring strip;
  for (const Complex corner : {Complex(0, 0), Complex(160, 0), Complex(160, 108), Complex(0, 108)})
    strip.push_back(as_point(corner * std::polar(1.0, radians(30))));
  const auto found = largest_iso_sheet(as_arcs({{{strip, {}}}}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->name, "A6");
  EXPECT_NEAR(found->turn, radians(30), radians(5));
}

TEST(LargestSheet, NothingFitsNothing) {
  EXPECT_FALSE(largest_rectangle({}, 1.4, true));
  EXPECT_FALSE(largest_iso_sheet({}));
  EXPECT_TRUE(largest_sheets({}, {}).empty());
}

}  // namespace
}  // namespace kempe
