#include "reports/linkages/centres_picture.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "reports/linkages/centres_steps.hpp"
#include "reports/linkages/picture.hpp"

namespace kempe {
namespace {

using Kind = InstantCentre::Kind;

constexpr double one_place = 1e-6;  ///< extents: centres that are nearer are one place
constexpr double reach = 1.6;       ///< extents from the linkage's middle: what lies farther away is an arrow

class CentresPicture {
 public:
  CentresPicture(const LinkageScene& scene, const std::vector<InstantCentre>& centres, double unit)
      : scene_(scene), centres_(centres), unit_(unit), middle_(0.5 * (scene.lower + scene.upper)),
        numbers_(link_numbers(centres)) {
    Point lower = scene.lower, upper = scene.upper;
    for (const InstantCentre& centre : centres)
      if (is_near(centre)) {
        lower = lower.cwiseMin(on_page(centre.at));
        upper = upper.cwiseMax(on_page(centre.at));
      }
    scale_ = PictureScale::of(lower, upper);
    legend_ = (upper - lower).maxCoeff() * 0.5;
    for (Group& group : groups())
      if (group.size() > 1) insets_.push_back(std::move(group));
  }

  std::string draw() {
    const double width = scale_.upper.x() - scale_.lower.x() + legend_,
                 height = scale_.upper.y() - scale_.lower.y();
    const std::string left = scale_.number(scale_.lower.x()), top = scale_.number(scale_.lower.y());
    std::string inside = SvgElement("title").saying("Instant centres of " + scene_.title).line() +
                         SvgElement("style").holding(own_style()).line();
    inside += SvgElement("rect")
                  .with("x", left)
                  .with("y", top)
                  .with("width", scale_.number(width))
                  .with("height", scale_.number(height))
                  .with("fill", "#fff")
                  .line();
    inside += drawing(false) + draw_legend() + draw_insets();
    return svg_root()
        .with("viewBox", fmt::format("{} {} {} {}", left, top, scale_.number(width), scale_.number(height)))
        .with("width", "1100")
        .with("role", "img")
        .holding("\n" + inside)
        .line();
  }

  /// For a page that says by its own style sheet how things look, and lists the links beside it: sizes are shares of the letters.
  std::string draw_for_page() const {
    const double width = scale_.upper.x() - scale_.lower.x() +
                         (insets_.empty() ? 0 : inset_side() + scale_.letter),
                 height = scale_.upper.y() - scale_.lower.y();
    return SvgElement("svg")
        .with("id", "centres")
        .with("viewBox",
              fmt::format("{} {} {} {}", scale_.number(scale_.lower.x()), scale_.number(scale_.lower.y()),
                          scale_.number(width), scale_.number(height)))
        .with("font-size", scale_.number(0.75 * scale_.letter))
        .with("role", "img")
        .with("aria-label", "Instant centres of " + scene_.title)
        .holding("\n" + drawing(true) + draw_insets())
        .text();
  }

 private:
  /// With or without the lines of centres that lie outside.
  std::string drawing(bool with_far) const {
    std::string text;
    for (const InstantCentre& centre : centres_)
      if (centre.lines && (with_far || is_near(centre)))
        text += SvgElement("g")
                    .with("class", "lines")
                    .with("data-centre", name_of(centre))
                    .holding(draw_lines(centre))
                    .line();
    return text + draw_linkage() + draw_points();
  }

  Point on_page(const Point& p) const { return {p.x() / unit_, -p.y() / unit_}; }
  bool is_near(const InstantCentre& centre) const {
    return centre.kind == Kind::finite && (on_page(centre.at) - middle_).norm() < reach * scene_.extent();
  }

  std::string name_of(const InstantCentre& centre) const {
    return centre_name(numbers_, centre.first, centre.second);
  }

