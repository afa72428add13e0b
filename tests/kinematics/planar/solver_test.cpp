// A hundred thousand random linkages: closed to rounding, or honestly not at all.
#include "kinematics/planar/solver.hpp"

#include <gtest/gtest.h>

#include "kinematics/planar/assemblies.hpp"
#include "tests/kinematics/planar/random_linkages.hpp"
#include "tests/samples.hpp"

namespace kempe {
namespace {

using test::Random;

/// Tries a few first guesses.
std::optional<Assembled> close(const PlanarLinkage& linkage, const std::vector<double>& values,
                               Random& random, int tries) {
  for (int i = 0; i < tries; ++i)
    if (auto closed = solve_from(linkage, test::random_position(random, linkage.body_count(), 3), values))
      return *closed;
  return std::nullopt;
}

TEST(PlanarSolver, ClosesRandomFourBarsOrSaysThatTheyDoNotAssemble) {
  Random random(21);
  int closed_count = 0, open_count = 0;
  for (int i = 0; i < test::samples(100000); ++i) {
    const double d = random.logarithmic(0.1, 5), a = random.logarithmic(0.1, 5),
                 b = random.logarithmic(0.1, 5), c = random.logarithmic(0.1, 5),
                 crank = random.uniform(-pi, pi);
    const double between = (Point(a * std::cos(crank), a * std::sin(crank)) - Point(d, 0)).norm();
    const double margin =
        std::min(b + c - between, between - std::abs(b - c));  // the triangle's two conditions
    const PlanarLinkage linkage = test::four_bar(d, a, b, c);
    if (margin < 0) {
      ++open_count;
      const auto open = solve_from(linkage, test::random_position(random, 4, 3), {crank});
      ASSERT_FALSE(open);
      EXPECT_GT(open.error().closure_error, 0);
      EXPECT_FALSE(open.error().worst.empty());
      continue;
    }
    const auto closed = close(linkage, {crank}, random, margin > 1e-3 ? 4 : 12);
    ASSERT_TRUE(closed) << d << " " << a << " " << b << " " << c << " at " << crank << " margin " << margin;
    EXPECT_LT(closed->closure_error, 1e-12 * linkage.size());
    ++closed_count;
  }
  EXPECT_GT(closed_count, test::samples(10000));
  EXPECT_GT(open_count, test::samples(10000));
}

/// A four-bar whose coupler and rocker each carry a further point, joined by a dyad.
PlanarLinkage watt(Random& random, double crank_length) {
  PlanarLinkage linkage = test::four_bar(random.uniform(1.5, 2.5), crank_length, random.uniform(1.5, 2.5),
                                         random.uniform(1.5, 2.5));
  const int first = linkage.add_body("EG"), second = linkage.add_body("FG");
  const double e = random.uniform(0.5, 3), f = random.uniform(0.5, 3);
  linkage.add(Revolute{{2, random.point(2)}, {first, Point(0, 0)}}, "E");
  linkage.add(Revolute{{3, random.point(2)}, {second, Point(0, 0)}}, "F");
  linkage.add(Revolute{{first, Point(e, 0)}, {second, Point(f, 0)}}, "G");
  return linkage;
}

TEST(PlanarSolver, ClosesRandomWattSixBarsOrSaysThatTheyDoNotAssemble) {
  Random random(22);
  int closed_count = 0;
  for (int i = 0; i < test::samples(100000); ++i) {
    const double crank = random.uniform(-pi, pi);
    const PlanarLinkage linkage = watt(random, random.uniform(0.2, 1));
    const auto tried = solve_from(linkage, test::random_position(random, 6, 3), {crank});
    if (tried) {
      ++closed_count;
      EXPECT_LT(tried->closure_error, 1e-12 * linkage.size());
    } else {
      EXPECT_GT(tried.error().closure_error, closing_tolerance(linkage, tried.error().nearest));
    }
  }
  EXPECT_GT(closed_count, test::samples(50000));
}

TEST(PlanarSolver, RedundantEquationsDoNoHarm) {
  // A parallelogram with a third crank: one equation too many, closed all the same.
  PlanarLinkage linkage;
  int cranks[3];
  for (int& crank : cranks) crank = linkage.add_body("crank");
  const int bar = linkage.add_body("bar");
  for (int i = 0; i < 3; ++i) {
    linkage.add(Revolute{{0, Point(2.0 * i, 0)}, {cranks[i], Point(0, 0)}}, "foot");
    linkage.add(Revolute{{cranks[i], Point(1, 0)}, {bar, Point(2.0 * i, 0)}}, "head");
  }
  linkage.drive(RelativeAngle{cranks[0], 0, 0}, "crank");
  PlanarPosition guess(5);
  for (std::size_t i = 1; i <= 3; ++i) guess[i] = {Point(2.0 * static_cast<double>(i - 1), 0.1), 1.1};
  guess[4] = {Point(0.5, 0.8), 0.1};
  const auto closed = solve_from(linkage, guess, {1.0});
  ASSERT_TRUE(closed);
  EXPECT_LT((place(closed->position, {bar, Point(4, 0)}) - Point(4 + std::cos(1.0), std::sin(1.0))).norm(),
            1e-12);
}

TEST(PlanarSolver, SizesFromOneToAThousandCloseToTheSameShareOfTheSize) {
  Random random(23);
  for (const double unit : {1e-3, 1.0, 1e6})
    for (int i = 0; i < 200; ++i) {
      const double d = unit * 2, a = unit * random.logarithmic(2e-3, 1.9), b = unit * 2,
                   c = unit * random.uniform(1.95, 2.05);
      const PlanarLinkage linkage = test::four_bar(d, a, b, c);
      PlanarPosition guess = test::random_position(random, 4, 2 * unit);
      const auto closed = solve_from(linkage, guess, {random.uniform(-pi, pi)});
      ASSERT_TRUE(closed);
      EXPECT_LT(closed->closure_error, 1e-12 * linkage.size());
    }
}

TEST(PlanarSolver, WhatIsMissingIsTheRealDistance) {
  // A four-bar that cannot reach: coupler and rocker in line leave exactly this gap, wherever it is opened.
  Random random(24);
  int tried = 0;
  while (tried < test::samples(200)) {
    const double d = random.uniform(0.5, 5), a = random.uniform(0.5, 5), b = random.uniform(0.5, 2),
                 c = random.uniform(0.5, 2), crank = random.uniform(-pi, pi);
    const double between = (Point(a * std::cos(crank), a * std::sin(crank)) - Point(d, 0)).norm();
    const double gap = std::max(between - b - c, std::abs(b - c) - between);
    if (gap < 1e-6) continue;
    ++tried;
    const PlanarLinkage linkage = test::four_bar(d, a, b, c);
    const auto found =
        search_assembly_modes(linkage, test::random_position(random, 4, 3), {crank}, {40, 1, 64, {}});
    ASSERT_TRUE(found.assembly_modes.empty());
    const Missing missing = missing_at(linkage, found.nearest.value(), {crank});
    if (missing.gap.is_angle) continue;  // then the crank's angle is off, by what closes the gap
    EXPECT_NEAR(missing.gap.amount, gap, 1e-5 * linkage.size()) << d << " " << a << " " << b << " " << c;
  }
}

TEST(PlanarSolver, AnAngleIsMissingInRadians) {
  // Three slides at 0, 90 and 45 degrees that shall not turn: one of them is off by 45 degrees.
  PlanarLinkage linkage;
  const int a = linkage.add_body("a"), b = linkage.add_body("b");
  linkage.add(RelativeAngle{a, 0, 0}, "first");
  linkage.add(RelativeAngle{b, 0, pi / 2}, "second");
  linkage.add(RelativeAngle{b, a, pi / 4}, "third");
  const auto open = solve_from(linkage, PlanarPosition(3), {});
  ASSERT_FALSE(open);
  const Missing missing = missing_at(linkage, open.error(), {});
  EXPECT_TRUE(missing.gap.is_angle);
  EXPECT_NEAR(missing.gap.amount, pi / 4, 1e-6);
  EXPECT_EQ(missing.name, "first");
}

TEST(PlanarAssemblies, AFourBarHasTwoAndTheyAreMirrored) {
  const PlanarLinkage linkage = test::four_bar(2, 1, 2, 2);
  const auto found = find_assembly_modes(linkage, PlanarPosition(4), {0.7});
  ASSERT_EQ(found.size(), 2u);
  const Point B(std::cos(0.7), std::sin(0.7)), D(2, 0);
  const Point left = test::meet(B, 2, D, 2, 1), right = test::meet(B, 2, D, 2, -1);
  const Point first = place(found[0], {2, Point(2, 0)}), second = place(found[1], {2, Point(2, 0)});
  EXPECT_LT(std::min((first - left).norm() + (second - right).norm(),
                     (first - right).norm() + (second - left).norm()),
            1e-12);
  EXPECT_TRUE(find_assembly_modes(test::four_bar(9, 1, 2, 2), PlanarPosition(4), {0.7}).empty());
}

}  // namespace
}  // namespace kempe
