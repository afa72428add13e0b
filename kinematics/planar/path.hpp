#pragma once
// Moving a linkage by its drivers without ever changing its assembly.
//
// Each step is certified (step_certificate.hpp): steps that are too long are cut, so a path either arrives on its own
// assembly mode or stops at a singular position; it cannot jump.

#include <Eigen/Core>
#include <functional>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/planar/equations.hpp"
#include "kinematics/planar/factors.hpp"
#include "kinematics/planar/solver.hpp"
#include "kinematics/planar/step_certificate.hpp"

namespace kempe {

/// Why a path ends before its target. Outcomes of the domain.
enum class PathEnd {
  dead_point,        ///< the drivers cannot go on in this direction: the linkage can only turn back
  change_point,      ///< another assembly mode touches here: the linkage may leave either way
  over_constrained,  ///< a constraint that was redundant at the start is violated: the linkage locks
  gave_up,           ///< the way on takes more certified steps than were allowed
  interrupted        ///< the caller asked to stop
};
std::string_view name(PathEnd end);

/// What motions may cost before they give up: work, not time, so that the answer is the same on every machine.
struct PathLimits {
  std::size_t steps = 0;       ///< certified steps tried in one motion (advance or follow)
  std::function<bool()> stop;  ///< looked at every so often, if there is one: true ends the motion
};

/// Steps that are plenty for any motion of a linkage with so many unknowns: fewer where each costs more.
std::size_t plenty_of_steps(int unknowns);

struct PathStop {
  PathEnd end = PathEnd::dead_point;
  double share = 0;            ///< of the wanted change of driver values that was covered, 0..1
  std::vector<double> values;  ///< driver values of the last good position
};

/// Why there is no path from a guess.
enum class NoPath {
  does_not_assemble,  ///< the loops do not close near the guess
  freedom_left,       ///< fewer drivers than freedoms
  drivers_dependent,  ///< drivers more than freedoms, or not independent at this position
};
std::string_view name(NoPath why);

struct NoPathHere {
  NoPath why = NoPath::does_not_assemble;
  int freedoms = 0;            ///< of the linkage without drivers, at the closed position
  NotAssembled assembly_mode;  ///< for does_not_assemble
  PlanarPosition position;     ///< the closed position, for the others
};

/// A curve of driver values for PlanarPath::follow.
struct DriverCurve {
  /// Writes the driver values at a share of the curve, 0..1; continuous, and at 0 where the path stands.
  std::function<void(double share, std::vector<double>& values)> values_at;
  /// A bound of |dvalue/dshare| for each driver.
  std::vector<double> fastest;

  /// Where known, for longer steps: dvalue/dshare at a share, and a bound of |d2value/dshare2| for each
  /// driver.
  std::function<void(double share, std::vector<double>& slopes)> slopes_at = {};
  std::vector<double> most_bent = {};
};

/// A linkage on the move. Invariant: it is closed at position() with the drivers at values(), its Jacobian is
/// regular there, and every position it has shown lies on one assembly. Copyable; not to be shared by
/// threads.
class PlanarPath {
 public:
  /// Closes the loops near the guess (solve_from) and starts there.
  static tl::expected<PlanarPath, NoPathHere> from(const PlanarLinkage& linkage, const PlanarPosition& guess,
                                                   const std::vector<double>& driver_values);

  /// Moves all drivers straight from values() to `target`, in as many certified steps as it takes. On a stop
  /// the path stays at the last good position before the singular one, within about 1e-8 rad of it.
  tl::expected<void, PathStop> advance(const std::vector<double>& target);

  /// What each motion from here on may cost; plenty_of_steps unless said.
  void set_limits(PathLimits limits) { limits_ = std::move(limits); }

  /// Moves the drivers along a curve, with the same certificate for the curve itself (not for its chords).
  tl::expected<void, PathStop> follow(const DriverCurve& curve);

  /// Rates of all unknowns (mm/s, rad/s) for speeds of the drivers (mm/s, rad/s): J q' = -F', exactly.
  Eigen::VectorXd velocity(const std::vector<double>& speeds);

  /// Second derivatives (mm/s^2, rad/s^2) for the drivers' speeds and accelerations; `rate` is
  /// velocity(speeds).
  Eigen::VectorXd acceleration(const Eigen::VectorXd& rate, const std::vector<double>& speeds,
                               const std::vector<double>& accelerations);

  PlanarPosition position() const { return position_of(q_); }
  Point at(const BodyPoint& point) const;
  double angle(int body) const { return body == PlanarLinkage::ground ? 0 : q_[3 * body - 1]; }
  const Eigen::VectorXd& unknowns() const { return q_; }
  const std::vector<double>& values() const { return equations_.values(); }

  /// Largest residual of the equations at the last good position, mm.
  double residual() const { return f_.size() == 0 ? 0 : f_.lpNorm<Eigen::Infinity>(); }

  /// +1 or -1 with the sign of the Jacobian's determinant, up to a sign of the linkage's own: never changes along a
  /// path.
  int orientation() const { return orientation_; }

  /// Certified steps taken so far, and those tried.
  std::size_t steps() const { return steps_; }
  std::size_t steps_tried() const { return tried_; }

  /// The equations, square part first, at the last good position.
  const PlanarEquations& equations() const { return equations_; }

 private:
  PlanarPath(PlanarEquations equations, Eigen::VectorXd q);

  bool is_exact() const;     ///< the factors are those at q_
  bool is_measured() const;  ///< the gains are those at the factors' place
  bool linearise();
  bool choose_rows_again();
  void measure();
  double apart();
  double allowed(double length);
  double share_of(const Eigen::VectorXd& step);
  double share_of(double a, double b, double left);
  template <class Share, class Values>
  tl::expected<void, PathStop> move(const Share& certified_share, const Values& values_at);
  double reach_of(int driver, double way);
  double straight_share(const std::vector<double>& target);
  double curve_share(const DriverCurve& curve, double covered);
  void keep_scales();
  void accept();
  double closing_limit() const;
  double predict(double share);
  void learn_curvature(double share);
  bool correct(const std::vector<double>& values, double share);
  PathEnd kind_of_singularity(const std::vector<double>& target);

  PathLimits limits_;
  std::size_t tried_ = 0;  ///< steps, taken or not
  PlanarEquations equations_;
  Eigen::VectorXd q_, f_, change_, trial_, trial_f_, step_;
  Eigen::MatrixXd jacobian_;
  PlanarFactors factors_;
  StepCertificate certificate_;
  std::vector<double> slopes_;
  Eigen::VectorXd base_;            ///< where factors_ were computed; empty: nowhere
  Eigen::VectorXd first_;           ///< Newton's first step for the whole way ahead, if straight
  Eigen::VectorXd curvature_;       ///< of the last step, per mm^2 of way; empty: not known
  Eigen::VectorXd rows_chosen_at_;  ///< the position; empty: at the start
  double bent_rows_ = 0;  ///< 1/rad: with a larger omega other rows are looked for, if there are any
  double way_ = 0;        ///< largest change of a driver's equation over the way, mm; 0: first_ not known
  double reach_ = 0;      ///< bound of Newton's first step of the share taken, rad, under the weights
  int orientation_ = 1;
  std::size_t steps_ = 0;
};

}  // namespace kempe
