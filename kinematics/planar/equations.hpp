#pragma once
// The equations of a planar linkage and their derivatives, ready for Newton's method.
//
// Unknowns q: x, y, angle of each body but the ground. With r = R(angle) local, P = (x, y) + r and u =
// R(angle) direction:
//   Revolute        F = A - B                                   (2 rows)
//   Coordinate      F = u . (P - O) - value
//   Distance        F = (|A - B|^2 - value^2) / (2 scale)
//   RelativeAngle   F = size (angle - angle' - value)
//   GearPair        F = size (a (angle1 - angle3) + b (angle2 - angle3) - value) / max(|a|, |b|)
//   RackAndPinion   F = u . (C - O) + radius (angle - angle') - value
// All rows are lengths (mm), and every one grows with the linkage alone: drawn larger or in another unit, F, q and all
// that is made from them are the same numbers times a power of the scale, to the last bit for a power of two. A revolute joint is linear in the places and bends only in the angles, which is
// what the step control lives on.

#include <Eigen/Core>
#include <vector>

#include "kinematics/planar/linkage.hpp"

namespace kempe {

/// The equations of one linkage at changing driver values. Keeps its own room for sines and cosines: one
/// object a thread.
class PlanarEquations {
 public:
  explicit PlanarEquations(const PlanarLinkage& linkage);

  int unknown_count() const { return unknowns_; }
  int row_count() const { return rows_; }
  double size() const { return size_; }
  double reach() const { return reach_; }  ///< the linkage's, mm

  /// Puts the rows in this order (a permutation of all rows, new place by old row): the first of them are
  /// then the top rows of every result.
  void reorder(const std::vector<int>& place_of_row);

  /// Driver values in force, in the linkage's order of drivers.
  const std::vector<double>& values() const { return values_; }
  void set_values(const std::vector<double>& values);

  /// Row of a constraint's (first) equation, and of a driver's.
  int row_of(int constraint) const { return entries_[static_cast<std::size_t>(constraint)].row; }
  int driver_row(int driver) const;

  /// A length of a body, mm: how far its angle moves what constraints hold of it, at most.
  double arm_of(int body) const { return arms_[static_cast<std::size_t>(body)]; }

  /// F(q), mm.
  void residual(const Eigen::VectorXd& q, Eigen::VectorXd& f);

  /// F(q) and dF/dq.
  void residual_and_jacobian(const Eigen::VectorXd& q, Eigen::VectorXd& f, Eigen::MatrixXd& jacobian);

  /// D^2F(q)(rate, rate): the part of F's second time derivative that is quadratic in the rates.
  void second_derivative(const Eigen::VectorXd& q, const Eigen::VectorXd& rate, Eigen::VectorXd& f);

  /// -dF/dvalue of any constraint at its present value; 1 of a revolute joint, which has none.
  double value_slope(int constraint) const;

  /// The same of a driver, and the part of -F'' that its speed adds: what stands on the right of J q' = ... and
  /// J q'' = ... in the driver's row.
  double driver_slope(int driver) const;
  double driver_bend(int driver, double speed) const;

  /// The Jacobian without units: each row over its largest entry, each angle's column over the body's own arm, so that
  /// neither the unit nor a link much smaller than the others changes its rank.
  Eigen::MatrixXd dimensionless(Eigen::MatrixXd jacobian) const;

  /// Measures rows of driven distances in their present value again, if it has changed much; true if any was. J changes
  /// by that factor in these rows.
  bool rescale_distances();

  /// How strongly F bends: with |v| the largest over bodies of |angle| and |place|/reach, within |v| <= 1/2 of
  /// q, the sum over the entries of a row (or of two rows together) bounds |D^2F(v, w)|; an entry adds
  ///   bound |v_b| |w_b|   with the angle of its body b alone,
  ///   bound |v| |w|       without a body.
  struct Bend {
    int row, second_row;  ///< second_row is -1 where there is one only
    int body;             ///< whose turning alone bends it; 0: angles and places of several bodies together
    double bound;         ///< mm
  };
  /// The entries of all constraints that are not linear.
  void bends(const Eigen::VectorXd& q, std::vector<Bend>& result);

  /// Bodies whose angle, or whose place, enters some equation in a bent way: |v| above may leave out all
  /// others.
  const std::vector<bool>& angle_bends() const { return angle_bends_; }
  const std::vector<bool>& place_bends() const { return place_bends_; }

  /// A revolute joint and its rows (x, y): bodies a and b.
  struct Joint {
    int row, second_row, a, b;
  };
  /// The joints whose two rows both stand among the top square rows and that join two bodies.
  std::vector<Joint> joints() const;

  /// The columns that each row may hold.
  std::vector<std::vector<int>> columns_by_row() const;

  bool has_distance_driver() const { return has_distance_driver_; }
  bool is_distance(int driver) const;

 private:
  struct Arm {  ///< a point as seen from its body's origin, turned into the table's frame
    int body;
    Point turned, at;
  };
  struct Entry {
    Constraint constraint;
    int row;         ///< first row
    int second_row;  ///< of a revolute joint; else -1
    double scale;    ///< of a distance, mm; mm a unit of pitch circle of gears
  };
  void mark_bends(const Constraint& constraint);
  void turn_bodies(const Eigen::VectorXd& q);
  Arm arm(const Eigen::VectorXd& q, const BodyPoint& point) const;
  Point turned(int body, const Point& local) const;
  void add_angle(Eigen::MatrixXd& jacobian, int row, int body, double slope) const;
  void add_point(Eigen::MatrixXd& jacobian, int row, const Arm& arm, const Point& along) const;
  static void add_joint(Eigen::MatrixXd& jacobian, const Entry& entry, const Arm& arm, double sign);
  class Evaluation;
  void evaluate(const Eigen::VectorXd& q, Eigen::VectorXd& f, Eigen::MatrixXd* jacobian);

  std::vector<Entry> entries_;
  std::vector<int> driver_entries_;
  std::vector<double> values_;
  std::vector<bool> angle_bends_, place_bends_;
  std::vector<double> arms_;  ///< of each body, mm: a length that its angle moves points by
  bool has_distance_driver_ = false;
  std::vector<Point> directions_;  ///< (cos, sin) of each body's angle
  int unknowns_, rows_;
  double size_, reach_;
};

/// The unknowns of a position, and back.
Eigen::VectorXd unknowns_of(const PlanarPosition& position);
PlanarPosition position_of(const Eigen::VectorXd& unknowns);

/// What a constraint is off by, measured without the equations above: the distance between the two points of a joint,
/// the error of a distance, or of an angle (of gears: that of the larger wheel).
struct ConstraintGap {
  double amount = 0;      ///< mm, or rad
  bool is_angle = false;  ///< the amount is an angle
  double as_length(double size) const { return is_angle ? amount * size : amount; }
};
ConstraintGap gap_of(const Constraint& constraint, const PlanarPosition& position);

/// The same of one of the linkage's constraints, the drivers at these values.
ConstraintGap gap_of(const PlanarLinkage& linkage, int constraint, const PlanarPosition& position,
                     const std::vector<double>& driver_values);

/// What rounding leaves of a position is a share of this, mm: the linkage's size, the places' distance from the origin,
/// the size times the turns an angle counts.
double magnitude_of(const Eigen::VectorXd& unknowns, double size);

/// The largest error over all constraints as a length, angles times the linkage's size.
struct ClosureError {
  double largest = 0;
  int constraint = 0;  ///< whose it is
};
ClosureError closure_error(const PlanarLinkage& linkage, const PlanarPosition& position,
                           const std::vector<double>& driver_values);

}  // namespace kempe
