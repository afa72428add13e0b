#include "reports/linkage_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/html_text.hpp"

namespace kempe {
namespace {

constexpr std::array<const char*, 8> colours{"#0b6e99", "#c05621", "#2f7d32", "#8e3b8f",
                                             "#b7312c", "#5a6b00", "#3f51b5", "#7a4b2a"};

}  // namespace

PictureScale PictureScale::of(const Point& lower, const Point& upper) {
  const double extent = std::max((upper - lower).maxCoeff(), 1e-9);
  const Point margin = Point(0.09, 0.09) * extent;
  PictureScale scale{lower - margin, upper + margin, extent / 400, extent / 110, extent / 34, 0};
  scale.decimals = std::clamp(5 - static_cast<int>(std::floor(std::log10(extent))), 0, 15);
  return scale;
}

std::string PictureScale::number(double value) const {
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_not_of("-0.") == std::string::npos ? "0" : text;
}

std::string PictureScale::pair(const Point& p) const { return number(p.x()) + "," + number(p.y()); }

std::string PictureScale::view_box() const {
  return fmt::format("{} {} {} {}", number(lower.x()), number(lower.y()), number(upper.x() - lower.x()),
                     number(upper.y() - lower.y()));
}

std::string link_colour(int body) {
  return body == 0 ? "#666" : colours[static_cast<std::size_t>(body - 1) % colours.size()];
}

std::string body_shape(const SceneBody& body, int number, const PictureScale& scale) {
  std::string shape;
  for (const auto& guide : body.guides)
    shape +=
        fmt::format("<path class=\"guide\" d=\"M{} L{}\"/>", scale.pair(guide.from), scale.pair(guide.to));
  for (const auto& wheel : body.wheels)
    shape += fmt::format(
        "<circle class=\"wheel\" cx=\"{}\" cy=\"{}\" r=\"{}\"/><path class=\"spoke\" d=\"M{} L{}\"/>",
        scale.number(wheel.centre.x()), scale.number(wheel.centre.y()), scale.number(wheel.radius),
        scale.pair(wheel.centre), scale.pair(wheel.centre + Point(wheel.radius, 0)));
  if (number > 0 && body.hull.size() > 1) {
    shape += "<path class=\"link\" d=\"M";
    for (std::size_t i = 0; i < body.hull.size(); ++i) shape += (i ? " L" : "") + scale.pair(body.hull[i]);
    shape += body.hull.size() > 2 ? " Z\"/>" : "\"/>";
  }
  if (number > 0)
    for (const Point& pin : body.pins)
      shape += fmt::format("<circle class=\"pin\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>", scale.number(pin.x()),
                           scale.number(pin.y()), scale.number(scale.pin));
  return shape;
}

std::string ground_sign(const Point& at, const PictureScale& scale) {
  const double s = 2.4 * scale.pin;
  std::string hatch;
  for (int i = -2; i <= 2; ++i)
    hatch += fmt::format("M{} l{} ", scale.pair(at + Point(i * 0.5 * s + 0.3 * s, 1.4 * s)),
                         scale.pair(Point(-0.45 * s, 0.45 * s)));
  return fmt::format("<path class=\"ground\" d=\"M{} L{} L{} Z\"/><path class=\"hatch\" d=\"M{} H{} {}\"/>",
                     scale.pair(at), scale.pair(at + Point(-0.8 * s, 1.4 * s)),
                     scale.pair(at + Point(0.8 * s, 1.4 * s)), scale.pair(at + Point(-1.3 * s, 1.4 * s)),
                     scale.number(at.x() + 1.3 * s), hatch);
}

std::string trace_curve(const LinkageScene& scene, std::size_t traced, const PictureScale& scale) {
  const ScenePoint& point = scene.points[traced];
  std::string data;
  for (const auto& moment : scene.moments)
    data += (data.empty() ? "M" : " L") + scale.pair(scene.place(point, moment));
  return fmt::format("<path class=\"trace\" stroke=\"{}\" d=\"{}\"><title>{}</title></path>",
                     link_colour(point.body), data, html_escaped(point.name));
}

std::string picture_style(const PictureScale& scale) {
  const auto wide = [&](double times) { return scale.number(times * scale.stroke); };
  return fmt::format(
      ".link{{fill:currentColor;fill-opacity:.16;stroke:currentColor;stroke-width:{};stroke-linejoin:round;"
      "stroke-linecap:"
      "round}}.pin{{fill:#fff;stroke:currentColor;stroke-width:{}}}.guide{{stroke:#999;stroke-width:{};"
      "stroke-dasharray:{} "
      "{}}}.wheel{{fill:currentColor;fill-opacity:.08;stroke:currentColor;stroke-width:{}}}.spoke{{stroke:"
      "currentColor;"
      "stroke-width:{}}}.ground{{fill:#fff;stroke:#555;stroke-width:{}}}.hatch{{fill:none;stroke:#555;stroke-"
      "width:{}}}"
      ".trace{{fill:none;stroke-width:{};stroke-opacity:.75;stroke-linejoin:round}}.name{{font:italic {}px "
      "Georgia,serif;"
      "fill:#222;paint-order:stroke;stroke:#fff;stroke-width:{}}}",
      wide(3.2), wide(1.4), wide(1), wide(5), wide(4), wide(1.2), wide(1), wide(1.2), wide(1), wide(1.4),
      scale.number(scale.letter), wide(2.5));
}

}  // namespace kempe
