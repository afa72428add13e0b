#include "specs/spec_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "specs/build_reader.hpp"
#include "specs/copy_reader.hpp"
#include "specs/file_kind.hpp"
#include "specs/key_checks.hpp"
#include "specs/load_reader.hpp"
#include "specs/region_reader.hpp"
#include "specs/spec_table.hpp"
#include "specs/spec_unit.hpp"
#include "specs/text/complaints.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {
namespace {

/// A table of the top level, perhaps absent.
TableView table_in(const toml::table& root, std::string_view name) {
  const toml::table* table = root.get_as<toml::table>(name);
  return table ? TableView(*table, std::string(name)) : TableView();
}

/// True if the spec asks for the copy error, by objective or limit.
bool needs_tolerance(const Spec& spec) {
  return spec.objective.objective == Objective::copy_error || spec.limits.copy_error.has_value();
}

/// The strip must leave some distance of joints that shortest_mm allows.
void check_strip(const Spec& spec, const toml::table& root, Complaints& complaints) {
  if (!spec.limits.longest_strip || !complaints.none_about("limits") || !complaints.none_about("links"))
    return;
  if (largest_joint_distance(spec) >= spec.links.shortest) return;
  const auto fits = [&](const LinkSection& section) {
    return *spec.limits.longest_strip - section.width >= spec.links.shortest;
  };
  if (std::any_of(spec.links.sections.begin(), spec.links.sections.end(), fits)) return;
  const TableView limits = table_in(root, "limits");
  const SpecUnit unit = complaints.unit();
  complaints.add(
      limits.line_of_key("longest_strip_mm"), limits.dotted("longest_strip_mm"),
      number_in(unit, *spec.limits.longest_strip),
      fmt::format("at least {}: {} and {}", length_in(unit, spec.links.shortest + spec.links.style.width),
                  name_in(unit, "links.shortest_mm"), name_in(unit, "links.width_mm")));
}

void check_tolerance(const Spec& spec, const toml::table& root, Complaints& complaints) {
  if (!needs_tolerance(spec) || !complaints.none_about("tolerance")) return;
  const bool by_limit = spec.limits.copy_error.has_value();
  const TableView asking = table_in(root, by_limit ? "limits" : "objective");
  const std::string_view key = by_limit ? "copy_error_mm" : "minimize";
  const std::string length = name_in(complaints.unit(), "length_mm"),
                    play = name_in(complaints.unit(), "play_mm");
  if (!spec.tolerance) {
    complaints.add(asking.line_of_key(key), asking.dotted(key),
                   "the copy error asked for without [tolerance]",
                   fmt::format("it with a table [tolerance]: {}, {}", length, play));
  } else if (spec.tolerance->length == 0 && spec.tolerance->play == 0) {
    complaints.add(asking.line_of_key(key), asking.dotted(key),
                   "the copy error asked for with all tolerances 0",
                   fmt::format("{} or {} above 0 in [tolerance]", length, play));
  }
}

void check_robust(const Spec& spec, const toml::table& root, Complaints& complaints) {
  if (!spec.tolerance || !spec.tolerance->robust || !complaints.none_about("tolerance")) return;
  if (spec.tolerance->length > 0 || spec.tolerance->play > 0) return;
  const TableView table = table_in(root, "tolerance");
  complaints.add(table.line_of_key("robust"), table.dotted("robust"), "true with all tolerances 0",
                 fmt::format("{} or {} above 0 beside it", name_in(complaints.unit(), "length_mm"),
                             name_in(complaints.unit(), "play_mm")));
}

/// The title, if it is a line that a page and a drawing can show.
std::string read_title(const toml::table& root, Complaints& complaints) {
  const toml::node* value = root.get("title");
  if (!value || !complaints.none_about("title")) return {};
  std::string title = value->value_or(std::string());
  if (title.size() > most_title_bytes)
    complaints.add(line_of(*value), "title", fmt::format("{} bytes", title.size()),
                   fmt::format("at most {}", most_title_bytes));
  else if (printable(title) != title)
    complaints.add(line_of(*value), "title", printable(title, 60),
                   "one line of UTF-8 without control characters");
  return title;
}

/// Robust designs know of links and obstacles alone.
void check_robust_surroundings(const Spec& spec, const toml::table& root, Complaints& complaints) {
  if (!spec.tolerance || !spec.tolerance->robust || (spec.bodies.empty() && !spec.table)) return;
  const TableView table = table_in(root, "tolerance");
  complaints.add(table.line_of_key("robust"), table.dotted("robust"),
                 spec.table ? "true beside [table]" : "true beside [[bodies]]",
                 "false there: robust designs are sought without bodies and without a table's edge");
}

void require_tables(const toml::table& root, Complaints& complaints) {
  const SpecUnit unit = spec_unit_of(root);
  if (!root.contains("copy") && !is_meant(root, "copy")) {
    complaints.add(0, "copy", "nothing",
                   "a table [copy] with scale and rotation_deg, or " + name_in(unit, "pairs_mm"));
  }
  if (!root.contains("region") && !root.contains("mechanism") && !is_meant(root, "region")) {
    complaints.add(
        0, "region", "nothing",
        fmt::format("a table [region] with exactly one of {}, {}, {}, file", name_in(unit, "polygon_mm"),
                    name_in(unit, "rectangle_mm"), name_in(unit, "circle_mm")));
  }
}

/// A body that turns with a link leaves the groundings in which the link has its point.
void read_bodies_into(Spec& spec, const toml::array& tables, Complaints& complaints) {
  spec.bodies = read_bodies(tables, complaints);
  if (spec.mechanism && groundings_with_links_of(tables, {spec.mechanism->grounding}, complaints).empty())
    return;
  spec.objective.groundings = groundings_with_links_of(tables, spec.objective.groundings, complaints);
}

/// Reads every table whose keys are without complaint; whatever is wrong is in `complaints`.
Spec read_tables(const toml::table& root, const std::filesystem::path& folder, Complaints& complaints) {
  Spec spec;
  spec.title = read_title(root, complaints);
  const auto table = [&root](std::string_view name) { return table_in(root, name); };
  const auto sound = [&](std::string_view name) {
    return root.contains(name) && complaints.none_about(name);
  };
  CopyReading copy;
  if (sound("copy")) copy = read_copy(table("copy"), complaints);
  spec.copy = copy.copy;
  if (sound("links")) spec.links = read_links(table("links"), complaints);
  spec.limits = read_limits(table("limits"));
  spec.tolerance = read_tolerance(table("tolerance"));
  spec.tool = read_tool(table("tool"));
  if (sound("material")) spec.material = read_material(table("material"), complaints);
  if (sound("load")) spec.load = read_load(table("load"));
  if (sound("objective")) spec.objective = read_objective(table("objective"), complaints);
  if (sound("mechanism") && sound("copy") && complaints.none_about("links"))
    spec.mechanism = read_mechanism(table("mechanism"), spec.copy, spec.links.layers, complaints);
  spec.cutting = read_cutting(table("cutting"));
  check_strip(spec, root, complaints);
  check_tolerance(spec, root, complaints);
  check_robust(spec, root, complaints);
  check_loads(spec, root, complaints);
  if (complaints.none_about("pole"))
    spec.pole = read_pole(table("pole"), copy.pole.value_or(Point::Zero()), complaints);
  if (sound("obstacles")) spec.obstacles = read_obstacles(*root.get_as<toml::array>("obstacles"), complaints);
  if (sound("bodies")) read_bodies_into(spec, *root.get_as<toml::array>("bodies"), complaints);
  if (sound("table")) spec.table = read_table_edge(table("table"), complaints);
  check_body_outlines(spec, complaints);
  check_robust_surroundings(spec, root, complaints);
  if (sound("region")) spec.region = read_region(table("region"), folder, complaints).value_or(Region{});
  return spec;
}

/// From here on all lengths are in mm; what is wrong with them is told by the keys of the file.
void convert(toml::table& root, SpecUnit unit, Complaints& complaints) {
  if (unit == SpecUnit::mm) return;
  to_millimetres(root);
  complaints.state_in(unit, [unit](const std::string& key) { return name_in(unit, key); });
}

tl::expected<Spec, InputError> read_root(toml::table root, const std::string& file_name,
                                         const std::filesystem::path& folder) {
  Complaints complaints(file_name);
  check_keys(root, complaints);
  require_tables(root, complaints);
  convert(root, spec_unit_of(root), complaints);
  Spec spec = read_tables(root, folder, complaints);
  if (!complaints.none()) return tl::unexpected(complaints.all());
  return spec;
}

}  // namespace

