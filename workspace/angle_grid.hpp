#pragma once
// The integer grid of the map's two angles: bearing across, opening upwards.

#include <cstdint>

#include "kinematics/copying_linkage.hpp"

namespace kempe {

/// A rectangle of the grid, in grid units; both sides powers of two.
struct GridCell {
  std::uint32_t x, y, width, height;
  std::uint32_t right() const { return x + width; }
  std::uint32_t top() const { return y + height; }
  bool operator==(const GridCell&) const = default;
};

/// Openings of one interval and all bearings, cut into units: a cell is an annular sector of the tracer's
/// plane, bounded by arcs about the pole and by radial segments.
class AngleGrid {
 public:
  static constexpr std::uint32_t turn = 1u << 31;  ///< units of a whole turn of the bearing
  static constexpr std::uint32_t rise = 1u << 30;  ///< units of the interval of openings
  /// No cell is smaller: corners can be cut by a unit without being seen.
  static constexpr std::uint32_t smallest = 1u << 4;

  AngleGrid(const CopyingLinkage& linkage, const OpeningInterval& openings);

  const OpeningInterval& openings() const { return openings_; }
  const CopyingLinkage& linkage() const { return linkage_; }

  double opening(double y) const;  ///< rad; exactly the interval's ends at 0 and rise
  double radius(double y) const { return linkage_.radius_at(opening(y)); }  ///< mm
  static double bearing(double x) { return x * (2 * pi / turn); }           ///< rad
  /// The tracer's place, table frame, mm.
  Point place(double x, double y) const;

  /// Area of a cell in the tracer's plane, mm^2: exact up to rounding.
  double area(const GridCell& cell) const {
    return area_per_bearing(cell.y, cell.height) * bearing(cell.width);
  }
  /// That of a cell with these openings over its bearings' width, mm^2/rad.
  double area_per_bearing(std::uint32_t y, std::uint32_t height) const;

 private:
  CopyingLinkage linkage_;
  OpeningInterval openings_;
  double area_scale_;  // 2 VA m / n^2 of area_per_bearing(), mm^2
  double dead_;        // arg s
};

}  // namespace kempe
