#include "workspace/map/contours.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kempe {
namespace {

const Annulus ring{{5, -3}, 20, 60};

TEST(Contours, HalfPlaneHasHalfTheAnnulus) {
  const auto bands = contours(ring, [](const Point& p) { return p.x() - 5; }, {0}, {720, 80});
  ASSERT_EQ(bands.size(), 1u);
  EXPECT_NEAR(area(bands[0].area), 0.5 * area(ring), 2e-3 * area(ring));
}

TEST(Contours, LevelsBelowAndAboveGiveAllAndNothing) {
  const auto bands = contours(ring, [](const Point& p) { return p.norm(); }, {0, 1000});
  EXPECT_NEAR(area(bands[0].area), area(ring), 1e-3 * area(ring));
  EXPECT_TRUE(bands[1].area.empty());
}

TEST(Contours, AHillInsideIsADiscAndAPitIsAHole) {
  const Point top(45, -3);
  const auto hill = contours(ring, [&](const Point& p) { return -(p - top).norm(); }, {-10}, {720, 160});
  ASSERT_EQ(hill[0].area.polygons.size(), 1u);
  EXPECT_NEAR(area(hill[0].area), pi * 100, 1);
  const auto pit = contours(ring, [&](const Point& p) { return (p - top).norm(); }, {10}, {720, 160});
  ASSERT_EQ(pit[0].area.polygons.size(), 1u);
  EXPECT_EQ(pit[0].area.polygons[0].holes.size(), 2u) << "the inner circle and the pit";
  EXPECT_NEAR(area(pit[0].area), area(ring) - pi * 100, 2);
}

TEST(Contours, PlacesWithoutAValueAreBelowEveryLevel) {
  const auto bands =
      contours(ring, [](const Point& p) { return p.x() > 5 ? 1.0 : std::nan(""); }, {0.5}, {720, 20});
  EXPECT_NEAR(area(bands[0].area), 0.5 * area(ring), 0.02 * area(ring));
}

TEST(Contours, TransmissionIsAtLeastTheLevelInsideItsAnnulusAndBelowOutside) {
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2, {1, 2});
  for (const auto& [level, region] :
       transmission_contours(linkage, {radians(10), radians(25), radians(40)})) {
    ASSERT_EQ(region.size(), 1u);
    const double outer = (region[0].outer[0].at - linkage.pole()).norm();
    EXPECT_NEAR(linkage.transmission_angle(*linkage.opening_at(outer)), level, 1e-9);
    EXPECT_LT(linkage.transmission_angle(*linkage.opening_at(outer + 0.01)), level);
    EXPECT_GT(linkage.transmission_angle(*linkage.opening_at(outer - 0.01)), level);
  }
}

}  // namespace
}  // namespace kempe
