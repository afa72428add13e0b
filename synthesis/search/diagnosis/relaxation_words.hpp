#pragma once
// Values and sentences of what is in the way and what would do, in the unit of the spec's file. Values are rounded to what is
// printed: a person who writes the printed value into the spec gets the spec that was searched.

#include <string>
#include <string_view>

#include "specs/spec.hpp"
#include "specs/unit_words.hpp"

namespace kempe {

/// A length above 0 (mm) to four digits in the unit, not more than it is.
double rounded_down(double length, SpecUnit unit);
/// To the six digits that sentences print, not less than it is.
double rounded_up(double length, SpecUnit unit);
/// The next size that a maker would ask for, not less than a length (mm): whole millimetres, half ones below ten, tenths below one;
/// sixteenths of an inch, 32nds below ten of them, 128ths below one.
double next_size(double length, SpecUnit unit);
/// The next play that a maker would ask for, not more than a length above 0 (mm): of two digits, the second one 0 or 5 from 2 on.
double next_smaller(double length, SpecUnit unit);
/// A length (mm) to six digits: "12.5"; "0.492126" in inches.
std::string six_digits(double length, SpecUnit unit);
/// A place (mm) as a spec states it: "(12.5, -3) mm".
std::string place_text(const Point& place, SpecUnit unit);
/// "two holes of 6 mm with a wall of 0.6 mm between them stand 6.6 mm apart"
std::string holes_sentence(const Spec& spec, SpecUnit unit);
/// "limits.clearance_mm = 2 is in the way; 1.5 would do", of lengths in mm.
std::string length_would_do(const std::string& key, double demanded, double possible, SpecUnit unit);
/// "links.sections_mm has none that is stiff enough; with 20 x 5 added a design exists"
std::string section_would_do(const LinkSection& section, SpecUnit unit);
/// "links.layers = 2 is in the way; 3 would do", with the values in the key's own unit.
std::string would_do(const std::string& key, double demanded, double possible);
/// "links.grid_mm is in the way; without it a design exists"
std::string without_it(const std::string& key, SpecUnit unit);
/// What follows the sentence of a change that need not be the least.
inline constexpr std::string_view may_be_smaller =
    " (a smaller change may do: the search for the least ended early)";

}  // namespace kempe
