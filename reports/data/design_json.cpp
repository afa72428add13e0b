#include "reports/data/design_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/stated_angle.hpp"
#include "reports/data/geojson_geometry.hpp"
#include "reports/data/link_shape.hpp"
#include "reports/data/task_json.hpp"
#include "specs/objective_unit.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

Json opening_json(const OpeningInterval& opening) {
  return opening.empty() ? Json(nullptr)
                         : Json::array({stated_degrees(opening.lower), stated_degrees(opening.upper)});
}

Json lengths_json(const LinkLengths& lengths) {
  Json json = Json::object();
  const auto values = lengths.values();
  for (std::size_t i = 0; i < values.size(); ++i) json[std::string(LinkLengths::names[i])] = values[i];
  return json;
}

Json links_json(const Design& design) {
  Json links = Json::array();
  for (const Link link : all_links) {
    const LinkJoints joints = joints_of(link);
    Json letters = Json::array();
    for (int i = 0; i < joints.count; ++i)
      letters.push_back(std::string(1, letter(joints.joints[static_cast<std::size_t>(i)])));
    links.push_back({{"name", name(link)},
                     {"joints", std::move(letters)},
                     {"shape", shape_name(link, design.style)},
                     {"layer", design.layers[link]}});
  }
  return links;
}

/// A name, or where joints differ an object of names: "default" and the joints' letters.
Json hardware_json(const JointHardware& hardware) {
  if (!hardware.differs()) return hardware.every;
  Json json = Json::object();
  if (!hardware.every.empty()) json["default"] = hardware.every;
  for (const Joint joint : all_joints)
    if (const std::string& own = hardware.at[static_cast<std::size_t>(joint)]; !own.empty())
      json[std::string(1, letter(joint))] = own;
  return json;
}

Json mechanism_json(const Design& design) {
  const CopyingLinkage& linkage = design.linkage;
  const LoopSides sides = linkage.assembly_mode().sides;
  const auto text = [](Joint joint) { return std::string(1, letter(joint)); };
  Json json{{"vertex", name(linkage.grounding())},
            {"pole", text(linkage.pole_joint())},
            {"tracer", text(linkage.tracer_joint())},
            {"pen", text(linkage.pen_joint())},
            {"pole_position_mm", position(linkage.pole())},
            {"shape", Json::array({linkage.shape().real(), linkage.shape().imag()})},
            {"assembly", linkage.assembly_mode().number},
            {"opening_deg", opening_json(design.opening)},
            {"lengths_mm", lengths_json(linkage.lengths())},
            {"orientation",
             {{"parallelogram", sign(sides.parallelogram)},
              {"plate_ACX", sign(sides.plate_ACX)},
              {"plate_BCY", sign(sides.plate_BCY)}}},
            {"links", links_json(design)},
            {"link_width_mm", design.style.width},
            {"pin_diameter_mm", design.style.pin_diameter},
            {"thickness_mm", design.style.thickness}};
  if (!design.hardware.none()) json["hardware"] = hardware_json(design.hardware);
  return json;
}

/// A figure of the objective; without a search, which names one, in the library's unit.
Json objective_figure(const std::optional<double>& value, const std::optional<SearchRecord>& search) {
  if (!value) return nullptr;
  return finite_or_null(search ? in_file_unit(search->objective, *value) : *value);
}

Json quality_json(const Design& design) {
  const Quality& quality = design.quality;
  const Json swept = design.region.empty() ? Json(nullptr) : finite_or_null(quality.footprint);
  Json json{{"size_mm", finite_or_null(quality.size)},
            {"transmission_min_deg", finite_or_null(degrees(quality.transmission_min))},
            {"clearance_min_mm", finite_or_null(quality.clearance_min)},
            {"copy_error_worst_mm", finite_or_null(quality.copy_error_worst)},
            {"copy_error_rss_mm", finite_or_null(quality.copy_error_rss)},
            {"distortion_worst_mm", finite_or_null(quality.distortion_worst)},
            {"footprint_mm2", swept},
            {"lower_bound", objective_figure(quality.proven_bound, design.search)}};
  if (quality.copy_error_at_corner)
    json["copy_error_at_corner_mm"] = finite_or_null(*quality.copy_error_at_corner);
  if (quality.loads) {
    json["load_error_max_mm"] = finite_or_null(quality.loads->error_max);
    json["load_error_min_mm"] = finite_or_null(quality.loads->error_min);
    json["pin_force_max_N"] = finite_or_null(quality.loads->pin_force_max);
    json["hand_force_max_N"] = finite_or_null(quality.loads->hand_force_max);
    json["stress_max_MPa"] = finite_or_null(quality.loads->stress_max);
    if (quality.loads->weight_error_max)
      json["weight_error_max_mm"] = finite_or_null(*quality.loads->weight_error_max);
  }
  if (quality.layered) {
    json["load_error_layered_max_mm"] = finite_or_null(quality.layered->error_max);
    json["load_rise_max_mm"] = finite_or_null(quality.layered->rise_max);
    if (quality.layered->stress_max) json["stress_layered_max_MPa"] = *quality.layered->stress_max;
    if (quality.layered->weight_error_max && quality.layered->weight_rise_max) {
      json["weight_error_layered_max_mm"] = *quality.layered->weight_error_max;
      json["weight_rise_max_mm"] = *quality.layered->weight_rise_max;
    }
  }
  if (quality.sag) json["sag_max_mm"] = finite_or_null(*quality.sag);
  if (quality.mass) json["mass_kg"] = finite_or_null(*quality.mass);
  if (quality.robust)
    json["robust"] = {{"holds", quality.robust->holds},
                      {"clearance_min_mm", finite_or_null(quality.robust->clearance)},
                      {"clearance_loss_mm", finite_or_null(quality.robust->clearance_loss)},
                      {"nominal_value", objective_figure(quality.robust->nominal_value, design.search)}};
  return json;
}

