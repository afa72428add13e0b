#pragma once
// The problem of one discrete choice: every requirement and every goal, once as plain figures (assess) and
// once as a smooth program with exact first and second derivatives.
//
// With x = (u, v, d_near, d_far [, pole] [, t]) as design_vector.hpp lays it out, r(u, v, d) of reach.hpp,
// unit L:
//
//   reach, near    dist(pole, edge i) - r(u, v, d_near) >= 0      for every edge i of the region
//   reach, far     r(u, v, d_far) - |pole - corner j| >= 0        for every corner j of the region's convex hull
//   transmission   d_near and d_far at least mu inside the assembly mode's interval:
//                  bounds, or with the goal t = mu rows
//   contact        gap_m(u, v, d_near + h (d_far - d_near)) - clearance >= 0
//                                                                 for every pair m and every 0 <= h <= 1
//   copy_gap       dist of an edge of the region and an edge of its image - gap >= 0
//                                                                 for every two edges
//   load error     log limit (or the goal's t) - log error(u, v, d_near + h (d_far - d_near)) >= 0
//   sag            log 2 - f(sag(u, v, d_near + h (d_far - d_near)) / limit) >= 0 with f(z) = log(1 + z), below 0 f(z) = z
//   pole           half planes around the start (search_space.hpp)
//   lengths        bounds of u and v, or with the goal t = log longest, log shortest rows
//
// All mm are divided by L. There are infinitely many rows (h) or very many (edges), so a program holds those
// that matter at a point; after each local solution the violated ones are added and it is solved again
// (exchange method). Source: Hettich and Kortanek, Semi-infinite programming, SIAM Review 35 (1993).

#include <span>
#include <vector>

#include "synthesis/loads/load_error.hpp"
#include "synthesis/loads/mass.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/problem/link_gap.hpp"
#include "synthesis/problem/obstacle_gap.hpp"
#include "synthesis/problem/search_space.hpp"
#include "synthesis/solvers/smooth_program.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe {

/// The continuous part of a design.
struct DesignPoint {
  LogLengths lengths{};
  Point pole = Point::Zero();  ///< mm
};

/// A design point seen with all requirements.
struct Assessment {
  bool feasible = false;  ///< every requirement holds, contact at samples only
  double violation = 0;   ///< sum of what is missing, in shares of the task's size; 0 if feasible
  double cost = 0;        ///< the goal, with a minus if it is to be large
  double near_opening = 0, far_opening = 0;  ///< rad
  Attained attained;
};

/// What must keep its clearance: parts from each other, and parts from obstacles.
struct ContactTerms {
  std::vector<GapTerm> gaps{};
  std::vector<ObstacleTerm> obstacles{};
  bool empty() const { return gaps.empty() && obstacles.empty(); }
};

/// One row of the semi-infinite program.
struct Row {
  enum class Kind {
    near_edge,
    far_corner,
    near_end,
    far_end,
    contact,
    obstacle,
    copy_gap,
    half_plane,
    pole_margin,
    longest,
    shortest,
    copy_error,
    size,
    load_error,
    mass,
    sag
  } kind;
  std::size_t index =
      0;  ///< edge, corner, gap or obstacle term, corner of region or copy, half plane; 0: VA, 1: VB; 0: tracer, 1: pen
  double share = 0;       ///< h of a contact, a copy error, a load error or a sag
  std::size_t place = 0;  ///< of the tracer, for an obstacle
  bool operator==(const Row&) const = default;
};

/// How many derivatives a caller needs: those of obstacles and of the footprint cost several evaluations.
enum class Derivatives { none, first, second };

/// A row's value and derivatives by the design vector; those that were not asked for may be zero.
struct RowJet {
  double value = 0;
  DesignVector gradient;
  DesignMatrix hessian;
};

/// The openings that keep a transmission angle (rad), a trifle inside.
OpeningInterval openings_with_transmission(const Reach& reach, double transmission);

