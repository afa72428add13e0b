#pragma once
// The whole task moved: turned, shifted, enlarged or mirrored, with all that belongs to it.

#include <algorithm>

#include "specs/spec.hpp"

namespace kempe::laws {

/// z -> scale exp(i turn) z + shift, or with the mirror first z -> conj z.
struct Movement {
  double scale = 1, turn = 0;
  Point shift = Point::Zero();
  bool mirror = false;

  Point operator()(const Point& z) const {
    const Complex seen = mirror ? std::conj(as_complex(z)) : as_complex(z);
    return as_point(scale * copy_ratio(1, turn) * seen) + shift;
  }

  Ring operator()(const Ring& ring) const {
    Ring moved;
    for (const Point& point : ring) moved.push_back((*this)(point));
    if (mirror)
      std::reverse(moved.begin() + 1, moved.end());  // it still runs the way it did, from the same corner
    return moved;
  }

  Polygon operator()(const Polygon& polygon) const {
    Polygon moved{(*this)(polygon.outer), {}};
    for (const Ring& hole : polygon.holes) moved.holes.push_back((*this)(hole));
    return moved;
  }

  Region operator()(const Region& region) const {
    Region moved;
    for (const Polygon& polygon : region.polygons) moved.polygons.push_back((*this)(polygon));
    return moved;
  }

  /// The same assembly mode of the mirrored linkage: the intervals of the opening change their signs and so their order.
  int assembly_mode(int index, Complex k, Grounding grounding) const {
    return mirror ? static_cast<int>(assembly_modes(shape_of(k, grounding)).size()) - 1 - index : index;
  }

  Spec operator()(const Spec& spec) const {
    Spec moved = spec;
    if (mirror) moved.copy = Copy::of(std::conj(spec.copy.k()));
    moved.region = (*this)(spec.region);
    if (spec.pole.is_fixed())
      moved.pole.place = (*this)(std::get<Point>(spec.pole.place));
    else
      moved.pole.place = (*this)(std::get<Region>(spec.pole.place));
    for (Obstacle& obstacle : moved.obstacles) obstacle.shape = (*this)(obstacle.shape);
    enlarge(moved.links);
    enlarge(moved.limits);
    if (moved.tolerance)
      moved.tolerance =
          Tolerance{scale * moved.tolerance->length, scale * moved.tolerance->play, moved.tolerance->robust};
    if (moved.mechanism) {
      moved.mechanism->VA *= scale;
      moved.mechanism->VB *= scale;
      moved.mechanism->assembly_mode =
          assembly_mode(spec.mechanism->assembly_mode, spec.copy.k(), spec.mechanism->grounding);
    }
    return moved;
  }

 private:
  void enlarge(LinkSpec& links) const {
    links.style.width *= scale;
    links.style.pin_diameter *= scale;
    links.style.thickness *= scale;
    links.shortest *= scale;
    links.longest *= scale;
    if (links.stock_lengths.grid) *links.stock_lengths.grid *= scale;
    for (double& length : links.stock_lengths.stock) length *= scale;
    for (auto& length : links.stock_lengths.locked)
      if (length) *length *= scale;
  }

  void enlarge(Limits& limits) const {
    limits.clearance *= scale;
    if (limits.copy_gap) *limits.copy_gap *= scale;
    if (limits.copy_error) *limits.copy_error *= scale;
  }
};

}  // namespace kempe::laws
