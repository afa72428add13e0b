#include "reports/data/error_budget_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "geometry/fixed_text.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

double nine_digits(double length) { return with_digits(length, 9); }

Json values_of(const BudgetChange& change) {
  return {{"change", change.words},
          {"after_mm", nine_digits(change.after)},
          {"needs_other_lengths", change.needs_other_lengths}};
}

}  // namespace

Json error_budget_values(const ErrorBudget& budget) {
  Json sources = Json::array();
  for (const BudgetEntry& entry : budget.entries) {
    Json changes = Json::array();
    for (const BudgetChange& change : entry.changes) changes.push_back(values_of(change));
    sources.push_back({{"source", name(entry.source)},
                       {"in_plane", is_in_plane(entry.source)},
                       {"error_mm", nine_digits(entry.error)},
                       {"would_help", std::move(changes)}});
  }
  Json most = Json::object();
  const auto add = [&](const char* key, const std::optional<BestChange>& best) {
    if (!best) return;
    most[key] = values_of(best->change);
    most[key]["before_mm"] = nine_digits(best->before);
  };
  add("in_plane", budget.best_in_plane);
  add("down", budget.best_down);
  add("give", budget.best_against_give);
  return {{"in_plane_mm", nine_digits(budget.sum(true))},
          {"down_mm", nine_digits(budget.sum(false))},
          {"give_mm", nine_digits(budget.give)},
          {"states_layers", budget.states_layers},
          {"sources", std::move(sources)},
          {"would_help_most", std::move(most)}};
}

}  // namespace kempe
