#pragma once
// The error budget as data: what `kempe synthesize --json` and Python's design.error_budget hold.

#include <nlohmann/json_fwd.hpp>

#include "synthesis/design/error_budget.hpp"

namespace kempe {

/// {"in_plane_mm", "down_mm", "give_mm": as ErrorBudget has them, "states_layers", "sources": [{"source", "in_plane", "error_mm", "would_help":
/// [{"change", "after_mm", "needs_other_lengths"}]}], "would_help_most": {"in_plane", "down", "give": the same with "before_mm", each where
/// something helps}}. Lengths to nine digits.
nlohmann::ordered_json error_budget_values(const ErrorBudget& budget);

}  // namespace kempe
