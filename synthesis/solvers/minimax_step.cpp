// The dual: maximise sum_r y_r v_r with sum_r y_r a_r = 0, sum of the figures' y = 1, y >= 0, where row r is
// v_r + a_r . d <= t or 0. A basis of n + 1 rows gives (d, t); the most violated row enters, the ratio test
// says which leaves.

#include "synthesis/solvers/minimax_step.hpp"

#include <vector>

#include "geometry/decompositions.hpp"
#include "synthesis/solvers/slack.hpp"

namespace kempe {
namespace {

constexpr int most_pivots = 500;

class DualSimplex {
 public:
  explicit DualSimplex(const MinimaxProgram& program)
      : program_(program), n_(program.figure_slopes.cols()), figures_(program.figures.size()),
        limits_(program.limits.size()) {
    rows_.resize(figures_ + limits_ + 2 * n_, n_ + 1);
    values_.resize(rows_.rows());
    rows_.setZero();
    rows_.topLeftCorner(figures_, n_) = program.figure_slopes;
    rows_.topRightCorner(figures_, 1).setConstant(1);  // the multipliers' sum
    values_.head(figures_) = program.figures;
    if (limits_ > 0) {
      rows_.block(figures_, 0, limits_, n_) = program.limit_slopes;
      values_.segment(figures_, limits_) = program.limits;
    }
    for (Eigen::Index j = 0; j < n_; ++j)
      for (int side = 0; side < 2; ++side) {
        const Eigen::Index row = figures_ + limits_ + 2 * j + side;
        rows_(row, j) = side == 0 ? 1 : -1;
        values_[row] = -program.box;
      }
  }

  std::optional<MinimaxStep> solve() {
    start();
    for (int pivot = 0; pivot < most_pivots; ++pivot) {
      const Eigen::MatrixXd basis = rows_(basis_, Eigen::all);
      const Eigen::FullPivLU<Eigen::MatrixXd> lu(basis);
      if (!lu.isInvertible()) return std::nullopt;
      // row . d - t = -value for figures, row . d = -value else: unknowns (d, -t).
      const Eigen::VectorXd at = solution_of(lu, -values_(basis_));
      const Eigen::VectorXd violation = values_ + rows_ * at;
      Eigen::Index entering = 0;
      const double scale = program_.figures.cwiseAbs().maxCoeff();
      if (violation.maxCoeff(&entering) <= slack::row_rounding * scale) return described(at);
      if (!exchange(lu, entering)) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  /// The highest figure, and on each axis the side of the box that its slope runs against.
  void start() {
    Eigen::Index highest = 0;
    program_.figures.maxCoeff(&highest);
    basis_ = {highest};
    y_.resize(n_ + 1);
    y_[0] = 1;
    for (Eigen::Index j = 0; j < n_; ++j) {
      const double slope = program_.figure_slopes(highest, j);
      basis_.push_back(figures_ + limits_ + 2 * j + (slope > 0 ? 1 : 0));
      y_[j + 1] = std::abs(slope);
    }
  }

  /// Lets a row enter the basis; false if nothing bounds its multiplier (the limits contradict each other).
  bool exchange(const Eigen::FullPivLU<Eigen::MatrixXd>& lu, Eigen::Index entering) {
    const Eigen::VectorXd fall = lu.inverse().transpose() * rows_.row(entering).transpose();
    Eigen::Index leaving = -1;
    double least = 0;
    for (Eigen::Index i = 0; i <= n_; ++i) {
      if (!(fall[i] > slack::fall_rounding)) continue;
      const double ratio = std::max(0.0, y_[i]) / fall[i];
      if (leaving < 0 || ratio < least || (ratio == least && basis_[at(i)] < basis_[at(leaving)])) {
        leaving = i;
        least = ratio;
      }
    }
    if (leaving < 0) return false;
    y_ -= least * fall;
    y_[leaving] = least;
    basis_[at(leaving)] = entering;
    return true;
  }

  static std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

  MinimaxStep described(const Eigen::VectorXd& solution) const {
    MinimaxStep step{solution.head(n_), -solution[n_], Eigen::VectorXd::Zero(figures_),
                     Eigen::VectorXd::Zero(limits_)};
    for (Eigen::Index i = 0; i <= n_; ++i) {
      const Eigen::Index row = basis_[at(i)];
      const double multiplier = std::max(0.0, y_[i]);
      if (row < figures_)
        step.figure_multipliers[row] = multiplier;
      else if (row < figures_ + limits_)
        step.limit_multipliers[row - figures_] = multiplier;
      else
        step.at_box = step.at_box || multiplier > 0;
    }
    return step;
  }

  const MinimaxProgram& program_;
  Eigen::Index n_, figures_, limits_;
  Eigen::MatrixXd rows_;
  Eigen::VectorXd values_, y_;
  std::vector<Eigen::Index> basis_;
};

}  // namespace

std::optional<MinimaxStep> solve_minimax_step(const MinimaxProgram& program) {
  if (program.figures.size() == 0) return std::nullopt;
  return DualSimplex(program).solve();
}

}  // namespace kempe
