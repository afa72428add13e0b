// The bound's figures of angles and places against the same with eleven bits more (long double): every one must lie on the
// safe side of the truth, by however little.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "synthesis/bound/branch.hpp"
#include "synthesis/bound/copy_distance.hpp"
#include "synthesis/bound/copy_gap.hpp"
#include "synthesis/bound/joint_moves.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

using Exact = std::complex<long double>;
constexpr long double exact_pi = std::numbers::pi_v<long double>;

Exact exact(Complex z) { return {z.real(), z.imag()}; }
Exact exact(const Point& z) { return {z.x(), z.y()}; }

/// A random vector no longer than `most`.
Exact off_by(test::SpecDice& dice, double most) {
  const long double size = most * dice.uniform(0, 1);
  return size * std::polar(1.0L, static_cast<long double>(dice.uniform(-pi, pi)));
}

/// Where pole, tracer and pen are as seen from the pole, for a tracer at 1.
Exact place_of(Joint joint, const JointRoles& roles, Exact k) {
  return joint == roles.pole ? Exact(0) : joint == roles.tracer ? Exact(1) : k;
}

/// The shape from the ratio: V, X, Y form a triangle similar to (0, 1, s).
Exact exact_shape(Complex k, Grounding grounding) {
  const JointRoles roles = roles_of(grounding);
  const auto at = [&](Joint joint) { return place_of(joint, roles, exact(k)); };
  return (at(Joint::Y) - at(Joint::V)) / (at(Joint::X) - at(Joint::V));
}

/// |psi| at all dead and change points: psi = d - arg s with d one of 0, pi, arg s, arg s + pi.
std::array<long double, 4> exact_ends(Exact s) {
  const long double turn = std::abs(std::arg(s));
  return {0, exact_pi, turn, exact_pi - turn};
}

bounding::Branch branch_of(const Spec& spec, Grounding grounding, int number) {
  const auto modes = assembly_modes(shape_of(spec.copy.k(), grounding));
  return bounding::make_branch(spec, grounding, modes[static_cast<std::size_t>(number)], {});
}

