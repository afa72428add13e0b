#include "kinematics/planar/run.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "kinematics/planar/singularity.hpp"

namespace kempe {
namespace {

/// Calls `range` for each driven value and `path` for each driven point, with the values' numbers.
template <class Range, class Path>
void each_motion(const DriveSchedule& schedule, const Range& range, const Path& path) {
  for (const auto& motion : schedule.motions) {
    if (const auto* straight = std::get_if<DriverRange>(&motion))
      range(*straight);
    else
      path(std::get<DriverPath>(motion));
  }
}

/// Shares of the motion at which some path turns a corner, between two shares.
std::vector<double> legs_between(const DriveSchedule& schedule, double from, double to) {
  std::set<double> ends{to};
  each_motion(
      schedule, [](const DriverRange&) {},
      [&](const DriverPath& path) {
        const auto first = std::upper_bound(path.ends().begin(), path.ends().end(), from);
        for (auto end = first; end != path.ends().end() && *end < to; ++end) ends.insert(*end);
      });
  return {ends.begin(), ends.end()};
}

/// True if every driver moves straight between two shares of one leg.
bool is_straight(const DriveSchedule& schedule, double from, double to) {
  bool straight = true;
  each_motion(
      schedule, [](const DriverRange&) {},
      [&](const DriverPath& path) {
        straight &= path.pieces()[path.piece_at(0.5 * (from + to))].is_straight();
      });
  return straight;
}

/// The drivers' curve over one leg, its shares those of the leg.
DriverCurve curve_of(const DriveSchedule& schedule, double from, double to) {
  DriverCurve curve;
  const double part = to - from;
  bool bends_known = true;
  curve.values_at = [&schedule, from, to](double share, std::vector<double>& values) {
    values = schedule.values_at(share < 1 ? from + share * (to - from) : to);
  };
  each_motion(
      schedule,
      [&](const DriverRange& range) {
        curve.fastest.push_back(std::abs(range.to - range.from) * part);
        curve.most_bent.push_back(0);
      },
      [&](const DriverPath& path) {
        const double way = path.length() * part;
        const auto curved = path.pieces()[path.piece_at(0.5 * (from + to))].most_curved();
        bends_known &= curved.has_value();
        curve.fastest.insert(curve.fastest.end(), 2, way);
        curve.most_bent.insert(curve.most_bent.end(), 2, curved.value_or(0) * way * way);
      });
  if (bends_known)
    curve.slopes_at = [&schedule, from, to](double share, std::vector<double>& slopes) {
      slopes.clear();
      each_motion(
          schedule,
          [&](const DriverRange& range) { slopes.push_back((range.to - range.from) * (to - from)); },
          [&](const DriverPath& path) {
            const Point slope = path.at(from + share * (to - from)).tangent * path.length() * (to - from);
            slopes.insert(slopes.end(), {slope.x(), slope.y()});
          });
    };
  return curve;
}

/// How far from the linkage, in sizes, a place counts as run away.
constexpr double far_away = 10;

/// What can be said where the work was not enough: what runs off, or that the steps have become small.
std::vector<std::string> describe_giving_up(const PlanarLinkage& linkage, const PlanarPath& path) {
  std::vector<std::string> sentences{std::to_string(path.steps_tried()) + " certified steps were not enough"};
  const PlanarPosition position = path.position();
  for (int body = 1; body < linkage.body_count(); ++body) {
    const double away = position[static_cast<std::size_t>(body)].at.norm() / linkage.size();
    if (away < far_away) continue;
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), away, std::chars_format::general, 3);
    sentences.push_back(linkage.body_name(body) + " runs off: it is " + std::string(text.data(), end.ptr) +
                        " sizes of the linkage away");
  }
  return sentences;
}

/// A linkage on its way along a schedule, with a budget of work.
class ScheduledMotion {
 public:
  ScheduledMotion(const PlanarLinkage& linkage, const DriveSchedule& schedule, PlanarPath path,
                  const RunLimits& limits)
      : linkage_(linkage), schedule_(schedule), path_(std::move(path)), limits_(limits) {}

  /// Moves to a share of the motion, with `more` steps on top of what is left.
  std::optional<RunStop> go_to(double to, std::size_t more) {
    allowed_ += more;
    for (const double end : legs_between(schedule_, share_, to)) {
      path_.set_limits({allowed_ - std::min(allowed_, path_.steps_tried()), limits_.stop});
      const auto moved = move_leg(end);
      if (!moved) {
        share_ += moved.error().share * (end - share_);
        return RunStop{moved.error().end, share_, sentences(moved.error().end)};
      }
      share_ = end;
    }
    return std::nullopt;
  }

