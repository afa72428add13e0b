#include "reports/solve_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "kinematics/planar_rates.hpp"

namespace kempe {
namespace {

struct Column {
  std::string name;
  std::function<double(const RunFrame&)> value;
  bool needs_rates = false;
};

/// Angle at b between the ways to a and c, folded to 0..90 degrees.
double transmission_angle(const LinkageModel& model, const std::array<std::string, 3>& points,
                          const RunFrame& frame) {
  const Point b = place(frame.position, model.point(points[1]));
  const Point u = place(frame.position, model.point(points[0])) - b,
              v = place(frame.position, model.point(points[2])) - b;
  return degrees(std::atan2(std::abs(cross(u, v)), std::abs(u.dot(v))));
}

class Columns {
 public:
  Columns(const LinkageFile& file, const LinkageModel& model, int steps) : file_(file), model_(model) {
    add("step", [steps](const RunFrame& frame) { return frame.share * steps; });
    add("time_s", [&file](const RunFrame& frame) { return frame.share * file.duration; });
    for (const std::string& name : file.output.points) add_point(name);
    for (const std::string& name : file.output.angles) add_link(name);
    for (const auto& points : file.output.transmission)
      add(fmt::format("transmission_{}_{}_{}_deg", points[0], points[1], points[2]),
          [&model, points](const RunFrame& frame) { return transmission_angle(model, points, frame); });
  }

  std::vector<Column> all;

 private:
  void add(std::string name, std::function<double(const RunFrame&)> value, bool needs_rates = false) {
    all.push_back({std::move(name), std::move(value), needs_rates});
  }

  /// x and y of something of a point, in the file's unit.
  void add_pair(const std::string& name, const std::string& letter, const std::string& per, bool needs_rates,
                std::function<Point(const RunFrame&)> value) {
    for (const int axis : {0, 1})
      add(
          fmt::format("{}_{}{}_{}{}", name, letter, axis == 0 ? 'x' : 'y', file_.unit.name, per),
          [value, axis, unit = file_.unit.in_mm](const RunFrame& frame) { return value(frame)[axis] / unit; },
          needs_rates);
  }

  void add_point(const std::string& name) {
    const BodyPoint point = model_.point(name);
    add_pair(name, "", "", false, [point](const RunFrame& f) { return place(f.position, point); });
    if (file_.output.velocities)
      add_pair(name, "v", "_per_s", true,
               [point](const RunFrame& f) { return velocity_of(f.position, f.rate, point); });
    if (file_.output.accelerations)
      add_pair(name, "a", "_per_s2", true,
               [point](const RunFrame& f) { return acceleration_of(f.position, f.rate, f.second, point); });
  }

  void add_link(const std::string& name) {
    const int body = model_.body(name);
    add(name + "_angle_deg",
        [body](const RunFrame& f) { return degrees(f.position[static_cast<std::size_t>(body)].angle); });
    if (file_.output.velocities)
      add(
          name + "_rate_rad_per_s", [body](const RunFrame& f) { return spin_of(f.rate, body); }, true);
    if (file_.output.accelerations)
      add(
          name + "_acceleration_rad_per_s2", [body](const RunFrame& f) { return spin_of(f.second, body); },
          true);
  }

  const LinkageFile& file_;
  const LinkageModel& model_;
};

}  // namespace

SolveTable solve_table(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run, int steps) {
  const Columns columns(file, model, steps);
  SolveTable table;
  for (const Column& column : columns.all) table.columns.push_back(column.name);
  for (const RunFrame& frame : run.frames) {
    auto& row = table.rows.emplace_back();
    for (const Column& column : columns.all) {
      const bool known = !column.needs_rates || frame.rate.size() > 0;
      row.push_back(known ? std::optional(column.value(frame) + 0.0) : std::nullopt);  // + 0.0: no -0
    }
  }
  return table;
}

std::string csv_text(const SolveTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i]) text += fmt::format("{}", *row[i]);
      text += i + 1 < row.size() ? ',' : '\n';
    }
  return text;
}

}  // namespace kempe
