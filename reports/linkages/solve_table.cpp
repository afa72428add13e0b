#include "reports/linkages/solve_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/fixed_text.hpp"
#include "kinematics/planar/rates.hpp"
#include "reports/linkages/forces.hpp"

namespace kempe {
namespace {

struct Column {
  std::string name;
  ColumnKind kind;
  std::function<double(const RunFrame&)> value;

  /// Rates do not exist at a dead point.
  bool needs_rates() const {
    return kind == ColumnKind::velocity || kind == ColumnKind::acceleration || kind == ColumnKind::spin ||
           kind == ColumnKind::spin_change;
  }
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
    add("step", ColumnKind::step, [steps](const RunFrame& frame) { return frame.share * steps; });
    add("time_s", ColumnKind::time, [&file](const RunFrame& frame) { return frame.share * file.duration; });
    for (const std::string& name : file.output.points) add_point(name);
    for (const std::string& name : file.output.angles) add_link(name);
    for (const auto& points : file.output.transmission)
      add(fmt::format("transmission_{}_{}_{}_deg", points[0], points[1], points[2]), ColumnKind::angle,
          [&model, points](const RunFrame& frame) { return transmission_angle(model, points, frame); });
  }

  std::vector<Column> all;

 private:
  void add(std::string name, ColumnKind kind, std::function<double(const RunFrame&)> value) {
    all.push_back({std::move(name), kind, std::move(value)});
  }

  /// x and y of something of a point, in the file's unit; `letter` and `per` say what in the column's name.
  void add_pair(const std::string& name, ColumnKind kind, const std::string& letter, const std::string& per,
                const std::function<Point(const RunFrame&)>& value) {
    for (const int axis : {0, 1})
      add(fmt::format("{}_{}{}_{}{}", name, letter, axis == 0 ? 'x' : 'y', file_.unit.name, per), kind,
          [value, axis, unit = file_.unit.in_mm](const RunFrame& frame) {
            return value(frame)[axis] / unit;
          });
  }

  void add_point(const std::string& name) {
    const BodyPoint point = model_.point(name);
    add_pair(name, ColumnKind::place, "", "",
             [point](const RunFrame& f) { return place(f.position, point); });
    if (file_.output.velocities)
      add_pair(name, ColumnKind::velocity, "v", "_per_s",
               [point](const RunFrame& f) { return velocity_of(f.position, f.rate, point); });
    if (file_.output.accelerations)
      add_pair(name, ColumnKind::acceleration, "a", "_per_s2",
               [point](const RunFrame& f) { return acceleration_of(f.position, f.rate, f.second, point); });
  }

  void add_link(const std::string& name) {
    const int body = model_.body(name);
    add(name + "_angle_deg", ColumnKind::angle,
        [body](const RunFrame& f) { return degrees(f.position[static_cast<std::size_t>(body)].angle); });
    if (file_.output.velocities)
      add(name + "_rate_rad_per_s", ColumnKind::spin,
          [body](const RunFrame& f) { return spin_of(f.rate, body); });
    if (file_.output.accelerations)
      add(name + "_acceleration_rad_per_s2", ColumnKind::spin_change,
          [body](const RunFrame& f) { return spin_of(f.second, body); });
  }

  const LinkageFile& file_;
  const LinkageModel& model_;
};

/// Decimals that show 15 digits of the largest value of a column's kind: what lies beyond is rounding.
int decimals_of(const SolveTable& table, std::size_t column) {
  double largest = 0;
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i] && table.kinds[i] == table.kinds[column]) largest = std::max(largest, std::abs(*row[i]));
  return largest > 0 ? std::clamp(14 - static_cast<int>(std::floor(std::log10(largest))), 0, 300) : 0;
}

/// Adds the forces to a table whose rows are those of the run.
void add_forces(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run, SolveTable& table) {
  const std::vector<ForceColumn> columns = force_columns(file, model);
  if (columns.empty()) return;
  for (const ForceColumn& column : columns) {
    table.columns.push_back(column.name);
    table.kinds.push_back(column.kind());
  }
  ForceFinder finder(model);
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const auto reactions = finder.at(run.frames[i]);
    for (const ForceColumn& column : columns) {
      auto value =
          reactions ? column.value((*reactions)[static_cast<std::size_t>(column.constraint)]) : std::nullopt;
      table.rows[i].push_back(value ? std::optional(*value + 0.0) : std::nullopt);  // + 0.0: no -0
    }
  }
}

}  // namespace

SolveTable solve_table(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run, int steps) {
  const Columns columns(file, model, steps);
  SolveTable table;
  for (const Column& column : columns.all) {
    table.columns.push_back(column.name);
    table.kinds.push_back(column.kind);
  }
  for (const RunFrame& frame : run.frames) {
    auto& row = table.rows.emplace_back();
    for (const Column& column : columns.all) {
      const bool known = !column.needs_rates() || frame.rate.size() > 0;
      row.push_back(known ? std::optional(column.value(frame) + 0.0) : std::nullopt);  // + 0.0: no -0
    }
  }
  add_forces(file, model, run, table);
  return table;
}

std::string csv_text(const SolveTable& table) {
  std::vector<int> decimals;
  for (std::size_t i = 0; i < table.columns.size(); ++i) decimals.push_back(decimals_of(table, i));
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i]) append_short_text(text, *row[i], decimals[i]);
      text += i + 1 < row.size() ? ',' : '\n';
    }
  return text;
}

}  // namespace kempe