tl::expected<Spec, InputError> read_spec_table(toml::table root) {
  return read_root(std::move(root), "", "");
}

tl::expected<Spec, InputError> read_spec(std::string_view text, const std::string& file_name,
                                         const std::filesystem::path& folder) {
  auto root = parse_toml(text, file_name);
  if (!root) return tl::unexpected(or_other_kind(root.error(), text, FileKind::spec));
  return read_root(std::move(*root), file_name, folder).map_error([&](const InputError& faults) {
    return or_other_kind(faults, text, FileKind::spec);
  });
}

tl::expected<Spec, InputError> read_spec_file(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text) return tl::unexpected(text.error());
  return read_spec(*text, path.string(), path.parent_path());
}

SpecUnit unit_of_spec(std::string_view text) {
  // Without the key's letters it can only be spelt with a backslash.
  if (text.find("units") == text.npos && text.find('\\') == text.npos) return SpecUnit::mm;
  const auto root = parse_toml(text, "");
  return root ? spec_unit_of(*root) : SpecUnit::mm;
}

std::optional<std::filesystem::path> region_file_of(std::string_view text) {
  // Hundred thousand corners take long to read again. A key without its letters can only be spelt with a backslash.
  if (text.find("file") == text.npos && text.find('\\') == text.npos) return std::nullopt;
  const auto root = parse_toml(text, "");
  const auto name = root ? (*root)["region"]["file"].value<std::string>() : std::nullopt;
  return name ? std::optional(std::filesystem::path(*name)) : std::nullopt;
}

}  // namespace kempe
