#pragma once

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

// Eigen's decompositions of matrices of any size, compiled once, in decompositions.cpp: a file that instantiates one of them
// itself takes seconds more to compile. Who decomposes such a matrix includes this header instead of Eigen's.

extern template class Eigen::JacobiSVD<Eigen::MatrixXd>;
extern template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
extern template class Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
extern template class Eigen::FullPivLU<Eigen::MatrixXd>;
extern template class Eigen::PartialPivLU<Eigen::MatrixXd>;

namespace kempe {

/// The inverse, by elimination with partial pivoting.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix);
/// Of a symmetric positive definite system, by Cholesky's factors.
Eigen::VectorXd definite_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// True if a symmetric matrix is positive definite.
bool is_definite(const Eigen::MatrixXd& matrix);
/// In falling order, each to a rounding of the largest, from the bidiagonal form: of large matrices many times as fast as Jacobi's turns. Of a matrix
/// that is not finite they are not either.
Eigen::VectorXd singular_values_of(const Eigen::MatrixXd& matrix);
/// What `solve` of each decomposition gives.
Eigen::VectorXd solution_of(const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& matrix,
                            const Eigen::VectorXd& right);
Eigen::VectorXd solution_of(const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>& matrix,
                            const Eigen::VectorXd& right);
Eigen::VectorXd solution_of(const Eigen::FullPivLU<Eigen::MatrixXd>& matrix, const Eigen::VectorXd& right);

/// A square matrix, factored by elimination with partial pivoting.
class Elimination {
 public:
  explicit Elimination(const Eigen::MatrixXd& matrix) : factors_(matrix) {}
  Eigen::VectorXd solution(const Eigen::VectorXd& right) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace kempe
