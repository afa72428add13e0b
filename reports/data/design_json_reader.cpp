#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/data/design_json.hpp"
#include "reports/data/design_json_keys.hpp"
#include "reports/data/json_fields.hpp"
#include "specs/file_kind.hpp"
#include "specs/hardware.hpp"
#include "specs/materials.hpp"
#include "specs/text/json_text.hpp"
#include "specs/text/printable.hpp"

namespace kempe {
namespace {

constexpr double largest_coordinate = 1e7;  ///< mm; ten kilometres: beyond it squares lose the micrometre
constexpr std::size_t many = 10'000'000;
constexpr std::size_t most_solvers = 100, longest_solver_name = 200;

template <class Value>
Value one_of(const JsonField& field, const std::vector<std::pair<std::string, Value>>& choices) {
  const std::string text = field.text();
  std::string allowed;
  for (const auto& [word, value] : choices) {
    if (text == word) return value;
    allowed += (allowed.empty() ? "\"" : ", \"") + word + "\"";
  }
  field.refuse(allowed);
  return choices.front().second;
}

double coordinate(const JsonField& field) { return field.number(-largest_coordinate, largest_coordinate); }

double length(const JsonField& field) {
  const double value = field.positive();
  if (value > largest_coordinate) field.refuse(fmt::format("a length up to {} mm", largest_coordinate));
  return value;
}

Point point(const JsonField& field) {
  const auto both = field.elements(2, 2);
  return both.size() == 2 ? Point(coordinate(both[0]), coordinate(both[1])) : Point(Point::Zero());
}

Ring ring(const JsonField& field) {
  Ring result;
  const std::size_t before = field.faults();
  for (const JsonField& place : field.elements(4, many)) {
    result.push_back(point(place));
    if (field.failed()) return {};
  }
  if (field.faults() != before) return {};
  if (result.front() != result.back())
    field.refuse("an open ring", "a ring whose last position repeats the first");
  result.pop_back();
  return result;
}

Region region(const JsonField& field) {
  Region result;
  if (field["type"].text() != "MultiPolygon") field["type"].refuse("\"MultiPolygon\"");
  for (const JsonField& rings : field["coordinates"].elements(0, many)) {
    Polygon polygon;
    for (const JsonField& one : rings.elements(1, many)) {
      if (polygon.outer.empty())
        polygon.outer = ring(one);
      else
        polygon.holes.push_back(ring(one));
      if (field.failed()) return {};
    }
    result.polygons.push_back(std::move(polygon));
  }
  return result;
}

Joint joint(const JsonField& field) {
  std::vector<std::pair<std::string, Joint>> choices;
  for (const Joint one : all_joints) choices.emplace_back(std::string(1, letter(one)), one);
  return one_of(field, choices);
}

OpeningInterval opening(const JsonField& field) {
  const auto ends = field.elements(2, 2);
  if (ends.size() != 2) return {};
  const OpeningInterval result{radians(ends[0].number(-180, 180)), radians(ends[1].number(-180, 180))};
  if (result.empty()) field.refuse("[lower, upper] with lower <= upper, degrees");
  return result;
}

LinkLengths lengths(const JsonField& field) {
  const auto at = [&](std::size_t i) { return length(field[LinkLengths::names[i]]); };
  return {
      .VA = at(0), .VB = at(1), .AC = at(2), .BC = at(3), .AX = at(4), .CX = at(5), .BY = at(6), .CY = at(7)};
}

LoopSides loop_sides(const JsonField& field) {
  const auto side = [](const JsonField& one) { return static_cast<Side>(one.integer(-1, 1)); };
  const LoopSides result{side(field["parallelogram"]), side(field["plate_ACX"]), side(field["plate_BCY"])};
  if (result.parallelogram == Side::on_line) field["parallelogram"].refuse("1 or -1");
  return result;
}

void require_joint(const JsonField& field, Joint expected) {
  if (joint(field) != expected) field.refuse(fmt::format("\"{}\" with this vertex", letter(expected)));
}

void require_roles(const JsonField& field, const JointRoles& roles) {
  require_joint(field["pole"], roles.pole);
  require_joint(field["tracer"], roles.tracer);
  require_joint(field["pen"], roles.pen);
}

DrawnMechanism drawn_mechanism(const JsonField& field, const JointRoles& roles) {
  return {.lengths = lengths(field["lengths_mm"]),
          .sides = loop_sides(field["orientation"]),
          .pole = roles.pole,
          .tracer = roles.tracer,
          .pen = roles.pen,
          .pole_position = point(field["pole_position_mm"]),
          .opening = field["opening_deg"].is_null() ? OpeningInterval{} : opening(field["opening_deg"])};
}

/// The link's layer; its name and joints must be those of the mechanism.
void read_link(const JsonField& field, Link expected, StoredDesign& design) {
  const LinkJoints joints = joints_of(expected);
  if (field["name"].text() != name(expected)) field["name"].refuse(fmt::format("\"{}\"", name(expected)));
  const auto count = static_cast<std::size_t>(joints.count);
  const auto stored = field["joints"].elements(count, count);
  for (std::size_t i = 0; i < stored.size(); ++i)
    if (joint(stored[i]) != joints.joints[i])
      stored[i].refuse(fmt::format("\"{}\"", letter(joints.joints[i])));
  design.layers.of[static_cast<std::size_t>(expected)] = static_cast<int>(field["layer"].integer(1, 100));
  if (joints.count == 2 && field["shape"].text() != "bar") field["shape"].refuse("\"bar\"");
  if (joints.count == 3) {
    const PlateStyle plate =
        one_of<PlateStyle>(field["shape"], {{"bent", PlateStyle::bent}, {"triangle", PlateStyle::triangle}});
    if (expected == Link::BCY && plate != design.style.plate)
      field["shape"].refuse("the shape of plate ACX: both are made alike");
    design.style.plate = plate;
  }
}

void read_links(const JsonField& field, StoredDesign& design) {
  const auto links = field.elements(all_links.size(), all_links.size());
  for (std::size_t i = 0; i < links.size(); ++i) read_link(links[i], all_links[i], design);
}

Grounding grounding(const JsonField& field) {
  std::vector<std::pair<std::string, Grounding>> choices;
  for (const Grounding each : all_groundings) choices.emplace_back(name(each), each);
  return one_of(field, choices);
}

std::string hardware_name(const JsonField& field) {
  std::string name = field.text();
  if (hardware_named(name) == nullptr) field.refuse("a name of docs/hardware.md");
  return name;
}

/// A name, or an object of names by joint.
JointHardware joint_hardware(const JsonField& field) {
  if (!field.is_object()) return hardware_name(field);
  JointHardware hardware;
  if (const auto every = field.find("default")) hardware.every = hardware_name(*every);
  for (const Joint joint : all_joints)
    if (const auto own = field.find(std::string(1, letter(joint))))
      hardware.at[static_cast<std::size_t>(joint)] = hardware_name(*own);
  return hardware;
}

void read_mechanism(const JsonField& field, StoredDesign& design) {
  const std::size_t before = field.faults();
  design.grounding = grounding(field["vertex"]);
  const JointRoles roles = roles_of(design.grounding);
  if (field.faults() == before) require_roles(field, roles);
  design.mechanism = drawn_mechanism(field, roles);
  if (const auto assembly_mode = field.find("assembly"))
    design.assembly_mode = static_cast<int>(assembly_mode->integer(0, 3));
  const auto [real, imaginary] = field["shape"].pair();
  design.shape = {real, imaginary};
  read_links(field["links"], design);
  design.style.width = length(field["link_width_mm"]);
  design.style.pin_diameter = length(field["pin_diameter_mm"]);
  if (const auto hardware = field.find("hardware")) design.hardware = joint_hardware(*hardware);
  design.style.thickness = length(field["thickness_mm"]);
}

void read_copy(const JsonField& field, StoredDesign& design) {
  design.scale = field["scale"].positive();
  design.rotation = radians(field["rotation_deg"].number(-360, 360));
  design.k = copy_ratio(design.scale, design.rotation);
  if (std::abs(design.k - 1.0) < 1e-12)
    field.refuse("a ratio other than 1 without rotation, which is no similarity with a pole");
  if (!field.find("wanted_scale") && !field.find("wanted_rotation_deg")) return;
  design.wanted =
      WantedCopy{field["wanted_scale"].positive(), radians(field["wanted_rotation_deg"].number(-3600, 3600)),
                 field["ratio_error"].number(0, largest_coordinate)};
}

Robustness robustness(const JsonField& field) {
  return {.holds = field["holds"].boolean(),
          .clearance = field["clearance_min_mm"].number_or_null().value_or(-HUGE_VAL),
          .clearance_loss = field["clearance_loss_mm"].number_or_null().value_or(HUGE_VAL),
          .nominal_value = field["nominal_value"].number_or_null()};
}

/// All of them or none.
std::optional<LoadFigures> load_figures(const JsonField& field) {
  if (!field.find("load_error_max_mm")) return std::nullopt;
  return LoadFigures{.error_max = field["load_error_max_mm"].number(),
                     .error_min = field["load_error_min_mm"].number(),
                     .pin_force_max = field["pin_force_max_N"].number(),
                     .hand_force_max = field["hand_force_max_N"].number(),
                     .stress_max = field["stress_max_MPa"].number_or_null().value_or(HUGE_VAL)};
}

Quality quality(const JsonField& field) {
  Quality result;
  result.size = field["size_mm"].number();
  result.transmission_min = radians(field["transmission_min_deg"].number(0, 90));
  result.clearance_min = field["clearance_min_mm"].number_or_null().value_or(HUGE_VAL);
  result.copy_error_worst = field["copy_error_worst_mm"].number_or_null();
  result.copy_error_rss = field["copy_error_rss_mm"].number_or_null();
  result.distortion_worst = field["distortion_worst_mm"].number_or_null();
  result.footprint = field["footprint_mm2"].number_or_null().value_or(0);
  result.proven_bound = field["lower_bound"].number_or_null();
  result.loads = load_figures(field);
  if (const auto sag = field.find("sag_max_mm")) result.sag = sag->number();
  if (const auto mass = field.find("mass_kg")) result.mass = mass->number();
  if (const auto one = field.find("robust")) result.robust = robustness(*one);
  return result;
}

Verification verification(const JsonField& field) {
  constexpr std::int64_t most = 1'000'000'000;
  Verification result;
  result.samples = static_cast<std::size_t>(field["samples"].integer(0, most));
  result.copy_error_max = field["copy_error_max_mm"].number_or_null().value_or(HUGE_VAL);
  result.loop_residual_max = field["loop_residual_max_mm"].number_or_null().value_or(HUGE_VAL);
  result.scale = field["scale"].number();
  result.rotation = radians(field["rotation_deg"].number());
  result.flips = static_cast<int>(field["flips"].integer(0, most));
  result.holds = field["certified"].boolean();
  if (const auto over = field.find("driven_over")) result.over_workspace = over->text() == "workspace";
  if (const auto failure = field.find("failure")) result.failure = failure->text();
  return result;
}

FittingSheet sheet(const JsonField& field) {
  return {.name = field["name"].text(),
          .width = length(field["width_mm"]),
          .height = length(field["height_mm"]),
          .centre = point(field["centre_mm"]),
          .turn = radians(field["turn_deg"].number(-360, 360))};
}

StoredMap stored_map(const JsonField& field) {
  const auto number = [&](std::string_view key) {
    const auto one = field.find(key);
    return one ? std::optional(one->number()) : std::nullopt;
  };
  StoredMap result{.reachable = number("reachable_mm2"),
                   .usable = number("usable_mm2"),
                   .collision_free = number("collision_free_mm2"),
                   .uncertain = number("uncertain_mm2"),
                   .map_tolerance = number("map_tolerance"),
                   .sheets = {}};
  if (result.map_tolerance) field["map_tolerance"].number(1e-5, 0.5);
  if (const auto sheets = field.find("sheets"))
    for (const JsonField& one : sheets->elements(0, 100)) result.sheets.push_back(sheet(one));
  if (const auto largest = field.find("largest_sheet"); largest && largest->find("width_mm"))
    result.sheets.push_back(sheet(*largest));
  return result;
}

Limits limits(const JsonField& field) {
  Limits result;
  result.clearance = field["clearance_mm"].number(0, largest_coordinate);
  result.transmission = radians(field["transmission_deg"].number(0, 90));
  if (const auto gap = field.find("sheets_gap_mm")) result.copy_gap = gap->number();
  if (const auto error = field.find("copy_error_mm")) result.copy_error = error->number();
  if (const auto strip = field.find("longest_strip_mm")) result.longest_strip = length(*strip);
  if (const auto error = field.find("load_error_mm")) result.load_error = length(*error);
  if (const auto sag = field.find("sag_mm")) result.sag = length(*sag);
  return result;
}

Tolerance tolerance(const JsonField& field) {
  const auto robust = field.find("robust");
  return {.length = field["length_mm"].number(0, largest_coordinate),
          .play = field["play_mm"].number(0, largest_coordinate),
          .robust = robust && robust->boolean()};
}

Polygon one_polygon(const JsonField& field) {
  const Region shape = region(field);
  if (shape.polygons.size() == 1) return shape.polygons.front();
  field.refuse("one polygon");
  return {};
}

/// Name and layers of an obstacle or a body.
template <typename Thing>
void read_name_and_layers(const JsonField& field, Thing& thing) {
  if (const auto name = field.find("name")) thing.name = printable(name->text());
  const auto layers = field["layers"].elements(2, 2);
  if (layers.size() != 2) return;
  thing.lowest_layer = static_cast<int>(layers[0].integer(1, 100));
  thing.highest_layer = static_cast<int>(layers[1].integer(thing.lowest_layer, 100));
}

Obstacle obstacle(const JsonField& field) {
  Obstacle result;
  result.shape = one_polygon(field["shape"]);
  read_name_and_layers(field, result);
  return result;
}

Body body(const JsonField& field) {
  Body result;
  result.at = one_of<Carrier>(field["at"], {{"tracer", Carrier::tracer}, {"pen", Carrier::pen}});
  if (const auto link = field.find("turns_with"))
    result.turns_with =
        one_of<Link>(*link, {{"VA", Link::VA}, {"VB", Link::VB}, {"ACX", Link::ACX}, {"BCY", Link::BCY}});
  if (const auto circle = field.find("circle_mm")) {
    const double radius = (*circle)["radius"].number(0, largest_coordinate);
    if (!(radius > 0)) (*circle)["radius"].refuse("a number > 0");
    result.shape = Disc{point((*circle)["centre"]), radius};
  } else {
    result.shape = one_polygon(field["shape"]);
  }
  read_name_and_layers(field, result);
  return result;
}

Material material(const JsonField& field) {
  Material result{.name = printable(field["name"].text()),
                  .E = MPa_per_GPa * field["E_GPa"].positive(),
                  .density = field["density_kg_m3"].positive(),
                  .strength = field["strength_MPa"].positive()};
  if (const auto shear = field.find("G_GPa")) result.G = MPa_per_GPa * shear->positive();
  return result;
}

Load load(const JsonField& field) {
  constexpr double largest_mass = 1e4;
  Load result{.pen_force = field["pen_N"].positive()};
  if (const auto mass = field.find("pen_mass_kg")) result.pen_mass = mass->number(0, largest_mass);
  if (const auto mass = field.find("tracer_mass_kg")) result.tracer_mass = mass->number(0, largest_mass);
  if (const auto tilt = field.find("tilt_deg")) result.tilt = radians(tilt->number(0, 90));
  if (const auto grip = field.find("grip_mm")) result.grip = grip->positive();
  if (const auto friction = field.find("friction")) result.friction = friction->number(0, 2);
  if (const auto rests = field.find("rests"))
    for (const JsonField& one : rests->elements(0, 2))
      result.rests.push_back(one_of<Carrier>(one, {{"tracer", Carrier::tracer}, {"pen", Carrier::pen}}));
  return result;
}

/// A length that may be absent.
std::optional<double> perhaps_length(const JsonField& field, std::string_view key) {
  const auto one = field.find(key);
  return one ? std::optional(length(*one)) : std::nullopt;
}

PoleSpec pole(const JsonField& field) {
  PoleSpec result;
  if (const auto at = field.find("at_mm"))
    result.place = point(*at);
  else if (Region area = region(field["within_mm"]); !area.empty())
    result.place = std::move(area);
  else
    field["within_mm"].refuse("an area of at least one polygon");
  return result;
}

void read_links_limits(const JsonField& field, Allowed& allowed) {
  allowed.layers = static_cast<int>(field["layers"].integer(2, 100));
  allowed.shortest = length(field["shortest_mm"]);
  allowed.longest = length(field["longest_mm"]);
  allowed.wall = perhaps_length(field, "wall_mm");
  allowed.seat = perhaps_length(field, "seat_mm");
  allowed.stock_lengths.grid = perhaps_length(field, "grid_mm");
  if (const auto stock = field.find("stock_mm"))
    for (const JsonField& one : stock->elements(0, many)) allowed.stock_lengths.stock.push_back(length(one));
  for (std::size_t i = 0; i < LinkLengths::names.size(); ++i)
    allowed.stock_lengths.locked[i] = perhaps_length(field, std::string(LinkLengths::names[i]) + "_mm");
  if (const auto sections = field.find("sections_mm"))
    for (const JsonField& one : sections->elements(0, most_sections))
      if (const auto sides = one.elements(2, 2); sides.size() == 2)
        allowed.sections.push_back({length(sides[0]), length(sides[1])});
}

std::vector<Grounding> groundings(const JsonField& field) {
  std::vector<Grounding> result;
  for (const JsonField& one : field.elements(1, 3)) result.push_back(grounding(one));
  return result;
}

CuttingSpec cutting(const JsonField& field) {
  CuttingSpec result{.hole_fit = field["hole_fit_mm"].number(-1000, 1000),
                     .kerf = field["kerf_mm"].number(0, 1000)};
  if (const auto process = field.find("process"))
    result.process = one_of<Process>(*process, {{"laser", Process::laser},
                                                {"mill", Process::mill},
                                                {"print", Process::print},
                                                {"drill", Process::drill}});
  if (const auto sheet = field.find("sheet_mm")) result.stock_sheet = point(*sheet);
  result.gap = field["gap_mm"].number(0, largest_coordinate);
  return result;
}

ToolAdvice tool(const JsonField& field) {
  return {.follower_radius = field["follower_radius_mm"].number_or_null(),
          .cutter_radius = field["cutter_radius_mm"].number_or_null(),
          .exact_follower_radius = field["exact_follower_radius_mm"].number_or_null(),
          .exact_cutter_radius = field["exact_cutter_radius_mm"].number_or_null(),
          .cut_outside = field["cut_outside_mm"].number_or_null(),
          .template_offset = field["template_offset_mm"].number_or_null()};
}

void read_search(const JsonField& field, StoredDesign& design) {
  if (const auto objective = field.find("objective")) {
    std::vector<std::pair<std::string, Objective>> choices;
    for (const Objective one : {Objective::size, Objective::transmission, Objective::copy_error,
                                Objective::footprint, Objective::load_error, Objective::mass})
      choices.emplace_back(name(one), one);
    design.objective = one_of(*objective, choices);
  }
  if (const auto value = field.find("value")) design.value = value->number();
  StoredSearch& search = design.search;
  if (const auto solvers = field.find("solvers"))
    for (const JsonField& solver : solvers->elements(0, most_solvers))
      search.solvers.push_back(printable(solver.text(), longest_solver_name));
  if (const auto evaluations = field.find("evaluations")) search.evaluations = evaluations->natural();
  if (const auto seed = field.find("seed")) search.seed = seed->natural();
  if (const auto complete = field.find("complete")) search.complete = complete->boolean();
}

std::string title(const JsonField& field) {
  std::string text = field.text();
  if (text.size() > most_title_bytes || printable(text) != text)
    field.refuse(fmt::format("one line of at most {} bytes, without control characters", most_title_bytes));
  return text;
}

void read_extras(const JsonField& root, StoredDesign& design) {
  if (const auto field = root.find("title")) design.title = title(*field);
  if (const auto field = root.find("limits")) design.limits = limits(*field);
  if (const auto field = root.find("tolerance")) design.tolerance = tolerance(*field);
  if (const auto field = root.find("material")) design.material = material(*field);
  if (const auto field = root.find("load")) design.load = load(*field);
  if (const auto field = root.find("obstacles"))
    for (const JsonField& one : field->elements(0, many)) design.obstacles.push_back(obstacle(one));
  if (const auto field = root.find("bodies"))
    for (const JsonField& one : field->elements(0, many)) design.bodies.push_back(body(one));
  if (const auto field = root.find("table")) design.table = one_polygon(*field);
  if (const auto field = root.find("cutting")) design.cutting = cutting(*field);
  if (const auto field = root.find("tool")) design.tool = tool(*field);
  if (const auto field = root.find("search")) read_search(*field, design);
}

/// pole, links and objective come together: what the spec of a searched design allows.
void read_allowed(const JsonField& root, StoredDesign& design) {
  if (!root.find("pole") && !root.find("links") && !root.find("objective")) return;
  Allowed& allowed = design.allowed.emplace();
  allowed.pole = pole(root["pole"]);
  read_links_limits(root["links"], allowed);
  allowed.groundings = groundings(root["objective"]["groundings"]);
}

StoredDesign read_fields(const JsonField& root) {
  StoredDesign design;
  if (root["format"].text() != "kempe-design/1") root["format"].refuse("\"kempe-design/1\"");
  if (root.faults() > 0) return design;  // another file
  read_copy(root["copy"], design);
  design.region = region(root["region"]);
  read_mechanism(root["mechanism"], design);
  design.quality = quality(root["quality"]);
  design.footprint = root["quality"]["footprint_mm2"].number_or_null();
  design.region_covered = root["workspace"]["region_covered"].boolean();
  design.map = stored_map(root["workspace"]);
  design.verification = verification(root["verification"]);
  read_extras(root, design);
  read_allowed(root, design);
  note_keys(root, design);
  return design;
}

}  // namespace

tl::expected<StoredDesign, InputError> read_design(std::string_view text, const std::string& file) {
  const auto json = parse_json(text, file);
  if (!json) return tl::unexpected(or_other_kind(json.error(), text, FileKind::design));
  JsonField::Log log{file};
  StoredDesign design = read_fields(JsonField(*json, log));
  if (log.faults.empty()) return design;
  InputError faults = log.faults.front();
  faults.others.assign(log.faults.begin() + 1, log.faults.end());
  return tl::unexpected(or_other_kind(std::move(faults), text, FileKind::design));
}

namespace {

/// The assembly mode whose interval holds the stored opening and whose orientation is the stored one.
std::optional<CopyingLinkage> fitting_assembly_mode(const StoredDesign& design) {
  const DrawnMechanism& drawn = design.mechanism;
  constexpr double slack = 1e-9;
  for (const AssemblyMode& mode : assembly_modes(shape_of(design.k, design.grounding))) {
    const OpeningInterval widened{mode.openings.lower - slack, mode.openings.upper + slack};
    if (!widened.contains(drawn.opening) || mode.sides != drawn.sides ||
        mode.number != design.assembly_mode.value_or(mode.number))
      continue;
    const auto linkage = CopyingLinkage::make(design.k, design.grounding, drawn.lengths.VA, drawn.lengths.VB,
                                              mode.number, drawn.pole_position);
    if (linkage) return *linkage;
  }
  return std::nullopt;
}

}  // namespace

tl::expected<CopyingLinkage, InputError> linkage_of(const StoredDesign& design, const std::string& file) {
  const auto refused = [&](const std::string& key, const std::string& found, const std::string& allowed) {
    return tl::unexpected(InputError{file, 0, "mechanism." + key, found, allowed});
  };
  const Complex shape = shape_of(design.k, design.grounding);
  if (std::abs(shape - design.shape) > 1e-9 * (1 + std::abs(shape)))
    return refused("shape", fmt::format("[{}, {}]", design.shape.real(), design.shape.imag()),
                   fmt::format("[{}, {}] for this copy ratio and vertex", shape.real(), shape.imag()));
  const auto linkage = fitting_assembly_mode(design);
  if (!linkage)
    return refused("opening_deg", "an opening or an orientation of no assembly mode",
                   "those of one assembly mode of this shape");
  const auto stored = design.mechanism.lengths.values(), exact = linkage->lengths().values();
  for (std::size_t i = 0; i < stored.size(); ++i)
    if (std::abs(stored[i] - exact[i]) > 1e-9 * linkage->size())
      return refused(fmt::format("lengths_mm.{}", LinkLengths::names[i]), fmt::format("{}", stored[i]),
                     fmt::format("{} to close and copy with VA, VB and the shape", exact[i]));
  return *linkage;
}

MapTask map_task(const StoredDesign& design, const CopyingLinkage& linkage) {
  const Limits limits = design.limits.value_or(Limits{});
  return {.linkage = linkage,
          .style = design.style,
          .layers = design.layers,
          .clearance = limits.clearance,
          .transmission = limits.transmission,
          .obstacles = design.obstacles,
          .bodies = design.bodies,
          .table = design.table,
          .copy_gap = limits.copy_gap};
}

namespace {

/// Where there is no region to drive over the file does not say where the linkage is free: it is mapped anew.
void drive_over_workspace(const StoredDesign& design, VerificationTask& task) {
  const auto linkage = linkage_of(design, "");
  if (!linkage) return;  // whatever contradicts itself there, the drive over the region sees it too
  MapTask mapped = map_task(design, *linkage);
  WorkspaceMap map = map_workspace(mapped, {.largest_sheets = false});
  // Of several free intervals the file states one, which need not be the widest.
  if (!task.mechanism.opening.empty()) map.certified_opening = task.mechanism.opening;
  task.workspace = part_to_drive_over(mapped, map);
  if (!task.mechanism.opening.empty()) return;
  task.mechanism.opening = linkage->openings_with_transmission(mapped.transmission);
  task.region_covered = false;
}

}  // namespace

VerificationTask verification_task(const StoredDesign& design) {
  VerificationTask task;
  task.mechanism = design.mechanism;
  task.mechanism.shape = design.shape;
  task.k = design.k;
  task.region = design.region;
  task.region_covered = design.region_covered;
  task.style = design.style;
  task.layers = design.layers;
  if (task.region.empty() || !task.region_covered) drive_over_workspace(design, task);
  if (design.limits && task.region_covered) {
    task.transmission = design.limits->transmission;
    task.clearance = design.limits->clearance;
    task.obstacles = design.obstacles;
    task.bodies = design.bodies;
    task.table = design.table;
  }
  return task;
}

}  // namespace kempe
