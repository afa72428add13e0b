// Monte Carlo of instruments that are made within their tolerances, have play and give way under load, links and pins, each brought into balance
// by the general solver (soft_instrument.hpp): the error budget holds them all.
// The whole: KEMPE_SAMPLES=50 ... --gtest_filter='SoftInstrument.*' (docs/trust.md).
#include "tests/synthesis/loads/soft_instrument.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "synthesis/design/error_budget.hpp"
#include "synthesis/loads/pin_compliance.hpp"
#include "tests/samples.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using soft_instrument::Play;
using soft_instrument::SoftInstrument;
using soft_instrument::Stuff;
using wrong_instruments::Chance;
using wrong_instruments::Flaws;

const Material soft_materials[] = {
    {"steel", 200e3, 7850, 235}, {"aluminium", 70e3, 2700, 150}, {"PLA", 3e3, 1240, 26}};

/// A design as far as the budget reads it, over a square, and the middle of that square.
struct SoftCase {
  Design design;
  Point middle;
  double half;  ///< mm, of the square's side

  Stuff stuff() const {
    return {design.style, design.material->E,
            pin_compliance(design.linkage.grounding(), design.layers, design.style, design.hardware)};
  }
};

/// Ratios, groundings, sections, layers and materials of every kind, one in four straight; well away from dead and change points. The force is such that
/// the links alone give way by a tenth of a millimetre or so.
SoftCase soft_case(Chance& chance) {
  for (;;) {
    const double rotation =
        chance.one_in(4) ? pi * static_cast<double>(chance.below(2)) : chance.uniform(-pi, pi);
    const Complex k = copy_ratio(std::exp(chance.uniform(-1.2, 1.2)), rotation);
    const Grounding grounding = all_groundings[chance.below(3)];
    const Complex s = shape_of(k, grounding);
    // A plate that is nearly flat but not quite is toleranced by lengths that say little (docs/tolerance.md).
    const double flatness = std::abs(s.imag()) / std::max({1.0, std::abs(s), std::abs(s - 1.0)});
    if (std::abs(k - 1.0) < 0.3 || (!is_straight(s) && flatness < 0.3)) continue;
    const auto modes = assembly_modes(s);
    const auto& mode = modes[chance.below(modes.size())];
    if (mode.openings.width() < radians(80)) continue;
    const auto linkage =
        CopyingLinkage::make(k, grounding, chance.uniform(90, 250), chance.uniform(90, 250), mode.number,
                             {chance.uniform(-50, 50), chance.uniform(-50, 50)});
    const double opening =
        chance.uniform(mode.openings.lower + radians(35), mode.openings.upper - radians(35));
    const Point middle = linkage->tracer_at(opening, chance.uniform(-pi, pi));
    const double half = 0.04 * (middle - linkage->pole()).norm();
    if (!openings_over(*linkage, wrong_instruments::square_about(middle, half))) continue;
    SoftCase result{{.linkage = *linkage}, middle, half};
    Design& design = result.design;
    design.scale = std::abs(k);
    design.rotation = std::arg(k);
    design.region = wrong_instruments::square_about(middle, half);
    design.style.width = chance.uniform(12, 25);
    design.style.thickness = chance.uniform(3, 8);
    design.style.pin_diameter = chance.uniform(4, 8);
    const auto assignments = layer_assignments(2 + static_cast<int>(chance.below(2)));
    design.layers = assignments[chance.below(assignments.size())];
    design.material = soft_materials[chance.below(3)];
    design.tolerance = Tolerance{chance.uniform(0.01, 0.05), chance.uniform(0.01, 0.05)};
    const double for_each_newton = LoadErrorProfile(k, grounding, design.style, *design.material, 1)
                                       .at({linkage->VA(), linkage->VB()}, opening)
                                       .worst;
    design.load = Load{.pen_force = chance.uniform(0.03, 0.2) / for_each_newton};
    return result;
  }
}

