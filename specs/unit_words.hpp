#pragma once
// Keys and lengths as a spec in its unit states them: what a person reads can be typed into the file that it is about.

#include <string>
#include <string_view>

#include "specs/spec_keys.hpp"

namespace kempe {

/// The name of a key in a spec of that unit: "links.width_in" for "links.width_mm" of a spec in inches.
std::string name_in(SpecUnit unit, std::string_view dotted_name);

/// A sentence of this program in which the keys are named so; its figures stay as they are.
std::string keys_in(SpecUnit unit, std::string_view sentence);

/// A length (mm) as a number in the unit: "0.75" for 19.05 in inches. The fewest digits that mean it: what was
/// written comes back, and a bound that is told is allowed.
std::string number_in(SpecUnit unit, double length);
/// The same with its unit: "0.75 in".
std::string length_in(SpecUnit unit, double length);

}  // namespace kempe
