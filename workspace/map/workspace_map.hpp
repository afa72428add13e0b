#pragma once
// The map: where the tracer can go, where the real links can follow, and why not elsewhere.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/stop_flag.hpp"
#include "workspace/map/losses.hpp"
#include "workspace/map_task.hpp"

namespace kempe {

struct MapOptions {
  /// Refinement stops when the uncertain band takes less than this share of the collision-free area.
  double map_tolerance = 0.005;
  bool largest_sheets = true;  ///< look for them; the slowest part without obstacles
  int threads = 1;             ///< to look for sheets on; their number changes nothing
  StopFlag stop{};             ///< set: the map stays as coarse as it is
  /// Told after each step and each refinement the share of the work done, 0..1, which never falls.
  std::function<void(double share)> progress{};
};

/// The largest rectangle of a kind that fits the collision-free workspace.
struct FittingSheet {
  std::string name;              ///< "A4", or "region's proportions"
  double width = 0, height = 0;  ///< mm
  Point centre = Point::Zero();
  double turn = 0;  ///< rad, of the width's direction against the x axis
};

/// Is the region covered by one component of the collision-free workspace? Limits and clearances are taken as
/// kept where they are missed by less than 1e-8 of the outer reach, so that a design optimal at a limit
/// counts.
struct Coverage {
  bool covered = false;          ///< certainly: every point of the region, in one component
  bool uncertain = false;        ///< neither proven nor refuted; then covered is false
  std::string why_not;           ///< a sentence for a person; empty if covered
  std::optional<Point> witness;  ///< a point of the region that is not covered
  std::optional<Cause> cause;
  std::vector<std::string> parts;
  /// Where parts of the region are lost: how much to what, the largest first. Empty if covered, or if map or
  /// region have so many corners that the exact intersection would take seconds.
  std::vector<RegionLoss> losses = {};
};

struct WorkspaceMap {
  /// Reach, change point, transmission and self-contact kept all over it: of all such intervals the one that
  /// holds the region's openings, or else the widest; empty if there is none.
  OpeningInterval certified_opening;
  ArcRegion reachable;       ///< the reach of the chosen assembly mode
  ArcRegion usable;          ///< transmission kept
  ArcRegion collision_free;  ///< usable, certainly without contact
  ArcRegion uncertain;       ///< neither proven free nor proven in contact
  std::vector<LostArea> lost;
  Coverage coverage;
  std::vector<FittingSheet> largest_sheets;
  double clearance_min = 0;  ///< mm, smallest gap while the tracer covers the region; infinite: not known
  std::string clearance_min_parts;         ///< "link VA and link BCY"
  Point clearance_min_at = Point::Zero();  ///< tracer's place
  double map_tolerance = 0.005;            ///< of the options it was made with
  /// False: stopped early. What is called free or lost is, but more is uncertain than the tolerance allows, sheets were not
  /// looked for, and the smallest gap and what covers the region may not be known.
  bool complete = true;
};

/// Maps a linkage. Deterministic unless stopped. Whether the region is covered may then be uncertain.
WorkspaceMap map_workspace(const MapTask& task, const MapOptions& options);

/// Why the tracer cannot stand at a point, or nothing if it can. One sentence's worth.
struct Verdict {
  bool free = false;
  bool uncertain = false;
  std::optional<Cause> cause;
  std::vector<std::string> parts;
  std::string sentence;  ///< for a person, with figures
};
Verdict verdict_at(const MapTask& task, const Point& tracer);

}  // namespace kempe
