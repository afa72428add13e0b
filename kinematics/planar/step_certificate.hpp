#pragma once
// How far a linkage may be driven in one step so that it certainly stays on its assembly.
//
// The theorem of Newton and Kantorovich: with J the Jacobian at the position q, eta the length of Newton's first step
// towards the new driver values and omega a bound of how strongly J^-1 F bends (known in advance: a joint bends only with
// the angles of its bodies, at most by the joint's arm),
//   omega eta < 1/2
// says that the closed position moves continuously from q to exactly one position in the ball of radius 2 eta, that J stays
// regular on the way, and that no other lies in that ball. (Rounding is not part of the proof.)
//
// The theorem holds in any norm. Where the plain one (the largest turn of a body) does not allow a whole step, bodies are
// weighed by how far they turn in it: |v| = max |v_b| / w_b with 0 < w_b <= 1. With g_ab the gain of body a's angle from the
// bends of body b,
//   omega = max_a (1 / w_a) sum_b g_ab w_b^2
// so that a body that hardly turns does not pay for one that turns fast.
//
// Gains are measured at an anchor and carried over: within |q - anchor| = m, omega grows at most to omega / (1 - omega m).

#include <Eigen/Core>
#include <vector>

#include "kinematics/planar/equations.hpp"
#include "kinematics/planar/factors.hpp"

namespace kempe {

/// The bound of the bending near one position of a linkage. A value; it belongs to the equations it was made for.
class StepCertificate {
 public:
  StepCertificate() = default;
  explicit StepCertificate(const PlanarEquations& equations);

  /// Measures the gains at `anchor`, the place of the factors, for steps from q. Costs one solution a body.
  void measure(PlanarEquations& equations, PlanarFactors& factors, const Eigen::VectorXd& anchor,
               const Eigen::VectorXd& q);

  /// Where the gains were measured last; empty: nowhere yet.
  const Eigen::VectorXd& anchor() const { return anchor_; }

  /// The position to certify steps from.
  void stand_at(const Eigen::VectorXd& q);

  /// All bodies weigh 1; or each by its turn in a Newton step and what the bends may add to it.
  void weigh_alike();
  void weigh_by(const Eigen::VectorXd& step);

  /// The norm under the weights, rad: the largest turn of a body whose angle bends something, over its weight, and the
  /// largest shift (in reaches) of a body whose place does.
  double length(const Eigen::VectorXd& change) const;

  /// omega here under the weights, 1/rad; negative where the gains are none or too far away.
  double bending() const;

  /// How long, at most `wanted`, Newton's first step may be, rad; 0 at a singular position and without gains. The step may
  /// have been computed with the factors of a place `apart` from here: the true one is longer by up to
  /// |J(q)^-1 J(base)| <= 1 + omega apart.
  double allowed(double wanted, double apart) const;

  /// The longest step that is ever allowed, rad.
  static constexpr double longest = 0.2;

 private:
  void weigh();

  std::vector<bool> angle_bends_, place_bends_;  ///< bodies that count in the norm
  double size_ = 1;                              ///< reach of the linkage, mm
  /// g, 1/rad: a row a body (its angle, then its place), a column a bend's body (0: of several together)
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> gains_;
  Eigen::VectorXd weights_;  ///< w of each body; 1 for the ground, which stands for bends of several
  Eigen::VectorXd load_;     ///< room for w^2 and the like
  Eigen::VectorXd anchor_;
  Eigen::VectorXd way_;  ///< from the anchor
  Eigen::VectorXd inverse_row_;
  std::vector<PlanarEquations::Bend> bends_;
  double bending_ = 0;  ///< omega at the anchor under the weights, 1/rad
  double moved_ = 0;    ///< length of way_
  bool alike_ = true;   ///< all weights are 1
};

}  // namespace kempe
