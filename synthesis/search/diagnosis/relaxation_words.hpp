#pragma once
// Values and sentences of what is in the way and what would do. Values are rounded to what is printed: a person who writes
// the printed value into the spec gets the spec that was searched.

#include <string>
#include <string_view>

#include "specs/spec.hpp"

namespace kempe {

/// To four digits, not more than the value (above 0).
double rounded_down(double value);
/// To the six digits that sentences print, not less than the value (above 0).
double rounded_up(double value);
/// A place as a spec states it: "(12.5, -3)".
std::string place_text(const Point& place);
/// "two holes of 6 mm with a wall of 0.6 mm between them stand 6.6 mm apart"
std::string holes_sentence(const Spec& spec);
/// "links.layers = 2 is in the way; 3 would do", with the values in the key's own unit.
std::string would_do(const std::string& key, double demanded, double possible);
/// "links.grid_mm is in the way; without it a design exists"
std::string without_it(const std::string& what);
/// What follows the sentence of a change that need not be the least.
inline constexpr std::string_view may_be_smaller =
    " (a smaller change may do: the search for the least ended early)";

}  // namespace kempe
