// The factors of linkages' Jacobians against a dense decomposition that knows nothing of linkages.
#include "kinematics/planar/factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/kinematics/planar/random_linkages.hpp"

namespace kempe {
namespace {

using test::four_bar;
using test::Random;

/// A block on a slanting line of a turning arm, geared and racked to a crank; a bar of kept distance hangs on the
/// block. Two bodies are held by no joint.
PlanarLinkage slotted_arm() {
  PlanarLinkage linkage;
  const int crank = linkage.add_body("crank"), arm = linkage.add_body("arm"),
            block = linkage.add_body("block"), bob = linkage.add_particle("bob");
  linkage.add(Revolute{{0, Point(0, 0)}, {crank, Point(0, 0)}});
  linkage.add(Revolute{{arm, Point(0, 0)}, {0, Point(7, 1)}});
  linkage.add(Coordinate{{block, Point(0, 0)}, {arm, Point(0, 0)}, Point(0.6, 0.8), 0.5});
  linkage.add(RelativeAngle{block, arm, 0.3});
  linkage.add(Distance{{crank, Point(3, 0)}, {block, Point(0, 1)}, 4});
  linkage.add(Distance{{block, Point(2, 0)}, {bob, Point(0, 0)}, 5});
  linkage.add(Coordinate{{bob, Point(0, 0)}, {0, Point(0, 0)}, Point(0, 1), -3});
  linkage.add(GearPair{crank, block, arm, 2, 1, 0});
  linkage.add(RackAndPinion{{crank, Point(0, 0)}, {block, Point(0, 0)}, Point(1, 0), 2, 0});
  return linkage;
}

/// A chain of `bodies` bars, jointed end to end with both ends on the ground, its angles driven until it is square.
PlanarLinkage chain(Random& random, int bodies) {
  PlanarLinkage linkage;
  BodyPoint end{0, random.point(3)};
  for (int i = 0; i < bodies; ++i) {
    const int body = linkage.add_body();
    if (i % 2)
      linkage.add(Revolute{{body, random.point(3)}, end});
    else
      linkage.add(Revolute{end, {body, random.point(3)}});
    end = {body, random.point(3)};
  }
  linkage.add(Revolute{end, {0, random.point(3)}});
  for (int i = 2; i < bodies; ++i) linkage.drive(RelativeAngle{i, i - 1, 0});
  return linkage;
}

void expect_factors_of(const PlanarLinkage& linkage, Random& random, int reduced) {
  ASSERT_EQ(linkage.equation_count(), linkage.unknown_count());
  PlanarEquations equations(linkage);
  PlanarFactors factors(equations);
  EXPECT_EQ(factors.reduced_count(), reduced);
  Eigen::VectorXd f, solved, row;
  Eigen::MatrixXd jacobian;
  double first = 0;
  for (int i = 0; i < 50; ++i) {
    const Eigen::VectorXd q = unknowns_of(test::random_position(random, linkage.body_count(), 5));
    equations.residual_and_jacobian(q, f, jacobian);
    const Eigen::FullPivLU<Eigen::MatrixXd> dense(jacobian);
    if (dense.rcond() < 1e-6) continue;
    factors.compute(jacobian);
    factors.solve(f, solved);
    EXPECT_LT((jacobian * solved - f).norm(), 1e-13 * f.norm() / dense.rcond());
    const Eigen::MatrixXd inverse = dense.inverse();
    for (Eigen::Index unknown = 0; unknown < q.size(); ++unknown) {
      factors.inverse_row(unknown, row);
      EXPECT_LT((row.transpose() - inverse.row(unknown)).norm(), 1e-9 * inverse.norm());
    }
    const double sign = factors.sign() * (dense.determinant() < 0 ? -1 : 1);
    if (first == 0) first = sign;
    EXPECT_EQ(sign, first);
    Eigen::VectorXd in_place = f;
    factors.solve(in_place, in_place);
    EXPECT_EQ(in_place, solved);
  }
  EXPECT_NE(first, 0);
}

TEST(PlanarFactors, SolveFourBars) {
  Random random(21);
  for (int i = 0; i < 20; ++i)
    expect_factors_of(
        four_bar(random.uniform(1, 9), random.uniform(1, 9), random.uniform(1, 9), random.uniform(1, 9)),
        random, 3);
}

TEST(PlanarFactors, SolveChains) {
  Random random(22);
  for (int bodies = 2; bodies < 12; ++bodies) expect_factors_of(chain(random, bodies), random, bodies);
}

TEST(PlanarFactors, KeepThePlacesThatNoJointHolds) {
  Random random(23);
  expect_factors_of(slotted_arm(), random, 8);
}

TEST(PlanarFactors, SaySingularWhereTheCrankCannotBeDriven) {
  PlanarLinkage linkage;
  const int body = linkage.add_body();
  linkage.add(Revolute{{0, Point(0, 0)}, {body, Point(0, 0)}});
  linkage.drive(Coordinate{{body, Point(2, 0)}, {0, Point(0, 0)}, Point(1, 0), 2});
  PlanarEquations equations(linkage);
  PlanarFactors factors(equations);
  Eigen::VectorXd f, q = Eigen::VectorXd::Zero(3);
  Eigen::MatrixXd jacobian;
  equations.residual_and_jacobian(q, f, jacobian);
  factors.compute(jacobian);
  EXPECT_EQ(factors.sign(), 0);
}

}  // namespace
}  // namespace kempe
