#include "reports/pictures/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "reports/pictures/html_text.hpp"
#include "reports/pictures/map_contours.hpp"
#include "reports/pictures/mechanism_picture.hpp"
#include "reports/pictures/picture_labels.hpp"
#include "reports/pictures/round_step.hpp"
#include "reports/pictures/svg_element.hpp"
#include "reports/pictures/svg_path.hpp"
#include "synthesis/design/assemble.hpp"
#include "workspace/obstacles.hpp"

namespace kempe {
namespace {

/// Nominal width of the picture on a screen, px: what text sizes and line widths are measured against.
constexpr double nominal_width = 760;
/// Strips for the frame's figures and the scale bar, nominal px.
constexpr double least_left_strip = 40, bottom_strip = 52, margin = 24;
/// Widest a character of the frame's figures gets, nominal px: on a phone (report.css).
constexpr double figure_width = 12.1;
/// Size of a letter, nominal px, and its width over its height.
constexpr double letter_size = 15, letter_width = 0.62;

/// Of a number's text, nominal px.
double width_of_figure(double value) {
  const std::string text = number_text(value, 6);
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80; };
  return figure_width * static_cast<double>(std::count_if(text.begin(), text.end(), begins));
}

class Extent {
 public:
  void add(const Point& at) {
    lower_ = lower_.cwiseMin(at);
    upper_ = upper_.cwiseMax(at);
  }
  void add(const Point& at, double around) {
    add(at - Point::Constant(around));
    add(at + Point::Constant(around));
  }
  void add(const Ring& ring) {
    for (const Point& at : ring) add(at);
  }
  void add(const Region& region) {
    for (const Polygon& polygon : region.polygons) add(polygon.outer);
  }
  void add(const ArcRegion& region) {
    for (const ArcPolygon& polygon : region)
      for (std::size_t i = 0; i < polygon.outer.size(); ++i)
        add_edge(polygon.outer[i], polygon.outer[(i + 1) % polygon.outer.size()].at);
  }
  bool empty() const { return !(lower_.x() <= upper_.x()); }
  PictureBox box() const { return {0.5 * (lower_ + upper_), 0.5 * (upper_ - lower_)}; }

 private:
  void add_edge(const ArcVertex& from, const Point& to) {
    add(from.at);
    if (from.bulge == 0) return;
    // Points along the arc: half the sweep's tangent gives the arc's rise over the chord.
    const Complex a = as_complex(from.at), chord = as_complex(to) - a;
    const double sweep = 4 * std::atan(from.bulge);
    const Complex centre = a + chord / (1.0 - std::polar(1.0, sweep));
    constexpr int steps = 24;
    for (int i = 1; i < steps; ++i) add(as_point(centre + (a - centre) * std::polar(1.0, sweep * i / steps)));
  }
  Point lower_ = Point::Constant(std::numeric_limits<double>::infinity());
  Point upper_ = Point::Constant(-std::numeric_limits<double>::infinity());
};

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

std::string path_element(std::string_view css, const std::string& data) {
  return data.empty() ? std::string() : svg_shape(css, data).line();
}

std::string group(std::string_view id, const std::string& inside) {
  if (inside.empty()) return {};
  return SvgElement("g").with("class", fmt::format("m-{}", id)).holding("\n" + inside).line();
}

/// Inside a sheet, `inset` (mm) under the middle of its uppermost side, where its name stands.
Point under_upper_side(const FittingSheet& sheet, double inset) {
  const Ring ring = corners(sheet);
  Point best = 0.5 * (ring[3] + ring[0]);
  for (std::size_t i = 0; i < 3; ++i)
    if (const Point middle = 0.5 * (ring[i] + ring[i + 1]); middle.y() > best.y()) best = middle;
  return best + inset * (sheet.centre - best).normalized();
}

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
    {Cause::sheet_overlap, "overlap", "Copy overlaps original"},
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
    case Cause::sheet_overlap: return "Original and copy would overlap.";
    case Cause::self_contact:
    case Cause::obstacle_contact: break;
  }
  return parts.empty() ? "Parts come too close to each other." : "Too close: " + parts + ".";
}

