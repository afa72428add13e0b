// Derivatives and bends of every constraint, against differences.
#include "kinematics/planar/equations.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/kinematics/planar/random_linkages.hpp"

namespace kempe {
namespace {

using test::Random;

/// One constraint of each kind between random points of three bodies and the ground.
PlanarLinkage one_of_each(Random& random) {
  PlanarLinkage linkage;
  for (int i = 0; i < 3; ++i) linkage.add_body("body");
  const auto point = [&] { return BodyPoint{random.below(4), random.point(3)}; };
  const auto other_than = [&](int body) {
    return BodyPoint{(body + 1 + random.below(3)) % 4, random.point(3)};
  };
  const auto direction = [&] {
    const double angle = random.uniform(-pi, pi);
    return Point(std::cos(angle), std::sin(angle));
  };
  const BodyPoint a = point(), b = point(), c = point(), d = point();
  linkage.add(Revolute{a, other_than(a.body)}, "revolute");
  linkage.add(Coordinate{b, other_than(b.body), direction(), random.uniform(-2, 2)}, "coordinate");
  linkage.add(Distance{c, other_than(c.body), random.uniform(0.5, 4)}, "distance");
  linkage.add(RelativeAngle{1, 2, random.uniform(-1, 1)}, "angle");
  linkage.add(GearPair{1, 2, 3, random.uniform(0.5, 2), random.uniform(-2, -0.5), 0.3}, "gears");
  linkage.add(RackAndPinion{d, other_than(d.body), direction(), random.uniform(0.5, 2), 0.1}, "rack");
  return linkage;
}

Eigen::VectorXd random_way(Random& random, Eigen::Index size) {
  Eigen::VectorXd way(size);
  for (double& entry : way) entry = random.uniform(-1, 1);
  return way;
}

TEST(PlanarEquations, JacobianAndSecondDerivativeAgreeWithDifferences) {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const PlanarLinkage linkage = one_of_each(random);
    PlanarEquations equations(linkage);
    const Eigen::VectorXd q = unknowns_of(test::random_position(random, 4, 4)),
                          way = random_way(random, q.size());
    Eigen::VectorXd f, ahead, behind, second;
    Eigen::MatrixXd jacobian;
    equations.residual_and_jacobian(q, f, jacobian);
    const double h = 1e-4;
    equations.residual(q + h * way, ahead);
    equations.residual(q - h * way, behind);
    EXPECT_LT((jacobian * way - (ahead - behind) / (2 * h)).norm(), 1e-6 * (1 + jacobian.norm()));
    equations.second_derivative(q, way, second);
    EXPECT_LT((second - (ahead - 2 * f + behind) / (h * h)).norm(), 1e-4 * (1 + jacobian.norm()));
  }
}

/// The step control's norm: largest turn and largest shift in sizes.
double norm_of(const Eigen::VectorXd& way, double size) {
  double norm = 0;
  for (Eigen::Index x = 0; x < way.size(); x += 3)
    norm = std::max({norm, std::abs(way[x + 2]), way.segment<2>(x).norm() / size});
  return norm;
}

TEST(PlanarEquations, BendsBoundTheSecondDerivativeInTheWholeBall) {
  Random random(12);
  double sharpest = 0;
  for (int i = 0; i < 2000; ++i) {
    const PlanarLinkage linkage = one_of_each(random);
    PlanarEquations equations(linkage);
    const Eigen::VectorXd q = unknowns_of(test::random_position(random, 4, 4));
    std::vector<PlanarEquations::Bend> bends;
    equations.bends(q, bends);
    Eigen::VectorXd shift = random_way(random, q.size()), way = random_way(random, q.size()), second;
    for (Eigen::Index x = 0; x < q.size(); ++x)
      if (x % 3 != 2) shift[x] *= equations.size(), way[x] *= equations.size();
    shift *= 0.5 / norm_of(shift, equations.size());
    way /= norm_of(way, equations.size());
    equations.second_derivative(q + shift, way, second);
    std::map<std::pair<int, int>, double> bounds;  // by row and second row
    for (const auto& bend : bends) {
      const double turn = bend.body > 0 ? way[3 * bend.body - 1] : 1;
      bounds[{bend.row, bend.second_row}] += bend.bound * turn * turn;
    }
    for (const auto& [rows, bound] : bounds) {
      const double other = rows.second >= 0 ? second[rows.second] : 0;
      const double value = std::hypot(second[rows.first], other);
      EXPECT_LE(value, bound * (1 + 1e-12));
      sharpest = std::max(sharpest, value / bound);
      second[rows.first] = 0;
      if (rows.second >= 0) second[rows.second] = 0;
    }
    EXPECT_EQ(second.lpNorm<Eigen::Infinity>(), 0);  // what has no bend is linear
  }
  EXPECT_GT(sharpest, 0.3);  // a bound, and not an idle one
}

TEST(PlanarEquations, ReorderingRowsMovesThemAndNothingElse) {
  Random random(13);
  const PlanarLinkage linkage = one_of_each(random);
  PlanarEquations plain(linkage), reversed(linkage);
  std::vector<int> place;
  for (int row = 0; row < plain.row_count(); ++row) place.push_back(plain.row_count() - 1 - row);
  reversed.reorder(place);
  const Eigen::VectorXd q = unknowns_of(test::random_position(random, 4, 4));
  Eigen::VectorXd f, g;
  Eigen::MatrixXd j, k;
  plain.residual_and_jacobian(q, f, j);
  reversed.residual_and_jacobian(q, g, k);
  EXPECT_EQ(f, Eigen::VectorXd(g.reverse()));
  EXPECT_EQ(j, Eigen::MatrixXd(k.colwise().reverse()));
}

TEST(PlanarEquations, ClosureErrorMeasuresLengthsByItself) {
  PlanarLinkage linkage;
  const int body = linkage.add_body("body"), particle = linkage.add_particle("P");
  linkage.add(Distance{{body, Point(3, 4)}, {particle, Point(0, 0)}, 2}, "bar");
  PlanarPosition position(3);
  position[1] = {Point(1, 1), 0};
  position[2] = {Point(4, 8), 0};
  EXPECT_NEAR(closure_error(linkage, position, {}).largest, 1, 1e-15);  // 3 apart where 2 is asked
  EXPECT_EQ(
      linkage.constraints()[static_cast<std::size_t>(closure_error(linkage, position, {}).constraint)].name,
      "bar");
}

}  // namespace
}  // namespace kempe
