#pragma once
// Whether the instrument bears its load, in words for summary, report and workshop.

#include <optional>
#include <string>
#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// MPa: in the link that is strained most, with bending and twist out of the plane where that is stated. Of a design with a load.
double largest_stress(const Design& design);

/// N: the largest push in either bar under the load, over the openings that the region uses; 0 without a load or where the region is
/// not reached.
double largest_push_in_bars(const Design& design);

/// N: the push at which the longer bar buckles. Of a design with a material.
double buckling_load_of_bars(const Design& design);

/// A sentence each: a hole that leaves nothing of a link; links stressed beyond the material's strength; bars pushed beyond their buckling
/// load; then which section would bear it, if one does. Empty where the instrument bears its load, and without a load.
std::vector<std::string> overload_words(const Design& design);

/// That links bend so far that figures of small bending are no longer right; nothing where they do not, and without a load.
std::optional<std::string> large_bending_words(const Design& design);

/// "pins and layers", or with "the links' own weight": what a load error of the links alone lacks.
std::string beside_the_links(const Design& design);
/// True if the limit on the load error, which speaks of the links alone, is kept by them, and with all that is beside them the pen gives way
/// too far for it.
bool gives_too_far_in_all(const Design& design);

}  // namespace kempe