/// Draws one design; a function a layer, from the table upward.
class Picture {
 public:
  /// `coarseness` nominal pixels are left out between two corners of an outline.
  Picture(const Design& design, double coarseness)
      : design_(design), coarseness_(coarseness), tracer_(place_to_show(design)),
        copy_(similar_image(design.region, design.linkage.k(), design.linkage.pole())) {
    if (auto pose = design.linkage.pose_with_tracer_at(tracer_)) pose_ = *pose;
    frame_view();
  }

  MapPicture draw();

 private:
  void frame_view();
  void fit_drawing(const PictureBox& box, double strip);
  std::vector<double> heights() const;
  double widest_figure_beside() const;
  double grid_step() const { return round_step(2 * drawing_.half.x() / 9); }
  std::string defs() const;
  std::string grid() const;
  std::string scale_bar() const;
  std::string areas();
  std::string lost_areas();
  std::string things();
  std::string contours(const std::vector<ContourCircle>& circles,
                       const std::function<std::string(double)>& words) const;
  std::string labels() const;
  std::string text(std::string_view css, const Point& at, const std::string& inside) const;
  Point free_side(Joint joint) const;
  std::string joint_labels(LabelPlacer& placer) const;
  double detail() const { return coarseness_ * view_.unit; }
  void layer(std::string id, std::string label, std::string figure, std::string group, bool shown = true) {
    layers_.push_back({std::move(id), std::move(label), std::move(figure), std::move(group), shown});
  }

  const Design& design_;
  double coarseness_;
  Point tracer_;
  Region copy_;
  Pose pose_;
  PictureView view_;
  PictureBox drawing_;  ///< the view without its strips, y upward
  std::vector<MapLayer> layers_;
};

void Picture::frame_view() {
  Extent extent;
  extent.add(design_.map.reachable);
  extent.add(design_.map.collision_free);
  for (const LostArea& lost : design_.map.lost) extent.add(lost.area);
  extent.add(design_.region);
  extent.add(copy_);
  for (const Obstacle& obstacle : design_.obstacles) extent.add(obstacle.shape.outer);
  for (const Joint joint : all_joints) extent.add(pose_[joint], design_.style.width / 2);
  PictureBox box = extent.box();
  box.half = box.half.cwiseMax(1e-3);
  box.half.x() = std::max(box.half.x(), box.half.y() / 1.02);
  box.half.y() = std::max(box.half.y(), box.half.x() / 1.7);
  // A wider strip makes the drawing a little smaller, which may change the figures.
  double strip = least_left_strip;
  for (int pass = 0; pass < 3; ++pass) {
    fit_drawing(box, strip);
    strip = std::max(strip, widest_figure_beside() + 8);
  }
  fit_drawing(box, strip);
  const double u = view_.unit;
  view_.left = drawing_.lower().x() - strip * u;
  view_.top = -drawing_.upper().y();
  view_.width = 2 * drawing_.half.x() + strip * u;
  view_.height = 2 * drawing_.half.y() + bottom_strip * u;
}

/// The unit and the drawing of a box beside a strip of so many nominal px.
void Picture::fit_drawing(const PictureBox& box, double strip) {
  view_.unit = 2 * box.half.x() / (nominal_width - strip - 2 * margin);
  drawing_ = {box.centre, box.half + Point::Constant(margin * view_.unit)};
}

/// Values with a line across and a figure in the strip. A line at the very top would have no room for its figure.
std::vector<double> Picture::heights() const {
  return multiples_within(grid_step(), drawing_.lower().y(), drawing_.upper().y() - 7 * view_.unit);
}

