#pragma once
// What searches and fronts ask of a spec beyond what its reader does.

#include <optional>

#include "kempe/input_error.hpp"
#include "kempe/spec.hpp"

namespace kempe {

/// A spec without a region, which a map alone can do without; without file and line.
inline std::optional<InputError> search_fault(const Spec& spec) {
  if (!spec.region.empty()) return std::nullopt;
  return InputError{"", 0, "region", "nothing",
                    "a region for a design; kempe workspace maps a [mechanism] without one"};
}

/// What the two objectives of a front need and the spec does not have, or what fronts do not know; without file and line.
inline std::optional<InputError> front_fault(const Spec& spec, Objective first, Objective second) {
  if (auto fault = search_fault(spec)) return fault;
  const auto seeks = [&](Objective one) { return first == one || second == one; };
  const auto no_table = [](const char* table, const char* allowed) {
    return InputError{"", 0, table, "no such table", allowed};
  };
  if (seeks(Objective::copy_error) && !spec.tolerance)
    return no_table("tolerance", "[tolerance] with length_mm and play_mm, for copy_error");
  if (seeks(Objective::load_error) && !spec.load)
    return no_table("load", "[load] with pen_N, for load_error");
  if (seeks(Objective::load_error) && spec.limits.load_error_in_all)
    return InputError{"", 0, "limits.load_error_in_all", "true",
                      "false: a front's load error is that of the links alone"};
  if (seeks(Objective::mass) && !spec.material) return no_table("material", "[material] with name, for mass");
  if (spec.tolerance && spec.tolerance->robust)
    return InputError{"", 0, "tolerance.robust", "true", "false: fronts are of the instruments as drawn"};
  return std::nullopt;
}

}  // namespace kempe
