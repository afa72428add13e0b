// Load error and forces against golden values that two finite-element frames gave, and against what must hold whatever the formulas: scaling,
// superposition, power, exact derivatives.
#include "synthesis/loads/load_error.hpp"

#include <gtest/gtest.h>

#include "synthesis/loads/pin_compliance.hpp"
#include "synthesis/loads/strength.hpp"
#include "tests/synthesis/loads/any_linkage.hpp"

namespace kempe {
namespace {

using namespace any_linkage;

LinkStyle section(double width, double thickness) { return {.width = width, .thickness = thickness}; }

struct GoldenError {
  Complex k;
  Grounding grounding;
  double VA, VB, width, thickness, force, opening_deg, worst, least, pin_force;
};

/// Worst and least deflection at the pen, mm; worst force at pins A and B for each newton.
const GoldenError golden[] = {
    {{0, 1.4}, Grounding::tracer, 56.786, 25.807, 6, 2, 10, -150, 0.68835, 0.01443, 2.8},
    {{0, 1.4}, Grounding::tracer, 56.786, 25.807, 6, 2, 10, -120, 0.68675, 0.01132, 1.6166},
    {{0, 1.4}, Grounding::tracer, 56.786, 25.807, 6, 2, 10, -84.462, 0.69285, 0.00413, 1.4066},
    {{0, 1.4}, Grounding::pole, 50, 35, 6, 2, 10, 100, 0.30665, 0.00188, 1.7470},
    {{0, 1.4}, Grounding::pole, 50, 35, 6, 2, 10, 135, 0.29452, 0.01686, 2.4331},
    {{0, 1.4}, Grounding::pole, 50, 35, 6, 2, 10, 170, 0.33344, 0.04791, 9.9078},
    {{0.4, 0}, Grounding::pen, 91.784, 76.542, 15, 5, 10, -150, 0.010115, 0.000391, 2.0},
    {{0.4, 0}, Grounding::pen, 91.784, 76.542, 15, 5, 10, -30, 0.010115, 0.000391, 2.0},
    {{0.4, 0}, Grounding::pen, 91.784, 76.542, 15, 5, 10, -90, 0.008329, 0.001503, 1.0},
    {{0.4, 0}, Grounding::tracer, 225, 135, 15, 5, 50, 40, 0.069455, 0.009450, 0.6223},
    {{0.4, 0}, Grounding::tracer, 225, 135, 15, 5, 50, 90, 0.039300, 0.039060, 0.4},
    {{0.4, 0}, Grounding::tracer, 225, 135, 15, 5, 50, 150, 0.073937, 0.005575, 0.8},
};

TEST(LoadError, IsThatOfTheGoldenValues) {
  for (const GoldenError& one : golden) {
    const LoadErrorProfile profile(one.k, one.grounding, section(one.width, one.thickness), steel, one.force);
    const LoadErrorAt error = profile.at({one.VA, one.VB}, radians(one.opening_deg));
    const PinForces pins = pin_forces(one.k, one.grounding, radians(one.opening_deg));
    const double half_a_digit = one.width > 10 ? 0.6e-6 : 0.6e-5;
    EXPECT_NEAR(error.worst, one.worst, half_a_digit) << one.opening_deg;
    EXPECT_NEAR(error.least, one.least, half_a_digit) << one.opening_deg;
    EXPECT_NEAR(pins.A, one.pin_force, 0.6e-4) << one.opening_deg;
    EXPECT_NEAR(pins.B, one.pin_force, 0.6e-4) << one.opening_deg;
  }
}

/// A linkage of any kind at an opening away from its change points.
struct Case {
  Complex k;
  Grounding grounding;
  BarLengths lengths;
  LinkStyle style;
  double force, opening;
  LoadErrorProfile profile(const PinCompliance& pins = {}) const {
    return {k, grounding, style, steel, force, pins};
  }
};

Case random_pushed(Chance& chance) {
  for (;;) {
    const double rotation = one_in(chance, 3) ? (one_in(chance, 2) ? 0 : pi) : chance.uniform(-pi, pi);
    const Complex k = copy_ratio(std::exp(chance.uniform(-1.4, 1.4)), rotation);
    if (std::abs(k - 1.0) < 0.1) continue;
    return {k,
            any_grounding(chance),
            {chance.uniform(20, 400), chance.uniform(20, 400)},
            section(chance.uniform(5, 30), chance.uniform(2, 10)),
            chance.uniform(0.1, 100),
            (one_in(chance, 2) ? 1 : -1) * chance.uniform(0.2, pi - 0.2)};
  }
}

TEST(LoadError, GrowsWithTheLoad) {
  Chance chance(1);
  for (int i = 0; i < 300; ++i) {
    Case one = random_pushed(chance);
    const LoadErrorAt before = one.profile().at(one.lengths, one.opening);
    one.force *= 2;
    const LoadErrorAt after = one.profile().at(one.lengths, one.opening);
    EXPECT_NEAR(after.worst, 2 * before.worst, 1e-12 * after.worst);
    EXPECT_NEAR(after.least, 2 * before.least, 1e-12 * after.worst);
  }
}

/// Bending goes with the cube of the lengths, pull with the lengths; forces are the same.
TEST(LoadError, GrowsWithTheCubeOfTheLengths) {
  Chance chance(2);
  for (int i = 0; i < 300; ++i) {
    Case one = random_pushed(chance);
    const double c = chance.uniform(1.5, 4);
    const auto at = [&](double share) {
      return one.profile().at({share * one.lengths.VA, share * one.lengths.VB}, one.opening).worst;
    };
    EXPECT_LE(at(c), c * c * c * at(1) * (1 + 1e-12));
    EXPECT_GE(at(c), c * at(1));
    one.style.width = 0.01;  // bends so easily that nothing else counts
    EXPECT_NEAR(at(c), c * c * c * at(1), 1e-5 * at(c));
  }
}

/// A linkage that is enlarged as a whole, its sections with it, gives way less by that share.
TEST(LoadError, FallsWithTheSizeOfTheWhole) {
  Chance chance(3);
  for (int i = 0; i < 300; ++i) {
    Case one = random_pushed(chance);
    const double before = one.profile().at(one.lengths, one.opening).worst, c = chance.uniform(0.2, 5);
    one.lengths = {c * one.lengths.VA, c * one.lengths.VB};
    one.style.width *= c;
    one.style.thickness *= c;
    EXPECT_NEAR(one.profile().at(one.lengths, one.opening).worst, before / c, 1e-10 * before / c);
  }
}

TEST(LoadError, HasExactDerivatives) {
  Chance chance(4);
  for (int i = 0; i < 300; ++i) {
    const Case one = random_pushed(chance);
    const LoadErrorProfile profile = one.profile({1e-6, 2e-6, 3e-6, 4e-6, 5e-6});
    const auto at = [&](const Eigen::Vector3d& x) {
      return profile.worst({one.lengths.VA * std::exp(x[0]), one.lengths.VB * std::exp(x[1])},
                           one.opening + x[2]);
    };
    const LoadErrorJet here = at(Eigen::Vector3d::Zero());
    const LoadErrorAt plain = profile.at(one.lengths, one.opening);
    EXPECT_NEAR(here.value, plain.worst, 1e-12 * plain.worst);
    const LoadErrorJet slopes = profile.worst(one.lengths, one.opening, false);
    EXPECT_NEAR(slopes.value, here.value, 1e-12 * here.value);
    EXPECT_LE((slopes.gradient - here.gradient).norm(), 1e-12 * here.gradient.norm());
    EXPECT_TRUE(slopes.hessian.isZero(0));
    if (plain.worst - plain.least < 0.02 * plain.worst) continue;  // near the kink of |D|
    constexpr double step = 1e-5;
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d along = step * Eigen::Vector3d::Unit(j);
      const LoadErrorJet ahead = at(along), behind = at(-along);
      EXPECT_NEAR((ahead.value - behind.value) / (2 * step), here.gradient[j],
                  1e-6 * (here.value + here.gradient.norm()));
      EXPECT_LT(((ahead.gradient - behind.gradient) / (2 * step) - here.hessian.col(j)).norm(),
                1e-5 * (here.value + here.hessian.norm()));
    }
  }
}

/// Force times speed at the hand is force times speed at the pen, and at pole and hand together nothing is left over.
TEST(LinkForces, DoNoWorkOnTheWay) {
  Chance chance(5);
  for (int i = 0; i < 300; ++i) {
    const Case one = random_pushed(chance);
    const Complex speed = std::polar(1.0, chance.uniform(-pi, pi)),
                  pen = std::polar(2.0, chance.uniform(-pi, pi));
    const Complex hand = -std::conj(one.k) * pen, pole = (std::conj(one.k) - 1.0) * pen;
    EXPECT_NEAR((std::conj(hand) * speed + std::conj(pen) * one.k * speed).real(), 0, 1e-12);
    EXPECT_NEAR(std::abs(hand + pole + pen), 0, 1e-12);
    EXPECT_NEAR(std::abs(hand), 2 * hand_force(one.k), 1e-12);
    EXPECT_NEAR(pin_forces(one.k, one.grounding, one.opening).pole, std::abs(pole) / 2, 1e-12);
  }
}

/// Each plate in equilibrium about its corner: the moments of C and X, or of C and Y, cancel; so do those of the straight plate's joints.
TEST(LinkForces, BalanceEachPlate) {
  Chance chance(6);
  for (int i = 0; i < 300; ++i) {
    const Case one = random_pushed(chance);
    const Complex s = shape_of(one.k, one.grounding);
    const LinkForces forces = link_forces(s, one.opening);
    const double scale = 1 + std::abs(s) + std::abs(forces.bar_VA);
    EXPECT_NEAR(std::abs(forces.C_of_ACX.across - forces.X.across / std::abs(s)), 0, 1e-12 * scale);
    EXPECT_NEAR(std::abs(forces.C_of_BCY.across + std::abs(s) * forces.Y.across), 0, 1e-12 * scale);
    if (!is_straight(s)) continue;
    EXPECT_NEAR(std::abs(forces.A.across + forces.C_of_ACX.across - s * forces.X.across / std::abs(s)), 0,
                1e-12 * scale);
  }
}

/// As the plates become straight with their corner at an end, two arms from the corner would be softer than the one beam that they are.
TEST(LoadError, TakesAStraightPlateAsOneBeam) {
  const auto at = [](double rotation) {
    return LoadErrorProfile(copy_ratio(0.4, rotation), Grounding::tracer, section(15, 5), steel, 50)
        .at({225, 135}, radians(40))
        .worst;
  };
  EXPECT_NEAR(at(0), 0.069455, 1e-6);
  EXPECT_GT(at(1e-6), 5 * at(0));
}

TEST(LoadError, OverAnIntervalIsThatOfItsWorstOpening) {
  Chance chance(7);
  for (int i = 0; i < 200; ++i) {
    const Case one = random_pushed(chance);
    const double side = one.opening > 0 ? 0 : -pi;
    const OpeningInterval openings{side + chance.uniform(0.1, 1), side + chance.uniform(1.5, pi - 0.1)};
    const LoadErrorProfile::Range range = one.profile().over(one.lengths, openings);
    double worst = 0, least = HUGE_VAL;
    for (int j = 0; j <= 2000; ++j) {
      const LoadErrorAt here = one.profile().at(one.lengths, openings.lower + openings.width() * j / 2000);
      worst = std::max(worst, here.worst);
      least = std::min(least, here.least);
    }
    EXPECT_GE(range.worst, worst * (1 - 1e-9));
    EXPECT_LE(range.worst, worst * (1 + 1e-4));
    EXPECT_EQ(one.profile().worst_over(one.lengths, openings), range.worst);
    EXPECT_LE(range.least, least + 1e-9 * worst);
    EXPECT_TRUE(openings.contains(range.worst_opening) && openings.contains(range.least_opening));
  }
}

/// A pin that gives adds its compliance times the square of what it bears.
TEST(LoadError, AddsWhatPinsGive) {
  Chance chance(8);
  for (int i = 0; i < 100; ++i) {
    const Case one = random_pushed(chance);
    const double c = 1e-3, rigid = one.profile().at(one.lengths, one.opening).worst;
    const PinForces pins = pin_forces(one.k, one.grounding, one.opening);
    const double by_A = one.profile({.A = c}).at(one.lengths, one.opening).worst - rigid;
    EXPECT_GE(by_A, -1e-12);
    EXPECT_LE(by_A, one.force * c * pins.A * pins.A * (1 + 1e-9));
    const double by_pole = one.profile({.pole = c}).at(one.lengths, one.opening).worst - rigid;
    EXPECT_GE(by_pole, -1e-12);
    EXPECT_NEAR(by_pole, one.force * c * pins.pole * pins.pole,
                1e-9 * (by_pole + rigid));  // the same in every direction
  }
}

/// Handbook figures: a pin of 8 mm between links of 5 mm, and a post that stands 2.5 mm or 7.5 mm out of the table.
TEST(PinCompliance, IsThatOfShortSteelBeams) {
  const LinkStyle style{.width = 15, .pin_diameter = 8, .thickness = 5};
  const double inertia = pi * 4096 / 64, area = pi * 16;
  const PinCompliance two_layers = pin_compliance(Grounding::pen, LayerAssignment{{1, 2, 2, 1}}, style, {});
  const double beside = 125 / (12 * 200000 * inertia) + 10 * 5 / (9 * 77000 * area);
  for (const double each : {two_layers.A, two_layers.B, two_layers.C, two_layers.V})
    EXPECT_NEAR(each, beside, 1e-12);
  EXPECT_NEAR(two_layers.pole, 421.875 / (3 * 200000 * inertia) + 75 / (9 * 77000 * area), 1e-12);
  const PinCompliance far = pin_compliance(Grounding::pole, LayerAssignment{{1, 4, 4, 1}}, style, {});
  EXPECT_NEAR(far.A, 3375 / (12 * 200000 * inertia) + 150 / (9 * 77000 * area), 1e-12);
}

TEST(LinkStresses, AreThoseOfABeam) {
  // Straight, corner between the joints: the arm A-X of 76.542 / 1.5 mm bears the tracer's force at its end.
  const LinkStyle style = section(15, 5);
  const Complex k = 0.4;
  const LinkStresses stress = link_stresses(k, Grounding::pen, style, 0, {91.784, 76.542}, radians(-90));
  const double moment_of_Y = std::abs(1.0 / (1.0 - shape_of(k, Grounding::pen))) * 1.5 * 91.784;
  EXPECT_NEAR(stress.BCY, moment_of_Y / (5 * 15.0 * 15 / 6), 0.05 * stress.BCY);
  const LinkStresses bored = link_stresses(k, Grounding::pen, style, 8, {91.784, 76.542}, radians(-90));
  EXPECT_GT(bored.largest(), stress.largest());
  EXPECT_EQ(link_stresses(k, Grounding::pen, style, 15, {91.784, 76.542}, radians(-90)).largest(), HUGE_VAL);
}

TEST(Buckling, IsEulers) {
  // 100 mm of 10 x 2 mm steel: pi^2 200000 (10 8 / 12) / 10000
  EXPECT_NEAR(buckling_load(section(10, 2), steel, 100), 1315.947, 1e-3);
}

}  // namespace
}  // namespace kempe