  std::string own_style() const {
    return fmt::format(
        ".line{{stroke:#b7312c;stroke-width:{0};stroke-opacity:.3}}.normal{{stroke-dasharray:{3} "
        "{3}}}.primary{{fill:#222}}.found{{fill:#b7312c}"
        "}"
        ".rates{{fill:#8e3b8f}}.centre{{font:{1}px "
        "system-ui,sans-serif;paint-order:stroke;stroke:#fff;stroke-width:{2}}}"
        ".legend{{font:{1}px system-ui,sans-serif;fill:#333}}"
        ".inset{{fill:#fff;stroke:#999;stroke-width:{0}}}",
        scale_.number(scale_.stroke), scale_.number(0.75 * scale_.letter), scale_.number(2 * scale_.stroke),
        scale_.number(3 * scale_.stroke));
  }

  /// The lines on which a centre was found, as far as they cross the picture.
  std::string draw_lines(const InstantCentre& centre) const {
    std::string text;
    for (const CentreLine& line : *centre.lines) {
      const auto through = point_on(centre, line);
      const Point along(line.direction.x(), -line.direction.y());
      if (!through || along == Point::Zero()) continue;
      if (const auto ends = visible_part(on_page(*through), along))
        text += SvgElement("path")
                    .with("class", line.from == CentreLine::From::slider ? "line normal" : "line")
                    .with("d", scale_.line(ends->first, ends->second))
                    .line();
    }
    return text;
  }

  /// A finite centre on a line: the one that was found, or one that the line goes through.
  std::optional<Point> point_on(const InstantCentre& found, const CentreLine& line) const {
    if (found.kind == Kind::finite) return found.at;
    for (const InstantCentre& centre : centres_) {
      const auto is_of = [&](int a, int b) {
        return centre.first == std::min(a, b) && centre.second == std::max(a, b);
      };
      if (line.via && centre.kind == Kind::finite &&
          (is_of(found.first, *line.via) || is_of(*line.via, found.second)))
        return centre.at;
    }
    return std::nullopt;
  }

  /// The part of a straight line that lies within the view, if any.
  std::optional<std::pair<Point, Point>> visible_part(const Point& at, const Point& along) const {
    double first = -std::numeric_limits<double>::infinity(), last = -first;
    for (const int axis : {0, 1}) {
      const double lower = scale_.lower[axis] - at[axis], upper = scale_.upper[axis] - at[axis];
      if (along[axis] == 0 && (lower > 0 || upper < 0)) return std::nullopt;
      if (along[axis] == 0) continue;
      first = std::max(first, std::min(lower / along[axis], upper / along[axis]));
      last = std::min(last, std::max(lower / along[axis], upper / along[axis]));
    }
    if (!(first < last)) return std::nullopt;
    return std::pair<Point, Point>(at + first * along, at + last * along);
  }

  std::string draw_linkage() const {
    const auto& moment = scene_.moments.front();
    std::string text = ground_group(scene_, scale_).line();
    for (const ScenePoint& point : scene_.points)
      if (point.fixed) text += ground_sign(point, scale_);
    for (std::size_t body = 1; body < scene_.bodies.size(); ++body)
      text += SvgElement("g")
                  .with("color", link_colour(static_cast<int>(body)))
                  .with("opacity", ".7")
                  .with("transform", placement(moment, body, scale_))
                  .holding(body_shape(scene_.bodies[body], static_cast<int>(body), scale_))
                  .line();
    return text;
  }

  SvgElement words(const std::string& css, const Point& at, const std::string& text) const {
    return SvgElement("text")
        .with("class", css)
        .with("x", scale_.number(at.x()))
        .with("y", scale_.number(at.y()))
        .saying(text);
  }

  static std::string style_of(InstantCentre::Source source) {
    if (source == InstantCentre::Source::primary) return "primary";
    return source == InstantCentre::Source::rates ? "rates" : "found";
  }

  /// Centres at one place: one dot and one label.
  struct Place {
    Point at;  ///< on the page
    std::vector<const InstantCentre*> centres;
  };
  /// Places so near each other that dots or labels would lie on each other; of more than one place an inset is drawn.
  using Group = std::vector<Place>;

  static Point middle_of(const Group& group) {
    Point lower = group.front().at, upper = lower;
    for (const Place& place : group) {
      lower = lower.cwiseMin(place.at);
      upper = upper.cwiseMax(place.at);
    }
    return 0.5 * (lower + upper);
  }

