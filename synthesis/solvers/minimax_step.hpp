#pragma once
// One step of a sequential minimax: the linear program whose solution lowers the largest of several
// linearised figures within limits and a box.

#include <Eigen/Core>
#include <optional>

namespace kempe {

/// minimise t  with  value + slope . d <= t   (figures)
///                   value + slope . d <= 0   (limits)
///                   |d_j| <= box             (every unknown)
struct MinimaxProgram {
  Eigen::MatrixXd figure_slopes, limit_slopes;  ///< a row each
  Eigen::VectorXd figures, limits;
  double box = 1;  ///< > 0
};

struct MinimaxStep {
  Eigen::VectorXd d;
  double t = 0;
  Eigen::VectorXd figure_multipliers, limit_multipliers;  ///< none negative; those of the figures sum to 1
  bool at_box = false;                                    ///< some |d_j| is held by the box
};

/// The solution by the simplex method on the dual, which starts from the highest figure and the box. Nothing
/// if the limits cannot be kept within the box. At least one figure.
std::optional<MinimaxStep> solve_minimax_step(const MinimaxProgram& program);

}  // namespace kempe
