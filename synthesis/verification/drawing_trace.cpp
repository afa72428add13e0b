#include "synthesis/verification/drawing_trace.hpp"

#include <algorithm>
#include <cmath>
#include <tl/expected.hpp>

#include "geometry/chance.hpp"
#include "geometry/segment_distance.hpp"
#include "kinematics/instrument.hpp"
#include "synthesis/verification/slack.hpp"

namespace kempe {

std::string_view name(NotReached why) {
  switch (why) {
    case NotReached::too_far: return "beyond the outer reach";
    case NotReached::too_near: return "inside the inner reach";
    case NotReached::beyond_change_point: return "beyond the change point";
    case NotReached::outside_the_opening: return "outside the usable opening";
    case NotReached::obstacle: return "contact with an obstacle";
    case NotReached::not_closing: break;
  }
  return "the loops do not close";
}

namespace {

/// The measures with which an instrument is closed at each pose: as drawn, or as one made within tolerances
/// with its pins against the walls of their holes.
class MeasuresInUse {
 public:
  MeasuresInUse(const Instrument& instrument, const std::optional<TraceOptions::Made>& made)
      : own_(instrument.drawn), chance_(made ? made->seed : 0) {
    if (!made) return;
    for (const Measure measure : {Measure::VA, Measure::VB, Measure::AX, Measure::CX, Measure::offset_A,
                                  Measure::BC, Measure::CY, Measure::offset_B})
      own_[index_of(measure)] += chance_.symmetric(made->tolerance.length);
    wall_ = 0.5 * made->tolerance.play;
    for (double& direction : directions_) direction = chance_.symmetric(pi);
  }

  /// The pins roll on along their holes while the tracer moves by `way` (mm).
  void advance(double way) {
    constexpr double turning_length = 20;  ///< mm over which a pin's direction wanders by a radian
    if (wall_ > 0)
      for (double& direction : directions_) direction += std::sqrt(way / turning_length) * chance_.normal();
  }

  /// `pose`: about where the joints are, for the directions of the links.
  Measures at(const Pose& pose) const {
    if (wall_ == 0) return own_;
    const auto shift = [&](int pin) { return std::polar(wall_, directions_[static_cast<std::size_t>(pin)]); };
    const auto along = [&](Complex moved, const Point& from, const Point& to) {
      const Complex way = as_complex(to - from);
      return (moved * std::conj(way)).real() / std::abs(way);
    };
    Measures measures = own_;
    measures[index_of(Measure::pole_x)] += shift(0).real();
    measures[index_of(Measure::pole_y)] += shift(0).imag();
    measures[index_of(Measure::VA)] += along(shift(1), pose.V, pose.A);
    measures[index_of(Measure::VB)] += along(shift(2) - shift(3), pose.V, pose.B);
    move_C(measures, shift(4), pose);
    return measures;
  }

 private:
  /// Plate A-C-X measured from the place in its hole C where the pin rests.
  static void move_C(Measures& measures, Complex moved, const Pose& pose) {
    const Complex axis = as_complex(pose.X - pose.C) / std::abs(as_complex(pose.X - pose.C));
    const Complex shift = moved * std::conj(axis);
    double& CX = measures[index_of(Measure::CX)];
    double& AX = measures[index_of(Measure::AX)];
    double& offset = measures[index_of(Measure::offset_A)];
    const Complex X = CX - shift, A = Complex(CX - AX, offset) - shift;
    const Complex turned = A * std::conj(X) / std::abs(X);
    CX = std::abs(X);
    AX = CX - turned.real();
    offset = turned.imag();
  }

  Measures own_;
  Chance chance_;
  double wall_ = 0;
  std::array<double, 5> directions_{};
};

using Reached = tl::expected<Pose, NotReached>;

/// At least 1; as a double, for it may be beyond every int.
double steps_over(double length, double step) { return std::max(1.0, std::ceil(length / step)); }

class Tracing {
 public:
  Tracing(const TraceTask& task, const TraceOptions& options)
      : task_(task), options_(options), instrument_(instrument_of(task.mechanism.linkage)),
        measures_(instrument_, options.made) {}

  Trace run(const std::vector<DrawnStroke>& strokes) {
    for (std::size_t i = 0; i < strokes.size() && goes_on(); ++i) follow(i, strokes[i]);
    return std::move(trace_);
  }

