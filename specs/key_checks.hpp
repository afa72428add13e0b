#pragma once
// The spec's tables against spec_keys.hpp: unknown keys, wrong units, wrong kinds, values out of range.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "specs/spec_keys.hpp"
#include "specs/text/complaints.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// Checks every table and key of a spec, its lengths in the unit that it says, except for what stands inside rings and pairs.
void check_keys(const toml::table& spec, Complaints& complaints);

/// Checks one table by the rules of `rules` ("rectangle_mm"); `path` is how its keys are called in
/// complaints.
void check_table(const toml::table& table, std::string_view rules, const std::string& path,
                 Complaints& complaints, SpecUnit unit = SpecUnit::mm);

/// True if an unknown key or table at the top level of a spec seems to mean this table.
bool is_meant(const toml::table& spec, std::string_view table);

/// The candidate that `word` seems to mean: the one with the fewest insertions, deletions, replacements and swaps of neighbours
/// away from it, of equals the first. None where that takes more than two of them, or changes half of the word.
std::optional<std::string_view> nearest(std::string_view word,
                                        const std::vector<std::string_view>& candidates);

/// What is allowed in place of a name that is not known: "scale (the nearest known key)"; with none near all of them, "one of
/// the keys scale, rotation_deg". `kind` is "key" or what else the names are of. Empty candidates give "no key".
std::string known_instead(std::string_view word, const std::vector<std::string_view>& candidates,
                          std::string_view kind = "key");

}  // namespace kempe
