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
  if (body.is_block)
    return fmt::format("<rect class=\"block\" x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\"/>",
                       scale.number(-2.6 * scale.pin), scale.number(-1.7 * scale.pin),
                       scale.number(5.2 * scale.pin), scale.number(3.4 * scale.pin));
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

std::string ground_sign(const ScenePoint& point, const PictureScale& scale) {
  const Point& at = point.local;
  const double s = 2.4 * scale.pin;
  if (!point.pivot)
    return fmt::format("<path class=\"hatch\" d=\"M{} l{} M{} l{}\"/>", scale.pair(at - Point(0.4, 0.4) * s),
                       scale.pair(Point(0.8, 0.8) * s), scale.pair(at + Point(-0.4, 0.4) * s),
                       scale.pair(Point(0.8, -0.8) * s));
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
  std::string style = R"(
.link{fill:currentColor;fill-opacity:.16;stroke:currentColor;stroke-width:W3.2;stroke-linejoin:round;stroke-linecap:round}
.pin{fill:#fff;stroke:currentColor;stroke-width:W1.4}
.block{fill:#fff;fill-opacity:.75;stroke:#555;stroke-width:W1.2}
.guide{stroke:#999;stroke-width:W1.0;stroke-dasharray:W5.0 W4.0}
.wheel{fill:currentColor;fill-opacity:.08;stroke:currentColor;stroke-width:W1.2}
.spoke{stroke:currentColor;stroke-width:W1.0}
.ground{fill:#fff;stroke:#555;stroke-width:W1.2}
.hatch{fill:none;stroke:#555;stroke-width:W1.0}
.trace{fill:none;stroke-width:W1.4;stroke-opacity:.75;stroke-linejoin:round}
.name{font:italic )" + scale.number(scale.letter) +
                      R"(px Georgia,serif;fill:#222;paint-order:stroke;stroke:#fff;stroke-width:W2.5}
)";
  for (std::size_t at = style.find('W'); at != std::string::npos; at = style.find('W', at))
    style.replace(at, 4, scale.number(scale.stroke * (style[at + 1] - '0' + 0.1 * (style[at + 3] - '0'))));
  return style;
}

}  // namespace kempe
