#include "specs/build_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/grounding.hpp"
#include "specs/grid_lengths.hpp"
#include "specs/hardware.hpp"
#include "specs/load_reader.hpp"
#include "specs/unit_words.hpp"

namespace kempe {
namespace {

/// Multiples of the grid that the search looks through.
constexpr double most_grid_lengths = 1e5;

/// What concerns several keys of [links].
class LinkChecks {
 public:
  LinkChecks(const LinkSpec& links, const TableView& table, Complaints& complaints)
      : links_(links), table_(table), complaints_(complaints), unit_(complaints.unit()) {}

  void run() {
    for (const std::string_view key : {"width_mm", "thickness_mm"})
      if (table_.has("sections_mm") && table_.has(key))
        refuse(key, "it beside " + named("sections_mm"), "one of the two");
    if (links_.style.pin_diameter > links_.style.width) {
      refuse(table_.has("pin_diameter_mm") ? "pin_diameter_mm" : width_key(),
             fmt::format("a pin of {} in a link {} wide", length(links_.style.pin_diameter),
                         length(links_.style.width)),
             named("pin_diameter_mm") + " <= " + named("width_mm"));
    }
    check_pins();
    std::vector<const Hardware*> checked;  // each once
    for (const Joint joint : all_joints) {
      const Hardware* hardware = hardware_named(links_.hardware[joint]);
      if (hardware == nullptr || std::find(checked.begin(), checked.end(), hardware) != checked.end())
        continue;
      checked.push_back(hardware);
      check_hardware(*hardware);
    }
    if (links_.shortest > links_.longest) {
      refuse(table_.has("shortest_mm") ? "shortest_mm" : "longest_mm",
             fmt::format("{} {} above {} {}", named("shortest_mm"), number(links_.shortest),
                         named("longest_mm"), number(links_.longest)),
             named("shortest_mm") + " <= " + named("longest_mm"));
      return;
    }
    check_stock_lengths();
  }

 private:
  std::string named(std::string_view key) const { return name_in(unit_, key); }
  std::string number(double length) const { return number_in(unit_, length); }
  std::string length(double length) const { return length_in(unit_, length); }

  void refuse(std::string_view key, std::string found, std::string allowed) {
    complaints_.add(table_.line_of_key(key), table_.dotted(key), std::move(found), std::move(allowed));
  }

  /// Plain pins may be thicker than those that are bought, if there are any.
  void check_pins() {
    const double thickest = thickest_pin(links_.hardware), given = links_.style.pin_diameter;
    const bool has_plain = std::any_of(all_joints.begin(), all_joints.end(),
                                       [&](Joint joint) { return links_.hardware[joint].empty(); });
    if (thickest == 0 || given == thickest || (has_plain && given > thickest)) return;
    refuse("pin_diameter_mm",
           links_.hardware.differs()
               ? fmt::format("{} beside pins of {} in hardware", number(given), length(thickest))
               : fmt::format("{} beside hardware = \"{}\"", number(given), links_.hardware.every),
           fmt::format("{}{}, or left out", has_plain ? "at least " : "", number(thickest)));
  }

  void check_hardware(const Hardware& hardware) {
    if (hardware.seat >= links_.style.width)
      refuse("hardware", fmt::format("\"{}\" in links {} wide", hardware.name, length(links_.style.width)),
             fmt::format("{} above {}", named("links.width_mm"), number(hardware.seat)));
    if (hardware.seat_width > links_.style.thickness)
      refuse("hardware",
             fmt::format("\"{}\" in links {} thick", hardware.name, length(links_.style.thickness)),
             fmt::format("{} of at least {}", named("links.thickness_mm"), number(hardware.seat_width)));
  }

  std::string_view width_key() const { return table_.has("sections_mm") ? "sections_mm" : "width_mm"; }

  bool fits(double length) const { return links_.shortest <= length && length <= links_.longest; }
  std::string range() const {
    return fmt::format("{} to {} ({}, {})", number(links_.shortest), length(links_.longest),
                       named("shortest_mm"), named("longest_mm"));
  }

  void check_stock_lengths() {
    const StockLengths& stock_lengths = links_.stock_lengths;
    if (stock_lengths.grid && !stock_lengths.stock.empty())
      refuse("stock_mm", "it beside " + named("grid_mm"),
             fmt::format("one of {} and {}", named("grid_mm"), named("stock_mm")));
    if (stock_lengths.grid && !fits(longest_multiple(*stock_lengths.grid, links_.longest))) {
      refuse("grid_mm",
             fmt::format("{}, of which no multiple is a length allowed", number(*stock_lengths.grid)),
             "lengths from " + range());
    }
    if (stock_lengths.grid && links_.longest / *stock_lengths.grid > most_grid_lengths) {
      refuse("grid_mm",
             fmt::format("{} beside {} = {}", number(*stock_lengths.grid), named("longest_mm"),
                         number(links_.longest)),
             fmt::format("at least {} / {:.0f}", named("longest_mm"), most_grid_lengths));
    }
    if (!stock_lengths.stock.empty() && std::none_of(stock_lengths.stock.begin(), stock_lengths.stock.end(),
                                                     [&](double length) { return fits(length); })) {
      refuse("stock_mm", "no length that is allowed", "at least one length from " + range());
    }
    check_locked(stock_lengths);
  }

