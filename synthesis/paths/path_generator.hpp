#pragma once
// Four-bars whose coupler point follows given points.
//
// With the ground link as the unit, alpha, beta, gamma the ratios of crank, coupler and rocker to it, psi the crank's angle from it
// and u(psi) the coupler's direction, the coupler point at point i is
//   P_i = z0 + z1 e^{i psi_i} + z2 u(psi_i)        z0 = A0, z1 = alpha (B0 - A0), z2 = (p + i q) e^{i base}
// linear in three complex unknowns: of the ten unknowns of a task with timing four are searched (alpha, beta, gamma, psi_1), the
// others follow by linear least squares (variable projection: Golub and Pereyra 1973).

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "synthesis/paths/coupler_four_bar.hpp"

namespace kempe {

/// What is made small.
enum class PathAim {
  mean_square,      ///< the root of the mean squared distance
  largest_distance  ///< the largest distance
};

/// What is asked for. Lengths mm, angles rad.
struct PathTask {
  std::vector<Point> points;  ///< at least 3, not all in one place
  std::vector<double>
      turns;  ///< how far the crank has turned at each from the first on: 0, then rising or falling; empty: free
  PathAim aim = PathAim::mean_square;
  double longest = 0;  ///< of CouplerFourBar::longest, > 0
  double transmission =
      0;  ///< rad, < pi/2: least angle from the first point to the last; 0.02 are always kept
  std::vector<Point> pivots_within;    ///< corners of a convex polygon, counter-clockwise; empty: anywhere
  std::vector<CrankMotion> motions;    ///< by Grashof's rule, one of these; no change point; empty: any
  std::optional<Point> crank_pivot;    ///< where A0 stands, within pivots_within; nothing: free
  std::optional<double> ground_angle;  ///< rad: the direction from A0 to B0; nothing: free
  std::optional<double> first_angle;  ///< rad: the crank's angle from A0-B0 at the first point; nothing: free
};

/// A limit that an answer stands at: without it, another might come nearer to the points.
struct ActiveLimit {
  std::string
      key;  ///< of the spec, "limits.longest_mm"; or what is always kept: "dead point", "change point", "ratios searched"
  std::string what;  ///< "rocker"; empty where the key says all
};

/// A four-bar, moved over its points by the general solver.
struct PathAnswer {
  CouplerFourBar linkage;
  std::vector<double> crank_angles;                ///< at each point, rad, rising or falling
  std::vector<double> coupler_angles;              ///< rad
  std::vector<Point> reached;                      ///< where the coupler point is at each
  double error_rms = 0;                            ///< mm: root of the mean squared distance
  double error_max = 0;                            ///< mm
  double transmission_min = 0;                     ///< rad, from the first point to the last
  std::optional<std::array<Cognate, 2>> cognates;  ///< nothing where one has a link without length
  std::vector<ActiveLimit> active;                 ///< the limits that it stands at
};

/// What a search looked at.
struct PathEffort {
  std::size_t starts = 0;       ///< scattered linkages judged by linear least squares
  std::size_t refined = 0;      ///< of them that the local solver went on from
  std::size_t evaluations = 0;  ///< of the whole path, by the local solver
  std::size_t rejected =
      0;  ///< refined linkages that break a limit or whose motion the general solver stopped
};

struct PathSearch {
  /// The best first; different ones, none a cognate of another, and of those whose coupler curves lie, from the first point to the last, nowhere
  /// farther apart than a tenth of the better one's largest error the best alone.
  std::vector<PathAnswer> answers;
  PathEffort effort;
};

/// The best four-bars found, at most `most`. A search: nothing is proven about what it did not find, and there is no bound of the
/// least error. The same task gives the same answers. The error is a sentence that says what was searched.
tl::expected<PathSearch, std::string> generate_path(const PathTask& task, std::size_t most = 3);

/// The task's own answer for a linkage and its crank angles: moved by the general solver, limits looked at, cognates made. Nothing
/// where a limit is broken or the motion has a defect.
std::optional<PathAnswer> judged_path(const PathTask& task, const CouplerFourBar& linkage,
                                      const std::vector<double>& crank_angles);

/// Whether an answer meets all points, to rounding.
bool meets_points(const PathTask& task, const PathAnswer& answer);

/// The limits that an answer stands at, to 1e-6 of their size.
std::vector<ActiveLimit> active_limits(const PathTask& task, const PathAnswer& answer);

/// How far two answers' coupler curves lie apart from the first point to the last, at most: the largest distance of a place of one from the other,
/// looked at `places` times between two points. Ends early, with infinity, where it is more than `enough`.
double curves_apart(const PathAnswer& one, const PathAnswer& other, double enough, int places = 6);

}  // namespace kempe