 private:
  static NotReached cause_of(Unreachable why) {
    switch (why) {
      case Unreachable::too_far: return NotReached::too_far;
      case Unreachable::too_near: return NotReached::too_near;
      case Unreachable::beyond_change_point: break;
    }
    return NotReached::beyond_change_point;
  }

  /// Whether the drawn linkage may stand here; its pose only lends directions and is not what the pen does.
  Reached allowed(const Point& tracer) const {
    const CopyingLinkage& linkage = task_.mechanism.linkage;
    const auto opening = linkage.opening_at((tracer - linkage.pole()).norm());
    if (!opening) return tl::unexpected(cause_of(opening.error()));
    if (*opening < task_.opening.lower - slack::traced_slack ||
        *opening > task_.opening.upper + slack::traced_slack)
      return tl::unexpected(NotReached::outside_the_opening);
    if (has_obstructions(task_.mechanism)) {
      const Verdict verdict = verdict_at(task_.mechanism, tracer);
      if (!verdict.free && !verdict.uncertain) return tl::unexpected(NotReached::obstacle);
    }
    const Point reach = tracer - linkage.pole();
    return linkage.pose_at(*opening, std::atan2(reach.y(), reach.x()));
  }

  /// The pose in which the loops close with the tracer here.
  Reached closed(const Point& tracer) const {
    return allowed(tracer).and_then([&](const Pose& about) -> Reached {
      const auto pose = pose_of(instrument_, measures_.at(about), tracer);
      if (!pose) return tl::unexpected(NotReached::not_closing);
      return *pose;
    });
  }

  bool goes_on() {
    if (trace_.complete && options_.stop && options_.stop()) trace_.complete = false;
    return trace_.complete;
  }

  void follow(std::size_t index, const DrawnStroke& stroke) {
    if (stroke.points.empty()) return;
    stroke_ = index;
    Stroke points = stroke.points;
    if (stroke.closed) points.push_back(points.front());
    const std::size_t first_drawn = trace_.drawn.size(), first_missing = trace_.missing.size();
    heading_ = Point::Zero();
    for (std::size_t i = 0; i + 1 < points.size() && heading_.isZero(); ++i) head(points[i], points[i + 1]);
    Reached here = visit(points.front());
    begin(points.front(), here);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) here = follow_segment(points[i], points[i + 1], here);
    finish();
    const bool in_one = trace_.complete && stroke.closed && trace_.drawn.size() == first_drawn + 1 &&
                        trace_.missing.size() == first_missing;
    // A made or loaded instrument does not come back to where it began: its line stays open, as on paper.
    if (in_one && !options_.made && !options_.gives_way) {
      trace_.drawn.back().closed = true;
      trace_.drawn.back().points.pop_back();
      if (options_.keep_hand) trace_.drawn.back().hand.pop_back();
    }
  }

  Reached follow_segment(const Point& from, const Point& to, Reached here) {
    const double length = (to - from).norm();
    turn_to(from, to, here);
    const int steps = static_cast<int>(steps_over(length, options_.step));
    Point last = from;
    for (int i = 1; i <= steps && goes_on(); ++i) {
      const Point place = i == steps ? to : Point(from + (to - from) * i / steps);
      measures_.advance(length / steps);
      const Reached there = visit(place);
      go(last, here, place, there);
      here = there;
      last = place;
    }
    return here;
  }

  Reached visit(const Point& tracer) {
    Reached pose = closed(tracer);
    ++trace_.poses_tried;
    if (!pose) {
      ++trace_.poses_missed;
      ++trace_.missed_by_cause[static_cast<std::size_t>(pose.error())];
    }
    if (options_.keep_poses)
      trace_.poses.push_back({stroke_, tracer, pose ? std::optional(*pose) : std::nullopt, heading_});
    return pose;
  }

  void head(const Point& from, const Point& to) {
    if (to != from) heading_ = (to - from).normalized();
  }

  /// At a corner the load turns too, and moves the pen while the tracer rests.
  void turn_to(const Point& from, const Point& to, const Reached& here) {
    constexpr double smallest_turn = radians(1);
    const Point before = heading_;
    head(from, to);
    const bool turned_back = before.dot(heading_) < 0;
    const bool turns = turned_back || std::abs(cross(before, heading_)) > std::sin(smallest_turn);
    if (options_.gives_way && here && turns) add(from, here);
  }

