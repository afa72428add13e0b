#pragma once
// The unit of a spec's lengths: millimetres, or inches with units = "in" at its top. For sources that read TOML only.

#include <string>
#include <string_view>

#include "specs/spec_keys.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// What `units` at the top of a spec says; mm without it, and where it says anything else than "mm" or "in".
SpecUnit spec_unit_of(const toml::table& spec);

/// The name of a key as the table of keys has it, from a spec in `unit`: "width_mm" for "width_in" of a spec in inches.
std::string name_in_mm(std::string_view name, SpecUnit unit);
/// The way back: "links.width_in" for "links.width_mm" of a spec in inches.
std::string name_in(SpecUnit unit, std::string_view dotted_name);

/// A spec in inches as one in millimetres, its lines kept: the keys end in _mm, and every number in their values, however deep,
/// is 25.4 times as large. Keys that end otherwise stay as they are.
void to_millimetres(toml::table& spec);

}  // namespace kempe
