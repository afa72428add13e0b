#include "specs/spec_check.hpp"

#include <algorithm>
#include <locale>
#include <sstream>

#include "geometry/stated_angle.hpp"
#include "kinematics/copying_linkage.hpp"
#include "kinematics/grounding.hpp"
#include "kinematics/links.hpp"
#include "kinematics/overloaded.hpp"
#include "specs/materials.hpp"
#include "specs/spec.hpp"
#include "specs/spec_table.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {
namespace {

toml::array list_of(const Point& point) { return toml::array{point.x(), point.y()}; }

toml::array list_of(const Ring& ring) {
  toml::array list;
  for (const Point& corner : ring) list.push_back(list_of(corner));
  return list;
}

template <typename Numbers>
toml::array toml_array(const Numbers& values) {
  toml::array list;
  for (const auto& value : values) list.push_back(value);
  return list;
}

toml::array outer_rings(const Region& region) {
  toml::array rings;
  for (const Polygon& polygon : region.polygons) rings.push_back(list_of(polygon.outer));
  return rings;
}

toml::array holes(const Region& region) {
  toml::array rings;
  for (const Polygon& polygon : region.polygons)
    for (const Ring& hole : polygon.holes) rings.push_back(list_of(hole));
  return rings;
}

void put(toml::table& table, std::string_view key, const std::optional<double>& value) {
  if (value) table.insert(key, *value);
}

/// What is as it would be without a word is left out: a fault is then laid to the key that makes it.
template <typename Value>
void put(toml::table& table, std::string_view key, const Value& value, const Value& usual) {
  if (value != usual) table.insert(key, value);
}

toml::table copy_table(const Copy& copy) {
  toml::table table{{"scale", copy.scale()}};
  put(table, "rotation_deg", stated_degrees(copy.rotation()), 0.0);
  return table;
}

toml::table region_table(const Region& region) {
  toml::table table{{"polygon_mm", outer_rings(region)}};
  if (toml::array rings = holes(region); !rings.empty()) table.insert("holes_mm", std::move(rings));
  return table;
}

toml::table pole_table(const PoleSpec& pole) {
  if (pole.is_fixed()) return toml::table{{"at_mm", list_of(std::get<Point>(pole.place))}};
  return toml::table{{"within_mm", outer_rings(std::get<Region>(pole.place))}};
}

toml::array section_list(const std::vector<LinkSection>& sections) {
  toml::array list;
  for (const LinkSection& section : sections) list.push_back(toml::array{section.width, section.thickness});
  return list;
}

toml::table hardware_table(const JointHardware& hardware) {
  toml::table table;
  put(table, "default", hardware.every, std::string());
  for (const Joint joint : all_joints)
    put(table, std::string(1, letter(joint)), hardware.at[static_cast<std::size_t>(joint)], std::string());
  return table;
}

toml::table links_table(const LinkSpec& links) {
  const LinkSpec usual;
  toml::table table;
  if (links.sections.empty()) put(table, "width_mm", links.style.width, usual.style.width);
  put(table, "pin_diameter_mm", links.style.pin_diameter, usual.style.pin_diameter);
  if (links.sections.empty()) put(table, "thickness_mm", links.style.thickness, usual.style.thickness);
  if (!links.sections.empty()) table.insert("sections_mm", section_list(links.sections));
  if (!links.hardware.none()) {
    if (links.hardware.differs())
      table.insert("hardware", hardware_table(links.hardware));
    else
      table.insert("hardware", links.hardware.every);
  }
  if (links.style.plate == PlateStyle::triangle) table.insert("plate", "triangle");
  put(table, "layers", links.layers, usual.layers);
  put(table, "shortest_mm", links.shortest, usual.shortest);
  put(table, "longest_mm", links.longest, usual.longest);
  put(table, "wall_mm", links.wall);
  put(table, "grid_mm", links.stock_lengths.grid);
  if (!links.stock_lengths.stock.empty()) table.insert("stock_mm", toml_array(links.stock_lengths.stock));
  for (std::size_t i = 0; i < LinkLengths::names.size(); ++i)
    put(table, std::string(LinkLengths::names[i]) + "_mm", links.stock_lengths.locked[i]);
  return table;
}

toml::table limits_table(const Limits& limits) {
  const Limits usual;
  toml::table table;
  put(table, "clearance_mm", limits.clearance, usual.clearance);
  put(table, "transmission_deg", stated_degrees(limits.transmission), stated_degrees(usual.transmission));
  put(table, "sheets_gap_mm", limits.copy_gap);
  put(table, "copy_error_mm", limits.copy_error);
  put(table, "longest_strip_mm", limits.longest_strip);
  put(table, "load_error_mm", limits.load_error);
  put(table, "load_error_in_all", limits.load_error_in_all, usual.load_error_in_all);
  put(table, "sag_mm", limits.sag);
  return table;
}

toml::table tool_table(const ToolSpec& tool) {
  toml::table table;
  put(table, "follower_radius_mm", tool.follower_radius);
  put(table, "cutter_radius_mm", tool.cutter_radius);
  return table;
}

toml::table material_table(const Material& material) {
  toml::table table{{"E_GPa", GPa_per_MPa * material.E},
                    {"density_kg_m3", material.density},
                    {"strength_MPa", material.strength}};
  put(table, "name", material.name, std::string());
  if (material.G) table.insert("G_GPa", GPa_per_MPa * *material.G);
  return table;
}

toml::table load_table(const Load& load) {
  const Load usual;
  toml::table table{{"pen_N", load.pen_force}};
  put(table, "pen_mass_kg", load.pen_mass, usual.pen_mass);
  put(table, "tracer_mass_kg", load.tracer_mass, usual.tracer_mass);
  put(table, "tilt_deg", stated_degrees(load.tilt), 0.0);
  put(table, "grip_mm", load.grip);
  put(table, "friction", load.friction, usual.friction);
  toml::array rests;
  for (const Carrier point : load.rests) rests.push_back(point == Carrier::tracer ? "tracer" : "pen");
  if (!rests.empty()) table.insert("rests", std::move(rests));
  return table;
}

toml::table obstacle_table(const Obstacle& obstacle) {
  toml::table table{{"polygon_mm", list_of(obstacle.shape.outer)},
                    {"layers", toml::array{obstacle.lowest_layer, obstacle.highest_layer}}};
  if (!obstacle.name.empty()) table.insert("name", obstacle.name);
  return table;
}

toml::array obstacle_tables(const std::vector<Obstacle>& obstacles) {
  toml::array tables;
  for (const Obstacle& obstacle : obstacles) tables.push_back(obstacle_table(obstacle));
  return tables;
}

/// Of one ring; a disc is the circle that it is.
toml::table body_table(const Body& body) {
  toml::table table{{"at", body.at == Carrier::tracer ? "tracer" : "pen"},
                    {"layers", toml::array{body.lowest_layer, body.highest_layer}}};
  std::visit(
      Overloaded{
          [&](const Disc& disc) {
            table.insert("circle_mm", toml::table{{"centre", list_of(disc.centre)}, {"radius", disc.radius}});
          },
          [&](const Polygon& polygon) { table.insert("polygon_mm", list_of(polygon.outer)); }},
      body.shape);
  if (body.turns_with) table.insert("turns_with", std::string(name(*body.turns_with)));
  if (!body.name.empty()) table.insert("name", body.name);
  return table;
}

toml::array body_tables(const std::vector<Body>& bodies) {
  toml::array tables;
  for (const Body& body : bodies) tables.push_back(body_table(body));
  return tables;
}

toml::table objective_table(const ObjectiveSpec& objective) {
  const ObjectiveSpec usual;
  toml::table table;
  if (objective.objective != usual.objective)
    table.insert(is_maximized(objective.objective) ? "maximize" : "minimize",
                 std::string(name(objective.objective)));
  if (objective.groundings == usual.groundings) return table;
  toml::array groundings;
  for (const Grounding grounding : objective.groundings) groundings.push_back(std::string(name(grounding)));
  table.insert("groundings", std::move(groundings));
  return table;
}

toml::table mechanism_table(const MechanismSpec& mechanism) {
  toml::table table{
      {"vertex", std::string(name(mechanism.grounding))}, {"VA_mm", mechanism.VA}, {"VB_mm", mechanism.VB}};
  put(table, "assembly", mechanism.assembly_mode, 0);
  if (mechanism.layers) table.insert("layers", toml_array(*mechanism.layers));
  return table;
}

toml::table tolerance_table(const Tolerance& tolerance) {
  toml::table table{{"length_mm", tolerance.length}, {"play_mm", tolerance.play}};
  put(table, "robust", tolerance.robust, Tolerance{}.robust);
  return table;
}

toml::table cutting_table(const CuttingSpec& cutting) {
  const CuttingSpec usual;
  toml::table table;
  if (cutting.process) table.insert("process", std::string(name(*cutting.process)));
  put(table, "hole_fit_mm", cutting.hole_fit, cutting.process ? usual_fit(*cutting.process) : usual.hole_fit);
  put(table, "kerf_mm", cutting.kerf, usual.kerf);
  put(table, "gap_mm", cutting.gap, usual.gap);
  if (cutting.stock_sheet) table.insert("sheet_mm", list_of(*cutting.stock_sheet));
  return table;
}

void put_if_any(toml::table& root, std::string_view key, toml::table table) {
  if (!table.empty()) root.insert(key, std::move(table));
}

toml::table table_of(const Spec& spec) {
  toml::table root{{"copy", copy_table(spec.copy)}, {"pole", pole_table(spec.pole)}};
  put(root, "title", spec.title, std::string());
  if (!spec.region.empty()) root.insert("region", region_table(spec.region));
  put_if_any(root, "links", links_table(spec.links));
  put_if_any(root, "limits", limits_table(spec.limits));
  if (spec.tolerance) root.insert("tolerance", tolerance_table(*spec.tolerance));
  put_if_any(root, "tool", tool_table(spec.tool));
  if (spec.material) root.insert("material", material_table(*spec.material));
  if (spec.load) root.insert("load", load_table(*spec.load));
  if (!spec.obstacles.empty()) root.insert("obstacles", obstacle_tables(spec.obstacles));
  if (!spec.bodies.empty()) root.insert("bodies", body_tables(spec.bodies));
  if (spec.table) root.insert("table", toml::table{{"polygon_mm", list_of(spec.table->outer)}});
  put_if_any(root, "objective", objective_table(spec.objective));
  if (spec.mechanism) root.insert("mechanism", mechanism_table(*spec.mechanism));
  put_if_any(root, "cutting", cutting_table(spec.cutting));
  return root;
}

bool has_holes(const Polygon& polygon) { return !polygon.holes.empty(); }

/// What a file has no words for.
std::optional<InputError> unspeakable(const Spec& spec) {
  const auto refused = [](std::string key) {
    return InputError{"", 0, std::move(key), "a polygon with holes", "polygons without holes"};
  };
  if (!spec.pole.is_fixed()) {
    const auto& polygons = std::get<Region>(spec.pole.place).polygons;
    if (std::any_of(polygons.begin(), polygons.end(), has_holes)) return refused("pole.within_mm");
  }
  for (const Obstacle& obstacle : spec.obstacles)
    if (has_holes(obstacle.shape)) return refused("obstacles.polygon_mm");
  for (const Body& body : spec.bodies)
    if (const auto* polygon = std::get_if<Polygon>(&body.shape); polygon && has_holes(*polygon))
      return refused("bodies.polygon_mm");
  if (spec.table && has_holes(*spec.table)) return refused("table.polygon_mm");
  return std::nullopt;
}

}  // namespace

tl::expected<Spec, InputError> check_spec(const Spec& spec) {
  if (auto fault = unspeakable(spec)) return tl::unexpected(std::move(*fault));
  auto read = read_spec_table(table_of(spec));
  if (!read) return tl::unexpected(read.error());
  Spec checked = spec;
  checked.region = std::move(read->region);
  checked.obstacles = std::move(read->obstacles);
  checked.bodies = std::move(read->bodies);
  checked.table = std::move(read->table);
  checked.objective.groundings = std::move(read->objective.groundings);            // those that bodies leave
  checked.links.stock_lengths.stock = std::move(read->links.stock_lengths.stock);  // sorted, each once
  checked.links.style.pin_diameter = read->links.style.pin_diameter;               // the hardware's
  checked.links.sections = std::move(read->links.sections);                        // sorted, each once
  if (!checked.links.sections.empty()) use_section(checked.links.style, checked.links.sections.front());
  if (!spec.pole.is_fixed()) checked.pole = std::move(read->pole);
  return checked;
}

std::string spec_as_toml(const Spec& spec) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << toml::toml_formatter(table_of(spec)) << "\n";
  return text.str();
}

}  // namespace kempe
