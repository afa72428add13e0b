#include "reports/drawings/svg_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "geometry/fixed_text.hpp"
#include "reports/pictures/svg_element.hpp"

namespace kempe {
namespace {

/// Numbers as exactly as a thing of some size (mm) needs.
class Figures {
 public:
  explicit Figures(double size) : decimals_(decimals_for(size)) {}

  std::string of(double value) const { return short_text(value, decimals_); }
  std::string of(const Point& point) const { return of(point.x()) + "," + of(-point.y()); }

 private:
  int decimals_;
};

double size_of(const ArcRing& ring) {
  const Box box = bounding_box(ring);
  return (box.upper - box.lower).maxCoeff();
}

/// The edge from one corner to the next.
std::string edge(const ArcVertex& from, const Point& to, const Figures& figures) {
  if (from.bulge == 0) return "L" + figures.of(to);
  const double bulge = std::abs(from.bulge);
  const std::string radius = figures.of((to - from.at).norm() * (1 + bulge * bulge) / (4 * bulge));
  return fmt::format("A{0},{0} 0 {1} {2} {3}", radius, bulge > 1 ? 1 : 0, from.bulge < 0 ? 1 : 0,
                     figures.of(to));
}

std::string element(const OutlineShape& outline) {
  return SvgElement("path").with("d", outline_path(outline.ring, outline.closed)).line();
}

std::string element(const CircleShape& circle) {
  const Figures figures(circle.radius);
  return SvgElement("circle")
      .with("cx", figures.of(circle.centre.x()))
      .with("cy", figures.of(-circle.centre.y()))
      .with("r", figures.of(circle.radius))
      .line();
}

std::string element(const TextShape& text) {
  // A capital of DejaVu Sans and its like is about 0.73 of the font size high.
  const Figures figures(text.height);
  const std::string x = figures.of(text.at.x()), y = figures.of(-text.at.y());
  SvgElement result("text");
  result.with("x", x).with("y", y).with("font-size", figures.of(text.height / 0.73));
  if (text.anchor == Anchor::middle) result.with("text-anchor", "middle");
  if (text.turn != 0)
    result.with("transform", fmt::format("rotate({} {} {})", figures.of(-degrees(text.turn)), x, y));
  return result.saying(text.text).line();
}

const std::string& layer_of(const Shape& shape) {
  return std::visit([](const auto& one) -> const std::string& { return one.layer; }, shape);
}

std::string group(const DrawingLayer& layer, const std::vector<Shape>& shapes) {
  std::string lines, texts;
  for (const Shape& shape : shapes) {
    if (layer_of(shape) != layer.name) continue;
    (std::holds_alternative<TextShape>(shape) ? texts : lines) +=
        std::visit([](const auto& one) { return element(one); }, shape);
  }
  if (!texts.empty())
    lines +=
        SvgElement("g").with("stroke", "none").with("fill", layer.svg_colour).holding("\n" + texts).line();
  return SvgElement("g")
      .with("id", layer.name)
      .with("stroke", layer.svg_colour)
      .with("fill", "none")
      .with("stroke-width", layer.is_cut ? "0.25" : "0.18")
      .holding("\n" + lines)
      .line();
}

}  // namespace

std::string outline_path(const ArcRing& ring, bool closed) {
  if (ring.empty()) return "";
  const Figures figures(size_of(ring));
  std::string path = "M" + figures.of(ring.front().at);
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) path += edge(ring[i], ring[i + 1].at, figures);
  if (closed && ring.back().bulge != 0) path += edge(ring.back(), ring.front().at, figures);
  return closed ? path + "Z" : path;
}

std::string svg_text(const Drawing& drawing, std::string_view title, double margin) {
  const Box box = bounding_box(drawing);
  const Point size = box.upper - box.lower + Point(2 * margin, 2 * margin);
  const Figures figures(size.maxCoeff());
  std::string inside = SvgElement("title").saying(title).line();
  for (const DrawingLayer& layer : drawing.layers) inside += group(layer, drawing.shapes);
  const std::string width = figures.of(size.x()), height = figures.of(size.y());
  return svg_file(svg_root()
                      .with("version", "1.1")
                      .with("width", width + "mm")
                      .with("height", height + "mm")
                      .with("viewBox", fmt::format("{} {} {} {}", figures.of(box.lower.x() - margin),
                                                   figures.of(-box.upper.y() - margin), width, height))
                      .with("font-family", "DejaVu Sans, Helvetica, Arial, sans-serif")
                      .holding("\n" + inside));
}

}  // namespace kempe