/// Nominal px.
double Picture::widest_figure_beside() const {
  double widest = 0;
  for (const double y : heights()) widest = std::max(widest, width_of_figure(y));
  return widest;
}

std::string Picture::defs() const {
  struct Hatch {
    std::string_view id;
    int turn;
    double step, stroke;  ///< nominal px
  };
  static constexpr std::array<Hatch, 7> hatches{{{"change", 45, 7, 2.2},
                                                 {"transmission", -45, 7, 2.2},
                                                 {"contact", 0, 6, 3},
                                                 {"obstructed", 90, 6, 3},
                                                 {"overlap", 20, 9, 2},
                                                 {"uncertain", 60, 4, 2},
                                                 {"thing", -45, 5, 1.6}}};
  const auto pattern = [](const Hatch& hatch, std::string_view prefix, double unit) {
    const std::string step = coordinate(hatch.step * unit, 5);
    return SvgElement("pattern")
        .with("id", fmt::format("{}-{}", prefix, hatch.id))
        .with("class", fmt::format("hatch-{}", hatch.id))
        .with("width", step)
        .with("height", step)
        .with("patternUnits", "userSpaceOnUse")
        .with("patternTransform", fmt::format("rotate({})", hatch.turn))
        .holding(SvgElement("rect").with("width", step).with("height", step).with("class", "ground").text())
        .holding(
            SvgElement("path").with("d", "M0,0V" + step).with("stroke-width", hatch.stroke * unit, 5).text())
        .line();
  };
  std::string patterns;
  for (const Hatch& hatch : hatches)
    patterns += pattern(hatch, "hatch", view_.unit) + pattern(hatch, "swatch", 0.8);
  return SvgElement("defs").holding("\n" + patterns).line();
}

std::string Picture::grid() const {
  const double u = view_.unit;
  const Point lower = drawing_.lower(), upper = drawing_.upper();
  std::string lines, figures;
  for (const double x : multiples_within(grid_step(), lower.x(), upper.x())) {
    lines += svg_line({{x, lower.y()}, {x, upper.y()}});
    if (x + 0.5 * width_of_figure(x) * u > upper.x()) continue;  // it would be cut
    figures += text("tick", {x, lower.y() - 10 * u}, number_text(x, 6));
  }
  for (const double y : heights()) {
    lines += svg_line({{lower.x(), y}, {upper.x(), y}});
    figures += text("tick end", {lower.x() - 6 * u, y}, number_text(y, 6));
  }
  return group("grid", path_element("grid-line", lines) + figures);
}

std::string Picture::scale_bar() const {
  const double u = view_.unit, length = round_step(2 * drawing_.half.x() / 12);
  const Point right(drawing_.upper().x() - 8 * u, drawing_.lower().y() - 34 * u),
      left = right - Point(length, 0);
  const Point tick(0, 4 * u);
  std::string bar =
      svg_line({left + tick, left - tick}) + svg_line({left, right}) + svg_line({right + tick, right - tick});
  return group("scale", path_element("scale-bar", bar) + text("tick end strong", left - Point(8 * u, 0),
                                                              number_text(length, 6) + "\u00a0mm"));
}

std::string Picture::text(std::string_view css, const Point& at, const std::string& inside) const {
  return svg_words(css, at).holding(inside).line();
}

std::string Picture::lost_areas() {
  std::string svg;
  for (const CauseWords& words : cause_words) {
    std::string paths;
    double lost = 0;
    for (const LostArea& part : design_.map.lost) {
      if (part.cause != words.cause || part.area.empty()) continue;
      lost += area(part.area);
      paths += SvgElement("path")
                   .with("class", "lost")
                   .with("data-why", why_lost(part))
                   .with("d", svg_path(part.area, detail()))
                   .line();
    }
    if (paths.empty()) continue;
    svg += group(words.id, paths);
    layer(std::string(words.id), std::string(words.label), area_text(lost), "lost");
  }
  return svg;
}

