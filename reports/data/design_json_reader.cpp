#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/data/design_json.hpp"
#include "reports/data/design_json_keys.hpp"
#include "reports/data/json_fields.hpp"
#include "specs/text/json_text.hpp"
#include "specs/text/printable.hpp"

namespace kempe {
namespace {

constexpr double largest_coordinate = 1e7;  ///< mm; ten kilometres: beyond it squares lose the micrometre
constexpr std::size_t many = 10'000'000;

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
  for (const JsonField& place : field.elements(4, many)) {
    result.push_back(point(place));
    if (field.failed()) return {};
  }
  if (result.empty()) return result;
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

CopyingLinkage::Orientation orientation(const JsonField& field) {
  const auto sign = [](const JsonField& one) { return static_cast<int>(one.integer(-1, 1)); };
  CopyingLinkage::Orientation result{sign(field["parallelogram"]), sign(field["plate_ACX"]),
                                     sign(field["plate_BCY"])};
  if (result.parallelogram == 0) field["parallelogram"].refuse("1 or -1");
  return result;
}

Joint carrier(const JsonField& field, Joint expected) {
  const Joint stored = joint(field);
  if (stored != expected) field.refuse(fmt::format("\"{}\" with this vertex", letter(expected)));
  return stored;
}

DrawnMechanism drawn_mechanism(const JsonField& field, Grounding grounding) {
  const JointRoles expected = roles_of(grounding);
  return {.lengths = lengths(field["lengths_mm"]),
          .orientation = orientation(field["orientation"]),
          .pole = carrier(field["pole"], expected.pole),
          .tracer = carrier(field["tracer"], expected.tracer),
          .pen = carrier(field["pen"], expected.pen),
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

void read_mechanism(const JsonField& field, StoredDesign& design) {
  design.grounding = one_of<Grounding>(
      field["vertex"], {{"pole", Grounding::pole}, {"tracer", Grounding::tracer}, {"pen", Grounding::pen}});
  design.mechanism = drawn_mechanism(field, design.grounding);
  if (const auto assembly_mode = field.find("assembly"))
    design.assembly_mode = static_cast<int>(assembly_mode->integer(0, 3));
  const auto [real, imaginary] = field["shape"].pair();
  design.shape = {real, imaginary};
  read_links(field["links"], design);
  design.style.width = length(field["link_width_mm"]);
  design.style.pin_diameter = length(field["pin_diameter_mm"]);
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
  result.certified = field["certified"].boolean();
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
  if (const auto gap = field.find("sheets_gap_mm")) result.sheets_gap = gap->number();
  if (const auto error = field.find("copy_error_mm")) result.copy_error = error->number();
  return result;
}

Tolerance tolerance(const JsonField& field) {
  const auto robust = field.find("robust");
  return {.length = field["length_mm"].number(0, largest_coordinate),
          .play = field["play_mm"].number(0, largest_coordinate),
          .robust = robust && robust->boolean()};
}

Obstacle obstacle(const JsonField& field) {
  Obstacle result;
  const Region shape = region(field["shape"]);
  if (shape.polygons.size() != 1) field["shape"].refuse("one polygon");
  if (const auto name = field.find("name")) result.name = printable(name->text());
  if (!shape.polygons.empty()) result.shape = shape.polygons.front();
  const auto layers = field["layers"].elements(2, 2);
  if (layers.size() != 2) return result;
  result.lowest_layer = static_cast<int>(layers[0].integer(1, 100));
  result.highest_layer = static_cast<int>(layers[1].integer(result.lowest_layer, 100));
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
  allowed.workshop.grid = perhaps_length(field, "grid_mm");
  if (const auto stock = field.find("stock_mm"))
    for (const JsonField& one : stock->elements(0, many)) allowed.workshop.stock.push_back(length(one));
  for (std::size_t i = 0; i < LinkLengths::names.size(); ++i)
    allowed.workshop.locked[i] = perhaps_length(field, std::string(LinkLengths::names[i]) + "_mm");
}

std::vector<Grounding> groundings(const JsonField& field) {
  std::vector<Grounding> result;
  for (const JsonField& one : field.elements(1, 3))
    result.push_back(one_of<Grounding>(
        one, {{"pole", Grounding::pole}, {"tracer", Grounding::tracer}, {"pen", Grounding::pen}}));
  return result;
}

CuttingSpec cutting(const JsonField& field) {
  CuttingSpec result{.hole_fit = field["hole_fit_mm"].number(-1000, 1000),
                     .kerf = field["kerf_mm"].number(0, 1000)};
  if (const auto sheet = field.find("sheet_mm")) result.sheet = point(*sheet);
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
    for (const Objective one :
         {Objective::size, Objective::transmission, Objective::copy_error, Objective::footprint})
      choices.emplace_back(name(one), one);
    design.objective = one_of(*objective, choices);
  }
  if (const auto value = field.find("value")) design.value = value->number();
}

void read_extras(const JsonField& root, StoredDesign& design) {
  if (const auto field = root.find("limits")) design.limits = limits(*field);
  if (const auto field = root.find("tolerance")) design.tolerance = tolerance(*field);
  if (const auto field = root.find("obstacles"))
    for (const JsonField& one : field->elements(0, many)) design.obstacles.push_back(obstacle(one));
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
  if (root.failed()) return design;
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
  if (!json) return tl::unexpected(json.error());
  JsonField::Log log{file, std::nullopt};
  StoredDesign design = read_fields(JsonField(*json, log));
  if (log.first) return tl::unexpected(*log.first);
  return design;
}

namespace {

/// The assembly mode whose interval holds the stored opening and whose orientation is the stored one.
std::optional<CopyingLinkage> fitting_assembly_mode(const StoredDesign& design) {
  const DrawnMechanism& drawn = design.mechanism;
  constexpr double slack = 1e-9;
  const auto intervals = assembly_modes(shape_of(design.k, design.grounding));
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const OpeningInterval widened{intervals[i].lower - slack, intervals[i].upper + slack};
    if (!widened.contains(drawn.opening) ||
        static_cast<int>(i) != design.assembly_mode.value_or(static_cast<int>(i)))
      continue;
    const auto linkage = CopyingLinkage::make(design.k, design.grounding, drawn.lengths.VA, drawn.lengths.VB,
                                              static_cast<int>(i), drawn.pole_position);
    if (linkage && linkage->orientation() == drawn.orientation) return *linkage;
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
  return map_task(linkage, design.style, design.layers, design.limits.value_or(Limits{}), design.obstacles,
                  {});
}

namespace {

/// Where there is no region to drive over the file does not say where the linkage is free: it is mapped anew.
void drive_over_workspace(const StoredDesign& design, VerificationTask& task) {
  const auto linkage = linkage_of(design, "");
  if (!linkage) return;  // whatever contradicts itself there, the drive over the region sees it too
  MapTask mapped = map_task(design, *linkage);
  task.workspace = part_to_drive_over(mapped, map_workspace(mapped, {.largest_sheets = false}));
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
  }
  return task;
}

}  // namespace kempe
