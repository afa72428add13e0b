#include "reports/linkages/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

constexpr std::array<const char*, 8> colours{"#0b6e99", "#c05621", "#2f7d32", "#8e3b8f",
                                             "#b7312c", "#5a6b00", "#3f51b5", "#7a4b2a"};

/// Widths and dashes in thin lines.
struct Look {
  std::string_view kind;
  const char *fill, *stroke;
  double width, dash;
  const char* further;
};
constexpr std::array<Look, 10> looks{{
    {"link", "currentColor", "currentColor", 3.2, 0,
     " fill-opacity=\".16\" stroke-linejoin=\"round\" stroke-linecap=\"round\""},
    {"pin", "#fff", "currentColor", 1.4, 0, ""},
    {"block", "#fff", "#555", 1.2, 0, " fill-opacity=\".75\""},
    {"guide", "none", "#999", 1, 5, ""},
    {"wheel", "currentColor", "currentColor", 1.2, 0, " fill-opacity=\".08\""},
    {"spoke", "none", "currentColor", 1, 0, ""},
    {"ground", "#fff", "#555", 1.2, 0, ""},
    {"hatch", "none", "#555", 1, 0, ""},
    {"trace", "none", nullptr, 0, 0, " stroke-opacity=\".75\" stroke-linejoin=\"round\""},
    {"name", "#222", "#fff", 2.5, 0,
     " font-style=\"italic\" font-family=\"Georgia, serif\" paint-order=\"stroke\""},
}};

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
    return fmt::format("<rect {0} x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/>", look("block", scale),
                       scale.number(-2.6 * scale.pin), scale.number(-1.7 * scale.pin),
                       scale.number(5.2 * scale.pin), scale.number(3.4 * scale.pin));
  std::string shape;
  for (const auto& guide : body.guides)
    shape += fmt::format("<path {} d=\"M{} L{}\"/>", look("guide", scale), scale.pair(guide.from),
                         scale.pair(guide.to));
  for (const auto& wheel : body.wheels)
    shape += fmt::format("<circle {} cx=\"{}\" cy=\"{}\" r=\"{}\"/><path {} d=\"M{} L{}\"/>",
                         look("wheel", scale), scale.number(wheel.centre.x()), scale.number(wheel.centre.y()),
                         scale.number(wheel.radius), look("spoke", scale), scale.pair(wheel.centre),
                         scale.pair(wheel.centre + Point(wheel.radius, 0)));
  if (number > 0 && body.hull.size() > 1) {
    shape += "<path " + look("link", scale) + " d=\"M";
    for (std::size_t i = 0; i < body.hull.size(); ++i) shape += (i ? " L" : "") + scale.pair(body.hull[i]);
    shape += body.hull.size() > 2 ? " Z\"/>" : "\"/>";
  }
  if (number > 0)
    for (const Point& pin : body.pins)
      shape += fmt::format("<circle {} cx=\"{}\" cy=\"{}\" r=\"{}\"/>", look("pin", scale),
                           scale.number(pin.x()), scale.number(pin.y()), scale.number(scale.pin));
  return shape;
}

std::string ground_sign(const ScenePoint& point, const PictureScale& scale) {
  const Point& at = point.local;
  const double s = 2.4 * scale.pin;
  if (!point.pivot)
    return fmt::format("<path {} d=\"M{} l{} M{} l{}\"/>", look("hatch", scale),
                       scale.pair(at - Point(0.4, 0.4) * s), scale.pair(Point(0.8, 0.8) * s),
                       scale.pair(at + Point(-0.4, 0.4) * s), scale.pair(Point(0.8, -0.8) * s));
  std::string hatch;
  for (int i = -2; i <= 2; ++i)
    hatch += fmt::format("M{} l{} ", scale.pair(at + Point(i * 0.5 * s + 0.3 * s, 1.4 * s)),
                         scale.pair(Point(-0.45 * s, 0.45 * s)));
  return fmt::format("<path {} d=\"M{} L{} L{} Z\"/><path {} d=\"M{} H{} {}\"/>", look("ground", scale),
                     scale.pair(at), scale.pair(at + Point(-0.8 * s, 1.4 * s)),
                     scale.pair(at + Point(0.8 * s, 1.4 * s)), look("hatch", scale),
                     scale.pair(at + Point(-1.3 * s, 1.4 * s)), scale.number(at.x() + 1.3 * s), hatch);
}

std::string trace_curve(const LinkageScene& scene, std::size_t traced, const PictureScale& scale) {
  const ScenePoint& point = scene.points[traced];
  std::string data;
  for (const auto& moment : scene.moments)
    data += (data.empty() ? "M" : " L") + scale.pair(scene.place(point, moment));
  return fmt::format("<path {} stroke=\"{}\" stroke-width=\"{}\" d=\"{}\"><title>{}</title></path>",
                     look("trace", scale), link_colour(point.body), scale.number(1.4 * scale.stroke), data,
                     html_escaped(point.name));
}

std::string look(std::string_view kind, const PictureScale& scale) {
  const auto found =
      std::find_if(looks.begin(), looks.end(), [&](const Look& one) { return one.kind == kind; });
  std::string text = fmt::format("class=\"{}\" fill=\"{}\"", found->kind, found->fill);
  if (found->stroke != nullptr)
    text += fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", found->stroke,
                        scale.number(found->width * scale.stroke));
  if (found->dash > 0)
    text += fmt::format(" stroke-dasharray=\"{} {}\"", scale.number(found->dash * scale.stroke),
                        scale.number(0.8 * found->dash * scale.stroke));
  if (kind == "name") text += fmt::format(" font-size=\"{}\"", scale.number(scale.letter));
  return text + found->further;
}

}  // namespace kempe
