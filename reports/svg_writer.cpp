#include "reports/svg_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "reports/html_text.hpp"

namespace kempe {
namespace {

std::string digits(double value) {
  std::string text = fmt::format("{:.12f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string place(const Point& point) { return digits(point.x()) + "," + digits(-point.y()); }

/// The edge from one corner to the next.
std::string edge(const ArcVertex& from, const Point& to) {
  if (from.bulge == 0) return "L" + place(to);
  const double bulge = std::abs(from.bulge);
  const std::string radius = digits((to - from.at).norm() * (1 + bulge * bulge) / (4 * bulge));
  return fmt::format("A{0},{0} 0 {1} {2} {3}", radius, bulge > 1 ? 1 : 0, from.bulge < 0 ? 1 : 0, place(to));
}

std::string element(const OutlineShape& outline) {
  return fmt::format("<path d=\"{}\"/>\n", outline_path(outline.ring, outline.closed));
}

std::string element(const CircleShape& circle) {
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", digits(circle.centre.x()),
                     digits(-circle.centre.y()), digits(circle.radius));
}

std::string element(const TextShape& text) {
  // A capital of DejaVu Sans and its like is about 0.73 of the font size high.
  const Point at(text.at.x(), -text.at.y());
  const std::string turned = text.turn == 0
                                 ? ""
                                 : fmt::format(" transform=\"rotate({} {} {})\"", digits(-degrees(text.turn)),
                                               digits(at.x()), digits(at.y()));
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}{}>{}</text>\n", digits(at.x()),
                     digits(at.y()), digits(text.height / 0.73),
                     text.anchor == Anchor::middle ? " text-anchor=\"middle\"" : "", turned,
                     html_escaped(text.text));
}

const std::string& layer_of(const Shape& shape) {
  return std::visit([](const auto& one) -> const std::string& { return one.layer; }, shape);
}

std::string group(const DrawingLayer& layer, const std::vector<Shape>& shapes) {
  std::string text = fmt::format("<g id=\"{}\" stroke=\"{}\" fill=\"none\" stroke-width=\"{}\">\n",
                                 html_escaped(layer.name), layer.svg_colour, layer.is_cut ? "0.25" : "0.18");
  std::string texts;
  for (const Shape& shape : shapes) {
    if (layer_of(shape) != layer.name) continue;
    (std::holds_alternative<TextShape>(shape) ? texts : text) +=
        std::visit([](const auto& one) { return element(one); }, shape);
  }
  if (!texts.empty())
    text += fmt::format("<g stroke=\"none\" fill=\"{}\">\n{}</g>\n", layer.svg_colour, texts);
  return text + "</g>\n";
}

}  // namespace

std::string outline_path(const ArcRing& ring, bool closed) {
  if (ring.empty()) return "";
  std::string path = "M" + place(ring.front().at);
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) path += edge(ring[i], ring[i + 1].at);
  if (closed && ring.back().bulge != 0) path += edge(ring.back(), ring.front().at);
  return closed ? path + "Z" : path;
}

std::string svg_text(const Drawing& drawing, std::string_view title, double margin) {
  const Box box = bounding_box(drawing);
  const Point size = box.upper - box.lower + Point(2 * margin, 2 * margin);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"{2} {3} {0} {1}\" font-family=\"DejaVu Sans, Helvetica, Arial, "
      "sans-serif\">\n<title>{4}</title>\n",
      digits(size.x()), digits(size.y()), digits(box.lower.x() - margin), digits(-box.upper.y() - margin),
      html_escaped(title));
  for (const DrawingLayer& layer : drawing.layers) text += group(layer, drawing.shapes);
  return text + "</svg>\n";
}

}  // namespace kempe
