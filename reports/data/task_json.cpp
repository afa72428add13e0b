#include "reports/data/task_json.hpp"

#include <cmath>

#include "geometry/stated_angle.hpp"
#include "reports/data/geojson_geometry.hpp"

namespace kempe {

using Json = nlohmann::ordered_json;

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json finite_or_null(const std::optional<double>& value) {
  return value ? finite_or_null(*value) : Json(nullptr);
}

Json limits_json(const Limits& limits) {
  return {{"clearance_mm", limits.clearance},
          {"transmission_deg", stated_degrees(limits.transmission)},
          {"sheets_gap_mm", finite_or_null(limits.sheets_gap)},
          {"copy_error_mm", finite_or_null(limits.copy_error)}};
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

Json pole_json(const Allowed& allowed) {
  if (allowed.pole.is_fixed()) return {{"at_mm", position(std::get<Point>(allowed.pole.place))}};
  return {{"within_mm", multi_polygon(std::get<Region>(allowed.pole.place))}};
}

Json links_limits_json(const Allowed& allowed) {
  Json json{{"layers", allowed.layers},
            {"shortest_mm", allowed.shortest},
            {"longest_mm", allowed.longest},
            {"wall_mm", finite_or_null(allowed.wall)},
            {"grid_mm", finite_or_null(allowed.workshop.grid)},
            {"stock_mm", allowed.workshop.stock}};
  for (std::size_t i = 0; i < allowed.workshop.locked.size(); ++i)
    if (allowed.workshop.locked[i])
      json[std::string(LinkLengths::names[i]) + "_mm"] = *allowed.workshop.locked[i];
  return json;
}

Json objective_json(const Allowed& allowed) {
  Json groundings = Json::array();
  for (const Grounding grounding : allowed.groundings) groundings.push_back(name(grounding));
  return {{"groundings", std::move(groundings)}};
}

Json cutting_json(const CuttingSpec& cutting) {
  return {{"hole_fit_mm", cutting.hole_fit},
          {"kerf_mm", cutting.kerf},
          {"sheet_mm", cutting.sheet ? position(*cutting.sheet) : Json(nullptr)},
          {"gap_mm", cutting.gap}};
}

Json task_json(const Spec& spec) {
  const Allowed allowed = allowed_by(spec);
  return {{"copy", {{"scale", spec.copy.scale()}, {"rotation_deg", stated_degrees(spec.copy.rotation())}}},
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
}

}  // namespace kempe
