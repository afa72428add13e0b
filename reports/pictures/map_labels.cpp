#include "reports/pictures/map_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "reports/pictures/html_text.hpp"
#include "reports/pictures/mechanism_picture.hpp"
#include "reports/pictures/picture_extent.hpp"
#include "reports/pictures/svg_element.hpp"
#include "workspace/obstacle_names.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// Width of a letter over its height.
constexpr double letter_width = 0.62;

/// A name that a person gave, no longer than a picture bears; cut between characters of UTF-8.
std::string shortened(const std::string& name) {
  std::size_t end = 0, characters = 0;
  const auto continues = [&](std::size_t at) {
    return (static_cast<unsigned char>(name[at]) & 0xC0) == 0x80;
  };
  for (; end < name.size() && characters < 24; ++characters) do
      ++end;
    while (end < name.size() && continues(end));
  return end == name.size() ? name : name.substr(0, end) + "…";
}

/// Away from the links that meet at a joint; the page's scripts put the moving letters there (stage.js,
/// freeSide).
Point free_side(const MapScene& scene, Joint joint) {
  Point away = Point::Zero(), along(1, 0);
  for (const Link link : all_links) {
    const std::vector<Joint> line = body_line(link);
    for (std::size_t i = 0; i < line.size(); ++i)
      for (std::size_t j = i == 0 ? 0 : i - 1; line[i] == joint && j < line.size() && j <= i + 1; ++j)
        if (j != i && (scene.pose[line[j]] - scene.pose[joint]).norm() > 0) {
          along = (scene.pose[line[j]] - scene.pose[joint]).normalized();
          away -= along;
        }
  }
  return away.norm() > 0.15 ? Point(away.normalized()) : Point(-along.y(), along.x());
}

std::string joint_labels(const MapScene& scene, LabelPlacer& placer) {
  const double u = scene.view.unit, radius = 1.6 * drawn_pin_radius(scene.design.style, u);
  std::string svg;
  // The named points first: they have the longer words.
  std::vector<Joint> order(all_joints.begin(), all_joints.end());
  std::stable_partition(order.begin(), order.end(),
                        [&](Joint j) { return !role(scene.design.linkage, j).empty(); });
  for (const Joint joint : order) {
    const std::string_view what = role(scene.design.linkage, joint);
    const double width = letter_size * letter_width *
                         (1.2 + (what.empty() ? 0.0 : 0.5 + 0.86 * static_cast<double>(what.size())));
    const Point at = placer.place_around(scene.pose[joint], radius, Point(width / 2, letter_size / 2) * u,
                                         free_side(scene, joint));
    const auto span = [](std::string_view css, std::string_view said) {
      return SvgElement("tspan").with("class", css).saying(said).text();
    };
    std::string words = span("letter", std::string(1, letter(joint)));
    if (!what.empty()) words += " " + span("role", what);
    svg += map_words(fmt::format("joint {}", what), at, words);
  }
  return map_group("names", svg);
}

/// More names than this would hide the picture, and each has to find a place clear of all others.
constexpr std::size_t most_named = 60;

/// The obstacles that are among the `most` nearest to the pole.
std::vector<bool> nearest_obstacles(const Design& design, std::size_t most) {
  std::vector<std::pair<double, std::size_t>> all;
  for (std::size_t i = 0; i < design.obstacles.size(); ++i)
    all.emplace_back((design.obstacles[i].shape.outer.front() - design.linkage.pole()).norm(), i);
  std::sort(all.begin(), all.end());
  std::vector<bool> is_near(all.size(), false);
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i) is_near[all[i].second] = true;
  return is_near;
}

}  // namespace

std::string map_labels(const MapScene& scene, LabelPlacer& placer) {
  const double u = scene.view.unit;
  for (const Link link : all_links) {
    const std::vector<Joint> line = body_line(link);
    for (std::size_t i = 1; i < line.size(); ++i)
      placer.avoid(scene.pose[line[i - 1]], scene.pose[line[i]], drawn_width(scene.design.style, u) / 2);
  }
  constexpr std::size_t corners_looked_at = 60;
  const std::vector<bool> is_near = nearest_obstacles(scene.design, most_named);
  for (std::size_t number = 0; number < scene.design.obstacles.size(); ++number) {
    const Ring& ring = scene.design.obstacles[number].shape.outer;
    if (!is_near[number]) continue;
    for (std::size_t i = 0; i < ring.size() && ring.size() <= corners_looked_at; ++i)
      placer.avoid(ring[i], ring[(i + 1) % ring.size()], 0);
  }
  std::string svg;
  for (const Joint joint : all_joints)
    placer.avoid({scene.pose[joint], Point::Constant(1.6 * drawn_pin_radius(scene.design.style, u))});
  svg += joint_labels(scene, placer);
  const auto beside = [&](const Region& region, std::string_view id, const std::string& words) {
    PictureExtent extent;
    extent.add(region);
    if (extent.empty()) return;
    const Point half(0.5 * 0.55 * 13 * static_cast<double>(words.size()) * u, 8 * u);
    svg += map_group(id, map_words(fmt::format("name {}", id), placer.place_beside(extent.box(), half),
                                   html_escaped(words)));
  };
  beside(scene.design.region, "region", "region");
  beside(scene.copy, "copy", "copy");
  for (std::size_t i = 0; i < scene.design.obstacles.size(); ++i) {
    if (!is_near[i]) continue;
    const std::string words = obstacle_name(scene.design.obstacles, i);
    // One table of the spec may hold several rings.
    if (i == 0 || obstacle_name(scene.design.obstacles, i - 1) != words)
      beside(Region{{scene.design.obstacles[i].shape}}, "obstacles", shortened(words));
  }
  for (std::size_t i = 0; i < scene.design.bodies.size() && i < most_named; ++i) {
    const std::variant<Disc, Polygon> shape =
        placed(scene.design.bodies[i], scene.design.linkage, scene.pose);
    Region room;
    if (const auto* disc = std::get_if<Disc>(&shape))
      room = Region::circle(disc->centre, disc->radius);
    else
      room = Region{{std::get<Polygon>(shape)}};
    beside(room, "bodies", shortened(body_name(scene.design.bodies, i)));
  }
  return SvgElement("g").with("class", "words").holding("\n" + svg).line();
}

}  // namespace kempe