class DesignProblem {
 public:
  /// `allowed`: the openings at which transmission and copy error keep their limits; `terms`: the pairs that
  /// must keep their clearance, none for the relaxation without contact; `locked`: lengths that are, the spec's unless others are given.
  DesignProblem(const SearchSpace& space, const Choice& choice, const Requirements& limits, Goal goal,
                const OpeningInterval& allowed, ContactTerms terms, const StockLengths& locked);
  DesignProblem(const SearchSpace& space, const Choice& choice, const Requirements& limits, Goal goal,
                const OpeningInterval& allowed, ContactTerms terms)
      : DesignProblem(space, choice, limits, goal, allowed, std::move(terms),
                      space.spec().links.stock_lengths) {}

  /// What a cost is divided by to be of order 1.
  double goal_scale() const;
  const Choice& choice() const { return choice_; }
  const Requirements& limits() const { return limits_; }
  Goal goal() const { return goal_; }
  const Reach& reach() const { return reach_; }
  const DesignLayout& layout() const { return layout_; }
  /// False if not even the bounds leave anything (no length fits, or the interval is narrower than twice mu).
  bool possible() const;

  /// Every requirement at a point; contact looked at in `openings` places between the region's two openings. A limit on the load
  /// error that is `left_out` counts as kept: nothing then seems worse than it is. count_load_error() adds it.
  enum class LoadLimit { counted, left_out };
  /// `shared`: the gaps at this point, of a problem that differs in its layers alone, or none; they only save work.
  Assessment assess(const DesignPoint& point, int openings, LoadLimit load = LoadLimit::counted,
                    SmallestGaps* shared = nullptr) const;
  Assessment count_load_error(Assessment seen, const DesignPoint& point) const;

  /// True with a limit on the load error, under another goal.
  bool has_load_limit() const { return load_error_ && goal_ != Goal::load_error; }
  bool has_obstacles() const { return !terms_.obstacles.empty(); }

  /// True with a limit on the sag: its rows jump where a point is lifted off the table, and a local solution may end beyond it.
  bool has_limit_that_jumps() const { return sag_ && limits_.sag; }
  /// True if both VA and VB are locked: only the pole can be free.
  bool lengths_are_locked() const { return box_.u.width() == 0 && box_.v.width() == 0; }
  /// Dimensions of the unit cube that unit_point() maps onto the designs: 2 for lengths unless they are locked, 2 more for
  /// a free pole.
  int cube_dimensions() const { return (lengths_are_locked() ? 0 : 2) + (layout_.pole_is_free ? 2 : 0); }
  /// For a pole from which the region can be reached: lengths that reach it and fit the length limits, if
  /// there are any.
  DesignPoint unit_point(std::span<const double> z) const;
  LogLengths unit_lengths(const Point& pole, double of_lambda, double of_m) const;
  Point unit_pole(double x, double y) const;
  /// Few poles worth starting from: none of them sees the region in an annulus that holds that of another.
  std::vector<Point> start_poles(int count) const;

  DesignVector vector_of(const DesignPoint& point) const;
  DesignPoint point_of(const DesignVector& x) const;

  /// The rows that matter near x; `room` is the pole's room around x.
  std::vector<Row> rows_at(const DesignVector& x) const;
  /// Adds rows that x violates by more than `tolerance`; true if there was one.
  bool add_violated(std::vector<Row>& rows, const DesignVector& x, double tolerance) const;
  void set_room(const Point& pole);
  /// What problems that differ in their layers alone share at a point. This problem must outlive it.
  SmallestGaps gaps_at(const DesignPoint& point) const;
  /// True if no lengths whatsoever keep the clearance from obstacles, because with a fixed pole the copy decides where tracer and
  /// pen are, and there something is in the way of them or of what they carry. `shared`: the gaps at any point.
  bool is_in_the_way_of_the_copy(SmallestGaps& shared) const;
  /// One more place of the tracer at which obstacles are looked at.
  void add_place(const Point& tracer) { places_.push_back(tracer); }
  /// All of them: those of the space, then those added.
  const std::vector<Point>& places() const { return places_; }
  /// A limit that a finished design misses by `shortfall` (mm or rad) is demanded so much more strictly: rows and samples
  /// look at single openings, the check of the finished design at all. False if that limit cannot be demanded more strictly.
  bool tighten(Goal limit, double shortfall);
  RowJet row(const Row& row, const DesignVector& x, Derivatives wanted = Derivatives::second) const;
  RowJet objective(const DesignVector& x, Derivatives wanted = Derivatives::second) const;
  /// The program of these rows; refers to this problem and copies the rows.
  SmoothProgram program(const std::vector<Row>& rows) const;
  DesignVector lower_bounds() const;
  DesignVector upper_bounds() const;

