#pragma once
// The same lengths in other sections and on other pins: the sizes to be had, and what a design keeps with them.

#include <optional>
#include <string>

#include "synthesis/design/design.hpp"

namespace kempe {

/// mm: the next larger width and thickness of flat bars as the trade has them (EN 10058, EN 10278), and diameter of dowel pins (ISO 2338); half as
/// much again beyond the largest. By at least a twentieth.
double next_width(double width);
double next_thickness(double thickness);
double next_pin_diameter(double diameter);

/// "15 x 5 mm": width and thickness.
std::string section_words(const LinkStyle& style);

/// Whether a design with such links and pins, of the same lengths, keeps what its spec limits beside the errors themselves.
bool keeps_the_rest(const Design& design, const LinkStyle& style, const JointHardware& hardware);

/// N: the largest push in VA or VB of a design with a load, over its region and all directions of the force; 0 where the region is not reached. On
/// a tilted table with the weight of links of that section.
double largest_push_in_bars(const Design& design, const LinkStyle& style);

/// The smallest section, wider or thicker by some sizes than the design's, in which the links of a design with load and material bear their
/// stress and its bars do not buckle; nothing if none of the sizes looked at does, or the design's own does.
std::optional<LinkStyle> section_that_bears(const Design& design);

}  // namespace kempe
