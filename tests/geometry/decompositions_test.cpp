#include "geometry/decompositions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>

#include "tests/random.hpp"

namespace kempe {
namespace {

Eigen::MatrixXd random_matrix(std::mt19937_64& random, Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd matrix(rows, columns);
  for (Eigen::Index i = 0; i < matrix.size(); ++i) matrix.data()[i] = test::uniform(random, -1, 1);
  return matrix;
}

/// Against Jacobi's turns: tall and wide, of any rank, at any size, with whole rows and columns of zeros.
TEST(SingularValues, AreThoseOfJacobisTurns) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 400; ++round) {
    const auto up_to = [&](int most) {
      return 1 + static_cast<Eigen::Index>(test::uniform(random, 0, most));
    };
    const Eigen::Index rows = up_to(30), columns = up_to(30), rank = up_to(30);
    Eigen::MatrixXd matrix = random_matrix(random, rows, rank) * random_matrix(random, rank, columns);
    if (round % 3 == 0) matrix.row(0).setZero();
    if (round % 4 == 0) matrix.col(columns / 2).setZero();
    if (round % 5 == 0) matrix *= std::pow(10, test::uniform(random, -140, 140));
    const Eigen::VectorXd found = singular_values_of(matrix);
    const Eigen::VectorXd wanted = Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
    ASSERT_EQ(found.size(), std::min(rows, columns));
    EXPECT_LE((found - wanted).cwiseAbs().maxCoeff(), 1e-13 * wanted[0]) << rows << " x " << columns;
    EXPECT_TRUE(std::is_sorted(found.data(), found.data() + found.size(), std::greater<>()));
    EXPECT_GE(found.minCoeff(), 0);
  }
}

TEST(SingularValues, OfNothingAndOfWhatIsNotFinite) {
  EXPECT_EQ(singular_values_of(Eigen::MatrixXd(0, 3)).size(), 0);
  EXPECT_EQ(singular_values_of(Eigen::MatrixXd::Zero(2, 3)), Eigen::VectorXd::Zero(2));
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(3, 3);
  EXPECT_TRUE(singular_values_of(matrix).isOnes(1e-15));
  matrix(1, 2) = HUGE_VAL;
  EXPECT_FALSE(singular_values_of(matrix).allFinite());
}

}  // namespace
}  // namespace kempe
