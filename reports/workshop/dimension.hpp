#pragma once
// Dimensions as ISO 129 draws them: extension lines, filled arrows, the figure above its line, read from below or from the right.

#include <string>

#include "reports/workshop/sheet.hpp"

namespace kempe::workshop {

/// From line to line of parallel dimensions, and from the part to the first, mm.
inline constexpr double dimension_step = 8;

/// A filled arrow with its point at `tip`, pointing along the unit vector `along`.
void draw_arrow(Sheet& sheet, const Point& tip, const Point& along);

/// Between two points, measured along x, on a line at height `y`. Where the figure has no room between the arrows, these stand
/// outside, and the figure before the first point (or behind the second, if `behind`).
void dimension_along_x(Sheet& sheet, const Point& from, const Point& to, double y, const std::string& figure,
                       const Lettering& lettering, bool behind = false);
/// Measured along y, on a line at `x`; the figure is read from the right.
void dimension_along_y(Sheet& sheet, const Point& from, const Point& to, double x, const std::string& figure,
                       const Lettering& lettering, bool behind = false);

/// The axes of a hole: a cross that stands out by this, mm.
inline constexpr double hole_axis_beyond = 1.5;
void draw_hole_axes(Sheet& sheet, const Point& centre, double radius);

/// A text on a shelf, its line led to `target`, which an arrow marks. The shelf begins at `at` and runs to the right, or ends
/// there if `to_left`.
void draw_leader(Sheet& sheet, const std::string& text, const Point& at, const Point& target,
                 const Lettering& lettering, bool to_left = false);

/// An item's number in a circle, led to a dot on the part.
void draw_balloon(Sheet& sheet, int item, const Point& at, const Point& target);
inline constexpr double balloon_radius = 3.5;  ///< mm

}  // namespace kempe::workshop
