#pragma once
// The spec's tables against spec_keys.hpp: unknown keys, wrong units, wrong kinds, values out of range.

#include <string>
#include <string_view>
#include <vector>

#include "specs/text/complaints.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// Checks every table and key of a spec, except for what stands inside rings and pairs.
void check_keys(const toml::table& spec, Complaints& complaints);

/// Checks one table by the rules of `rules` ("rectangle_mm"); `path` is how its keys are called in
/// complaints.
void check_table(const toml::table& table, std::string_view rules, const std::string& path,
                 Complaints& complaints);

/// True if an unknown key or table at the top level of a spec seems to mean this table.
bool is_meant(const toml::table& spec, std::string_view table);

/// The candidate with the fewest insertions, deletions, replacements and swaps of neighbours away from
/// `word`; of equals the first. `candidates` must not be empty.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace kempe
