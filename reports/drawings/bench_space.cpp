#include "reports/drawings/bench_space.hpp"

#include <cmath>
#include <variant>

#include "geometry/complex_vectors.hpp"
#include "geometry/convex_hull.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

std::vector<Point> corners_of(const Region& region) {
  std::vector<Point> corners;
  for (const Polygon& polygon : region.polygons)
    corners.insert(corners.end(), polygon.outer.begin(), polygon.outer.end());
  return corners;
}

/// Corners around a circle, four sides of which touch it where it is farthest left, right, in front and behind.
std::vector<Point> around(const Disc& disc) {
  constexpr int sides = 64;
  std::vector<Point> corners;
  for (int i = 0; i < sides; ++i)
    corners.push_back(disc.centre +
                      as_point(std::polar(disc.radius / std::cos(pi / sides), 2 * pi * (i + 0.5) / sides)));
  return corners;
}

/// As seen from the point that carries it.
std::vector<Point> around(const Body& body) {
  if (body.turns_with) return around(Disc{Point::Zero(), farthest(body)});
  if (const auto* disc = std::get_if<Disc>(&body.shape)) return around(*disc);
  return std::get<Polygon>(body.shape).outer;
}

}  // namespace

Region swept_outline(const Design& design, const Body& body) {
  if (design.region.empty()) return {};
  // Its point covers all of the original or of the copy.
  const CopyingLinkage& linkage = design.linkage;
  const Region path =
      body.at == Carrier::tracer ? design.region : similar_image(design.region, linkage.k(), linkage.pole());
  std::vector<Point> sums;
  const std::vector<Point> ends = convex_hull(around(body));
  for (const Point& place : convex_hull(corners_of(path)))
    for (const Point& end : ends) sums.push_back(place + end);
  return {{Polygon{convex_hull(std::move(sums)), {}}}};
}

std::optional<Box> swept_box(const Design& design) {
  std::optional<Box> swept;
  const auto add = [&](const Region& region) {
    if (region.empty()) return;
    const Box box = bounding_box(region);
    if (!swept) swept = box;
    swept->lower = swept->lower.cwiseMin(box.lower);
    swept->upper = swept->upper.cwiseMax(box.upper);
  };
  add(design.footprint);
  for (const Body& body : design.bodies) add(swept_outline(design, body));
  return swept;
}

}  // namespace kempe