 private:
  double cost_of(const Attained& attained) const;
  double footprint_at(const DesignPoint& point) const;
  RowJet footprint_objective(const DesignVector& x, Derivatives wanted) const;
  double goal_in_vector(double value) const;
  double violation_of(const Attained& attained) const;
  /// Or `enough`, if no gap is smaller.
  double smallest_gap(const LogLengths& lengths, double from, double to, int openings, double enough) const;
  Box pole_box() const;
  RowJet near_row(std::size_t edge, const DesignVector& x) const;
  RowJet far_row(std::size_t corner, const DesignVector& x) const;
  RowJet contact_row(std::size_t term, double share, const DesignVector& x) const;
  RowJet obstacle_row(const Row& row, const DesignVector& x, Derivatives wanted) const;
  RowJet obstacle_row_values(const Row& row, const DesignVector& x) const;
  RowJet copy_gap_row(std::size_t corner, const DesignVector& x) const;
  RowJet copy_error_row(double share, const DesignVector& x) const;
  RowJet size_row(const DesignVector& x) const;
  RowJet load_error_row(double share, const DesignVector& x, Derivatives wanted) const;
  RowJet mass_row(const DesignVector& x) const;
  RowJet mass_in_vector(const DesignVector& x) const;
  RowJet sag_row_values(const Row& row, const DesignVector& x) const;
  RowJet sag_row(const Row& row, const DesignVector& x, Derivatives wanted) const;
  double load_error_over(const LogLengths& lengths, double from, double to, int openings) const;
  double mass_at(const LogLengths& lengths) const;
  double sag_over(const LogLengths& lengths, double from, double to) const;
  void ask_for_loads();
  void add_obstacles(std::vector<Row>& rows, const DesignVector& x, double band) const;
  void add_copy_gap(std::vector<Row>& rows, const DesignVector& x) const;
  void add_copy_errors(std::vector<Row>& rows, const DesignVector& x) const;
  void add_load_errors(std::vector<Row>& rows, const DesignVector& x, double least_share) const;
  void add_sags(std::vector<Row>& rows, const DesignVector& x) const;
  double smallest_obstacle_gap(const DesignPoint& point, double enough, SmallestGaps* shared) const;
  RowJet half_plane_row(std::size_t plane, const DesignVector& x) const;
  RowJet pole_margin_row(const DesignVector& x) const;
  RowJet end_row(bool near, const DesignVector& x) const;
  RowJet length_row(bool longest, std::size_t family, const DesignVector& x) const;
  void add_nearest_and_farthest(std::vector<Row>& rows, const DesignVector& x) const;
  void add_around(std::vector<Row>& rows, const DesignVector& x) const;
  void add_contacts(std::vector<Row>& rows, const DesignVector& x, double band) const;
  double tightest_share(const GapTerm& term, const DesignVector& x, double below, double above) const;

  const SearchSpace& space_;
  Choice choice_;
  Requirements limits_;
  Goal goal_;
  OpeningInterval allowed_;
  ContactTerms terms_;
  std::vector<Point> places_;  ///< of the tracer, where obstacles are looked at
  JointRoles roles_;
  std::optional<CopyErrorProfile> copy_error_;
  std::optional<LoadErrorProfile> load_error_;  ///< where it is goal or limit
  std::optional<MassPolynomial> mass_;
  std::optional<SagProfile> sag_;  ///< where it is limited
  double goal_scale_ = 1;          ///< of the load error (mm) or the mass (kg)
  Reach reach_;
  LogBox box_;
  DesignLayout layout_;
  std::vector<HalfPlane> room_;
};

}  // namespace kempe