  std::vector<Group> groups() const {
    std::vector<Group> found;
    for (const InstantCentre& centre : centres_) {
      if (!is_near(centre)) continue;
      const Point at = on_page(centre.at);
      const auto within = [&](double distance) {
        return [&at, distance](const Place& place) { return (place.at - at).norm() < distance; };
      };
      const auto group = std::find_if(found.begin(), found.end(), [&](const Group& one) {
        return std::any_of(one.begin(), one.end(), within(std::max(3 * scale_.pin, 1.2 * scale_.letter)));
      });
      if (group == found.end()) {
        found.push_back({{at, {&centre}}});
        continue;
      }
      const auto same = std::find_if(group->begin(), group->end(), within(one_place * scene_.extent()));
      if (same == group->end())
        group->push_back({at, {&centre}});
      else
        same->centres.push_back(&centre);
    }
    return found;
  }

  static std::string letter_of(std::size_t inset) {
    return std::string(1, static_cast<char>('a' + inset % 26));
  }

  std::string names_of(const Place& place, const char* between) const {
    std::string names;
    for (const InstantCentre* centre : place.centres)
      names += (names.empty() ? "" : between) + name_of(*centre);
    return names;
  }

  /// The names of the centres at a place, beside it.
  std::string label(const Place& place, const Point& beside) const {
    return words("centre " + style_of(place.centres.front()->source), beside, names_of(place, ", "))
        .with("data-centres", names_of(place, " "))
        .line();
  }

  std::string inset_label(const Group& group, const Point& beside, const std::string& letter) const {
    std::string names;
    for (const Place& place : group) names += (names.empty() ? "" : " ") + names_of(place, " ");
    return words("centre", beside, "inset " + letter)
        .with("data-centres", names)
        .with("data-inset", letter)
        .line();
  }

  std::string dot(const Place& place, const Point& at) const {
    return SvgElement("circle")
        .with("class", style_of(place.centres.front()->source))
        .with("data-centres", names_of(place, " "))
        .with("cx", scale_.number(at.x()))
        .with("cy", scale_.number(at.y()))
        .with("r", scale_.number(0.7 * scale_.pin))
        .text();
  }

  /// Where words that belong to a dot begin: at its upper right, or at the first of the other corners where they lie on no earlier
  /// words. If all are taken, at its upper right.
  Point room_beside(const Point& dot, const std::string& said,
                    std::vector<Eigen::AlignedBox2d>& taken) const {
    const double high = 0.75 * scale_.letter, wide = 0.6 * high * static_cast<double>(said.size());
    const double pin = scale_.pin;
    const std::array<Point, 4> corners{Point(1.4, -1.2) * pin,
                                       {1.4 * pin, 1.2 * pin + 0.7 * high},
                                       {-1.4 * pin - wide, -1.2 * pin},
                                       {-1.4 * pin - wide, 1.2 * pin + 0.7 * high}};
    const auto box_at = [&](const Point& corner) {
      const Point from = dot + corner;
      return Eigen::AlignedBox2d(from - Point(0, 0.8 * high), from + Point(wide, 0.1 * high));
    };
    const auto* free = std::find_if(corners.begin(), corners.end(), [&](const Point& corner) {
      return std::none_of(
          taken.begin(), taken.end(),
          [box = box_at(corner)](const Eigen::AlignedBox2d& other) { return box.intersects(other); });
    });
    const Point& corner = free == corners.end() ? corners.front() : *free;
    taken.push_back(box_at(corner));
    return dot + corner;
  }

  std::string draw_points() const {
    std::string text;
    std::size_t inset = 0;
    std::vector<Eigen::AlignedBox2d> taken;
    for (const Group& group : groups()) {
      for (const Place& place : group) text += dot(place, place.at);
      const bool is_inset = group.size() > 1;
      const std::string letter = letter_of(inset);
      const std::string said = is_inset ? "inset " + letter : names_of(group.front(), ", ");
      const Point beside = room_beside(middle_of(group), said, taken);
      text += is_inset ? inset_label(group, beside, letter) : label(group.front(), beside);
      if (is_inset) ++inset;
    }
    return text;
  }

  /// All insets together take two thirds of the height at most.
  double inset_side() const {
    const double height = scale_.upper.y() - scale_.lower.y(),
                 share = 0.66 / static_cast<double>(insets_.size());
    return std::min(legend_ - scale_.letter, std::min(0.3, share) * height - 1.6 * scale_.letter);
  }