  void check_locked(const StockLengths& stock_lengths) {
    for (std::size_t i = 0; i < LinkLengths::names.size(); ++i) {
      if (!stock_lengths.locked[i] || fits(*stock_lengths.locked[i])) continue;
      refuse(std::string(LinkLengths::names[i]) + "_mm", number(*stock_lengths.locked[i]), range());
    }
    check_opposite(0, 3);
    check_opposite(1, 2);
  }

  /// Opposite sides of the parallelogram are equal.
  void check_opposite(std::size_t first, std::size_t second) {
    const auto &one = links_.stock_lengths.locked[first], &other = links_.stock_lengths.locked[second];
    if (!one || !other || *one == *other) return;
    const auto names = LinkLengths::names;
    refuse(std::string(names[second]) + "_mm",
           fmt::format("{} beside {} = {}", number(*other), named(std::string(names[first]) + "_mm"),
                       number(*one)),
           fmt::format("{} = {}: opposite sides of the parallelogram", names[second], names[first]));
  }

  const LinkSpec& links_;
  const TableView& table_;
  Complaints& complaints_;
  SpecUnit unit_;
};

StockLengths read_stock_lengths(const TableView& table) {
  StockLengths stock_lengths;
  table.set("grid_mm", stock_lengths.grid);
  for (std::size_t i = 0; i < stock_lengths.locked.size(); ++i) {
    table.set(std::string(LinkLengths::names[i]) + "_mm", stock_lengths.locked[i]);
  }
  const toml::node* stock = table.find("stock_mm");
  if (!stock || !stock->is_array()) return stock_lengths;
  for (const toml::node& length : *stock->as_array())
    stock_lengths.stock.push_back(finite_number(length).value_or(0));
  std::sort(stock_lengths.stock.begin(), stock_lengths.stock.end());
  stock_lengths.stock.erase(std::unique(stock_lengths.stock.begin(), stock_lengths.stock.end()),
                            stock_lengths.stock.end());
  return stock_lengths;
}

/// A name, or a table of names by joint.
JointHardware read_hardware(const TableView& table) {
  JointHardware hardware;
  table.set("hardware", hardware.every);
  const toml::node* node = table.find("hardware");
  if (node == nullptr || !node->is_table()) return hardware;
  const TableView by_joint(*node->as_table(), table.dotted("hardware"));
  by_joint.set("default", hardware.every);
  for (const Joint joint : all_joints)
    by_joint.set(std::string(1, letter(joint)), hardware.at[static_cast<std::size_t>(joint)]);
  return hardware;
}

/// With the narrowest and the thinnest of the sections, then with the first of them in place.
void check_links(LinkSpec& links, const TableView& table, Complaints& complaints) {
  const auto least = [&](double LinkSection::*side, double given) {
    for (std::size_t i = 0; i < links.sections.size(); ++i)
      given = i == 0 ? links.sections[i].*side : std::min(given, links.sections[i].*side);
    return given;
  };
  links.style.width = least(&LinkSection::width, links.style.width);
  links.style.thickness = least(&LinkSection::thickness, links.style.thickness);
  LinkChecks(links, table, complaints).run();
  if (!links.sections.empty()) use_section(links.style, links.sections.front());
}

std::optional<Process> process_named(std::string_view word) {
  for (const Process process : {Process::laser, Process::mill, Process::print, Process::drill})
    if (name(process) == word) return process;
  return std::nullopt;
}

/// A word that names none is complained about with its key.
Grounding grounding_or_last(std::string_view word) { return grounding_named(word).value_or(Grounding::pen); }

/// Links that share a joint must lie in different layers: all pairs but the opposite ones, VA-BCY and VB-ACX.
bool joined_links_share_a_layer(const std::array<int, 4>& of) {
  return of[0] == of[1] || of[0] == of[2] || of[1] == of[3] || of[2] == of[3];
}

std::optional<std::array<int, 4>> read_link_layers(const TableView& table, int most, Complaints& complaints) {
  const toml::node* value = table.find("layers");
  const toml::array* list = value ? value->as_array() : nullptr;
  if (!list || list->size() != 4) return std::nullopt;
  std::array<int, 4> layers{};
  for (std::size_t i = 0; i < 4; ++i) layers[i] = (*list)[i].value_or(0);
  const auto refuse = [&](std::string allowed) {
    complaints.add(line_of(*value), "mechanism.layers", fmt::format("[{}]", fmt::join(layers, ", ")),
                   std::move(allowed));
  };
  if (joined_links_share_a_layer(layers))
    refuse("different layers for links that share a joint; only VA and BCY, and VB and ACX, may share one");
  if (*std::max_element(layers.begin(), layers.end()) > most)
    refuse(fmt::format("layers 1 to {} (links.layers)", most));
  return layers;
}

}  // namespace

LinkSpec read_links(const TableView& table, Complaints& complaints) {
  LinkSpec links;
  std::string plate;
  table.set("width_mm", links.style.width);
  table.set("pin_diameter_mm", links.style.pin_diameter);
  table.set("thickness_mm", links.style.thickness);
  links.hardware = read_hardware(table);
  if (!table.has("pin_diameter_mm")) {
    const bool all_bought = std::none_of(all_joints.begin(), all_joints.end(),
                                         [&](Joint joint) { return links.hardware[joint].empty(); });
    const double thickest = thickest_pin(links.hardware);
    links.style.pin_diameter = all_bought ? thickest : std::max(links.style.pin_diameter, thickest);
  }
  table.set("plate", plate);
  table.set("layers", links.layers);
  table.set("shortest_mm", links.shortest);
  table.set("longest_mm", links.longest);
  table.set("wall_mm", links.wall);
  links.style.plate = plate == "triangle" ? PlateStyle::triangle : PlateStyle::bent;
  links.stock_lengths = read_stock_lengths(table);
  links.sections = read_sections(table);
  check_links(links, table, complaints);
  return links;
}

Limits read_limits(const TableView& table) {
  Limits limits;
  double transmission_degrees = 30;
  table.set("clearance_mm", limits.clearance);
  table.set("transmission_deg", transmission_degrees);
  table.set("sheets_gap_mm", limits.copy_gap);
  table.set("copy_error_mm", limits.copy_error);
  table.set("longest_strip_mm", limits.longest_strip);
  table.set("load_error_mm", limits.load_error);
  table.set("load_error_in_all", limits.load_error_in_all);
  table.set("sag_mm", limits.sag);
  limits.transmission = radians(transmission_degrees);
  return limits;
}

std::optional<Tolerance> read_tolerance(const TableView& table) {
  if (!table.present()) return std::nullopt;
  Tolerance tolerance;
  table.set("length_mm", tolerance.length);
  table.set("play_mm", tolerance.play);
  table.set("robust", tolerance.robust);
  return tolerance;
}

ToolSpec read_tool(const TableView& table) {
  ToolSpec tool;
  table.set("follower_radius_mm", tool.follower_radius);
  table.set("cutter_radius_mm", tool.cutter_radius);
  return tool;
}

ObjectiveSpec read_objective(const TableView& table, Complaints& complaints) {
  ObjectiveSpec objective;
  if (table.has("minimize") && table.has("maximize")) {
    complaints.add(table.line_of_key("maximize"), "objective.maximize", "it beside minimize",
                   "one of minimize and maximize");
  }
  std::string word = "size";
  table.set("minimize", word);
  table.set("maximize", word);
  objective.objective = objective_named(word).value_or(Objective::size);  // the keys' table says which words
  const toml::node* groundings = table.find("groundings");
  if (!groundings || !groundings->is_array()) return objective;
  objective.groundings.clear();
  for (const toml::node& node : *groundings->as_array()) {
    objective.groundings.push_back(grounding_or_last(node.value_or(std::string())));
  }
  return objective;
}

std::optional<MechanismSpec> read_mechanism(const TableView& table, const Copy& copy, int layers,
                                            Complaints& complaints) {
  if (!table.present()) return std::nullopt;
  MechanismSpec mechanism;
  std::string grounding;
  table.set("vertex", grounding);
  table.set("VA_mm", mechanism.VA);
  table.set("VB_mm", mechanism.VB);
  table.set("assembly", mechanism.assembly_mode);
  mechanism.grounding = grounding_or_last(grounding);
  mechanism.layers = read_link_layers(table, layers, complaints);
  if (!complaints.none_about("mechanism")) return mechanism;
  const auto count = static_cast<int>(assembly_modes(shape_of(copy.k(), mechanism.grounding)).size());
  if (mechanism.assembly_mode >= count) {
    complaints.add(table.line_of_key("assembly"), "mechanism.assembly",
                   fmt::format("{}", mechanism.assembly_mode),
                   fmt::format("0 to {}: this ratio has {} assembly modes with the {} at the vertex",
                               count - 1, count, grounding));
  }
  return mechanism;
}

CuttingSpec read_cutting(const TableView& table) {
  CuttingSpec cutting;
  std::string process;
  table.set("process", process);
  cutting.process = process_named(process);
  if (cutting.process) cutting.hole_fit = usual_fit(*cutting.process);
  table.set("hole_fit_mm", cutting.hole_fit);
  table.set("kerf_mm", cutting.kerf);
  table.set("gap_mm", cutting.gap);
  if (table.has("sheet_mm")) table.set("sheet_mm", cutting.stock_sheet.emplace(Point::Zero()));
  return cutting;
}

}  // namespace kempe
