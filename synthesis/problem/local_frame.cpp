#include "synthesis/problem/local_frame.hpp"

#include <cmath>

#include "geometry/region_reach.hpp"

namespace kempe {
namespace {

void shift(Ring& ring, const Point& by) {
  for (Point& corner : ring) corner += by;
}

void shift(Polygon& polygon, const Point& by) {
  shift(polygon.outer, by);
  for (Ring& hole : polygon.holes) shift(hole, by);
}

void shift(Region& region, const Point& by) {
  for (Polygon& polygon : region.polygons) shift(polygon, by);
}

/// To a multiple of the largest power of two that is no more than an eighth of `size`: few digits, the same at any scale.
Point rounded(const Point& place, double size) {
  const double step = std::exp2(std::floor(std::log2(size)) - 3);
  return {step * std::floor(place.x() / step + 0.5), step * std::floor(place.y() / step + 0.5)};
}

}  // namespace

Point local_origin(const Spec& spec) {
  if (spec.pole.is_fixed()) return std::get<Point>(spec.pole.place);
  if (spec.region.empty()) return Point::Zero();
  const Box box = bounding_box(spec.region);
  const Point size = box.upper - box.lower;
  return rounded(0.5 * (box.lower + box.upper), size.maxCoeff());
}

Spec shifted(Spec spec, const Point& by) {
  shift(spec.region, by);
  if (spec.pole.is_fixed())
    std::get<Point>(spec.pole.place) += by;
  else
    shift(std::get<Region>(spec.pole.place), by);
  for (Obstacle& obstacle : spec.obstacles) shift(obstacle.shape, by);
  if (spec.table) shift(*spec.table, by);
  return spec;
}

CopyingLinkage shifted(const CopyingLinkage& linkage, const Point& by) {
  return CopyingLinkage::make(linkage.k(), linkage.grounding(), linkage.VA(), linkage.VB(),
                              linkage.assembly_mode().number, linkage.pole() + by)
      .value();
}

}  // namespace kempe
