#include "forward_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace kempe::bench {
namespace {

std::vector<Point> all_places(const LinkageModel& model, const PlanarPosition& position) {
  std::vector<Point> places;
  for (const ModelPoint& point : model.points) places.push_back(place(position, point.place));
  return places;
}

/// The share of the drive at a pose: a degree a pose, back and forth unless it closes on itself.
double share_at(int pose, double degrees, bool closes) {
  const double turns = pose / degrees;
  if (closes) return turns - std::floor(turns);
  const double phase = std::fmod(turns, 2);
  return phase <= 1 ? phase : 2 - phase;
}

std::vector<std::vector<double>> drive(const LinkageModel& model, int poses) {
  const auto& motion = model.schedule.motions.at(0);
  const auto* range = std::get_if<DriverRange>(&motion);
  const double degrees = range ? kempe::degrees(std::abs(range->to - range->from)) : 360;
  const bool closes = std::abs(degrees - 360) < 1e-9;
  std::vector<std::vector<double>> values;
  for (int pose = 0; pose < poses; ++pose) {
    values.push_back(model.schedule.values_at(share_at(pose, degrees, closes)));
    // A turning crank goes on; it does not jump back by a turn.
    if (range && closes) values.back()[0] += (range->to - range->from) * std::floor(pose / degrees);
  }
  return values;
}

std::size_t number_of(const LinkageModel& model, const std::string& name) {
  return model.point_numbers.at(name);
}

/// The point that the drive moves: the path's, or the far end of the crank.
std::size_t driven_point(const LinkageFile& file, const LinkageModel& model) {
  const auto& what = file.drivers.at(0).what;
  if (const auto* point = std::get_if<DrivenPoint>(&what)) return number_of(model, point->point);
  const auto& crank = std::get<DrivenAngle>(what).link;
  for (const FileLink& link : file.links)
    if (link.name == crank)
      for (const auto& joint : link.joints)
        if (!model.is_fixed(joint.first)) return number_of(model, joint.first);
  throw std::runtime_error("no driven point");
}

std::vector<PointTask::Bar> bars_of(const LinkageFile& file, const LinkageModel& model,
                                    const PointTask& points) {
  std::vector<PointTask::Bar> bars;
  const auto add = [&](const NamedPoint& a, const NamedPoint& b) {
    const std::size_t i = number_of(model, a.first), j = number_of(model, b.first);
    if (!points.fixed[i] || !points.fixed[j]) bars.push_back({i, j, (a.second - b.second).norm()});
  };
  for (const FileLink& link : file.links) {
    add(link.joints.at(0), link.joints.at(1));
    for (std::size_t k = 2; k < link.joints.size(); ++k) {
      add(link.joints[0], link.joints[k]);
      add(link.joints[1], link.joints[k]);
    }
  }
  return bars;
}

PointTask points_of(const LinkageFile& file, const ForwardTask& task) {
  PointTask points;
  points.start = all_places(task.model, task.start);
  points.driven = driven_point(file, task.model);
  for (std::size_t i = 0; i < task.model.points.size(); ++i) {
    points.names.push_back(task.model.points[i].name);
    points.fixed.push_back(task.model.is_fixed(points.names.back()) || i == points.driven);
  }
  points.bars = bars_of(file, task.model, points);
  return points;
}

}  // namespace

double cpu_seconds() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

ForwardTask forward_task(const std::string& name, int poses) {
  const auto file = read_linkage_file(name);
  if (!file) throw std::runtime_error("cannot read " + name);
  ForwardTask task{file->name, linkage_model(*file), {}, {}, {}};
  auto assembly_modes = start_assembly_modes(*file, task.model);
  if (!assembly_modes) throw std::runtime_error(name + " does not assemble");
  task.start = std::move(assembly_modes->front());
  task.values = drive(task.model, poses);
  task.points = points_of(*file, task);
  const ForwardResult moved = move_with_kempe(task, 1);
  const std::size_t count = task.model.points.size();
  for (std::size_t pose = 0; pose < task.values.size(); ++pose)
    task.points.places.push_back(moved.places.at(pose * count + task.points.driven));
  return task;
}

ForwardResult move_with_kempe(const ForwardTask& task, int rounds) {
  ForwardResult result;
  result.us_per_pose = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    auto path = PlanarPath::from(task.model.linkage, task.start, task.values.front());
    if (!path) throw std::runtime_error(task.name + " does not start");
    result.places.clear();
    result.places.reserve(task.values.size() * task.model.points.size());
    const double begin = cpu_seconds();
    for (const auto& values : task.values) {
      if (!path->advance(values)) ++result.failures;
      for (const ModelPoint& point : task.model.points) result.places.push_back(path->at(point.place));
    }
    const double spent = cpu_seconds() - begin;
    result.us_per_pose = std::min(result.us_per_pose, 1e6 * spent / static_cast<double>(task.values.size()));
  }
  return result;
}

double largest_distance(const ForwardResult& a, const ForwardResult& b) {
  double largest = a.places.size() == b.places.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.places.size(), b.places.size()); ++i)
    largest = std::max(largest, (a.places[i] - b.places[i]).norm());
  return largest;
}

std::string as_json(const PointTask& task, const ForwardResult& answer) {
  nlohmann::ordered_json json;
  const auto pairs = [](const std::vector<Point>& points) {
    auto list = nlohmann::ordered_json::array();
    for (const Point& point : points) list.push_back({point.x(), point.y()});
    return list;
  };
  json["names"] = task.names;
  json["start"] = pairs(task.start);
  json["fixed"] = task.fixed;
  for (const auto& bar : task.bars) json["bars"].push_back({bar.a, bar.b, bar.length});
  json["driven"] = task.driven;
  json["places"] = pairs(task.places);
  json["answer"] = pairs(answer.places);
  return json.dump();
}

}  // namespace kempe::bench
