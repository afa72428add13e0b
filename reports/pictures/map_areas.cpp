#include "reports/pictures/map_areas.hpp"

#include <algorithm>
#include <array>

#include "geometry/regions/region_algebra.hpp"
#include "reports/pictures/svg_element.hpp"
#include "reports/pictures/svg_path.hpp"

namespace kempe {
namespace {

struct CauseWords {
  Cause cause;
  std::string_view id, label;
};
constexpr std::array<CauseWords, 6> cause_words{{
    {Cause::out_of_reach, "outside", "Out of reach"},
    {Cause::beyond_change_point, "change", "Beyond the change point"},
    {Cause::transmission_below_limit, "transmission", "Transmission too low"},
    {Cause::self_contact, "contact", "Links touch"},
    {Cause::obstacle_contact, "obstructed", "Obstacle in the way"},
    {Cause::copy_overlap, "overlap", "Copy overlaps original"},
}};

/// One sentence for a person who points at the area.
std::string why_lost(const LostArea& lost) {
  std::string parts;
  for (const std::string& part : lost.parts) parts += (parts.empty() ? "" : " and ") + part;
  switch (lost.cause) {
    case Cause::out_of_reach: return "Out of reach.";
    case Cause::beyond_change_point:
      return "Beyond the change point: the parallelogram would have to fold over.";
    case Cause::transmission_below_limit: return "The transmission angle is below the limit.";
    case Cause::copy_overlap: return "Original and copy would overlap.";
    case Cause::self_contact:
    case Cause::obstacle_contact: break;
  }
  return parts.empty() ? "Parts come too close to each other." : "Too close: " + parts + ".";
}

std::string lost_areas(const MapScene& scene, std::vector<MapLayer>& layers) {
  std::string svg;
  for (const CauseWords& words : cause_words) {
    std::string paths;
    double lost = 0;
    for (const LostArea& part : scene.design.map.lost) {
      if (part.cause != words.cause || part.area.empty()) continue;
      lost += area(part.area);
      paths += SvgElement("path")
                   .with("class", "lost")
                   .with("data-why", why_lost(part))
                   .with("d", svg_path(part.area, scene.detail))
                   .line();
    }
    if (paths.empty()) continue;
    svg += map_group(words.id, paths);
    const bool not_obstacles_alone = !scene.design.bodies.empty() || scene.design.table;
    const bool of_any = words.cause == Cause::obstacle_contact && not_obstacles_alone;
    layers.push_back({std::string(words.id), of_any ? "Something in the way" : std::string(words.label),
                      scene.areas.text(lost), "lost"});
  }
  return svg;
}

}  // namespace

std::string map_areas(const MapScene& scene, std::vector<MapLayer>& layers) {
  const WorkspaceMap& map = scene.design.map;
  std::string svg;
  const auto add = [&](const char* id, const char* label, const ArcRegion& shape, bool shown = true) {
    if (shape.empty()) return;
    svg += map_group(id, map_path("area", svg_path(shape, scene.detail)));
    layers.push_back({id, label, scene.areas.text(area(shape)), "map", shown});
  };
  add("reachable", "Reachable", map.reachable);
  add("usable", "Usable", map.usable);
  svg += lost_areas(scene, layers);
  add("free", "Collision-free", map.collision_free);
  add("uncertain", "Uncertain", map.uncertain);
  if (!map.collision_free.empty()) {
    const ArcRegion image =
        similar_image(map.collision_free, scene.design.linkage.k(), scene.design.linkage.pole());
    svg += map_group("image", map_path("area", svg_path(image, scene.detail)));
    layers.push_back({"image", "Places of the pen", scene.areas.text(area(image)), "map", false});
  }
  std::stable_sort(layers.begin(), layers.end(),
                   [](const MapLayer& a, const MapLayer& b) { return a.group == "map" && b.group != "map"; });
  return svg;
}

}  // namespace kempe
