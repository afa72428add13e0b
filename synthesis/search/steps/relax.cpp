#include "synthesis/search/steps/relax.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/parallel.hpp"
#include "synthesis/search/steps/promising_poles.hpp"
#include "synthesis/search/steps/rank.hpp"

namespace kempe {
namespace {

void remember(std::vector<Prospect>& prospects, const std::vector<RelaxedDesign>& known) {
  for (Prospect& prospect : prospects) {
    const Choice& choice = prospect.subproblem.choice->choice;
    for (const RelaxedDesign& one : known)
      if (choice.grounding == one.grounding && choice.assembly_mode == one.assembly_mode)
        prospect.known.push_back({{std::log(one.VA), std::log(one.VB)}, one.pole});
  }
}

/// Indices of prospects that differ in their layers alone, in groups.
std::vector<std::vector<std::size_t>> alike_in(const std::vector<Prospect>& prospects) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < prospects.size(); ++i) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& indices) {
      return are_alike(prospects[indices.front()].subproblem, prospects[i].subproblem);
    });
    if (group == groups.end())
      groups.push_back({i});
    else
      group->push_back(i);
  }
  return groups;
}

/// Solves the problem without contact. `without_load`: what it comes to without the limit on the load error, after which the same poles are
/// promising.
void relax_one(const SearchTask& task, Prospect& prospect, const ChoiceResult* without_load = nullptr) {
  const Subproblem& sub = prospect.subproblem;
  const DesignProblem problem(task.space(), sub.choice->choice, task.limits, task.goal, sub.allowed, {});
  if (!without_load)
    prospect.poles = promising_poles(problem, task.budgets().pole, task.budgets().local, task.stop());
  const ChoiceBudgets& budgets = task.budgets().choice;
  const bool pole_is_free = task.space().layout().pole_is_free;
  ChoiceOptions options = choice_options(task, without_load ? budgets.without_contact_under_load(pole_is_free)
                                                            : budgets.without_contact(pole_is_free));
  if (without_load) {
    options.hints.push_back(without_load->point);
    options.bound = without_load->cost;
  }
  for (const Point& pole : prospect.poles)
    for (const double of_lambda : {0.0, 1.0})
      options.hints.push_back({problem.unit_lengths(pole, of_lambda, 0), pole});
  options.hints.insert(options.hints.end(), prospect.known.begin(), prospect.known.end());
  prospect.relaxed = search_choice(problem, options);
}

/// With the limit on the load error, if any design without contact and without that limit is feasible.
void relax_one_under_load(const SearchTask& task, Prospect& prospect) {
  prospect.lacks_load_limit = false;
  if (const ChoiceResult without_load = prospect.relaxed; without_load.feasible)
    relax_one(task, prospect, &without_load);
}

/// What is known of one without contact, for another that differs from it in its layers alone.
void learn_from(const Prospect& alike, Prospect& prospect) {
  prospect.relaxed = alike.relaxed;
  prospect.poles = alike.poles;
  prospect.lacks_load_limit = alike.lacks_load_limit;
}

/// With the limit on the load error, for all that differ from the first in their layers alone.
void relax_first_under_load(const SearchTask& task, std::span<Prospect> order) {
  Prospect& first = order.front();
  relax_one_under_load(task, first);
  for (Prospect& other : order.subspan(1))
    if (other.lacks_load_limit && are_alike(other.subproblem, first.subproblem)) learn_from(first, other);
}

}  // namespace

std::vector<Prospect> prospects_of(const SearchTask& task, std::vector<Subproblem> subproblems,
                                   const std::vector<RelaxedDesign>& known) {
  std::vector<Prospect> prospects;
  for (Subproblem& sub : subproblems) prospects.push_back({std::move(sub)});
  remember(prospects, known);
  const auto groups = alike_in(prospects);
  const std::optional<SearchTask> at_first = without_load_limit(task);
  run_parallel(groups.size(), task.control.options().threads, [&](std::size_t i) {
    Prospect& first = prospects[groups[i].front()];
    relax_one(at_first ? *at_first : task, first);
    if (at_first) relax_one_under_load(task, first);
    for (const std::size_t other : groups[i]) learn_from(first, prospects[other]);
  });
  return prospects;
}

void relax_rest_under_load(const SearchTask& task, std::vector<Prospect>& prospects) {
  const auto groups = alike_in(prospects);
  run_parallel(groups.size(), task.control.options().threads, [&](std::size_t i) {
    Prospect& first = prospects[groups[i].front()];
    if (!first.lacks_load_limit) return;
    relax_one_under_load(task, first);
    for (const std::size_t other : groups[i]) learn_from(first, prospects[other]);
  });
}

void sort_by_choice(std::span<Prospect> prospects) {
  std::stable_sort(prospects.begin(), prospects.end(), [](const Prospect& a, const Prospect& b) {
    const Subproblem &one = a.subproblem, &other = b.subproblem;
    return std::pair(one.choice, one.allowed.lower) < std::pair(other.choice, other.allowed.lower);
  });
}

void sort_by_promise(std::span<Prospect> prospects) {
  std::stable_sort(prospects.begin(), prospects.end(),
                   [](const Prospect& a, const Prospect& b) { return better(a.relaxed, b.relaxed); });
}

std::vector<Prospect> relax(const SearchTask& task, const std::vector<RelaxedDesign>& known) {
  std::vector<Prospect> prospects = prospects_of(task, task.subproblems(), known);
  sort_by_promise(prospects);
  return prospects;
}

std::vector<Prospect> relax_without_load(const SearchTask& task, const std::vector<RelaxedDesign>& known) {
  const std::optional<SearchTask> without = without_load_limit(task);
  if (!without) return relax(task, known);
  std::vector<Prospect> prospects = prospects_of(*without, task.subproblems(), known);
  for (Prospect& prospect : prospects) prospect.lacks_load_limit = true;
  sort_by_promise(prospects);
  return prospects;
}

bool may_beat(const Prospect& prospect, const ChoiceResult& best) {
  return !best.feasible || (prospect.relaxed.feasible && rank(prospect.relaxed.cost) < rank(best.cost));
}

std::uint64_t relax_under_load(const SearchTask& task, std::span<Prospect> order, const ChoiceResult& best) {
  std::uint64_t evaluations = 0;
  while (order.front().lacks_load_limit && order.front().relaxed.feasible && may_beat(order.front(), best) &&
         !task.stopped()) {
    relax_first_under_load(task, order);
    evaluations += order.front().relaxed.evaluations;
    sort_by_promise(order);
  }
  return evaluations;
}

}  // namespace kempe
