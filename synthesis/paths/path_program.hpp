#pragma once
// The unknowns of a path generator for the local solver: values and slopes of errors and limits.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "synthesis/paths/path_generator.hpp"

namespace kempe {

/// By Grashof's rule: one link and each other are together shorter (sign +1: the link is the shortest, and the linkage Grashof's) or longer (-1: the
/// longest, and not Grashof's) than the other two.
struct GrashofRows {
  int link;  ///< 0 ground, 1 crank, 2 coupler, 3 rocker
  double sign;
};

/// The rows of which one set is enough for one of these motions; none for a change point.
std::vector<GrashofRows> grashof_choices(const std::vector<CrankMotion>& motions);

/// A path moved to its centroid and scaled to size 1, turned so that a ground link whose direction is given lies along x, with the way of turning and the assembly mode that a start has.
///
/// Unknowns: z0, z1, z2 (two each), the logarithms of alpha, beta, gamma, and the crank's angles from the ground link: the first where
/// there is timing, else all.
class PathProgram {
 public:
  PathProgram(const PathTask& task, FourBarBranch branch, bool rising);

  static constexpr int ratios_at = 6, angles_at = 9;
  int size() const { return angles_at + (timed_ ? 1 : count()); }
  int count() const { return static_cast<int>(points_.size()); }
  bool timed() const { return timed_; }

  /// The crank's angle from the ground link at point i.
  double angle(const Eigen::VectorXd& x, int i) const {
    return timed_ ? x[angles_at] + turns_[static_cast<std::size_t>(i)] : x[angles_at + i];
  }

  /// Whether the task gives this unknown: it keeps its value, and the errors' slope along it counts as zero.
  bool is_given(int unknown) const { return given_[static_cast<std::size_t>(unknown)].has_value(); }

  /// Sets what the task gives, and z0, z1, z2 to the best for the ratios and angles; false where the loop does not close at every
  /// point, or only a negative size would bring the ground link into the direction given.
  bool project(Eigen::VectorXd& x) const;

  /// The 2 n differences of the coupler point from the points, and their slopes (2 n rows) unless null; false where the loop does not close.
  bool errors(const Eigen::VectorXd& x, Eigen::VectorXd& value, Eigen::MatrixXd* slope) const;

  /// The limits, each kept where not positive: transmission at every point and where it is least between them, lengths, pivots, order, and the motion.
  void limits(const Eigen::VectorXd& x, Eigen::VectorXd& value, Eigen::MatrixXd* slope) const;
  int limit_count() const;
  /// How many of the limits, the first ones, are of the transmission angle: its cosine, of either sign, less that of the limit.
  int transmission_rows() const { return 2 * (count() + static_cast<int>(in_line_.size())); }
  /// Whether there are more unknowns than conditions where every point is met: a family of linkages may then meet them.
  bool has_families() const;

  /// Adds those of the crank's two places in line with the ground link that lie between the points: the limit holds at these too.
  void watch_extremes(const Eigen::VectorXd& x);

  /// Where the task limits the motion: adds the rows of the choice that x breaks least.
  void choose_motion(const Eigen::VectorXd& x);

  CouplerFourBar linkage(const Eigen::VectorXd& x) const;
  std::vector<double> crank_angles(const Eigen::VectorXd& x) const;

  /// Where the local solver may go, for each unknown.
  Eigen::VectorXd lowest() const, highest() const;

 private:
  /// The best of z0, z1, z2 where some of them are given, by the normal equations of all.
  bool project_the_rest(const Eigen::Matrix3cd& normal, const Eigen::Vector3cd& right,
                        Eigen::VectorXd& x) const;
  Eigen::VectorXd kept_as_given(Eigen::VectorXd bound) const;

  struct LimitRows;
  /// Each adds the rows of some limits; `column`: of the unknown that is the angle, or the link's ratio, if one is.
  void add_transmission(double angle, std::optional<int> column, LimitRows& rows) const;
  void add_lengths(LimitRows& rows) const;
  void add_link(double ratio, std::optional<int> column, LimitRows& rows) const;
  void add_arm(double ratio, LimitRows& rows) const;
  void add_pivots(LimitRows& rows) const;
  void add_order(LimitRows& rows) const;
  void add_motion(LimitRows& rows) const;

  struct Coupler;
  Complex inside(const Point& on_table) const {
    return (as_complex(on_table) - centre_) / unit_ * std::conj(frame_);
  }
  Coupler coupler(const Eigen::VectorXd& x, double angle) const;

  std::vector<Complex> points_;
  std::vector<double> turns_;
  std::vector<Point> pivots_;
  std::vector<double> in_line_;  ///< crank angles, 0 and pi
  std::vector<GrashofRows> motions_;
  std::optional<GrashofRows> motion_;
  std::vector<std::optional<double>> given_;  ///< for each unknown
  FourBarBranch branch_;
  double way_;                  ///< +1 or -1
  Complex centre_, frame_ = 1;  ///< frame_: where the x axis of the unknowns points on the table
  double unit_ = 1, longest_ = 0, cos_limit_ = 1;
  bool timed_;
};

/// The unknowns that NLopt (SLSQP) reaches from x, brought to meet the points by Newton's steps where they nearly do. Counts what it
/// evaluated, as do the others.
Eigen::VectorXd refined_path(const PathProgram& program, PathAim aim, int most_evaluations,
                             const Eigen::VectorXd& x, std::size_t& evaluations);

/// The same by the second solver (synthesis/solvers/polish.hpp).
Eigen::VectorXd polished_path(const PathProgram& program, PathAim aim, const Eigen::VectorXd& x,
                              std::size_t& evaluations);

/// From x that meets the points to one that does too with a larger least transmission angle: NLopt (SLSQP), the errors kept at zero, no unknown u moved by
/// more than reach (1 + |u|).
Eigen::VectorXd led_to_larger_transmission(const PathProgram& program, double reach, int most_evaluations,
                                           const Eigen::VectorXd& x, std::size_t& evaluations);

}  // namespace kempe
