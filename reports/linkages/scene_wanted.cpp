#include "reports/linkages/scene_wanted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "geometry/fixed_text.hpp"
#include "reports/pictures/html_text.hpp"

namespace kempe {
namespace {

/// Where the number of a ring stands: beside the way through the places, on the outer side of a loop; of a pose across from its axes.
std::vector<Point> ways_out(const std::vector<SceneWanted>& wanted) {
  const std::size_t count = wanted.size();
  double area = 0;
  for (std::size_t i = 0; i < count; ++i) area += cross(wanted[i].at, wanted[(i + 1) % count].at);
  std::vector<Point> ways;
  for (std::size_t i = 0; i < count; ++i) {
    const Point along = wanted[std::min(i + 1, count - 1)].at - wanted[i > 0 ? i - 1 : 0].at;
    const Point aside = area < 0 ? Point(-along.y(), along.x()) : Point(along.y(), -along.x());
    if (const auto& angle = wanted[i].angle)
      ways.push_back(as_point(std::polar(1.0, *angle + 0.75 * pi)));
    else
      ways.push_back(aside.norm() > 0 ? Point(aside.normalized()) : Point(0, -1));
  }
  return ways;
}

/// A frame's axes, the longer one along its x.
std::string frame_axes(std::string_view kind, const Point& at, double angle, const PictureScale& scale) {
  const Point x(std::cos(angle), std::sin(angle)), y(x.y(), -x.x());  // on a page y runs downward
  const Point x_end = at + 6 * scale.pin * x, y_end = at + 3 * scale.pin * y;
  return drawn("path", kind, scale).with("d", scale.line(x_end, at) + scale.line(at, y_end)).text();
}

bool are_poses(const LinkageScene& scene) { return scene.wanted.front().angle.has_value(); }

constexpr double rounding_leaves = 1e-9;  // in the file's unit, or degrees

/// Three digits; of what rounding leaves only a bound.
std::string deviation_text(double value) {
  return value < rounding_leaves ? "<\u00a01e-9" : fmt::format("{:.3g}", value);
}

/// The largest of deviations in a sentence.
std::string bound_text(double value) {
  return value < rounding_leaves ? "less than 1e-9" : fmt::format("at most {:.3g}", value);
}

std::string pair_cell(const Point& at, const PictureScale& scale) {
  const int decimals = std::max(0, scale.decimals - 1);
  return fmt::format("<td>({}, {})</td>", fixed_text(at.x(), decimals), fixed_text(-at.y(), decimals));
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
    if (wanted.angle) text += frame_axes("wanted", wanted.at, *wanted.angle, scale);
    const Point number = wanted.at + 2.6 * scale.pin * ways[i];
    text += drawn("text", "order", scale)
                .with("x", scale.number(number.x()))
                .with("y", scale.number(number.y()))
                .saying(std::to_string(i + 1))
                .line();
  }
  return SvgElement("g").with("id", "wanted").holding(text).line();
}

std::string carried_axes(const LinkageScene& scene, std::size_t body, const PictureScale& scale) {
  if (scene.wanted.empty() || !scene.wanted.front().reached_angle) return "";
  const auto point = std::find_if(scene.points.begin(), scene.points.end(),
                                  [&](const ScenePoint& one) { return one.name == scene.wanted_of; });
  if (point == scene.points.end() || static_cast<std::size_t>(point->body) != body) return "";
  return frame_axes("spoke", point->local,
                    *scene.wanted.front().reached_angle - scene.moments.front().angle[body], scale);
}

std::string wanted_sentence(const LinkageScene& scene) {
  if (scene.wanted.empty()) return "";
  double most = 0, turned = 0;
  for (const SceneWanted& wanted : scene.wanted) {
    most = std::max(most, deviation(wanted));
    if (wanted.angle) turned = std::max(turned, turned_by(wanted));
  }
  if (are_poses(scene))
    return fmt::format(" Numbered rings with axes are the {} wanted poses: off by {} {} and {} degrees.",
                       scene.wanted.size(), bound_text(most), scene.unit, bound_text(turned));
  return fmt::format(" Numbered rings are the {} wanted places of {}: off by {} {}.", scene.wanted.size(),
                     html_escaped(scene.wanted_of), bound_text(most), scene.unit);
}

std::string wanted_table(const LinkageScene& scene) {
  if (scene.wanted.empty()) return "";
  const bool poses = are_poses(scene);
  const PictureScale scale = PictureScale::of(scene.lower, scene.upper);
  const std::string head =
      poses ? fmt::format("wanted, {0}</th><th>direction</th><th>off, {0}</th><th>off, degrees", scene.unit)
            : fmt::format("wanted, {0}</th><th>reached, {0}</th><th>off, {0}", scene.unit);
  std::string text = fmt::format(
      "<section id=\"wantedbox\"><h3>Wanted {}</h3><table><thead><tr><th>at</th><th>{}</th></tr></thead>"
      "<tbody>\n",
      poses ? "poses" : "places of " + html_escaped(scene.wanted_of), head);
  for (std::size_t i = 0; i < scene.wanted.size(); ++i) {
    const SceneWanted& wanted = scene.wanted[i];
    text += fmt::format("<tr><td><button type=\"button\" data-moment=\"{:.6g}\">{}</button></td>",
                        wanted.moment, i + 1) +
            pair_cell(wanted.at, scale);
    text += poses ? fmt::format("<td>{}°</td>", number_text(-degrees(*wanted.angle), 3))
                  : pair_cell(wanted.reached, scale);
    text += fmt::format("<td>{}</td>", html_escaped(deviation_text(deviation(wanted))));
    if (poses) text += fmt::format("<td>{}</td>", html_escaped(deviation_text(turned_by(wanted))));
    text += "</tr>\n";
  }
  return text + "</tbody></table></section>\n";
}

}  // namespace kempe
