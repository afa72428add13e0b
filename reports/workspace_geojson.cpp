#include "reports/workspace_geojson.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/geojson_geometry.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

class Features {
 public:
  explicit Features(double tolerance) : tolerance_(tolerance) {}

  /// Adds a feature; returns its properties for more.
  Json& add(std::string_view layer, Json geometry) {
    list_.push_back({{"type", "Feature"},
                     {"properties", {{"layer", layer}, {"tolerance_mm", tolerance_}}},
                     {"geometry", std::move(geometry)}});
    return list_.back()["properties"];
  }
  Json& add(std::string_view layer, const Region& region) {
    Json& properties = add(layer, multi_polygon(region));
    properties["area_mm2"] = area(region);
    return properties;
  }
  Json& add(std::string_view layer, const ArcRegion& region, Flatten side) {
    return add(layer, flattened(region, tolerance_, side));
  }
  Json take() { return std::move(list_); }

 private:
  double tolerance_;
  Json list_ = Json::array();
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

/// The transmission angle depends on the opening alone, so its contours are circles about the pole.
void add_contours(Features& features, const CopyingLinkage& linkage, double tolerance) {
  for (int level = 10; level <= 80; level += 10) {
    const OpeningInterval openings = linkage.openings_with_transmission(radians(level));
    if (openings.empty()) return;
    for (const double opening : {openings.lower, openings.upper}) {
      const double radius = linkage.radius_at(opening);
      Json& properties = features.add("transmission", circle_line(linkage.pole(), radius, tolerance));
      properties["transmission_deg"] = level;
      properties["radius_mm"] = radius;
    }
  }
}

void add_obstacles(Features& features, const std::vector<Obstacle>& obstacles) {
  if (obstacles.empty()) features.add("obstacles", Region{});
  for (const Obstacle& obstacle : obstacles)
    features.add("obstacles", Region{{obstacle.shape}})["layers"] =
        Json::array({obstacle.lowest_layer, obstacle.highest_layer});
}

void add_lost(Features& features, const std::vector<LostArea>& lost) {
  for (const LostArea& one : lost) {
    Json& properties = features.add("lost", one.area, Flatten::grows);
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
  features.add("copy_workspace", similar_image(map.collision_free, linkage.k(), linkage.pole()),
               Flatten::shrinks);
  add_obstacles(features, design.obstacles);
  features.add("footprint", design.footprint);
  add_lost(features, map.lost);
  add_contours(features, linkage, tolerance);
  const Json collection{{"type", "FeatureCollection"},
                        {"units", "mm"},
                        {"tolerance_mm", tolerance},
                        {"features", features.take()}};
  return collection.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace kempe
