// The bound of the bending, against the Jacobians themselves, under any weights.
#include "kinematics/planar/step_certificate.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/kinematics/planar/random_linkages.hpp"

namespace kempe {
namespace {

using test::Random;

Eigen::VectorXd random_change(Random& random, const StepCertificate& certificate, Eigen::Index size) {
  Eigen::VectorXd change(size);
  for (double& each : change) each = random.uniform(-1, 1);
  return change / certificate.length(change);
}

TEST(StepCertificate, BendingBoundsTheChangeOfTheJacobianUnderAnyWeights) {
  Random random(41);
  double sharpest = 0;
  for (int i = 0; i < 300; ++i) {
    PlanarLinkage linkage = test::four_bar(2, random.uniform(0.3, 1), 2, 2);
    if (i % 2) linkage.add(Coordinate{{3, random.point(1)}, {2, Point(0, 0)}, Point(0, 1), 0}, "slot");
    PlanarEquations equations(linkage);
    PlanarFactors factors(equations);
    const Eigen::VectorXd anchor = unknowns_of(test::random_position(random, 4, 2));
    const Eigen::Index square = anchor.size();
    Eigen::VectorXd f;
    Eigen::MatrixXd here, there;
    equations.residual_and_jacobian(anchor, f, here);
    factors.compute(here);
    StepCertificate certificate(equations);
    certificate.measure(equations, factors, anchor, anchor);
    if (i % 3) certificate.weigh_by(random_change(random, certificate, square));
    const double omega = certificate.bending();
    ASSERT_GT(omega, 0);
    for (int j = 0; j < 10; ++j) {
      const Eigen::VectorXd way = 0.4 * random.uniform(0, 1) * random_change(random, certificate, square),
                            along = random_change(random, certificate, square);
      equations.residual_and_jacobian(anchor + way, f, there);
      const Eigen::VectorXd changed =
          here.topRows(square).partialPivLu().solve((there - here).topRows(square) * along);
      const double bound = omega * certificate.length(way);
      EXPECT_LE(certificate.length(changed), bound * (1 + 1e-9) + 1e-12);
      sharpest = std::max(sharpest, certificate.length(changed) / bound);
    }
  }
  EXPECT_GT(sharpest, 0.3);  // a bound, and not an idle one
}

TEST(StepCertificate, AllowsNothingWithoutGainsAndLessFarFromThem) {
  Random random(42);
  const PlanarLinkage linkage = test::four_bar(2, 0.7, 2, 2);
  PlanarEquations equations(linkage);
  PlanarFactors factors(equations);
  StepCertificate certificate(equations);
  EXPECT_EQ(certificate.allowed(1e-3, 0), 0);
  const Eigen::VectorXd anchor = unknowns_of(test::random_position(random, 4, 2));
  Eigen::VectorXd f;
  Eigen::MatrixXd jacobian;
  equations.residual_and_jacobian(anchor, f, jacobian);
  factors.compute(jacobian);
  certificate.measure(equations, factors, anchor, anchor);
  const double at_once = certificate.allowed(10, 0);
  EXPECT_GT(at_once, 0);
  EXPECT_EQ(certificate.allowed(0.5 * at_once, 0), 0.5 * at_once);
  EXPECT_LT(certificate.allowed(10, 0.01), at_once);
  const Eigen::VectorXd change = random_change(random, certificate, anchor.size());
  certificate.stand_at(anchor + 0.1 / certificate.bending() * change);
  EXPECT_LT(certificate.allowed(10, 0), at_once);
  EXPECT_GT(certificate.allowed(10, 0), 0);
  certificate.stand_at(anchor + 0.5 / certificate.bending() * change);
  EXPECT_LT(certificate.bending(), 0);
  EXPECT_EQ(certificate.allowed(10, 0), 0);
}

}  // namespace
}  // namespace kempe
