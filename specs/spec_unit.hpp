#pragma once
// The unit of a spec's lengths: millimetres, or inches with units = "in" at its top. For sources that read TOML only.

#include <string>
#include <string_view>

#include "specs/spec_keys.hpp"
#include "specs/text/toml_access.hpp"
#include "specs/unit_words.hpp"

namespace kempe {

/// What `units` at the top of a spec says; mm without it, and where it says anything else than "mm" or "in".
SpecUnit spec_unit_of(const toml::table& spec);

/// The name of a key as the table of keys has it, from a spec in `unit`: "width_mm" for "width_in" of a spec in inches. The way
/// back is name_in().
std::string name_in_mm(std::string_view name, SpecUnit unit);

/// A spec in inches as one in millimetres, its lines kept: the keys end in _mm, and every number in their values, however deep,
/// is 25.4 times as large. Keys that end otherwise stay as they are.
void to_millimetres(toml::table& spec);

}  // namespace kempe
