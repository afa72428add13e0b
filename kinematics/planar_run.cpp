#include "kinematics/planar_run.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "kinematics/planar_singularity.hpp"

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
        for (const double end : path.ends())
          if (end > from && end < to) ends.insert(end);
      });
  return {ends.begin(), ends.end()};
}

/// True if every driver moves straight between two shares of one leg.
bool is_straight(const DriveSchedule& schedule, double from, double to) {
  bool straight = true;
  each_motion(
      schedule, [](const DriverRange&) {},
      [&](const DriverPath& path) {
        straight &= path.pieces[path.piece_at(0.5 * (from + to))].is_straight();
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
        const auto curved = path.pieces[path.piece_at(0.5 * (from + to))].most_curved();
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

tl::expected<void, PathStop> move_leg(PlanarPath& path, const DriveSchedule& schedule, double from,
                                      double to) {
  if (is_straight(schedule, from, to)) return path.advance(schedule.values_at(to));
  return path.follow(curve_of(schedule, from, to));
}

/// Moves to a share of the motion; on a stop, the share reached.
tl::expected<void, std::pair<PathEnd, double>> move_to(PlanarPath& path, const DriveSchedule& schedule,
                                                       double from, double to) {
  for (const double end : legs_between(schedule, from, to)) {
    const auto moved = move_leg(path, schedule, from, end);
    if (!moved)
      return tl::unexpected(std::pair{moved.error().end, from + moved.error().share * (end - from)});
    from = end;
  }
  return {};
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
                                               const DriveSchedule& schedule, int steps) {
  auto path = PlanarPath::from(linkage, start, schedule.values_at(0));
  if (!path) return tl::unexpected(path.error());
  PlanarRun run;
  const auto record = [&](double share) {
    const std::vector<double> speeds = schedule.speeds_at(share);
    const Eigen::VectorXd rate = path->velocity(speeds);
    run.frames.push_back({share, path->values(), path->position(), rate,
                          path->acceleration(rate, speeds, schedule.accelerations_at(share))});
  };
  record(0);
  for (int step = 1; step <= steps; ++step) {
    const double from = run.frames.back().share, to = static_cast<double>(step) / steps;
    const auto moved = move_to(*path, schedule, from, to);
    if (!moved) {
      const auto [end, share] = moved.error();
      run.stop = RunStop{end, share, describe_singularity(linkage, path->position())};
      run.frames.push_back({share, path->values(), path->position(), {}, {}});
      return run;
    }
    record(to);
  }
  return run;
}

}  // namespace kempe
