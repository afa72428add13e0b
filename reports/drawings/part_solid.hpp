#pragma once
// A part as a solid of triangles, for printers and milling programs that take STL.

#include <array>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "reports/drawings/part_drawings.hpp"

namespace kempe {

/// A triangle, its corners counter-clockwise seen from outside, mm.
using Triangle = std::array<Eigen::Vector3d, 3>;
using Solid = std::vector<Triangle>;

/// How far a chord may lie from an arc of that radius, mm: 0.01, and less of a small one, so that a hole is at most half a per cent
/// narrower between its flats than between its corners.
double chord_tolerance(double radius);

/// The part's outline with its holes, standing from z = 0 to its thickness; arcs become chords within chord_tolerance(),
/// `tolerance` (mm, > 0) and half the part's wall, whose corners lie on them. Closed: every edge belongs to two
/// triangles. Empty where floats, which an STL holds, cannot tell a wall's two sides apart, or there is no wall.
Solid part_solid(const CutPart& part, double tolerance = 0.01);

/// Volume enclosed, mm^3; positive if the triangles look outward.
double volume(const Solid& solid);
/// True if every edge is run once in each direction.
bool is_closed(const Solid& solid);

/// Binary STL, little endian; `name` (ASCII) stands in the header.
std::string stl_bytes(const Solid& solid, std::string_view name);
/// A binary STL read back; the error says what is wrong with it.
tl::expected<Solid, std::string> read_stl(std::string_view bytes);

}  // namespace kempe