Json sheet_json(const FittingSheet& sheet) {
  return {{"name", sheet.name},
          {"width_mm", sheet.width},
          {"height_mm", sheet.height},
          {"centre_mm", position(sheet.centre)},
          {"turn_deg", degrees(sheet.turn)}};
}

Json workspace_json(const WorkspaceMap& map) {
  Json sheets = Json::array();
  const FittingSheet* largest = nullptr;
  for (const FittingSheet& sheet : map.largest_sheets) {
    sheets.push_back(sheet_json(sheet));
    if (largest == nullptr || sheet.width * sheet.height > largest->width * largest->height) largest = &sheet;
  }
  Json json{{"reachable_mm2", area(map.reachable)},
            {"usable_mm2", area(map.usable)},
            {"collision_free_mm2", area(map.collision_free)},
            {"uncertain_mm2", area(map.uncertain)},
            {"region_covered", map.coverage.covered},
            {"why_not_covered", map.coverage.why_not},
            {"largest_sheet", largest != nullptr ? sheet_json(*largest) : Json::object()},
            {"sheets", std::move(sheets)},
            {"tightest_parts", map.clearance_min_parts}};
  if (map.complete)
    json["map_tolerance"] = map.map_tolerance;
  else
    json["complete"] = false;
  return json;
}

Json verification_json(const Verification& verification) {
  Json json{{"samples", verification.samples},
            {"copy_error_max_mm", finite_or_null(verification.copy_error_max)},
            {"loop_residual_max_mm", finite_or_null(verification.loop_residual_max)},
            {"scale", finite_or_null(verification.scale)},
            {"rotation_deg", finite_or_null(stated_degrees(verification.rotation))},
            {"flips", verification.flips},
            {"certified", verification.holds},
            {"failure", verification.failure}};
  if (verification.over_workspace) json["driven_over"] = "workspace";
  return json;
}

/// `kempe workspace` searches nothing: the same keys, without values.
Json search_json(const std::optional<SearchRecord>& search) {
  if (!search)
    return {{"objective", nullptr},
            {"value", nullptr},
            {"solvers", Json::array()},
            {"evaluations", 0},
            {"seed", 0}};
  Json json{{"objective", name(search->objective)},
            {"value", objective_figure(search->value, search)},
            {"solvers", search->solvers},
            {"evaluations", search->evaluations},
            {"seed", search->seed},
            {"complete", search->complete}};
  if (!search->obstacles_out_of_reach.empty())
    json["obstacles_out_of_reach"] = search->obstacles_out_of_reach;
  return json;
}

template <class Function>
Json if_known(const std::optional<Allowed>& allowed, Function json) {
  return allowed ? json(*allowed) : Json(nullptr);
}

Json copy_json(const Design& design) {
  Json json{{"scale", design.scale}, {"rotation_deg", stated_degrees(design.rotation)}};
  if (design.wanted) {
    json["wanted_scale"] = design.wanted->scale;
    json["wanted_rotation_deg"] = stated_degrees(design.wanted->rotation);
    json["ratio_error"] = design.wanted->error;
  }
  return json;
}

Json tool_json(const std::optional<ToolAdvice>& tool) {
  if (!tool) return nullptr;
  return {{"follower_radius_mm", finite_or_null(tool->follower_radius)},
          {"cutter_radius_mm", finite_or_null(tool->cutter_radius)},
          {"exact_follower_radius_mm", finite_or_null(tool->exact_follower_radius)},
          {"exact_cutter_radius_mm", finite_or_null(tool->exact_cutter_radius)},
          {"cut_outside_mm", finite_or_null(tool->cut_outside)},
          {"template_offset_mm", finite_or_null(tool->template_offset)}};
}

}  // namespace

nlohmann::ordered_json design_values(const Design& design) {
  Json json = Json::object();
  json["format"] = "kempe-design/1";
  if (!design.title.empty()) json["title"] = design.title;
  json.update(Json{{"copy", copy_json(design)},
                   {"region", nullptr},
                   {"mechanism", mechanism_json(design)},
                   {"quality", quality_json(design)},
                   {"workspace", workspace_json(design.map)},
                   {"verification", verification_json(design.verification)},
                   {"search", search_json(design.search)},
                   {"limits", limits_json(design.limits)},
                   {"tolerance", tolerance_json(design.tolerance)},
                   {"obstacles", obstacles_json(design.obstacles)},
                   {"why_not_fewer_layers", design.why_not_fewer_layers},
                   {"tool", tool_json(design.tool)},
                   {"pole", if_known(design.allowed, pole_json)},
                   {"links", if_known(design.allowed, links_limits_json)},
                   {"objective", if_known(design.allowed, objective_json)},
                   {"cutting", cutting_json(design.cutting)}});
  add_material_and_load(design.material, design.load, json);
  add_bodies_and_table(design.bodies, design.table, json);
  return json;
}

std::string design_json(const Design& design) {
  constexpr int indent = 1;
  constexpr std::string_view key = "\"region\": ", nothing = "null";
  const std::string rest =
      design_values(design).dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
  const std::size_t place =
      rest.find(key) + key.size();  // before it are numbers and the title, its quotes escaped
  std::string text = rest.substr(0, place);
  append_multi_polygon(text, design.region, indent, 1);
  text.append(rest, place + nothing.size());
  return text;
}

}  // namespace kempe
