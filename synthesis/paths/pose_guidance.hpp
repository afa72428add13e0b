#pragma once
// Four-bars whose coupler takes given poses: three, four or five, exactly (Burmester).
//
// A point w of the moving body whose places in all poses lie on a circle about a fixed Z is a circle point, Z its centre point; two
// such pairs are a four-bar. With R turning by the pose's angle and x the pose's place, every pose says
//   |x + R w - Z|^2 = r^2,
// linear in (1, u, v, X, Y, X u + Y v, X v - Y u, |w|^2 + |Z|^2 - r^2) for w = (u, v), Z = (X, Y): five poses leave three of the eight
// free, and the two products are two conics in them, which meet in at most four places.

#include <cstddef>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/planar/linkage.hpp"
#include "synthesis/paths/path_generator.hpp"

namespace kempe {

/// A link between the ground and the moving body that all poses allow.
struct Dyad {
  Point centre = Point::Zero();  ///< Z, mm, on the table
  Point circle = Point::Zero();  ///< w, mm, in the moving body's frame
  double length = 0;             ///< r, mm
};

/// What is asked for: places (mm) and directions (rad) of the moving body, 3 to 5, in order. Limits as those of PathTask.
struct PoseTask {
  std::vector<BodyPlacement> poses;
  double longest = 0, transmission = 0;
  std::vector<Point> pivots_within;
  std::vector<CrankMotion> motions;
};

/// All dyads of five poses, at most four; of four poses those whose circle point lies on one of 180 lines through the body's origin, a
/// degree apart (every circle point lies near one); of three poses one for each circle point of a grid. Each met to rounding in
/// every pose; none longer than the limit, no centre outside the pivots' polygon.
std::vector<Dyad> dyads_of(const PoseTask& task);

/// Of five poses all dyads, whatever the limits.
std::vector<Dyad> burmester_dyads(const std::vector<BodyPlacement>& five);

struct PoseAnswer {
  PathAnswer path;             ///< its coupler point is the body's origin, its points the poses' places
  std::vector<double> angles;  ///< of the body at each pose, rad, as the general solver moves it
  double error_angle = 0;      ///< rad: the largest difference from the poses' angles, whole turns aside
};

struct PoseSearch {
  std::vector<PoseAnswer> answers;  ///< the largest transmission angle first, at most `most`
  std::vector<Dyad> dyads;          ///< within the limits, all that were looked at
  std::size_t linkages = 0;         ///< ordered pairs of dyads
  std::size_t defective = 0;        ///< of them, with the poses on two branches or in another order
  std::size_t limited = 0;          ///< broken limits, the general solver's stops among them
};

/// The four-bars without defect: the crank turns one way from the first pose to the last, on one assembly, moved so by the general solver.
/// Of three and four poses the best sampled four-bars that differ are led on until none nearby in the family has a larger transmission angle.
/// The error is a sentence with what was found and rejected.
tl::expected<PoseSearch, std::string> guide_poses(const PoseTask& task, std::size_t most = 6);

}  // namespace kempe
