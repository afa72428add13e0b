#include "reports/pictures/picture_extent.hpp"

#include <cmath>

namespace kempe {

void PictureExtent::add(const ArcRegion& region) {
  for (const ArcPolygon& polygon : region)
    for (std::size_t i = 0; i < polygon.outer.size(); ++i)
      add_edge(polygon.outer[i], polygon.outer[(i + 1) % polygon.outer.size()].at);
}

void PictureExtent::add_edge(const ArcVertex& from, const Point& to) {
  add(from.at);
  if (from.bulge == 0) return;
  // Points along the arc: half the sweep's tangent gives the arc's rise over the chord.
  const Complex a = as_complex(from.at), chord = as_complex(to) - a;
  const double sweep = 4 * std::atan(from.bulge);
  const Complex centre = a + chord / (1.0 - std::polar(1.0, sweep));
  constexpr int steps = 24;
  for (int i = 1; i < steps; ++i) add(as_point(centre + (a - centre) * std::polar(1.0, sweep * i / steps)));
}

}  // namespace kempe
