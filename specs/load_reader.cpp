#include "specs/load_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "specs/materials.hpp"

namespace kempe {
namespace {

std::string names_of_materials() {
  std::string names;
  for (const KnownMaterial& each : known_materials())
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", each.name);
  return names;
}

TableView table_of_root(const toml::table& root, std::string_view name) {
  const toml::table* table = root.get_as<toml::table>(name);
  return table ? TableView(*table, std::string(name)) : TableView();
}

/// A key that asks for what another table must give.
struct Need {
  bool asked;
  std::string_view table, key, found, allowed;
};

}  // namespace

std::optional<Material> read_material(const TableView& table, Complaints& complaints) {
  if (!table.present()) return std::nullopt;
  Material material;
  table.set("name", material.name);
  const KnownMaterial* known = material_named(material.name);
  if (known != nullptr) material = as_material(*known);
  std::optional<double> E_GPa;
  table.set("E_GPa", E_GPa);
  if (E_GPa) material.E = MPa_per_GPa * *E_GPa;
  std::optional<double> G_GPa;
  table.set("G_GPa", G_GPa);
  if (G_GPa) material.G = MPa_per_GPa * *G_GPa;
  table.set("density_kg_m3", material.density);
  table.set("strength_MPa", material.strength);
  if (material.name.empty()) material.name = "the material given";
  if (known != nullptr || (material.E > 0 && material.density > 0 && material.strength > 0)) return material;
  const std::string_view key = table.has("name") ? "name" : "E_GPa";
  complaints.add(table.line_of_key(key), table.dotted(key),
                 table.has("name") ? fmt::format("\"{}\" without all three figures", material.name)
                                   : "not all three figures, and no name",
                 fmt::format("one of {}, or E_GPa, density_kg_m3 and strength_MPa", names_of_materials()));
  return material;
}

std::optional<Load> read_load(const TableView& table) {
  if (!table.present()) return std::nullopt;
  Load load;
  table.set("pen_N", load.pen_force);
  table.set("pen_mass_kg", load.pen_mass);
  table.set("tracer_mass_kg", load.tracer_mass);
  double tilt_degrees = degrees(load.tilt);
  table.set("tilt_deg", tilt_degrees);
  load.tilt = radians(tilt_degrees);
  table.set("grip_mm", load.grip);
  table.set("friction", load.friction);
  const toml::node* rests = table.find("rests");
  if (rests == nullptr || !rests->is_array()) return load;
  for (const toml::node& point : *rests->as_array())
    load.rests.push_back(point.value_or(std::string()) == "tracer" ? Carrier::tracer : Carrier::pen);
  return load;
}

std::vector<LinkSection> read_sections(const TableView& links) {
  std::vector<LinkSection> sections;
  const toml::node* value = links.find("sections_mm");
  if (value == nullptr || !value->is_array()) return sections;
  for (const toml::node& each : *value->as_array())
    if (const auto section = finite_point(each)) sections.push_back({section->x(), section->y()});
  const auto order = [](const LinkSection& section) {
    return std::pair(section.width * section.thickness, section.width);
  };
  std::sort(sections.begin(), sections.end(),
            [&](const LinkSection& a, const LinkSection& b) { return order(a) < order(b); });
  sections.erase(std::unique(sections.begin(), sections.end()), sections.end());
  return sections;
}

void check_loads(const Spec& spec, const toml::table& root, Complaints& complaints) {
  if (!complaints.none_about("material") || !complaints.none_about("load")) return;
  const Objective objective = spec.objective.objective;
  const std::string_view no_load = "the load error asked for without [load]",
                         no_material = "it without [material]";
  const std::string_view load = "it with a table [load]: pen_N",
                         material = "it with a table [material]: name";
  const Need needs[] = {
      {spec.limits.load_error && !spec.load, "limits", "load_error_mm", no_load, load},
      {objective == Objective::load_error && !spec.load, "objective", "minimize", no_load, load},
      {objective == Objective::mass && !spec.material, "objective", "minimize",
       "the mass asked for without [material]", material},
      {spec.limits.load_error_in_all && !spec.limits.load_error, "limits", "load_error_in_all",
       "true without limits.load_error_mm", "true beside limits.load_error_mm"},
      {spec.limits.load_error_in_all && objective == Objective::load_error, "limits", "load_error_in_all",
       "true beside objective.minimize = \"load_error\"",
       "false there: what is made small is the load error of the links alone"},
      {spec.limits.sag && !spec.material, "limits", "sag_mm", no_material, material},
      {spec.load && !spec.material, "load", "pen_N", no_material, material},
      {spec.mechanism && spec.links.sections.size() > 1, "links", "sections_mm",
       "several sections beside [mechanism]", "one section there"},
  };
  for (const Need& need : needs) {
    if (!need.asked || !complaints.none_about(need.table)) continue;
    const TableView table = table_of_root(root, need.table);
    complaints.add(table.line_of_key(need.key), table.dotted(need.key), std::string(need.found),
                   std::string(need.allowed));
  }
}

}  // namespace kempe
