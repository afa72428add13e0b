// The mass of the links: the polynomial of the search against the areas of the outlines, and a weight worked out by hand.
#include "synthesis/loads/mass.hpp"

#include <gtest/gtest.h>

#include "tests/synthesis/loads/any_linkage.hpp"

namespace kempe {
namespace {

using namespace any_linkage;

Spec spec_of(PlateStyle plate) {
  Spec spec;
  spec.links.style = {.width = 12, .pin_diameter = 6, .thickness = 4, .plate = plate};
  spec.material = steel;
  return spec;
}

TEST(Mass, OfStraightBarsIsWhatTheyWeigh) {
  Spec spec = spec_of(PlateStyle::bent);
  spec.copy = Copy::of(-1.5, 0);
  const auto linkage = CopyingLinkage::make(-1.5, Grounding::pole, 100, 80, 0);
  ASSERT_TRUE(linkage);
  // VA 100, VB 80, ACX 80 + 80 / 1.5, BCY 100 + 150 mm between the outermost holes, a round end more, 10 holes
  const double area = 12 * (100 + 80 + 80 + 80 / 1.5 + 250) + 4 * pi * 36 - 10 * pi * 9;
  EXPECT_NEAR(mass_of_links(*linkage, spec), 7850e-9 * 4 * area, 1e-12);
}

TEST(Mass, IsThePolynomialOfTheSearch) {
  Chance chance(1);
  for (int i = 0; i < 200; ++i) {
    Spec spec = spec_of(one_in(chance, 2) ? PlateStyle::bent : PlateStyle::triangle);
    const double rotation = one_in(chance, 3) ? (one_in(chance, 2) ? 0 : pi) : chance.uniform(-pi, pi);
    const Complex k = copy_ratio(std::exp(chance.uniform(-1, 1)), rotation);
    if (std::abs(k - 1.0) < 0.2) continue;
    const Grounding grounding = any_grounding(chance);
    const double VA = chance.uniform(100, 400), VB = chance.uniform(100, 400);
    const auto linkage = CopyingLinkage::make(k, grounding, VA, VB, 0);
    ASSERT_TRUE(linkage);
    const MassPolynomial mass = mass_polynomial(spec, k, grounding);
    const auto at = [](const std::array<double, 3>& c, double length) {
      return c[0] + length * (c[1] + length * c[2]);
    };
    const double exact = mass_of_links(*linkage, spec), smooth = at(mass.of_VA, VA) + at(mass.of_VB, VB);
    EXPECT_LE(smooth, exact * (1 + 1e-9)) << i;
    const double angle = std::abs(std::remainder(std::arg(shape_of(k, grounding)), 2 * pi));
    const bool long_arms = angle > 1 || is_straight(shape_of(k, grounding));
    if (spec.links.style.plate == PlateStyle::triangle || long_arms) {
      EXPECT_NEAR(smooth, exact, 1e-9 * exact) << i;
    }
  }
}

}  // namespace
}  // namespace kempe
