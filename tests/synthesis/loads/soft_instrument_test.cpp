// Monte Carlo of instruments that are made within their tolerances, have play and give way under load, links and pins, each brought into balance
// by the general solver (soft_instrument.hpp): the error budget holds them all.
// The whole: KEMPE_SAMPLES=50 ... --gtest_filter='SoftInstrument.*' (docs/trust.md).
#include "tests/synthesis/loads/soft_instrument.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/samples.hpp"
#include "tests/synthesis/loads/soft_case.hpp"

namespace kempe {
namespace {

using soft_instrument::drawn_pen;
using soft_instrument::Play;
using soft_instrument::seen_sensitivities;
using soft_instrument::soft_case;
using soft_instrument::SoftCase;
using soft_instrument::SoftInstrument;
using soft_instrument::worst_flaws;
using wrong_instruments::Chance;
using wrong_instruments::Flaws;

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
