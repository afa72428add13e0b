#include "reports/linkages/scene_wanted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/fixed_text.hpp"
#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

/// Where the number of a ring stands: beside the way through the places, on the outer side of a loop.
std::vector<Point> ways_out(const std::vector<SceneWanted>& wanted) {
  const std::size_t count = wanted.size();
  double area = 0;
  for (std::size_t i = 0; i < count; ++i) area += cross(wanted[i].at, wanted[(i + 1) % count].at);
  std::vector<Point> ways;
  for (std::size_t i = 0; i < count; ++i) {
    const Point along = wanted[std::min(i + 1, count - 1)].at - wanted[i > 0 ? i - 1 : 0].at;
    const Point aside = area < 0 ? Point(-along.y(), along.x()) : Point(along.y(), -along.x());
    ways.push_back(aside.norm() > 0 ? Point(aside.normalized()) : Point(0, -1));
  }
  return ways;
}

/// A pose's axes, the longer one along the body's x.
std::string frame_axes(const Point& at, double angle, const PictureScale& scale) {
  const Point x(std::cos(angle), std::sin(angle)), y(x.y(), -x.x());  // on a page y runs downward
  const Point x_end = at + 6 * scale.pin * x, y_end = at + 3 * scale.pin * y;
  return drawn("path", "wanted", scale).with("d", scale.line(x_end, at) + scale.line(at, y_end)).text();
}

bool are_poses(const LinkageScene& scene) { return scene.wanted.front().angle.has_value(); }

/// Rounded as it is told: 0 where rounding alone is left of a distance.
std::string deviation_text(double value) { return value < 1e-9 ? "< 1e-9" : fmt::format("{:.3g}", value); }

std::string pair_cell(const Point& at, const PictureScale& scale) {
  return fmt::format("<td>({}, {})</td>", fixed_text(at.x(), scale.decimals),
                     fixed_text(-at.y(), scale.decimals));
}

double deviation(const SceneWanted& wanted) { return (wanted.reached - wanted.at).norm(); }

double turned_by(const SceneWanted& wanted) {
  return std::abs(degrees(std::remainder(*wanted.reached_angle - *wanted.angle, 2 * pi)));
}

}  // namespace

void add_wanted_places(const LinkageFile& file, const std::vector<WantedPlace>& places,
                       const std::string& point, LinkageScene& scene) {
  const auto on_page = [&](const Point& p) -> Point { return Point(p.x(), -p.y()) / file.unit.in_mm; };
  const auto turned = [](const std::optional<double>& angle) {
    return angle ? std::optional<double>(-*angle) : std::nullopt;
  };
  scene.wanted_of = point;
  const double last = static_cast<double>(scene.moments.size() - 1);
  for (const WantedPlace& place : places) {
    scene.wanted.push_back({on_page(place.at), on_page(place.reached), turned(place.angle),
                            turned(place.reached_angle), std::clamp(place.share, 0.0, 1.0) * last});
    scene.lower = scene.lower.cwiseMin(scene.wanted.back().at);
    scene.upper = scene.upper.cwiseMax(scene.wanted.back().at);
  }
}

std::string wanted_marks(const LinkageScene& scene, const PictureScale& scale) {
  if (scene.wanted.empty()) return "";
  std::string text;
  const std::vector<Point> ways = ways_out(scene.wanted);
  for (std::size_t i = 0; i < scene.wanted.size(); ++i) {
    const SceneWanted& wanted = scene.wanted[i];
    text += drawn("circle", "wanted", scale)
                .with("cx", scale.number(wanted.at.x()))
                .with("cy", scale.number(wanted.at.y()))
                .with("r", scale.number(1.15 * scale.pin))
                .text();
    if (wanted.angle) text += frame_axes(wanted.at, *wanted.angle, scale);
    const Point number = wanted.at + 2.6 * scale.pin * ways[i];
    text += drawn("text", "order", scale)
                .with("x", scale.number(number.x()))
                .with("y", scale.number(number.y()))
                .saying(std::to_string(i + 1))
                .line();
  }
  return SvgElement("g").with("id", "wanted").holding(text).line();
}

std::string wanted_sentence(const LinkageScene& scene) {
  if (scene.wanted.empty()) return "";
  double most = 0, turned = 0;
  for (const SceneWanted& wanted : scene.wanted) {
    most = std::max(most, deviation(wanted));
    if (wanted.angle) turned = std::max(turned, turned_by(wanted));
  }
  return fmt::format(" Numbered rings are the {} wanted {} of {}: off by {} {}{} at most.",
                     scene.wanted.size(), are_poses(scene) ? "poses" : "places",
                     html_escaped(scene.wanted_of), html_escaped(deviation_text(most)), scene.unit,
                     are_poses(scene) ? " and " + html_escaped(deviation_text(turned)) + "°" : "");
}

std::string wanted_table(const LinkageScene& scene) {
  if (scene.wanted.empty()) return "";
  const bool poses = are_poses(scene);
  const PictureScale scale = PictureScale::of(scene.lower, scene.upper);
  std::string text = fmt::format(
      "<section id=\"wantedbox\"><h3>Wanted {0} of {1}</h3><table><thead><tr><th>at</th><th>wanted, {2}</th>"
      "<th>reached, {2}</th><th>off, {2}</th>{3}</tr></thead><tbody>\n",
      poses ? "poses" : "places", html_escaped(scene.wanted_of), scene.unit,
      poses ? "<th>wanted</th><th>off, °</th>" : "");
  for (std::size_t i = 0; i < scene.wanted.size(); ++i) {
    const SceneWanted& wanted = scene.wanted[i];
    text += fmt::format("<tr><td><button type=\"button\" data-moment=\"{:.6g}\">{}</button></td>",
                        wanted.moment, i + 1) +
            pair_cell(wanted.at, scale) + pair_cell(wanted.reached, scale) +
            fmt::format("<td>{}</td>", html_escaped(deviation_text(deviation(wanted))));
    if (poses)
      text += fmt::format("<td>{}°</td><td>{}</td>", number_text(-degrees(*wanted.angle), 3),
                          html_escaped(deviation_text(turned_by(wanted))));
    text += "</tr>\n";
  }
  return text + "</tbody></table></section>\n";
}

}  // namespace kempe