  RunFrame frame() {
    const std::vector<double> speeds = schedule_.speeds_at(share_);
    const Eigen::VectorXd rate = path_.velocity(speeds);
    return {share_, path_.values(), path_.position(), rate,
            path_.acceleration(rate, speeds, schedule_.accelerations_at(share_))};
  }

  /// At a stop, where rates need not exist.
  RunFrame frame_without_rates() const { return {share_, path_.values(), path_.position(), {}, {}}; }

 private:
  tl::expected<void, PathStop> move_leg(double to) {
    if (is_straight(schedule_, share_, to)) return path_.advance(schedule_.values_at(to));
    return path_.follow(curve_of(schedule_, share_, to));
  }

  std::vector<std::string> sentences(PathEnd end) const {
    if (end == PathEnd::interrupted) return {};
    if (end == PathEnd::gave_up) return describe_giving_up(linkage_, path_);
    return describe_singularity(linkage_, path_.position());
  }

  const PlanarLinkage& linkage_;
  const DriveSchedule& schedule_;
  PlanarPath path_;
  RunLimits limits_;
  double share_ = 0;
  std::size_t allowed_ = 0;
};

/// Steps that every row of a table may take on top of what is plenty for the whole motion.
constexpr std::size_t steps_a_row = 20;

std::size_t steps_for(const PlanarLinkage& linkage, const RunLimits& limits) {
  return limits.steps > 0 ? limits.steps : plenty_of_steps(linkage.unknown_count());
}

}  // namespace

std::vector<double> DriveSchedule::values_at(double share) const {
  std::vector<double> values;
  each_motion(
      *this,
      [&](const DriverRange& range) {
        values.push_back(share < 1 ? range.from + share * (range.to - range.from) : range.to);
      },
      [&](const DriverPath& path) {
        const Point at = path.at(share).at;
        values.insert(values.end(), {at.x(), at.y()});
      });
  return values;
}

std::vector<double> DriveSchedule::speeds_at(double share) const {
  std::vector<double> speeds;
  each_motion(
      *this,
      [&](const DriverRange& range) {
        speeds.push_back(range.rate.value_or((range.to - range.from) / duration));
      },
      [&](const DriverPath& path) {
        const Point speed = path.at(share).tangent * path.speed.value_or(path.length() / duration);
        speeds.insert(speeds.end(), {speed.x(), speed.y()});
      });
  return speeds;
}

std::vector<double> DriveSchedule::accelerations_at(double share) const {
  std::vector<double> accelerations;
  each_motion(
      *this, [&](const DriverRange&) { accelerations.push_back(0); },
      [&](const DriverPath& path) {
        const double speed = path.speed.value_or(path.length() / duration);
        const Point bend = path.at(share).bend * speed * speed;
        accelerations.insert(accelerations.end(), {bend.x(), bend.y()});
      });
  return accelerations;
}

tl::expected<PlanarRun, NoPathHere> run_motion(const PlanarLinkage& linkage, const PlanarPosition& start,
                                               const DriveSchedule& schedule, int steps,
                                               const RunLimits& limits) {
  auto path = PlanarPath::from(linkage, start, schedule.values_at(0));
  if (!path) return tl::unexpected(path.error());
  ScheduledMotion motion(linkage, schedule, std::move(*path), limits);
  PlanarRun run;
  run.frames.push_back(motion.frame());
  std::size_t more = steps_for(linkage, limits);
  for (int step = 1; step <= steps; ++step) {
    run.stop = motion.go_to(static_cast<double>(step) / steps, more + steps_a_row);
    run.frames.push_back(run.stop ? motion.frame_without_rates() : motion.frame());
    if (run.stop) return run;
    more = 0;
  }
  return run;
}

tl::expected<PlanarRun, NoPathHere> run_to(const PlanarLinkage& linkage, const PlanarPosition& start,
                                           const DriveSchedule& schedule, double share,
                                           const RunLimits& limits) {
  auto path = PlanarPath::from(linkage, start, schedule.values_at(0));
  if (!path) return tl::unexpected(path.error());
  ScheduledMotion motion(linkage, schedule, std::move(*path), limits);
  PlanarRun run;
  if (share > 0) run.stop = motion.go_to(share, steps_for(linkage, limits));
  run.frames.push_back(run.stop ? motion.frame_without_rates() : motion.frame());
  return run;
}

}  // namespace kempe
