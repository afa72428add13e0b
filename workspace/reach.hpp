#pragma once
// What a linkage reaches without contact: annuli about the pole, in closed form.

#include <optional>

#include "geometry/arc_polygon.hpp"
#include "kinematics/copying_linkage.hpp"

namespace kempe {

/// The points whose distance from `centre` lies in [inner, outer], mm; empty if inner > outer.
struct Annulus {
  Point centre = Point::Zero();
  double inner = 1, outer = 0;
  bool empty() const { return !(inner <= outer); }
  bool contains(const Point& point) const;
};

/// The tracer's places over an interval of openings: all bearings, all distances between those of the ends.
Annulus annulus_over(const CopyingLinkage& linkage, const OpeningInterval& openings);

/// The reach of the linkage's assembly mode, its dead and change points included.
Annulus reachable_annulus(const CopyingLinkage& linkage);

/// Where the transmission angle is at least `transmission` (rad); empty if nowhere.
Annulus usable_annulus(const CopyingLinkage& linkage, double transmission);

/// What the serial chain V-A-X reaches, whatever the parallelogram does: both assembly modes of one elbow
/// together.
Annulus chain_annulus(const CopyingLinkage& linkage);

/// pi (outer^2 - inner^2), mm^2; 0 if empty.
double area(const Annulus& annulus);

/// The annulus as a polygon of arcs; a disc if inner = 0, nothing if it has no area.
ArcRegion as_region(const Annulus& annulus);

/// The part of `whole` that `part` (inside it, same centre) leaves: nothing, one or two annuli.
ArcRegion difference(const Annulus& whole, const Annulus& part);

/// True if every point of the region lies in the annulus: decided by the nearest and farthest point of the
/// region, so a hole of the region around the annulus's inner circle is no obstacle. Exact up to rounding.
bool covers(const Annulus& annulus, const Region& region);

/// The openings of the assembly mode at which the tracer is as far from the pole as some place of the region; empty if at
/// none. The region must not be empty.
OpeningInterval openings_met(const CopyingLinkage& linkage, const Region& region);

/// The openings that the linkage passes while its tracer covers the region; nothing if the region is empty or
/// the assembly mode does not reach all of it.
std::optional<OpeningInterval> openings_over(const CopyingLinkage& linkage, const Region& region);

}  // namespace kempe
