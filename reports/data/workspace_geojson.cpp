#include "reports/data/workspace_geojson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/data/geojson_geometry.hpp"
#include "reports/pictures/map_contours.hpp"
#include "reports/pictures/mechanism_picture.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

/// Features become text as they come: regions may have a million corners, whose JSON values are large.
class Features {
 public:
  explicit Features(double tolerance)
      : tolerance_(tolerance),
        text_(fmt::format(R"({{"type":"FeatureCollection","units":"mm","tolerance_mm":{},"features":[)",
                          Json(tolerance).dump())) {}

  /// Adds a feature; returns its properties for more, until the next is added.
  Json& add(std::string_view layer, const Json& geometry) {
    begin(layer);
    geometry_ = geometry.dump();
    return properties_;
  }
  Json& add(std::string_view layer, const Region& region) {
    begin(layer);
    append_multi_polygon(geometry_, region, -1, 0);
    properties_["area_mm2"] = area(region);
    return properties_;
  }
  Json& add(std::string_view layer, const ArcRegion& region, Flatten side) {
    return add(layer, flattened(region, tolerance_, side));
  }
  /// The whole collection's text; nothing is left here.
  std::string take() {
    write_last();
    text_ += "]}\n";
    return std::move(text_);
  }

 private:
  void begin(std::string_view layer) {
    write_last();
    properties_ = {{"layer", layer}, {"tolerance_mm", tolerance_}};
  }
  void write_last() {
    if (properties_.is_null()) return;
    if (text_.back() == '}') text_ += ',';
    text_ += R"({"type":"Feature","properties":)";
    text_ += properties_.dump(-1, ' ', false, Json::error_handler_t::replace);
    text_ += R"(,"geometry":)";
    text_ += geometry_;
    text_ += '}';
    properties_ = nullptr;
    geometry_.clear();
    geometry_.shrink_to_fit();
  }

  double tolerance_;
  Json properties_;
  std::string geometry_, text_;
};

/// A circle about the pole as a line whose points lie on it, within the tolerance of it between them.
Json circle_line(const Point& centre, double radius, double tolerance) {
  const double half_step = std::acos(std::max(0.0, 1 - tolerance / std::max(radius, tolerance)));
  const int steps = std::max(8, static_cast<int>(std::ceil(pi / half_step)));
  Json line = Json::array();
  for (int i = 0; i <= steps; ++i)
    line.push_back(position(centre + as_point(std::polar(radius, 2 * pi * (i % steps) / steps))));
  return {{"type", "LineString"}, {"coordinates", std::move(line)}};
}

void add_contours(Features& features, const Design& design, double tolerance) {
  const auto add = [&](const char* layer, const char* key, double level, double radius) {
    Json& properties = features.add(layer, circle_line(design.linkage.pole(), radius, tolerance));
    properties[key] = level;
    properties["radius_mm"] = radius;
  };
  for (const auto& [level, radius] : transmission_circles(design.linkage))
    add("transmission", "transmission_deg", std::round(degrees(level)), radius);
  for (const auto& [level, radius] : copy_error_circles(design))
    add("copy_error", "copy_error_mm", level, radius);
  for (const auto& [level, radius] : load_error_circles(design))
    add("load_error", "load_error_mm", level, radius);
}

void add_sheets(Features& features, const std::vector<FittingSheet>& sheets) {
  for (const FittingSheet& sheet : sheets) {
    Json& properties = features.add("sheets", Region{{Polygon{corners(sheet), {}}}});
    properties["name"] = sheet.name;
    properties["width_mm"] = sheet.width;
    properties["height_mm"] = sheet.height;
    properties["turn_deg"] = degrees(sheet.turn);
  }
}

/// Where two parts come nearest while the tracer covers the region.
void add_tightest(Features& features, const WorkspaceMap& map) {
  if (!std::isfinite(map.clearance_min) || map.clearance_min_parts.empty()) return;
  Json& properties =
      features.add("tightest", {{"type", "Point"}, {"coordinates", position(map.clearance_min_at)}});
  properties["clearance_mm"] = map.clearance_min;
  properties["parts"] = map.clearance_min_parts;
}

void add_obstacles(Features& features, const std::vector<Obstacle>& obstacles) {
  if (obstacles.empty()) features.add("obstacles", Region{});
  for (const Obstacle& obstacle : obstacles) {
    Json& properties = features.add("obstacles", Region{{obstacle.shape}});
    properties["name"] = obstacle.name;
    properties["layers"] = Json::array({obstacle.lowest_layer, obstacle.highest_layer});
  }
}

void add_lost(Features& features, const std::vector<LostArea>& lost) {
  for (const LostArea& one : lost) {
    Json& properties = features.add("lost", one.area, Flatten::grows);
    properties["cause"] = name(one.cause);
    properties["parts"] = one.parts;
  }
}

/// The same map seen from the pen: every place of the tracer's map as the place where the pen then stands.
void add_pen_side(Features& features, const Design& design) {
  const WorkspaceMap& map = design.map;
  const auto image = [&](const ArcRegion& area) {
    return similar_image(area, design.linkage.k(), design.linkage.pole());
  };
  features.add("copy_workspace", image(map.collision_free), Flatten::shrinks);
  features.add("copy_reachable", image(map.reachable), Flatten::shrinks);
  features.add("copy_usable", image(map.usable), Flatten::shrinks);
  features.add("copy_uncertain", image(map.uncertain), Flatten::grows);
  for (const LostArea& one : map.lost) {
    Json& properties = features.add("copy_lost", image(one.area), Flatten::grows);
    properties["cause"] = name(one.cause);
    properties["parts"] = one.parts;
  }
}

}  // namespace

std::string workspace_geojson(const Design& design, double tolerance) {
  const CopyingLinkage& linkage = design.linkage;
  const WorkspaceMap& map = design.map;
  Features features(tolerance);
  features.add("reachable", map.reachable, Flatten::shrinks);
  features.add("usable", map.usable, Flatten::shrinks);
  features.add("collision_free", map.collision_free, Flatten::shrinks);
  features.add("uncertain", map.uncertain, Flatten::grows);
  features.add("region", design.region);
  features.add("copy", similar_image(design.region, linkage.k(), linkage.pole()));
  add_pen_side(features, design);
  add_obstacles(features, design.obstacles);
  if (design.table) features.add("table", Region{{*design.table}});
  features.add("footprint", design.footprint);
  add_lost(features, map.lost);
  add_sheets(features, map.largest_sheets);
  add_tightest(features, map);
  add_contours(features, design, tolerance);
  return features.take();
}

}  // namespace kempe
