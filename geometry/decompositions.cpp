#include "geometry/decompositions.hpp"

#include <Eigen/Cholesky>

template class Eigen::JacobiSVD<Eigen::MatrixXd>;
template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
template class Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
template class Eigen::FullPivLU<Eigen::MatrixXd>;
template class Eigen::PartialPivLU<Eigen::MatrixXd>;

namespace kempe {

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix) { return matrix.inverse(); }

Eigen::VectorXd definite_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.ldlt().solve(right);
}

bool is_definite(const Eigen::MatrixXd& matrix) {
  return Eigen::LLT<Eigen::MatrixXd>(matrix).info() == Eigen::Success;
}

Eigen::VectorXd singular_values_of(const Eigen::MatrixXd& matrix) {
  return Eigen::BDCSVD<Eigen::MatrixXd>(matrix).singularValues();
}

Eigen::VectorXd solution_of(const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& matrix,
                            const Eigen::VectorXd& right) {
  return matrix.solve(right);
}

Eigen::VectorXd solution_of(const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>& matrix,
                            const Eigen::VectorXd& right) {
  return matrix.solve(right);
}

Eigen::VectorXd solution_of(const Eigen::FullPivLU<Eigen::MatrixXd>& matrix, const Eigen::VectorXd& right) {
  return matrix.solve(right);
}

Eigen::VectorXd Elimination::solution(const Eigen::VectorXd& right) const { return factors_.solve(right); }

}  // namespace kempe
