#include "geometry/decompositions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

template class Eigen::JacobiSVD<Eigen::MatrixXd>;
template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
template class Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
template class Eigen::FullPivLU<Eigen::MatrixXd>;
template class Eigen::PartialPivLU<Eigen::MatrixXd>;

namespace kempe {
namespace {

/// The bidiagonal d0 e0 d1 e1 ... to which Householder's reflections bring a matrix that has no more columns than rows.
Eigen::VectorXd bidiagonal_of(Eigen::MatrixXd m) {
  const Eigen::Index n = m.cols();
  Eigen::VectorXd ends(2 * n - 1), scratch(m.rows());
  double tau = 0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index below = m.rows() - k - 1, beside = n - k - 1;
    m.col(k).tail(below + 1).makeHouseholderInPlace(tau, ends[2 * k]);
    if (beside == 0) break;
    m.bottomRightCorner(below + 1, beside)
        .applyHouseholderOnTheLeft(m.col(k).tail(below), tau, scratch.data());
    m.row(k).tail(beside).makeHouseholderInPlace(tau, ends[2 * k + 1]);
    m.bottomRightCorner(below, beside)
        .applyHouseholderOnTheRight(m.row(k).tail(beside - 1).transpose(), tau, scratch.data());
  }
  return ends;
}

}  // namespace

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix) { return matrix.inverse(); }

Eigen::VectorXd definite_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.ldlt().solve(right);
}

bool is_definite(const Eigen::MatrixXd& matrix) {
  return Eigen::LLT<Eigen::MatrixXd>(matrix).info() == Eigen::Success;
}

Eigen::VectorXd singular_values_of(const Eigen::MatrixXd& matrix) {
  const Eigen::Index n = std::min(matrix.rows(), matrix.cols());
  if (n == 0) return {};
  if (!matrix.allFinite()) return Eigen::VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
  const double scale = matrix.cwiseAbs().maxCoeff();
  if (scale == 0) return Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd tall = matrix / scale;  // what counts as nothing beside it is told of entries near 1
  if (tall.cols() > n) tall.transposeInPlace();
  // Golub and Kahan: a symmetric tridiagonal matrix with nothing on its diagonal and the bidiagonal beside it has the singular
  // values and their negatives as eigenvalues.
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> both_signs;
  both_signs.computeFromTridiagonal(Eigen::VectorXd::Zero(2 * n), bidiagonal_of(tall),
                                    Eigen::EigenvaluesOnly);
  return scale * both_signs.eigenvalues().tail(n).reverse().cwiseMax(0);
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
