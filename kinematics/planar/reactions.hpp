#pragma once
// The forces in joints, guides, gears and drivers of a linkage that carries loads and moves masses.
//
// With J the Jacobian of the equations (equations.hpp), Q the applied forces and m the inertia forces (loads.hpp), the
// principle of virtual work says  J^T lambda = m - Q:  a constraint's force is its multiplier times the gradient of its
// equation. Gears are the exception: their equation knows angles alone, so their row becomes the force at the
// teeth's point of contact, which does the same work and loads the bearings as teeth do (along the pitch circle; what
// an angle of pressure adds along the centres is left out).

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "kinematics/planar/equations.hpp"
#include "kinematics/planar/linkage.hpp"

namespace kempe {

/// What one constraint or driver does to the linkage.
struct Reaction {
  /// N, table frame. Joint: on the second body (b), from the first. Coordinate: on the point's body, from the line's.
  /// Distance: on a, from b. Gears: on the first wheel, at the pitch point. Rack: on the pinion, at the pitch point.
  Point force = Point::Zero();

  /// Along the constraint: N, or N mm of a relative angle (on `body`, from `reference`). Of a driver: times the rate of
  /// its value it is the power that the driver brings in. Distance: > 0 pushes the points apart. Gears: > 0 turns
  /// the first wheel counter-clockwise where outer teeth mesh. Rack: in its direction. 0 of a joint.
  double along = 0;

  /// False where rigid links do not say it: equations are redundant, and what one of them bears another could
  /// bear as well.
  bool determined = true;
};

/// Finds the reactions of one linkage at any of its positions.
class ReactionSolver {
 public:
  explicit ReactionSolver(const PlanarLinkage& linkage);

  /// One reaction for each constraint, drivers included, in the linkage's order. `needed` is inertia_forces less
  /// applied_forces at this closed position; `driver_values` are those in force. Nothing at a singular position, where no
  /// forces balance the loads or no equation says which, nor where a force acts along the line of two points that coincide.
  std::optional<std::vector<Reaction>> at(const PlanarPosition& position,
                                          const std::vector<double>& driver_values,
                                          const Eigen::VectorXd& needed);

  /// Gears whose wheels have no joint with their carrier: nothing says where their bearings are. Then only the
  /// drivers' forces are determined.
  bool has_gears_without_bearings() const { return gears_without_bearings_; }

 private:
  /// Where the two wheels of a pair of gears turn on their carrier.
  struct Bearings {
    int constraint;
    BodyPoint first, second;
  };
  void find_bearings();
  std::optional<BodyPoint> bearing_of(int wheel, int carrier) const;
  void put_tooth_force(const Bearings& bearings, const PlanarPosition& position);
  void scale_rows();
  Reaction reaction_of(int constraint, const Eigen::VectorXd& multipliers, const Eigen::VectorXd& doubt,
                       const PlanarPosition& position) const;

  PlanarLinkage linkage_;
  PlanarEquations equations_;
  std::vector<Bearings> bearings_;
  bool gears_without_bearings_ = false;
  Eigen::VectorXd gaps_, row_scale_;
  Eigen::MatrixXd rows_;  ///< the force of each equation's unit multiplier on each unknown
};

}  // namespace kempe
