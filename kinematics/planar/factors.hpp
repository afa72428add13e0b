#pragma once
// Factors of a linkage's square Jacobian. Places are eliminated first: a revolute joint A = B holds the place of one
// body against that of the other with coefficients +1 and -1, so along a tree of joints from the ground outward the
// places follow from the angles by sums alone, exactly regular and without pivoting. What is left, about one
// unknown a body instead of three, is factored with pivots (LU):
//
//   J = [P Q; R S]  (rows and columns reordered),  P unit triangular up to signs
//   T = P^-1 Q,  S' = S - R T,  det J = +-det S'

#include <Eigen/Core>
#include <vector>

#include "kinematics/planar/equations.hpp"

namespace kempe {

/// Solves with the top square part of a linkage's Jacobian. The elimination's order belongs to the equations it was
/// made for; keeps room for its work: one object a thread.
class PlanarFactors {
 public:
  PlanarFactors() = default;

  /// The order for these equations, whose top rows are the square part.
  explicit PlanarFactors(const PlanarEquations& equations);

  /// Unknowns left after the places are eliminated.
  int reduced_count() const { return static_cast<int>(kept_.size()); }

  /// Factors the top square part of a Jacobian of the equations.
  void compute(const Eigen::MatrixXd& jacobian);

  /// J^-1 right; `result` gets its size and may be `right` itself.
  void solve(const Eigen::VectorXd& right, Eigen::VectorXd& result);

  /// A row of J^-1 (what one unknown owes to each row of the right side), by solving with J transposed.
  void inverse_row(Eigen::Index unknown, Eigen::VectorXd& result);

  /// +1 or -1, whose product with det J has the same sign for every Jacobian of these equations; 0 if J is singular to
  /// rounding or not finite.
  int sign() const { return sign_; }

 private:
  struct Row {
    int row;
    int column;                ///< eliminated by this row; -1: none
    std::vector<int> earlier;  ///< numbers of eliminated columns that the row may hold besides
  };
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  void choose_order(const PlanarEquations& equations);
  void factor_reduced();
  void solve_reduced(Eigen::VectorXd& x) const;
  void solve_reduced_transposed(Eigen::VectorXd& x) const;

  std::vector<Row> pivots_;  ///< in the order of elimination
  std::vector<Row> others_;  ///< the rows of S
  std::vector<int> kept_;    ///< columns of S
  std::vector<int> number_;  ///< of each column: -1 - its place among those kept, or its pivot's number
  Eigen::VectorXd pivot_;    ///< +1 or -1
  std::vector<std::vector<double>> below_pivot_, below_;  ///< values at `earlier`
  RowMajor eliminated_;                                   ///< T
  RowMajor reduced_;                                      ///< L and U of S', the diagonal of U inverted
  std::vector<Eigen::Index> exchanged_;                   ///< row exchanged with the k-th at its step
  Eigen::VectorXd place_, left_;
  int sign_ = 1;
};

}  // namespace kempe