  /// Where the pen is under its load, and what the hand then holds; without load, where it is.
  Point under_load(const Pose& pose) {
    const Point& pen = pose[task_.mechanism.linkage.pen_joint()];
    if (!options_.work) return pen;
    const auto work = options_.work->at(pose, heading_);
    if (options_.keep_hand) line_.hand.push_back(work ? work->hand.norm() : infinity);
    if (!work || !options_.gives_way) return pen;
    if (!work->counts_layers) ++trace_.without_layers;
    return pen + work->give;
  }

  Point image(const Point& tracer) const {
    const CopyingLinkage& linkage = task_.mechanism.linkage;
    return linkage.pole() + as_point(linkage.k() * as_complex(tracer - linkage.pole()));
  }

  void begin(const Point& tracer, const Reached& pose) {
    line_ = {stroke_, {}, false, {}};
    drawing_ = pose.has_value();
    add(tracer, pose);
  }

  void add(const Point& tracer, const Reached& pose) {
    if (!pose) return line_.points.push_back(image(tracer));
    const Point pen = under_load(*pose);
    trace_.departure = std::max(trace_.departure, (pen - image(tracer)).norm());
    line_.points.push_back(pen);
  }

  void finish() {
    if (line_.points.size() > 1) (drawing_ ? trace_.drawn : trace_.missing).push_back(std::move(line_));
    line_ = {};
  }

  void go(const Point& from, const Reached& here, const Point& to, const Reached& there) {
    if (here.has_value() == there.has_value()) {
      // Of a straight way the place nearest to the pole may lie inside the inner reach, or alone be within reach.
      if (const auto nearest = between_nearest_to_pole(from, to)) {
        const Reached at_nearest = closed(*nearest);
        if (at_nearest.has_value() != here.has_value()) {
          go(from, here, *nearest, at_nearest);
          return go(*nearest, at_nearest, to, there);
        }
      }
      add(to, there);
      (there ? trace_.drawn_length : trace_.missing_length) += (to - from).norm();
      return;
    }
    const auto [reached, beyond] = here ? boundary(from, to) : boundary(to, from);
    const Reached at_edge = closed(reached);
    const Point& edge = reached;
    // The line up to the edge and the line from it on: both hold the edge's point.
    const Reached missing = tl::unexpected(NotReached::not_closing);
    add(edge, here ? at_edge : missing);
    finish();
    begin(edge, there ? at_edge : missing);
    add(to, there);
    (here ? trace_.drawn_length : trace_.missing_length) += (edge - from).norm();
    (there ? trace_.drawn_length : trace_.missing_length) += (to - edge).norm();
  }

  /// The place of a segment nearest to the pole, if that is none of its ends.
  std::optional<Point> between_nearest_to_pole(const Point& from, const Point& to) const {
    const double share = nearest_share(task_.mechanism.linkage.pole(), from, to);
    if (!(share > 0 && share < 1)) return std::nullopt;
    return from + share * (to - from);
  }

  /// The last place reached and the first one not, nearer to each other than slack::cut_precision.
  std::pair<Point, Point> boundary(Point reached, Point beyond) const {
    const double near_enough = slack::cut_precision * std::min(1.0, task_.mechanism.linkage.size());
    while ((beyond - reached).norm() > near_enough) {
      const Point middle = 0.5 * (reached + beyond);
      if (middle == reached || middle == beyond) break;
      (closed(middle) ? reached : beyond) = middle;
    }
    return {reached, beyond};
  }

  const TraceTask& task_;
  const TraceOptions& options_;
  Instrument instrument_;
  MeasuresInUse measures_;
  Trace trace_;
  std::size_t stroke_ = 0;
  Point heading_ = Point::Zero();
  TracedLine line_;
  bool drawing_ = false;
};

}  // namespace

double poses_along(const std::vector<DrawnStroke>& strokes, double step) {
  double poses = 0;
  for (const DrawnStroke& stroke : strokes) {
    const std::size_t count = stroke.points.size();
    if (count == 0) continue;
    poses += 1;
    for (std::size_t i = stroke.closed ? 0 : 1; i < count; ++i)
      poses += steps_over((stroke.points[i] - stroke.points[(i + count - 1) % count]).norm(), step);
  }
  return poses;
}

Trace trace_drawing(const TraceTask& task, const std::vector<DrawnStroke>& strokes,
                    const TraceOptions& options) {
  return Tracing(task, options).run(strokes);
}

}  // namespace kempe