Point drawn_pen(const CopyingLinkage& linkage, const Point& tracer) {
  return linkage.pole() + as_point(linkage.k() * as_complex(Point(tracer - linkage.pole())));
}

/// The pen's displacement by a unit of each source, by differences of instruments that do not give way.
struct SeenSensitivities {
  std::array<Point, 8> length;
  std::array<std::array<Point, 2>, 5> pin;
};
std::optional<SeenSensitivities> seen_sensitivities(const SoftCase& of, const Point& tracer) {
  constexpr double step = 1e-3;
  const auto moved = [&](const auto& set) -> std::optional<Point> {
    std::array<Point, 2> pens;
    for (int side = 0; side < 2; ++side) {
      Flaws flaws;
      set(flaws, side == 0 ? -step : step);
      const auto pen = SoftInstrument(of.design.linkage, of.stuff(), flaws, {0, false}).pen(tracer, {0, 0});
      if (!pen) return std::nullopt;
      pens[static_cast<std::size_t>(side)] = *pen;
    }
    return Point((pens[1] - pens[0]) / (2 * step));
  };
  SeenSensitivities seen;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto way = moved([&](Flaws& flaws, double size) { flaws.length[i] = size; });
    if (!way) return std::nullopt;
    seen.length[i] = *way;
  }
  for (std::size_t i = 0; i < 5; ++i)
    for (int axis = 0; axis < 2; ++axis) {
      const auto way = moved([&](Flaws& flaws, double size) { flaws.pin[i][axis] = size; });
      if (!way) return std::nullopt;
      seen.pin[i][static_cast<std::size_t>(axis)] = *way;
    }
  return seen;
}

/// Lengths and play that move the pen farthest along `way`.
Flaws worst_flaws(const SeenSensitivities& seen, const Tolerance& tolerance, const Point& way) {
  Flaws flaws;
  for (std::size_t i = 0; i < 8; ++i)
    flaws.length[i] = std::copysign(tolerance.length, seen.length[i].dot(way));
  for (std::size_t i = 0; i < 5; ++i) {
    const Point slope{seen.pin[i][0].dot(way), seen.pin[i][1].dot(way)};
    if (slope.norm() > 0) flaws.pin[i] = 0.5 * tolerance.play / slope.norm() * slope;
  }
  return flaws;
}

TEST(SoftInstrument, GivesWayAsTheProfileSays) {
  Chance chance(51);
  double largest = 0, of_pins = 0;
  for (int i = 0; i < test::samples(60); ++i) {
    SCOPED_TRACE(i);
    const SoftCase one = soft_case(chance);
    const CopyingLinkage& linkage = one.design.linkage;
    const LoadErrorProfile profile(linkage.k(), linkage.grounding(), one.design.style, *one.design.material,
                                   1, one.stuff().pins);
    const Point force = chance.on_circle(1e-3 * one.design.load->pen_force);
    const auto pen = SoftInstrument(linkage, one.stuff(), {}, {0, false}).pen(one.middle, force);
    ASSERT_TRUE(pen);
    const Pose pose = linkage.pose_with_tracer_at(one.middle).value();
    const double opening = linkage.opening_at((one.middle - linkage.pole()).norm()).value();
    const Complex bar = std::polar(1.0, wrong_instruments::heading(pose.V, pose.A));
    const Complex said =
        bar * profile.displacement({linkage.VA(), linkage.VB()}, opening, as_complex(force) * std::conj(bar));
    const Complex seen = as_complex(Point(*pen - drawn_pen(linkage, one.middle)));
    largest = std::max(largest, std::abs(said - seen) / std::abs(said));
    const auto rigid_pins =
        SoftInstrument(linkage, {one.design.style, one.design.material->E, {}}, {}, {0, false})
            .pen(one.middle, force);
    ASSERT_TRUE(rigid_pins);
    of_pins = std::max(of_pins, (*pen - *rigid_pins).norm() / std::abs(said));
  }
  EXPECT_LT(largest, 1e-3);
  EXPECT_GT(of_pins, test::shortened() ? 0 : 0.05);
  std::printf("largest relative difference %.2g; pins give up to %.2g of it\n", largest, of_pins);
}