std::string Picture::areas() {
  const WorkspaceMap& map = design_.map;
  std::string svg;
  const auto add = [&](const char* id, const char* label, const ArcRegion& shape, bool shown = true) {
    if (shape.empty()) return;
    svg += group(id, path_element("area", svg_path(shape, detail())));
    layer(id, label, area_text(area(shape)), "map", shown);
  };
  add("reachable", "Reachable", map.reachable);
  add("usable", "Usable", map.usable);
  svg += lost_areas();
  add("free", "Collision-free", map.collision_free);
  add("uncertain", "Uncertain", map.uncertain);
  if (!map.collision_free.empty()) {
    const ArcRegion image = similar_image(map.collision_free, design_.linkage.k(), design_.linkage.pole());
    svg += group("image", path_element("area", svg_path(image, detail())));
    layer("image", "Places of the pen", area_text(area(image)), "map", false);
  }
  std::stable_sort(layers_.begin(), layers_.end(),
                   [](const MapLayer& a, const MapLayer& b) { return a.group == "map" && b.group != "map"; });
  return svg;
}

std::string Picture::things() {
  std::string obstacles, sheets, tightest;
  for (const Obstacle& obstacle : design_.obstacles)
    obstacles += path_element("thing", svg_path(obstacle.shape, detail()));
  for (const FittingSheet& sheet : design_.map.largest_sheets) {
    const Point size(sheet.width, sheet.height);
    sheets += path_element("sheet", svg_path(Polygon{corners(sheet), {}}, 0)) +
              text("small", under_upper_side(sheet, 10 * view_.unit),
                   html_escaped(fmt::format("{}, {} × {}", sheet.name, number_text(size.maxCoeff(), 0),
                                            number_text(size.minCoeff(), 0))));
  }
  if (std::isfinite(design_.map.clearance_min) && !design_.map.clearance_min_parts.empty()) {
    const Point at = design_.map.clearance_min_at, a(5 * view_.unit, 5 * view_.unit), b(a.x(), -a.y());
    tightest = path_element("tight", svg_line({at - a, at + a}) + svg_line({at - b, at + b}));
  }
  const auto add = [&](const char* id, const char* label, const std::string& inside, std::string figure,
                       bool shown = true) {
    if (!inside.empty()) layer(id, label, std::move(figure), "things", shown);
    return group(id, inside);
  };
  std::string svg = add("obstacles", "Obstacles", obstacles, count_text(design_.obstacles.size()));
  svg += add("sheets", "Largest sheets", sheets, count_text(design_.map.largest_sheets.size()), false);
  const auto outline = [&](const Region& region) {
    return region.empty() ? std::string() : path_element("outline", svg_path(region, detail()));
  };
  svg += add("region", "Region to trace", outline(design_.region), area_text(area(design_.region)));
  svg += add("copy", "Its copy", outline(copy_), area_text(area(copy_)));
  svg +=
      add("footprint", "Footprint", outline(design_.footprint), area_text(design_.quality.footprint), false);
  svg +=
      add("angle-lines", "Transmission angle",
          contours(transmission_circles(design_.linkage), [](double level) { return angle_text(level, 0); }),
          "10° steps", false);
  svg += add("error-lines", "Copy error, worst",
             contours(copy_error_circles(design_), [](double level) { return length_text(level); }), "lines",
             false);
  svg += add("tightest", "Tightest place", tightest, length_text(design_.map.clearance_min, 2), false);
  return svg;
}

