#pragma once
// The independent check of a design: build the linkage from its eight lengths alone, drive the tracer over the region
// by closing the loops numerically, and see what the pen did.
//
// Shares no formula with the closed form: bodies and joints go to the general planar solver.

#include <optional>
#include <string>

#include "geometry/point.hpp"
#include "kinematics/stop_flag.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// A mechanism as its drawing gives it: eight lengths, how the triangles are turned, which joint does what.
struct DrawnMechanism {
  LinkLengths lengths;  ///< mm
  LoopSides sides;      ///< how the loops are put together
  Joint pole = Joint::V, tracer = Joint::X, pen = Joint::Y;
  Point pole_position = Point::Zero();  ///< mm
  OpeningInterval opening;              ///< certified usable opening, rad: poses must stay inside
  /// The shape that both plates share. Three lengths tell a nearly flat triangle's height to half their digits
  /// only; there the angle of the shape places the third joint, and the third length must agree. Absent: lengths alone.
  std::optional<Complex> shape{};
};

/// What must be shown.
struct VerificationTask {
  DrawnMechanism mechanism;
  Complex k;                   ///< the copy ratio wanted
  Region region;               ///< what the tracer must cover
  bool region_covered = true;  ///< false: the workspace is driven over instead
  /// Driven over where there is no region, or it is not covered: the free workspace, or a part of it.
  Region workspace{};
  LinkStyle style;
  LayerAssignment layers;
  /// Kept over the region: of these transmission, and the clearance between parts and to obstacles. Absent: not checked.
  std::optional<Limits> limits{};
  std::vector<Obstacle> obstacles{};
  std::vector<Body> bodies{};
  std::optional<Polygon> table{};
  double shortest = 0, longest = infinity;  ///< mm, limits of every length
};

struct VerificationOptions {
  std::size_t outline_samples = 600;  ///< about this many places along the region's rings, corners preferred
  int hatch_lines = 12;               ///< inside, each direction
  double copy_error_share = 1e-9;     ///< copy error allowed, as a share of the mechanism's size
  /// Set: of the places that are left only some are driven to, all over the region.
  StopFlag stop{};
};

/// What was seen, and whether at all places.
struct VerificationRun {
  Verification found;
  bool complete = true;  ///< false: stopped early
};

/// Where the tracer is driven if there is no region to drive over: the largest part of the free workspace at the certified opening;
/// where nothing is free there, all of that opening; without one, of the usable workspace. Empty if the linkage has no position.
Region part_to_drive_over(const MapTask& task, const WorkspaceMap& map);

/// The task of checking a finished design.
VerificationTask verification_task(const Design& design);

/// Drives the mechanism over the region's outline and inside, in a frame whose origin is the pole: coordinates far
/// from the table's origin cost no digits. `holds` is true only if
///  1. the loops close at every place, to 1e-12 of the mechanism's size;
///  2. the pen is where k puts it, to copy_error_share of the size, and the similarity fitted to all pairs is k;
///  3. the assembly mode never changes and the opening never leaves its certified interval;
///  4. every limit of the task holds at every place.
/// Otherwise `failure` says what failed first and where. Deterministic unless stopped.
Verification verify(const VerificationTask& task, const VerificationOptions& options = {});
VerificationRun run_verification(const VerificationTask& task, const VerificationOptions& options);

}  // namespace kempe