TEST(SoftInstrument, TheBudgetHoldsEveryMadeAndLoadedOne) {
  constexpr int instruments = 20;
  Chance chance(52);
  double random_sum = 0, worst_sum = 0, random_course = 0, worst_course = 0;
  int made = 0, designs = 0;
  for (int i = 0; i < test::samples(12); ++i) {
    SCOPED_TRACE(i);
    const SoftCase one = soft_case(chance);
    const CopyingLinkage& linkage = one.design.linkage;
    const Tolerance& tolerance = *one.design.tolerance;
    const auto budget = error_budget(one.design);
    ASSERT_TRUE(budget);
    double sum = 0;  // the instruments' links lie in one plane
    for (const BudgetEntry& entry : budget->entries)
      if (is_in_plane(entry.source) && entry.source != ErrorSource::layers) sum += entry.error;
    const CopyErrorProfile copy = copy_error_profile(linkage, CopyTolerance::uniform(tolerance));
    const LoadErrorProfile give(linkage.k(), linkage.grounding(), one.design.style, *one.design.material,
                                one.design.load->pen_force, one.stuff().pins);
    ++designs;
    for (int n = 0; n < instruments; ++n) {
      const bool is_worst = n % 10 == 0;
      const Point tracer = one.middle + one.half * Point(chance.uniform(-1, 1), chance.uniform(-1, 1));
      const Point drawn = drawn_pen(linkage, tracer);
      Point force = chance.on_circle(one.design.load->pen_force);
      Flaws flaws;
      Play play{0.5 * tolerance.play, chance.one_in(2)};
      if (is_worst) {
        // The force that it gives way to most, and what is wrong with it all the same way.
        const SoftInstrument right(linkage, one.stuff(), {}, {0, false});
        Point way = Point::Zero();
        for (int step = 0; step < 18; ++step) {
          const Point turned = as_point(std::polar(one.design.load->pen_force, pi * step / 18));
          const auto pen = right.pen(tracer, turned);
          ASSERT_TRUE(pen);
          if ((*pen - drawn).norm() <= way.norm()) continue;
          way = *pen - drawn;
          force = turned;
        }
        const auto seen = seen_sensitivities(one, tracer);
        ASSERT_TRUE(seen);
        flaws = worst_flaws(*seen, tolerance, way.normalized());
        play.is_pressed = false;
      } else {
        const bool at_limits = chance.one_in(2);
        for (double& length : flaws.length)
          length = tolerance.length * (at_limits ? chance.sign() : chance.uniform(-1, 1));
        for (Point& pin : flaws.pin) pin = chance.in_disc(0.5 * tolerance.play);
      }
      const auto pen = SoftInstrument(linkage, one.stuff(), flaws, play).pen(tracer, force);
      ASSERT_TRUE(pen);
      ++made;
      const double error = (*pen - drawn).norm();
      const double opening = linkage.opening_at((tracer - linkage.pole()).norm()).value();
      const double there = copy.at(opening).worst + give.at({linkage.VA(), linkage.VB()}, opening).worst;
      (is_worst ? worst_sum : random_sum) = std::max(is_worst ? worst_sum : random_sum, error / sum);
      (is_worst ? worst_course : random_course) =
          std::max(is_worst ? worst_course : random_course, error / there);
      EXPECT_LT(error, sum);
      EXPECT_LT(error, (is_worst ? 1.02 : 1) * there);  // of first order in what is wrong
    }
  }
  EXPECT_GT(worst_course, test::shortened() ? 0 : 0.9);
  std::printf(
      "%d instruments of %d designs; of the budget random ones reach %.4g, the worst ones %.4g; of the "
      "budget at their opening %.4g, %.4g\n",
      made, designs, random_sum, worst_sum, random_course, worst_course);
}

}  // namespace
}  // namespace kempe