/// Circles about the pole, each with its level, side by side along a line square to the way to the region.
std::string Picture::contours(const std::vector<ContourCircle>& circles,
                              const std::function<std::string(double)>& words) const {
  const Point pole = design_.linkage.pole();
  const double bearing = std::arg(as_complex(tracer_ - pole)) + 0.75 * pi;
  std::string lines, figures;
  std::vector<double> named;  // figures need room on the line
  for (const ContourCircle& circle : circles) {
    const double radius = circle.radius;
    lines += svg_disc("contour", pole, radius).line();
    if (std::any_of(named.begin(), named.end(),
                    [&](double other) { return std::abs(other - radius) < 20 * view_.unit; }))
      continue;
    named.push_back(radius);
    figures += text("small", pole + as_point(std::polar(radius, bearing)), words(circle.level));
  }
  return lines + figures;
}

/// Away from the links that meet at a joint; the page's scripts put the moving letters there (stage.js,
/// freeSide).
Point Picture::free_side(Joint joint) const {
  Point away = Point::Zero(), along(1, 0);
  for (const Link link : all_links) {
    const std::vector<Joint> line = body_line(link);
    for (std::size_t i = 0; i < line.size(); ++i)
      for (std::size_t j = i == 0 ? 0 : i - 1; line[i] == joint && j < line.size() && j <= i + 1; ++j)
        if (j != i && (pose_[line[j]] - pose_[joint]).norm() > 0) {
          along = (pose_[line[j]] - pose_[joint]).normalized();
          away -= along;
        }
  }
  return away.norm() > 0.15 ? Point(away.normalized()) : Point(-along.y(), along.x());
}

std::string Picture::joint_labels(LabelPlacer& placer) const {
  const double u = view_.unit, radius = 1.6 * drawn_pin_radius(design_.style, u);
  std::string svg;
  // The named points first: they have the longer words.
  std::vector<Joint> order(all_joints.begin(), all_joints.end());
  std::stable_partition(order.begin(), order.end(),
                        [&](Joint j) { return !role(design_.linkage, j).empty(); });
  for (const Joint joint : order) {
    const std::string_view what = role(design_.linkage, joint);
    const double width = letter_size * letter_width *
                         (1.2 + (what.empty() ? 0.0 : 0.5 + 0.86 * static_cast<double>(what.size())));
    const Point at =
        placer.place_around(pose_[joint], radius, Point(width / 2, letter_size / 2) * u, free_side(joint));
    const auto span = [](std::string_view css, std::string_view said) {
      return SvgElement("tspan").with("class", css).saying(said).text();
    };
    std::string words = span("letter", std::string(1, letter(joint)));
    if (!what.empty()) words += " " + span("role", what);
    svg += text(fmt::format("joint {}", what), at, words);
  }
  return group("names", svg);
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

std::string Picture::labels() const {
  const double u = view_.unit;
  LabelPlacer placer(drawing_, u);
  for (const Link link : all_links) {
    const std::vector<Joint> line = body_line(link);
    for (std::size_t i = 1; i < line.size(); ++i)
      placer.avoid(pose_[line[i - 1]], pose_[line[i]], drawn_width(design_.style, u) / 2);
  }
  constexpr std::size_t corners_looked_at = 60;
  const std::vector<bool> is_near = nearest_obstacles(design_, most_named);
  for (std::size_t number = 0; number < design_.obstacles.size(); ++number) {
    const Ring& ring = design_.obstacles[number].shape.outer;
    if (!is_near[number]) continue;
    for (std::size_t i = 0; i < ring.size() && ring.size() <= corners_looked_at; ++i)
      placer.avoid(ring[i], ring[(i + 1) % ring.size()], 0);
  }
  std::string svg;
  for (const Joint joint : all_joints)
    placer.avoid({pose_[joint], Point::Constant(1.6 * drawn_pin_radius(design_.style, u))});
  svg += joint_labels(placer);
  const auto beside = [&](const Region& region, std::string_view id, const std::string& words) {
    Extent extent;
    extent.add(region);
    if (extent.empty()) return;
    const Point half(0.5 * 0.55 * 13 * static_cast<double>(words.size()) * u, 8 * u);
    svg += group(
        id, text(fmt::format("name {}", id), placer.place_beside(extent.box(), half), html_escaped(words)));
  };
  beside(design_.region, "region", "region");
  beside(copy_, "copy", "copy");
  for (std::size_t i = 0; i < design_.obstacles.size(); ++i) {
    if (!is_near[i]) continue;
    const std::string words = obstacle_name(design_.obstacles, i);
    // One table of the spec may hold several rings.
    if (i == 0 || obstacle_name(design_.obstacles, i - 1) != words)
      beside(Region{{design_.obstacles[i].shape}}, "obstacles", shortened(words));
  }
  return SvgElement("g").with("class", "words").holding("\n" + svg).line();
}

MapPicture Picture::draw() {
  const double u = view_.unit;
  std::string inside = defs() + grid();
  inside += areas() + things();
  inside += mechanism_svg(design_, pose_, u) + labels() + scale_bar();
  layer("mechanism", "Linkage", "", "things");
  layer("grid", "Grid, mm", "", "things");
  const SvgElement title =
      SvgElement("title").with("id", "map-title").saying("The linkage on its workspace map, seen from above");
  const SvgElement svg = SvgElement("svg")
                             .with("class", "map")
                             .with("id", "map")
                             .with("xmlns", svg_namespace)
                             .with("role", "img")
                             .with("aria-labelledby", "map-title")
                             .with("viewBox", view_box(view_.left, view_.top, view_.width, view_.height))
                             .with("font-size", letter_size * u, 5)
                             .holding("\n" + title.line() + inside);
  return {svg.line(), view_, layers_, tracer_, detail()};
}

Point centroid(const Ring& ring) {
  double doubled = 0;
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    doubled += cross(a, b);
    sum += cross(a, b) * (a + b);
  }
  return doubled == 0 ? ring[0] : Point(ring[0] + sum / (3 * doubled));
}

