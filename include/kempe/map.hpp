#pragma once
// The map: where the tracer can go, where the real links can follow, and why not elsewhere.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kempe/export.hpp"
#include "kempe/mechanism.hpp"
#include "kempe/point.hpp"

namespace kempe {

struct Design;  // what is inside

/// Whether the tracer can stand at a point.
struct PointVerdict {
  bool free = false;       ///< certainly, the real links included
  bool uncertain = false;  ///< neither proven free nor proven in contact; then free is false
  std::string sentence;    ///< for a person, with figures
};

/// A share of the region, or of the plane, that is lost.
struct Loss {
  std::string cause;               ///< "out of reach", "transmission below the limit", "contact", ...
  std::vector<std::string> parts;  ///< the two parts in contact ("link ACX", "obstacle 2"); else empty
  double area = 0;                 ///< mm^2
};

/// A rectangle that fits the collision-free workspace.
struct SheetThatFits {
  std::string name;              ///< "A4", or "region's proportions"
  double width = 0;              ///< mm
  double height = 0;             ///< mm
  Point centre = Point::Zero();  ///< mm
  double turn = 0;               ///< rad, of the width's direction against the x axis
};

/// The map of one linkage with its parts and surroundings. A value, cheap to copy; all places in the table's frame.
class KEMPE_EXPORT Map {
 public:
  /// True if every point of the region is certainly in one component of the collision-free workspace. False without a
  /// region.
  bool covers_region() const;
  /// Why it is not, a sentence; empty if it is.
  std::string why_not_covered() const;

  double reachable_area() const;       ///< mm^2, within reach of the assembly mode
  double usable_area() const;          ///< mm^2, of that, with the transmission kept
  double collision_free_area() const;  ///< mm^2, of that, certainly without contact
  double uncertain_area() const;       ///< mm^2, neither proven free nor proven in contact

  /// What is within reach, with straight edges around the true set, within `tolerance` (mm, > 0, not NaN) of its arcs. A full
  /// circle has about 2.2 (radius / tolerance)^(1/2) edges; 3e7 (half a gigabyte) at a tolerance of 5e-15 of the radius, and no
  /// more at any finer one, 0 and negative ones included.
  Region reachable(double tolerance) const;
  /// What is certainly free, with straight edges inside the true set, within `tolerance` of its arcs, as above.
  Region collision_free(double tolerance) const;

  /// What is lost of the disc of the outer reach, and to what.
  std::vector<Loss> losses() const;
  /// The largest sheets that fit; none if Options::largest_sheets was false.
  std::vector<SheetThatFits> largest_sheets() const;

  /// The openings over which reach, transmission and contact of the linkage with itself are certified; empty if there are
  /// none.
  OpeningInterval certified_opening() const;

  /// Whether the tracer can stand there, mm, and why not: each limit in turn, in closed form (docs/workspace-map.md). A place
  /// that is not finite is not free; on the pole the posts of pole and tracer would be in one place.
  PointVerdict at(const Point& tracer) const;

  /// False: stopped early. What is called free or lost is, but more is uncertain than asked for.
  bool complete() const;

 private:
  friend class FinishedDesign;
  explicit Map(std::shared_ptr<const Design> inside) : inside_(std::move(inside)) {}
  std::shared_ptr<const Design> inside_;
};

}  // namespace kempe
