#pragma once
// A drawing copied through the mechanism, pose by pose: the tracer follows every stroke, the loops are closed
// from the link lengths at each place, and the pen draws where it then stands. The similarity is never used
// to place the pen.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "specs/drawings/curve_flattening.hpp"
#include "synthesis/loads/hand_work.hpp"
#include "workspace/map/workspace_map.hpp"

namespace kempe {

/// Why the tracer cannot be somewhere.
enum class NotReached {
  too_far,              ///< beyond the outer reach
  too_near,             ///< inside the inner reach
  beyond_change_point,  ///< only with the parallelogram flipped
  outside_the_opening,  ///< beyond the certified opening: transmission limit or contact of the linkage with
                        ///< itself
  obstacle,             ///< a link, a pin or a post would meet an obstacle
  not_closing           ///< an instrument made within its tolerances cannot be put together here
};
inline constexpr std::array<NotReached, 6> all_not_reached{NotReached::too_far,
                                                           NotReached::too_near,
                                                           NotReached::beyond_change_point,
                                                           NotReached::outside_the_opening,
                                                           NotReached::obstacle,
                                                           NotReached::not_closing};
/// "beyond the outer reach" and so on.
std::string_view name(NotReached why);

/// What draws.
struct TraceTask {
  MapTask mechanism;        ///< linkage, parts and obstacles; region and copy_gap play no part
  OpeningInterval opening;  ///< certified: poses must stay inside
};

struct TraceOptions {
  double step = 0.5;        ///< mm, > 0, along the original: poses are at most this far apart
  bool keep_poses = false;  ///< fill Trace::poses
  /// Draw with an instrument as it might be made: each of its measures off by up to the length tolerance
  /// (evenly spread), each pin against its hole's wall in a direction that wanders while it draws.
  struct Made {
    std::uint64_t seed = 0;
    Tolerance tolerance = {};
  };
  std::optional<Made> made{};
  std::optional<HandWork> work{};  ///< what the load does
  bool keep_hand = false;          ///< with `work`: fill TracedLine::hand
  bool gives_way = false;          ///< with `work`: the pen draws where its load pushes it
  std::function<bool()> stop{};    ///< true ends it; asked at every pose
};

/// A line that the pen drew, or one that is missing (then: where it should be), mm on the table.
struct TracedLine {
  std::size_t stroke = 0;  ///< of the original, from 0
  Stroke points;
  bool closed = false;
  std::vector<double>
      hand{};  ///< N at each point of a line drawn, friction included; empty without TraceOptions::keep_hand
};

struct TracedPose {
  std::size_t stroke = 0;
  Point tracer = Point::Zero();
  std::optional<Pose> pose;  ///< absent: not reached
  Point heading =
      Point::Zero();  ///< unit vector, along which the tracer comes here; zero on a stroke without length
};

struct Trace {
  std::vector<TracedLine> drawn, missing;  ///< in the original's order and direction
  std::vector<TracedPose> poses;
  std::size_t poses_tried = 0, poses_missed = 0;
  /// Poses, in the order of all_not_reached.
  std::array<std::size_t, all_not_reached.size()> missed_by_cause{};
  /// Of a pen that gives way: places at which what the links' layers add is not counted.
  std::size_t without_layers = 0;
  double drawn_length = 0, missing_length = 0;  ///< mm of the original
  double departure = 0;  ///< mm, largest distance of the pen from the similar image at any pose
  bool complete = true;  ///< false: stopped before every stroke had been followed to its end
};

/// How many poses trace_drawing() tries; where they are more than `most_traced_poses`, it must not be asked.
double poses_along(const std::vector<DrawnStroke>& strokes, double step);
inline constexpr double most_traced_poses = 5e6;

/// Copies the strokes (mm, table frame).
///  1. Every point of a drawn line is the pen's place in a pose whose loops close and whose opening lies in
///     `task.opening`; the corners of the original are among the poses.
///  2. Order and direction of the strokes are kept; where the tracer cannot follow, the line is cut to 1e-9 mm of the
///     last place that it reaches.
///  3. The same task, strokes and options give the same trace.
Trace trace_drawing(const TraceTask& task, const std::vector<DrawnStroke>& strokes,
                    const TraceOptions& options = {});

}  // namespace kempe