/// Some place of the free workspace, the middle of its openings preferred; nothing if none is met.
std::optional<Point> free_place(const Design& design) {
  constexpr int bearings = 72;
  const MapTask task = map_task(design);
  for (const double share : {0.5, 0.3, 0.7, 0.1, 0.9})
    for (int i = 0; i < bearings && !design.opening.empty(); ++i) {
      const double opening = design.opening.lower + share * design.opening.width();
      const Point at = design.linkage.tracer_at(opening, 2 * pi * i / bearings);
      if (verdict_at(task, at).free) return at;
    }
  return std::nullopt;
}

}  // namespace

Point place_to_show(const Design& design) {
  const CopyingLinkage& linkage = design.linkage;
  if (design.region.empty())
    if (const auto place = free_place(design)) return *place;
  const auto good = [&](const Point& at) {
    const auto opening = linkage.opening_at((at - linkage.pole()).norm());
    return opening && (design.opening.empty() || design.opening.contains(*opening));
  };
  std::vector<Point> candidates;
  for (const Polygon& polygon : design.region.polygons) {
    const Point middle = centroid(polygon.outer);
    if (contains(design.region, middle)) candidates.push_back(middle);
  }
  for (const Polygon& polygon : design.region.polygons)
    candidates.insert(candidates.end(), polygon.outer.begin(), polygon.outer.end());
  for (const Point& at : candidates)
    if (good(at)) return at;
  const OpeningInterval& openings = design.opening.empty() ? linkage.assembly_interval() : design.opening;
  return linkage.tracer_at(openings.middle(), 0);
}

MapPicture map_picture(const Design& design) {
  // Finer than anyone sees; a map of very many corners is drawn coarser, so that the page stays a page.
  constexpr double finest = 0.15, coarsest = 5;
  constexpr std::size_t most = 500000;
  MapPicture picture;
  for (double coarseness = finest; coarseness < coarsest; coarseness *= 2) {
    picture = Picture(design, coarseness).draw();
    if (picture.svg.size() <= most) break;
  }
  return picture;
}

}  // namespace kempe