TEST(StrictRounding, EndsOfTheOpeningsAreRoundedOutwards) {
  test::SpecDice dice(911);
  Spec spec = dice.spec();
  spec.limits.copy_error.reset();
  int compared = 0;
  for (int i = 0; i < test::samples(20'000); ++i) {
    const double scale = dice.log_uniform(0.05, 20);
    spec.copy = Copy::of(scale, dice.uniform(-pi, pi));
    if (std::abs(spec.copy.k() - 1.0) < 0.01) continue;
    const Grounding grounding = all_groundings[static_cast<std::size_t>(i) % 3];
    const auto ends = exact_ends(exact_shape(spec.copy.k(), grounding));
    const auto nearest = [&](double end) {
      return *std::min_element(ends.begin(), ends.end(), [&](long double one, long double other) {
        return std::abs(one - end) < std::abs(other - end);
      });
    };
    const auto count = assembly_modes(shape_of(spec.copy.k(), grounding)).size();
    for (std::size_t number = 0; number < count; ++number) {
      const auto mode = branch_of(spec, grounding, static_cast<int>(number)).mode;
      const long double far = nearest(mode.far_end), near = nearest(mode.near_end);
      if (near - far < 1e-6L) continue;
      ++compared;
      ASSERT_LE(mode.far_end, far) << spec.copy.k();
      ASSERT_GE(mode.near_end, std::min(near, static_cast<long double>(pi))) << spec.copy.k();
      ASSERT_NEAR(mode.far_end, static_cast<double>(far), 1e-13);
      ASSERT_NEAR(mode.near_end, static_cast<double>(near), 1e-13);
      const double limit = dice.uniform(0, 0.5) * static_cast<double>(near - far);
      const bounding::Range usable = mode.usable(limit);
      ASSERT_LE(usable.lower, far + limit);
      ASSERT_GE(usable.upper, std::min(near, static_cast<long double>(pi)) - limit);
    }
  }
  EXPECT_GT(compared, test::expected(30'000));
}

/// A design of a box by its figures, and where its joints are with the tracer at a place; all in long double.
struct ExactDesign {
  long double t, w;
  Exact pole;
};
std::array<Exact, 6> exact_joints(const ExactDesign& design, const bounding::ModeFacts& mode, Complex k,
                                  const Point& place, long double cosine) {
  const JointRoles roles = roles_of(mode.grounding);
  const Exact s = exact_shape(k, mode.grounding);
  const Exact e = std::polar(1.0L, static_cast<long double>(mode.bend) * std::acos(cosine));
  const long double a = std::sqrt(design.w / design.t / 2), b = std::sqrt(design.w * design.t / 2);
  const Exact p = a, q = s * b * e;  // q / s along psi
  std::array<Exact, 6> at;
  const auto put = [&](Joint joint, Exact z) { at[static_cast<std::size_t>(joint)] = z; };
  put(Joint::V, 0);
  put(Joint::A, p);
  put(Joint::B, q);
  put(Joint::C, p + q);
  put(Joint::X, p + q / s);
  put(Joint::Y, q + s * p);
  const Exact ground = at[static_cast<std::size_t>(roles.pole)];
  const Exact turn = (exact(place) - design.pole) / (at[static_cast<std::size_t>(roles.tracer)] - ground);
  for (Exact& z : at) z = design.pole + turn * (z - ground);
  return at;
}

/// cos psi of a design with the tracer at a place, by the law of cosines.
long double exact_cosine(const ExactDesign& design, const bounding::ModeFacts& mode, Complex k,
                         const Point& place) {
  const long double chain = mode.grounding == Grounding::pen ? std::abs(exact(k)) : 1.0L;
  const long double r = std::abs(exact(place) - design.pole) * chain;
  return r * r / design.w - (design.t + 1 / design.t) / 2;
}

/// How far beyond what a spread says a place is, along the worst of some directions, mm; at most 0 if it lies in it.
long double beyond(const bounding::JointSpread& spread, Exact at) {
  long double most = -INFINITY;
  for (int i = 0; i < 16; ++i) {
    const Exact across = std::polar(1.0L, i * exact_pi / 8);
    const auto along = [&](Exact z) { return (z * std::conj(across)).real(); };
    long double reach = spread.rest;
    for (const Complex& by : spread.by) reach += std::abs(along(exact(by)));
    most = std::max(most, along(at - exact(spread.middle)) - reach);
  }
  return most;
}

TEST(StrictRounding, NoJointOfABoxMovesFartherThanSaid) {
  test::SpecDice dice(912);
  Spec spec = dice.spec();
  spec.limits.copy_error.reset();
  int compared = 0, at_the_end = 0, spread_over = 0;
  for (int i = 0; i < test::samples(6000); ++i) {
    const double scale = dice.log_uniform(0.1, 10);
    const Complex k = copy_ratio(scale, dice.uniform(-pi, pi));
    if (std::abs(k - 1.0) < 0.05) continue;
    spec.copy = Copy::of(k);
    const Grounding grounding = all_groundings[static_cast<std::size_t>(i) % 3];
    const auto mode = branch_of(spec, grounding, 0).mode;
    const double t = dice.log_uniform(0.3, 3), w = dice.log_uniform(5e3, 5e5);
    const double grow = i % 4 == 0 ? 1 : 1 + std::pow(10, dice.uniform(-15, -2));
    const Point pole{dice.uniform(-50, 50), dice.uniform(-50, 50)};
    const bounding::DesignBox box{{{t / grow, t * grow}, {w / grow, w * grow}},
                                  pole,
                                  i % 4 == 0 ? 0 : std::pow(10, dice.uniform(-15, 0))};
    // A place at which the middle stands at some cos psi; every third time as near to -1 or 1 as doubles can say.
    const double wanted = i % 3 == 0 ? (1 - std::pow(10, dice.uniform(-15.5, -6))) * (i % 2 == 0 ? 1 : -1)
                                     : dice.uniform(-0.99, 0.99);
    const double chain = chain_length_per_tracer(k, grounding);
    const double r2 = box.w() * (wanted + (box.t() + 1 / box.t()) / 2);
    if (!(r2 > 0)) continue;
    const Point place = pole + std::sqrt(r2) / chain * as_point(std::polar(1.0, dice.uniform(-pi, pi)));
    const ExactDesign middle{box.t(), box.w(), exact(pole)};
    const long double middle_cosine = exact_cosine(middle, mode, k, place);
    if (!(std::abs(middle_cosine) < 1)) continue;
    std::array<Complex, 6> about;
    const auto joints = exact_joints(middle, mode, k, place, middle_cosine);
    std::transform(joints.begin(), joints.end(), about.begin(), [](Exact z) { return Complex(z); });
    const auto moves = bounding::joints_move_at_most(mode, box, place, about);
    if (!moves) continue;
    const JointRoles roles = roles_of(grounding);
    const Joint carrier = i % 2 == 0 ? roles.tracer : roles.pen;
    const auto c = static_cast<std::size_t>(carrier);
    const auto beside = bounding::joints_move_at_most(mode, box, place, about, carrier);
    ASSERT_TRUE(beside);
    const auto of_copy = bounding::copying_joints_move_at_most(mode, k, box, place, about);
    const auto of_copy_beside = bounding::copying_joints_move_at_most(mode, k, box, place, about, carrier);
    at_the_end += i % 3 == 0;
    const bounding::JointMoving moving(mode);
    const bounding::Range some =
        i % 2 == 0 ? bounding::Range{0, pi} : bounding::Range{dice.uniform(0, 1), dice.uniform(2, pi)};
    const auto spread = moving.spread(box, place, some),
               spread_beside = moving.spread(box, place, some, carrier);
    for (int n = 0; n < 6; ++n) {
      const ExactDesign one{n == 0   ? box.lengths.t.lower
                            : n == 1 ? box.lengths.t.upper
                                     : dice.uniform(box.lengths.t.lower, box.lengths.t.upper),
                            n == 0   ? box.lengths.w.upper
                            : n == 1 ? box.lengths.w.lower
                                     : dice.uniform(box.lengths.w.lower, box.lengths.w.upper),
                            exact(pole) + off_by(dice, box.radius)};
      const long double cosine = exact_cosine(one, mode, k, place);
      if (!(std::abs(cosine) <= 1)) continue;
      ++compared;
      const auto at = exact_joints(one, mode, k, place, cosine);
      for (std::size_t j = 0; j < 6; ++j)
        ASSERT_LE(std::abs(at[j] - exact(about[j])), (*moves)[j]) << i << " joint " << j;
      for (std::size_t j = 0; j < 6; ++j)
        ASSERT_LE(std::abs(at[j] - at[c] - (exact(about[j]) - exact(about[c]))), (*beside)[j])
            << i << " joint " << j << " from " << c;
      if (const long double psi = std::acos(cosine); spread && psi >= some.lower && psi <= some.upper) {
        ++spread_over;
        for (std::size_t j = 0; j < 6; ++j) {
          ASSERT_LE(beyond((*spread)[j], at[j]), 1e-18L * std::abs(at[j])) << i << " joint " << j;
          ASSERT_LE(beyond((*spread_beside)[j], at[j] - at[c]), 1e-18L * std::abs(at[j] - at[c]))
              << i << " joint " << j << " from " << c;
        }
      }
      for (const Joint joint : {roles.tracer, roles.pen}) {
        const auto j = static_cast<std::size_t>(joint);
        // The tracer's place is known exactly: what is left is the rounding of long doubles.
        const long double own = 1e-18L * (std::abs(exact(place)) + std::abs(one.pole) + std::abs(at[j]));
        ASSERT_LE(std::abs(at[j] - exact(about[j])), of_copy[j] + own) << i << " joint " << j;
        ASSERT_LE(std::abs(at[j] - at[c] - (exact(about[j]) - exact(about[c]))), of_copy_beside[j] + own)
            << i << " joint " << j << " from " << c;
      }
    }
  }
  EXPECT_GT(compared, test::expected(8'000));
  EXPECT_GT(at_the_end, test::expected(300));
  EXPECT_GT(spread_over, test::expected(6'000));
}

TEST(StrictRounding, DistancesHoldForPlacesThatAreOffByTheirRounding) {
  test::SpecDice dice(913);
  for (int i = 0; i < test::samples(2000); ++i) {
    const auto range = [&] {
      const double lower = dice.uniform(-100, 100);
      return bounding::Range{lower, i % 2 == 0 ? lower : lower + dice.uniform(0, 20)};
    };
    const bounding::Range x = range(), y = range();
    const Point far{dice.uniform(200, 400), dice.uniform(-100, 100)};
    const Point near{dice.uniform(120, 190), dice.uniform(-50, 50)};
    const double rounding = std::pow(10, dice.uniform(-12, -3));
    const bounding::Range distance = bounding::distance_from_box(far, rounding, x, y);
    const bounding::Spread spread = bounding::spread_over(far, near, rounding, x, y);
    const bounding::PoleDisc disc = bounding::disc_around(x, y);
    for (int n = 0; n < 8; ++n) {
      const Exact pole{n < 4 ? (n % 2 == 0 ? x.lower : x.upper) : dice.uniform(x.lower, x.upper),
                       n < 4 ? (n < 2 ? y.lower : y.upper) : dice.uniform(y.lower, y.upper)};
      const long double to_far = std::abs(exact(far) + off_by(dice, rounding) - pole);
      const long double to_near = std::abs(exact(near) + off_by(dice, rounding) - pole);
      ASSERT_LE(distance.lower, to_far);
      ASSERT_GE(distance.upper, to_far);
      ASSERT_LE(spread.ratio, std::max(1.0L, to_far / to_near));
      ASSERT_LE(spread.squares, to_far * to_far - to_near * to_near);
      ASSERT_GE(disc.radius, std::abs(pole - exact(disc.centre)));
    }
  }
}

/// Rectangles far from the frame's origin, and gaps a hair above or below the distance of the copy.
TEST(StrictRounding, SheetsAreTooNearExactlyWhereTheyAre) {
  test::SpecDice dice(921);
  int said = 0, apart = 0;
  for (int i = 0; i < test::samples(600); ++i) {
    const double away = std::pow(10, dice.uniform(2, 6)), k = dice.uniform(0.2, 0.8);
    const Point corner{away, dice.uniform(-1, 1)};
    Spec spec;
    const double x = corner.x(), y = corner.y();
    spec.region = Region{{{{{x, y}, {x + 20, y}, {x + 20, y + 10}, {x, y + 10}}, {}}}};
    spec.copy = Copy::of(k, 0);
    // The pole stands left of the region, on the table's own scale: the copy of its right end lies left of it.
    const Point pole = corner - Point(dice.uniform(200, 300) * k / (1 - k), -3);
    const long double right = x + 20, left = x;
    const long double distance = left - (pole.x() + static_cast<long double>(k) * (right - pole.x()));
    if (distance < 1) continue;
    const long double hair =
        64 * std::numeric_limits<double>::epsilon() * static_cast<long double>(away + 300);
    const RegionReach reach(spec.region);
    const auto verdict_at = [&](long double gap) {
      spec.limits.copy_gap = static_cast<double>(gap);
      return bounding::CopyGap(spec, reach).verdict(pole, 0);
    };
    ASSERT_EQ(verdict_at(distance + hair), bounding::CopyGap::Verdict::too_near) << i << " " << away;
    ASSERT_NE(verdict_at(distance - hair), bounding::CopyGap::Verdict::too_near) << i << " " << away;
    ++said;
    const double exactly = static_cast<double>(distance);
    apart += exactly <= distance && verdict_at(exactly) != bounding::CopyGap::Verdict::too_near;
    ASSERT_FALSE(exactly <= distance && verdict_at(exactly) == bounding::CopyGap::Verdict::too_near);
  }
  EXPECT_GT(said, test::expected(300));
  EXPECT_GT(apart, test::expected(100));
}

/// Ratios so near to 1 that the shape, 1 - k, is known to few digits: a length whose error moves the pen by |s| times itself, and
/// limits a hair above that. No opening exceeds them.
TEST(StrictRounding, OpeningsThatKeepTheLimitOnTheCopyErrorAreNotRuledOut) {
  test::SpecDice dice(931);
  int off = 0;
  for (int i = 0; i < test::samples(60); ++i) {
    const long double beyond = dice.log_uniform(1e-13, 1e-11), scale = 1 + beyond;
    CopyTolerance tolerance;
    tolerance.length[4] = 1;  // AX: |s| = k - 1 in all openings
    const CopyErrorProfile profile(static_cast<double>(scale), Grounding::tracer, tolerance);
    const OpeningInterval openings{radians(20), radians(160)};
    const double limit = static_cast<double>((scale - 1) * (1 + 1e-6L));
    const OpeningInterval left = profile.openings_not_ruled_out(limit, openings);
    EXPECT_EQ(left.lower, openings.lower) << i;
    EXPECT_EQ(left.upper, openings.upper) << i;
    off += profile.at(1).worst > limit * (1 + 1e-5);
  }
  EXPECT_GT(off, test::expected(5));  // there the doubles are above the limit
}

/// A copy that surely lies in the original overlaps it; where it only touches an edge, that is not said.
TEST(StrictRounding, ACopyIsInsideExactlyWhereItIs) {
  test::SpecDice dice(941);
  int said = 0, not_said = 0;
  for (int i = 0; i < test::samples(600); ++i) {
    const double away = std::pow(10, dice.uniform(2, 6)), k = dice.uniform(0.2, 0.8);
    const double x = std::round(away), height = dice.uniform(5, 10);
    const RegionReach reach(Region{{{{{x, 0}, {x + 20, 0}, {x + 20, 2 * height}, {x, 2 * height}}, {}}}});
    // The copy of the place comes to `into` mm beyond the left edge; poles nearer to it than that leave it inside.
    const double into = dice.log_uniform(1e-9, 1) * (i % 2 == 0 ? 1 : -1);
    const Point place(x + 20, height), pole((x + into - k * (x + 20)) / (1 - k), height);
    const long double reached =
        pole.x() + static_cast<long double>(k) * (static_cast<long double>(place.x()) - pole.x()) - x;
    const double radius = std::abs(into) * dice.uniform(0, 2);
    const bool inside = bounding::copy_surely_inside(k, place, reach, pole, radius);
    ASSERT_FALSE(inside && !(reached > (1 - static_cast<long double>(k)) * radius)) << i;
    (inside ? said : not_said) += 1;
    const long double hair =
        64 * std::numeric_limits<double>::epsilon() * static_cast<long double>(away + 300);
    ASSERT_TRUE(inside || !(reached > (1 - static_cast<long double>(k)) * radius + hair)) << i;
  }
  EXPECT_GT(said, test::expected(100));
  EXPECT_GT(not_said, test::expected(100));
}

}  // namespace
}  // namespace kempe
