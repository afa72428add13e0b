#include "reports/drawings/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/complex_vectors.hpp"

namespace kempe {
namespace {

/// A box that grows with what it is shown.
class Extent {
 public:
  void include(const Point& point) {
    lower_ = lower_.cwiseMin(point);
    upper_ = upper_.cwiseMax(point);
  }
  void include(const Box& box) {
    include(box.lower);
    include(box.upper);
  }
  Box box() const {
    return lower_.x() <= upper_.x() ? Box{lower_, upper_} : Box{Point::Zero(), Point::Zero()};
  }

 private:
  static constexpr double far = std::numeric_limits<double>::infinity();
  Point lower_{far, far}, upper_{-far, -far};
};

/// The arc's points farthest right, up, left and down, where the sweep passes them.
void include_arc(Extent& extent, const Point& from, const Point& to, double bulge) {
  const Complex a = as_complex(from), b = as_complex(to);
  const Complex centre = arc_centre(a, b, bulge);
  const double radius = std::abs(a - centre), sweep = 4 * std::atan(bulge), start = std::arg(a - centre);
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = quarter * (pi / 2);
    double along = std::remainder(angle - start, 2 * pi);
    if (sweep > 0 && along < 0) along += 2 * pi;
    if (sweep < 0 && along > 0) along -= 2 * pi;
    if (std::abs(along) <= std::abs(sweep)) extent.include(as_point(centre + std::polar(radius, angle)));
  }
}

Box box_of(const OutlineShape& outline) { return bounding_box(outline.ring); }

Box box_of(const CircleShape& circle) {
  const Point reach(circle.radius, circle.radius);
  return {circle.centre - reach, circle.centre + reach};
}

Box box_of(const TextShape& text) {
  const Point along = as_point(std::polar(text_width(text), text.turn));
  const Point up = as_point(std::polar(text.height, text.turn + pi / 2));
  const Point start = text.anchor == Anchor::left ? text.at : Point(text.at - 0.5 * along);
  Extent extent;
  for (const Point& corner : {start, Point(start + along), Point(start + up), Point(start + along + up)})
    extent.include(corner);
  return extent.box();
}

}  // namespace

Box bounding_box(const ArcRing& ring) {
  Extent extent;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    extent.include(ring[i].at);
    if (ring[i].bulge != 0) include_arc(extent, ring[i].at, ring[(i + 1) % ring.size()].at, ring[i].bulge);
  }
  return extent.box();
}

Box bounding_box(const Drawing& drawing) {
  Extent extent;
  for (const Shape& shape : drawing.shapes)
    extent.include(std::visit([](const auto& one) { return box_of(one); }, shape));
  return extent.box();
}

double text_width(const TextShape& text) {
  // Sans-serif letters are about 0.85 of a capital's height wide, gaps included.
  const auto characters =
      std::count_if(text.text.begin(), text.text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return 0.85 * text.height * static_cast<double>(characters);
}

Point placed(const Point& point, const Placement& placement) {
  // Unturned parts keep every digit.
  if (placement.turn == 0) return point + placement.move;
  return as_point(as_complex(point) * copy_ratio(1, placement.turn)) + placement.move;
}

ArcRing placed(const ArcRing& ring, const Placement& placement) {
  ArcRing result = ring;
  for (ArcVertex& vertex : result) vertex.at = placed(vertex.at, placement);
  return result;
}

Shape placed(const Shape& shape, const Placement& placement) {
  Shape result = shape;
  if (auto* outline = std::get_if<OutlineShape>(&result)) outline->ring = placed(outline->ring, placement);
  if (auto* circle = std::get_if<CircleShape>(&result)) circle->centre = placed(circle->centre, placement);
  if (auto* text = std::get_if<TextShape>(&result)) {
    text->at = placed(text->at, placement);
    text->turn += placement.turn;
  }
  return result;
}

void append(Drawing& drawing, const Drawing& other, const Placement& placement) {
  for (const DrawingLayer& layer : other.layers)
    if (std::none_of(drawing.layers.begin(), drawing.layers.end(),
                     [&](const DrawingLayer& known) { return known.name == layer.name; }))
      drawing.layers.push_back(layer);
  for (const Shape& shape : other.shapes) drawing.shapes.push_back(placed(shape, placement));
}

int decimals_for(double size) {
  constexpr int digits = 13, least = 12, most = 30;
  if (!(size > 0)) return least;
  return std::clamp(digits - static_cast<int>(std::ceil(std::log10(size))), least, most);
}

}  // namespace kempe
