// Instruments at the limits of their tolerances against the general planar solver, and against random instruments.
#include "synthesis/tolerance/corner_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/synthesis/tolerance/wrong_instruments.hpp"

namespace kempe {
namespace {

using namespace wrong_instruments;

const Point& pen_hole(const MadePose& made, Joint pen) {
  const auto& [VA, VB, ACX, BCY] = made.holes;
  return pen == Joint::V ? VA[0] : pen == Joint::X ? ACX[2] : BCY[2];
}

/// The same instrument for MadeInstruments: its pins as the solver's pose shows them.
InstrumentErrors errors_of(const CopyingLinkage& linkage, const Flaws& flaws, const MadePose& made) {
  const auto& [VA, VB, ACX, BCY] = made.holes;
  const bool pole_at_V = linkage.grounding() == Grounding::pole;
  const double bearing = heading(made.pole, made.tracer);
  const auto seen = [&](const Point& from, const Point& to) {
    return as_complex(Point(to - from)) * std::polar(1.0, -bearing);
  };
  InstrumentErrors errors;
  errors.length = flaws.length;
  errors.pin = {seen(made.pole, pole_at_V ? VA[0] : ACX[2]), seen(pole_at_V ? made.pole : VA[0], VB[0]),
                seen(VA[1], ACX[0]), seen(VB[1], BCY[0]), seen(ACX[1], BCY[1])};
  return errors;
}

Flaws any_flaws(Chance& chance, const Tolerance& limits) {
  Flaws flaws;
  const bool at_limits = chance.one_in(2);
  for (auto& each : flaws.length) each = limits.length * (at_limits ? chance.sign() : chance.uniform(-1, 1));
  for (auto& each : flaws.pin)
    each = at_limits ? chance.on_circle(0.5 * limits.play) : chance.in_disc(0.5 * limits.play);
  return flaws;
}

TEST(CornerError, InstrumentsCloseWhereTheGeneralSolverClosesThem) {
  Chance chance(31);
  for (int n = 0; n < 150; ++n) {
    const auto [linkage, tracer] = random_case(chance);
    const MadeInstruments instruments(linkage);
    const double distance = (tracer - linkage.pole()).norm();
    const Complex bearing = std::polar(1.0, heading(linkage.pole(), tracer));
    for (int m = 0; m < 4; ++m) {
      const Flaws flaws = any_flaws(chance, {0.5, 0.4});
      const auto made = made_pose(linkage, flaws, tracer);
      if (!made) continue;
      const auto found = instruments.deviation(errors_of(linkage, flaws, *made), distance);
      ASSERT_TRUE(found);
      const Point wanted = pen_hole(*made, linkage.pen_joint()) - true_pen(linkage, tracer);
      EXPECT_LT(std::abs(*found * bearing - as_complex(wanted)), 1e-8) << name(linkage.grounding());
    }
  }
}

/// Half the perimeter of 231 mm, k = 0.5 at 60 degrees, transmission angles from 20 degrees: short links at the edge of their range.
CopyingLinkage small_linkage() {
  return CopyingLinkage::make(copy_ratio(0.5, pi / 3), Grounding::pen, 43.4331516203, 35.8636506692, 0)
      .value();
}

TEST(CornerError, FindsInstrumentsThatTheFirstOrderDoesNotHold) {
  const CopyingLinkage linkage = small_linkage();
  const CopyTolerance tolerance = CopyTolerance::uniform({0.2, 0.1});
  const OpeningInterval openings{radians(-160), radians(-110)};
  const double stated = copy_error_profile(linkage, tolerance).largest(openings).worst.worst;
  const CornerError corner = corner_error(linkage, tolerance, openings);
  EXPECT_NEAR(stated, 3.4456, 1e-4);
  EXPECT_GE(corner.worst, 5.169);  // one such instrument, found at random
  EXPECT_TRUE(corner.closes);
  EXPECT_TRUE(first_order_understates(stated, corner.worst));
  RecordProperty("corner", std::to_string(corner.worst));
}

struct Interval {
  CopyingLinkage linkage;
  OpeningInterval openings;
};
Interval any_openings(Chance& chance) {
  const auto [linkage, tracer] = random_case(chance);
  const OpeningInterval most = shrink(linkage.assembly_mode().openings, radians(20));
  const double from = most.lower + chance.uniform(0, 0.8) * most.width();
  return {linkage, {from, from + chance.uniform(0.1, 1) * (most.upper - from)}};
}

TEST(CornerError, GoesOverIntoTheFirstOrder) {
  Chance chance(32);
  for (int n = 0; n < 60; ++n) {
    const auto [linkage, openings] = any_openings(chance);
    const CopyTolerance tolerance = CopyTolerance::uniform({5e-5, 4e-5});
    const double stated = copy_error_profile(linkage, tolerance).largest(openings).worst.worst;
    const CornerError corner = corner_error(linkage, tolerance, openings);
    EXPECT_NEAR(corner.worst / stated, 1, 1e-4);
    EXPECT_FALSE(first_order_understates(stated, corner.worst));
    EXPECT_TRUE(corner.closes);
  }
}

// 250 instruments at each of 150 designs, with tolerances from 0.02 to 0.5 mm on links of some 60 to 500 mm, at random places of the openings.
TEST(CornerError, NoRandomInstrumentIsWorseThanBothFigures) {
  Chance chance(33);
  double nearest = 0;
  int understated = 0;
  for (int n = 0; n < 150; ++n) {
    const auto [linkage, openings] = any_openings(chance);
    const double size = std::exp(chance.uniform(std::log(0.02), std::log(0.5)));
    const Tolerance limits{size, chance.uniform(0, 1) * size};
    const CopyTolerance tolerance = CopyTolerance::uniform(limits);
    const double stated = copy_error_profile(linkage, tolerance).largest(openings).worst.worst;
    const CornerError corner = corner_error(linkage, tolerance, openings);
    EXPECT_GT(corner.worst, 0.95 * stated);
    understated += first_order_understates(stated, corner.worst);
    const MadeInstruments instruments(linkage);
    for (int m = 0; m < 250; ++m) {
      const Flaws flaws = any_flaws(chance, limits);
      InstrumentErrors errors{flaws.length, {}};
      for (std::size_t j = 0; j < 5; ++j) errors.pin[j] = as_complex(flaws.pin[j]);
      const double share = std::clamp(chance.uniform(-0.5, 1.5), 0.0, 1.0);  // at an end as often as between
      const auto found =
          instruments.deviation(errors, linkage.radius_at(openings.lower + share * openings.width()));
      if (!found) continue;
      EXPECT_LE(std::abs(*found), std::max(stated, corner.worst) * 1.0001);
      nearest = std::max(nearest, std::abs(*found) / std::max(stated, corner.worst));
    }
  }
  EXPECT_GT(nearest, 0.7);
  RecordProperty("nearest", std::to_string(nearest));
  RecordProperty("understated", understated);
}

// Every corner of the lengths at every opening looked at: none is worse.
TEST(CornerError, NoCornerOfTheLengthsIsWorse) {
  const CopyingLinkage linkage = small_linkage();
  const MadeInstruments instruments(linkage);
  const CopyTolerance tolerance = CopyTolerance::uniform({0.2, 0});
  const OpeningInterval openings{radians(-160), radians(-110)};
  const CornerError corner = corner_error(linkage, tolerance, openings);
  double worst = 0;
  for (unsigned signs = 0; signs < 256; ++signs)
    for (int step = 0; step <= 64; ++step) {
      InstrumentErrors errors;
      for (unsigned j = 0; j < 8; ++j) errors.length[j] = (signs >> j & 1U) != 0 ? 0.2 : -0.2;
      const auto found =
          instruments.deviation(errors, linkage.radius_at(openings.lower + openings.width() * step / 64));
      if (found) worst = std::max(worst, std::abs(*found));
    }
  EXPECT_NEAR(corner.worst, worst, 1e-6 * worst);
}

TEST(CornerError, NamesPlatesThatMayNotExist) {
  const auto plates = [](double rotation, double size, double off) {
    const Complex k = copy_ratio(1.4, radians(rotation));
    const auto linkage = CopyingLinkage::make(k, Grounding::pole, size, size, 0).value();
    return plates_at_risk(linkage, CopyTolerance::uniform({off, 0.02}));
  };
  EXPECT_TRUE(plates(90, 100, 0.05).empty());
  EXPECT_TRUE(plates(180, 20, 0.05).empty());  // a bar, toleranced as one
  const auto risky = plates(172, 20, 0.05);
  ASSERT_EQ(risky.size(), 2u);
  EXPECT_EQ(risky[0].plate, "ACX");
  EXPECT_EQ(risky[1].plate, "BCY");
  for (const double share : {0.999, 1.001}) {
    const double from = risky[0].flat_from;
    EXPECT_EQ(plates(172, 20, share * from)[0].height_may_lose >= 1, share > 1) << from;
  }
}

TEST(CornerError, SaysWhenAnInstrumentDoesNotClose) {
  const auto linkage = CopyingLinkage::make(copy_ratio(1.4, pi / 2), Grounding::pole, 50, 35, 3).value();
  const OpeningInterval all = linkage.assembly_mode().openings;
  const OpeningInterval middle = shrink(all, radians(30)), near_end = shrink(all, radians(0.5));
  EXPECT_TRUE(corner_error(linkage, CopyTolerance::uniform({0.05, 0.02}), middle).closes);
  EXPECT_FALSE(corner_error(linkage, CopyTolerance::uniform({0.5, 0.2}), near_end).closes);
}

}  // namespace
}  // namespace kempe
