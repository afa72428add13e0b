#include "tests/metamorphic/task.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "specs/spec_reader.hpp"

namespace kempe::metamorphic {
namespace {

std::string text(double value) { return fmt::format("{:.17g}", value); }

std::string text(const Ring& ring) {
  std::string result = "[";
  for (const Point& corner : ring)
    result += fmt::format("{}[{}, {}]", result.size() > 1 ? ", " : "", text(corner.x()), text(corner.y()));
  return result + "]";
}

std::string text(const std::vector<Ring>& rings) {
  if (rings.size() == 1) return text(rings[0]);
  std::string result = "[";
  for (const Ring& ring : rings) result += (result.size() > 1 ? ", " : "") + text(ring);
  return result + "]";
}

std::string quoted(const std::vector<std::string>& words) {
  std::string result = "[";
  for (const std::string& word : words)
    result += fmt::format("{}\"{}\"", result.size() > 1 ? ", " : "", word);
  return result + "]";
}

class File {
 public:
  void table(const std::string& name) { text_ += name + "\n"; }
  void line(const std::string& key, const std::string& value) {
    text_ += fmt::format("{} = {}\n", key, value);
  }
  void number(const std::string& key, const std::optional<double>& value) {
    if (value) line(key, text(*value));
  }
  const std::string& all() const { return text_; }

 private:
  std::string text_;
};

void add_links(File& file, const Task& task) {
  file.table("[links]");
  file.number("width_mm", task.width);
  file.number("pin_diameter_mm", task.pin_diameter);
  file.line("plate", task.triangle_plates ? "\"triangle\"" : "\"bent\"");
  file.line("layers", std::to_string(task.layers));
  file.number("shortest_mm", task.shortest);
  file.number("longest_mm", task.longest);
  file.number("grid_mm", task.grid);
  if (!task.stock.empty()) {
    std::string list;
    for (const double length : task.stock) list += (list.empty() ? "" : ", ") + text(length);
    file.line("stock_mm", "[" + list + "]");
  }
  for (const auto& [key, length] : task.locked) file.number(key, length);
}

void add_limits(File& file, const Task& task) {
  file.table("[limits]");
  file.number("clearance_mm", task.clearance);
  file.number("transmission_deg", task.transmission_deg);
  file.number("sheets_gap_mm", task.copy_gap);
  file.number("copy_error_mm", task.copy_error);
  if (!task.length_tolerance && !task.play) return;
  file.table("[tolerance]");
  file.number("length_mm", task.length_tolerance);
  file.number("play_mm", task.play);
}

void add_obstacles(File& file, const Task& task) {
  for (const TaskObstacle& obstacle : task.obstacles) {
    file.table("[[obstacles]]");
    file.line("polygon_mm", text(obstacle.rings));
    if (obstacle.layers)
      file.line("layers", fmt::format("[{}, {}]", (*obstacle.layers)[0], (*obstacle.layers)[1]));
  }
}

File file_of(const Task& task) {
  File file;
  file.table("[copy]");
  file.number("scale", task.scale);
  file.number("rotation_deg", task.rotation_deg);
  file.table("[region]");
  file.line("polygon_mm", text(task.region));
  if (!task.region_holes.empty()) file.line("holes_mm", text(task.region_holes));
  file.table("[pole]");
  if (task.pole_area.empty())
    file.line("at_mm", fmt::format("[{}, {}]", text(task.pole.x()), text(task.pole.y())));
  else
    file.line("within_mm", text(task.pole_area));
  add_links(file, task);
  add_limits(file, task);
  file.table("[objective]");
  file.line(task.objective == "transmission" ? "maximize" : "minimize", "\"" + task.objective + "\"");
  file.line("groundings", quoted(task.groundings));
  add_obstacles(file, task);
  return file;
}

}  // namespace

std::string toml_of(const Task& task) { return file_of(task).all(); }

std::string toml_of(const Task& task, const MechanismSpec& mechanism) {
  File file = file_of(task);
  file.table("[mechanism]");
  file.line("vertex", "\"" + std::string(name(mechanism.grounding)) + "\"");
  file.number("VA_mm", mechanism.VA);
  file.number("VB_mm", mechanism.VB);
  file.line("assembly", std::to_string(mechanism.assembly_mode));
  if (mechanism.layers) {
    const auto& of = *mechanism.layers;
    file.line("layers", fmt::format("[{}, {}, {}, {}]", of[0], of[1], of[2], of[3]));
  }
  return file.all();
}

Spec read(const Task& task) {
  const std::string text = toml_of(task);
  auto spec = read_spec(text, "task", ".");
  if (spec) return std::move(*spec);
  std::fprintf(stderr, "%s\nrefused: %s\n", text.c_str(), spec.error().message().c_str());
  std::abort();
}

}  // namespace kempe::metamorphic
