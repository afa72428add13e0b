#include "reports/linkages/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/fixed_text.hpp"

namespace kempe {
namespace {

constexpr std::array<const char*, 8> colours{"#0b6e99", "#c05621", "#2f7d32", "#8e3b8f",
                                             "#b7312c", "#5a6b00", "#3f51b5", "#7a4b2a"};

/// Widths and dashes in thin lines.
struct Look {
  std::string_view kind;
  const char *fill, *stroke;
  double width, dash;
  std::array<std::array<const char*, 2>, 3> further;  ///< attributes; null: none
};
constexpr std::array<Look, 13> looks{{
    {"link",
     "currentColor",
     "currentColor",
     3.2,
     0,
     {{{"fill-opacity", ".16"}, {"stroke-linejoin", "round"}, {"stroke-linecap", "round"}}}},
    {"pin", "#fff", "currentColor", 1.4, 0, {}},
    {"block", "#fff", "#555", 1.2, 0, {{{"fill-opacity", ".75"}}}},
    {"guide", "none", "#999", 1, 5, {}},
    {"wheel", "currentColor", "currentColor", 1.2, 0, {{{"fill-opacity", ".08"}}}},
    {"spoke", "none", "currentColor", 1, 0, {}},
    {"ground", "#fff", "#555", 1.2, 0, {}},
    {"hatch", "none", "#555", 1, 0, {}},
    {"force", "none", "#a4262c", 2.2, 0, {{{"stroke-linecap", "round"}, {"stroke-linejoin", "round"}}}},
    {"wanted", "none", "#0b7a3b", 1.6, 0, {{{"stroke-linecap", "round"}, {"stroke-linejoin", "round"}}}},
    {"order",
     "#0b7a3b",
     "#fff",
     2.5,
     0,
     {{{"text-anchor", "middle"}, {"dominant-baseline", "central"}, {"paint-order", "stroke"}}}},
    {"trace", "none", nullptr, 0, 0, {{{"stroke-opacity", ".75"}, {"stroke-linejoin", "round"}}}},
    {"name",
     "#222",
     "#fff",
     2.5,
     0,
     {{{"font-style", "italic"}, {"font-family", "Georgia, serif"}, {"paint-order", "stroke"}}}},
}};

std::string path(std::string_view kind, const std::string& data, const PictureScale& scale) {
  return drawn("path", kind, scale).with("d", data).text();
}

std::string circle(std::string_view kind, const Point& centre, double radius, const PictureScale& scale) {
  return drawn("circle", kind, scale)
      .with("cx", scale.number(centre.x()))
      .with("cy", scale.number(centre.y()))
      .with("r", scale.number(radius))
      .text();
}

}  // namespace

PictureScale PictureScale::of(const Point& lower, const Point& upper) {
  const double extent = std::max((upper - lower).maxCoeff(), 1e-9);
  const Point margin = Point(0.09, 0.09) * extent;
  PictureScale scale{lower - margin, upper + margin, extent / 400, extent / 110, extent / 34, 0};
  scale.decimals = std::clamp(5 - static_cast<int>(std::floor(std::log10(extent))), 0, 15);
  return scale;
}

std::string PictureScale::number(double value) const {
  std::string text = fixed_text(value, decimals);
  return text.find_first_not_of("0.") == std::string::npos ? "0" : text;
}

std::string PictureScale::pair(const Point& p) const { return number(p.x()) + "," + number(p.y()); }

std::string PictureScale::line(const Point& from, const Point& to) const {
  return "M" + pair(from) + " L" + pair(to);
}

std::string PictureScale::view_box() const {
  return fmt::format("{} {} {} {}", number(lower.x()), number(lower.y()), number(upper.x() - lower.x()),
                     number(upper.y() - lower.y()));
}

std::string link_colour(int body) {
  return body == 0 ? "#666" : colours[static_cast<std::size_t>(body - 1) % colours.size()];
}

std::string body_shape(const SceneBody& body, int number, const PictureScale& scale) {
  if (body.is_block)
    return drawn("rect", "block", scale)
        .with("x", scale.number(-2.6 * scale.pin))
        .with("y", scale.number(-1.7 * scale.pin))
        .with("width", scale.number(5.2 * scale.pin))
        .with("height", scale.number(3.4 * scale.pin))
        .text();
  std::string shape;
  for (const auto& guide : body.guides) shape += path("guide", scale.line(guide.from, guide.to), scale);
  for (const auto& wheel : body.wheels)
    shape += circle("wheel", wheel.centre, wheel.radius, scale) +
             path("spoke", scale.line(wheel.centre, wheel.centre + Point(wheel.radius, 0)), scale);
  if (number == 0) return shape;
  if (body.hull.size() > 1) {
    std::string data;
    for (const Point& corner : body.hull) data += (data.empty() ? "M" : " L") + scale.pair(corner);
    shape += path("link", data + (body.hull.size() > 2 ? " Z" : ""), scale);
  }
  for (const Point& pin : body.pins) shape += circle("pin", pin, scale.pin, scale);
  return shape;
}

SvgElement ground_group(const LinkageScene& scene, const PictureScale& scale) {
  return SvgElement("g").with("color", link_colour(0)).holding(body_shape(scene.bodies[0], 0, scale));
}

std::string placement(const LinkageScene::Moment& moment, std::size_t body, const PictureScale& scale) {
  return fmt::format("translate({}) rotate({:.5f})", scale.pair(moment.at[body]),
                     degrees(moment.angle[body]));
}

std::string ground_sign(const ScenePoint& point, const PictureScale& scale) {
  const Point& at = point.local;
  const double s = 2.4 * scale.pin;
  if (!point.pivot)
    return path(
        "hatch",
        fmt::format("M{} l{} M{} l{}", scale.pair(at - Point(0.4, 0.4) * s), scale.pair(Point(0.8, 0.8) * s),
                    scale.pair(at + Point(-0.4, 0.4) * s), scale.pair(Point(0.8, -0.8) * s)),
        scale);
  std::string hatch;
  for (int i = -2; i <= 2; ++i)
    hatch += fmt::format("M{} l{} ", scale.pair(at + Point(i * 0.5 * s + 0.3 * s, 1.4 * s)),
                         scale.pair(Point(-0.45 * s, 0.45 * s)));
  const std::string triangle =
      fmt::format("M{} L{} L{} Z", scale.pair(at), scale.pair(at + Point(-0.8 * s, 1.4 * s)),
                  scale.pair(at + Point(0.8 * s, 1.4 * s)));
  const std::string table = fmt::format("M{} H{} {}", scale.pair(at + Point(-1.3 * s, 1.4 * s)),
                                        scale.number(at.x() + 1.3 * s), hatch);
  return path("ground", triangle, scale) + path("hatch", table, scale);
}

SvgElement drawn(std::string_view element, std::string_view kind, const PictureScale& scale) {
  const auto found =
      std::find_if(looks.begin(), looks.end(), [&](const Look& one) { return one.kind == kind; });
  SvgElement result(element);
  result.with("class", found->kind).with("fill", found->fill);
  if (found->stroke != nullptr)
    result.with("stroke", found->stroke).with("stroke-width", scale.number(found->width * scale.stroke));
  if (found->dash > 0)
    result.with("stroke-dasharray", scale.number(found->dash * scale.stroke) + " " +
                                        scale.number(0.8 * found->dash * scale.stroke));
  if (kind == "order")
    result.with("font-size", scale.number(0.75 * scale.letter)).with("font-family", "sans-serif");
  if (kind == "name") result.with("font-size", scale.number(scale.letter));
  for (const auto& [key, value] : found->further)
    if (key != nullptr) result.with(key, value);
  return result;
}

}  // namespace kempe
