#pragma once
// The linkage seen from above, as SVG: links in their layers, pins, pole, tracer and pen.

#include <string>
#include <string_view>

#include "synthesis/design/design.hpp"

namespace kempe {

/// "pole", "tracer" or "pen" for the three homologous points, "" for A, B, C.
std::string_view role(const CopyingLinkage& linkage, Joint joint);

/// The joints that a link's body runs through, in the order of its arms: C-A-X for the bent plate ACX.
std::vector<Joint> body_line(Link link);

/// Width at which a link is drawn, mm: its own, or three nominal pixels (`unit`, mm) if that is more.
double drawn_width(const LinkStyle& style, double unit);
/// Radius at which joints are drawn, mm.
double drawn_pin_radius(const LinkStyle& style, double unit);

/// The corners of a sheet, counter-clockwise, mm.
Ring corners(const FittingSheet& sheet);

/// A link as two strokes over its axis (path data), rim and face so wide. Round caps and joins make exactly the outline of
/// the part: its axis grown by half its width.
std::string rim_and_face(const std::string& axis, double rim, double face);

/// The group <g class="m-mechanism">.
std::string mechanism_svg(const Design& design, const Pose& pose, double unit);

}  // namespace kempe