  /// Upper left corner of an inset; they stand from below upward beside the picture.
  Point inset_corner(std::size_t number) const {
    return {scale_.upper.x() + 0.5 * scale_.letter,
            scale_.upper.y() - static_cast<double>(number + 1) * (inset_side() + 1.6 * scale_.letter)};
  }

  /// A group of places drawn larger: only where they are to each other, and which is which.
  std::string draw_inset(std::size_t number) const {
    const Group& group = insets_[number];
    const Point middle = middle_of(group), corner = inset_corner(number);
    double spread = 0;
    for (const Place& place : group) spread = std::max(spread, 2 * (place.at - middle).cwiseAbs().maxCoeff());
    const double larger = 0.55 * inset_side() / spread;
    std::string text = SvgElement("rect")
                           .with("class", "inset")
                           .with("x", scale_.number(corner.x()))
                           .with("y", scale_.number(corner.y()))
                           .with("width", scale_.number(inset_side()))
                           .with("height", scale_.number(inset_side()))
                           .line();
    const Point centre = corner + Point(0.4, 0.5) * inset_side();
    for (const Place& place : group) {
      const Point at = centre + larger * (place.at - middle);
      text += dot(place, at);
      text += label(place, at + Point(1.4, -1.2) * scale_.pin);
    }
    return text + words("legend", corner - Point(0, 0.3 * scale_.letter),
                        fmt::format("inset {}, {:.3g} : 1", letter_of(number), larger))
                      .line();
  }

  std::string draw_insets() const {
    std::string text;
    for (std::size_t i = 0; i < insets_.size(); ++i) text += draw_inset(i);
    return text;
  }

  /// A coordinate that is zero but for rounding is zero.
  double without_dust(double coordinate) const {
    return std::abs(coordinate) < 1e-12 * scene_.extent() ? 0 : coordinate;
  }

  std::string draw_legend() const {
    std::vector<std::string> lines{scene_.title, ""};
    for (const auto& [body, number] : numbers_)
      lines.push_back(fmt::format("{}  {}", number, scene_.bodies[static_cast<std::size_t>(body)].name));
    lines.push_back("");
    for (const InstantCentre& centre : centres_) {
      if (is_near(centre)) continue;
      const std::string name = name_of(centre);
      if (centre.kind == Kind::at_infinity)
        lines.push_back(fmt::format("{}  at infinity, {:.2f}°", name,
                                    degrees(std::atan2(centre.direction.y(), centre.direction.x()))));
      else if (centre.kind == Kind::finite)
        lines.push_back(fmt::format("{}  at ({:.4g}, {:.4g}), outside", name,
                                    without_dust(centre.at.x() / unit_),
                                    without_dust(centre.at.y() / unit_)));
      else
        lines.push_back(fmt::format("{}  none: no relative motion", name));
    }
    std::string text;
    double y = scale_.lower.y() + 1.5 * scale_.letter;
    const double below =
        insets_.empty() ? scale_.upper.y() : inset_corner(insets_.size() - 1).y() - 1.5 * scale_.letter;
    const double step =
        std::min(1.15 * scale_.letter, std::max(below - y, 0.0) / static_cast<double>(lines.size()));
    for (const std::string& line : lines) {
      text += words("legend", {scale_.upper.x() + 0.5 * scale_.letter, y}, line).line();
      y += step;
    }
    return text;
  }

  const LinkageScene& scene_;
  const std::vector<InstantCentre>& centres_;
  double unit_;
  Point middle_;
  PictureScale scale_{};
  double legend_ = 0;
  std::vector<Group> insets_;
  std::map<int, int> numbers_;  ///< of links, from 1
};

}  // namespace

std::string centres_drawing(const LinkageScene& scene, const std::vector<InstantCentre>& centres,
                            double unit) {
  return CentresPicture(scene, centres, unit).draw_for_page();
}

std::string centres_svg(const LinkageScene& scene, const std::vector<InstantCentre>& centres, double unit) {
  return CentresPicture(scene, centres, unit).draw();
}

}  // namespace kempe
