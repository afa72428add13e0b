#include "reports/data/task_json.hpp"

#include <cmath>

#include "geometry/stated_angle.hpp"
#include "kinematics/links.hpp"
#include "kinematics/overloaded.hpp"
#include "reports/data/geojson_geometry.hpp"
#include "specs/materials.hpp"

namespace kempe {

using Json = nlohmann::ordered_json;

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json finite_or_null(const std::optional<double>& value) {
  return value ? finite_or_null(*value) : Json(nullptr);
}

Json limits_json(const Limits& limits) {
  Json json{{"clearance_mm", limits.clearance},
            {"transmission_deg", stated_degrees(limits.transmission)},
            {"sheets_gap_mm", finite_or_null(limits.copy_gap)},
            {"copy_error_mm", finite_or_null(limits.copy_error)}};
  if (limits.longest_strip) json["longest_strip_mm"] = *limits.longest_strip;
  if (limits.load_error) json["load_error_mm"] = *limits.load_error;
  if (limits.load_error_in_all) json["load_error_in_all"] = true;
  if (limits.sag) json["sag_mm"] = *limits.sag;
  return json;
}

Json tolerance_json(const std::optional<Tolerance>& tolerance) {
  if (!tolerance) return nullptr;
  Json json{{"length_mm", tolerance->length}, {"play_mm", tolerance->play}};
  if (tolerance->robust) json["robust"] = true;
  return json;
}

Json obstacles_json(const std::vector<Obstacle>& obstacles) {
  Json json = Json::array();
  for (const Obstacle& obstacle : obstacles)
    json.push_back({{"name", obstacle.name},
                    {"shape", multi_polygon(Region{{obstacle.shape}})},
                    {"layers", Json::array({obstacle.lowest_layer, obstacle.highest_layer})}});
  return json;
}

namespace {

Json body_json(const Body& body) {
  Json json{{"name", body.name}, {"at", body.at == Carrier::tracer ? "tracer" : "pen"}};
  std::visit(Overloaded{[&](const Disc& disc) {
                          json["circle_mm"] = {{"centre", position(disc.centre)}, {"radius", disc.radius}};
                        },
                        [&](const Polygon& polygon) { json["shape"] = multi_polygon(Region{{polygon}}); }},
             body.shape);
  if (body.turns_with) json["turns_with"] = std::string(name(*body.turns_with));
  json["layers"] = Json::array({body.lowest_layer, body.highest_layer});
  return json;
}

}  // namespace

void add_bodies_and_table(const std::vector<Body>& bodies, const std::optional<Polygon>& table, Json& json) {
  for (const Body& body : bodies) json["bodies"].push_back(body_json(body));
  if (table) json["table"] = multi_polygon(Region{{*table}});
}

void add_material_and_load(const std::optional<Material>& material, const std::optional<Load>& load,
                           Json& json) {
  if (material)
    json["material"] = {{"name", material->name},
                        {"E_GPa", GPa_per_MPa * material->E},
                        {"density_kg_m3", material->density},
                        {"strength_MPa", material->strength}};
  if (material && material->G) json["material"]["G_GPa"] = GPa_per_MPa * *material->G;
  if (!load) return;
  json["load"] = {{"pen_N", load->pen_force}, {"rests", Json::array()}};
  if (load->pen_mass > 0) json["load"]["pen_mass_kg"] = load->pen_mass;
  if (load->tracer_mass > 0) json["load"]["tracer_mass_kg"] = load->tracer_mass;
  if (load->tilt > 0) json["load"]["tilt_deg"] = stated_degrees(load->tilt);
  if (load->grip) json["load"]["grip_mm"] = *load->grip;
  json["load"]["friction"] = load->friction;
  for (const Carrier point : load->rests)
    json["load"]["rests"].push_back(point == Carrier::tracer ? "tracer" : "pen");
}

Json pole_json(const Allowed& allowed) {
  if (allowed.pole.is_fixed()) return {{"at_mm", position(std::get<Point>(allowed.pole.place))}};
  return {{"within_mm", multi_polygon(std::get<Region>(allowed.pole.place))}};
}

Json links_limits_json(const Allowed& allowed) {
  Json json{{"layers", allowed.layers},
            {"shortest_mm", allowed.shortest},
            {"longest_mm", allowed.longest},
            {"wall_mm", finite_or_null(allowed.wall)},
            {"grid_mm", finite_or_null(allowed.stock_lengths.grid)},
            {"stock_mm", allowed.stock_lengths.stock}};
  if (allowed.seat) json["seat_mm"] = *allowed.seat;
  for (const LinkSection& section : allowed.sections)
    json["sections_mm"].push_back(Json::array({section.width, section.thickness}));
  for (std::size_t i = 0; i < allowed.stock_lengths.locked.size(); ++i)
    if (allowed.stock_lengths.locked[i])
      json[std::string(LinkLengths::names[i]) + "_mm"] = *allowed.stock_lengths.locked[i];
  return json;
}

Json objective_json(const Allowed& allowed) {
  Json groundings = Json::array();
  for (const Grounding grounding : allowed.groundings) groundings.push_back(name(grounding));
  return {{"groundings", std::move(groundings)}};
}

Json cutting_json(const CuttingSpec& cutting) {
  Json json{{"hole_fit_mm", cutting.hole_fit},
            {"kerf_mm", cutting.kerf},
            {"sheet_mm", cutting.stock_sheet ? position(*cutting.stock_sheet) : Json(nullptr)},
            {"gap_mm", cutting.gap}};
  if (cutting.process) json["process"] = name(*cutting.process);
  return json;
}

Json task_json(const Spec& spec) {
  const Allowed allowed = allowed_by(spec);
  Json json{{"copy", {{"scale", spec.copy.scale()}, {"rotation_deg", stated_degrees(spec.copy.rotation())}}},
            {"region", multi_polygon(spec.region)},
            {"pole", pole_json(allowed)},
            {"links", links_limits_json(allowed)},
            {"limits", limits_json(spec.limits)},
            {"obstacles", obstacles_json(spec.obstacles)},
            {"objective", objective_json(allowed)},
            {"tolerance", tolerance_json(spec.tolerance)},
            {"cutting", cutting_json(spec.cutting)},
            {"link_width_mm", spec.links.style.width},
            {"pin_diameter_mm", spec.links.style.pin_diameter},
            {"plate", spec.links.style.plate == PlateStyle::bent ? "bent" : "triangle"}};
  add_bodies_and_table(spec.bodies, spec.table, json);
  return json;
}

}  // namespace kempe
