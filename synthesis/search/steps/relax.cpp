#include "synthesis/search/steps/relax.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/search/steps/promising_poles.hpp"
#include "synthesis/solvers/parallel.hpp"

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

/// Solves the problem without contact.
void relax_one(const SearchTask& task, Prospect& prospect) {
  const Subproblem& sub = prospect.subproblem;
  const DesignProblem problem(task.space(), sub.choice->choice, task.limits, task.goal, sub.allowed, {});
  prospect.poles = promising_poles(problem, task.budgets().pole, task.budgets().local, task.stop());
  ChoiceOptions options =
      choice_options(task, task.budgets().choice.without_contact(task.space().layout().pole_is_free));
  for (const Point& pole : prospect.poles)
    for (const double of_lambda : {0.0, 1.0})
      options.hints.push_back({problem.unit_lengths(pole, of_lambda, 0), pole});
  options.hints.insert(options.hints.end(), prospect.known.begin(), prospect.known.end());
  prospect.relaxed = search_choice(problem, options);
}

}  // namespace

std::vector<Prospect> prospects_of(const SearchTask& task, std::vector<Subproblem> subproblems,
                                   const std::vector<RelaxedDesign>& known) {
  std::vector<Prospect> prospects;
  for (Subproblem& sub : subproblems) prospects.push_back({std::move(sub)});
  remember(prospects, known);
  const auto groups = alike_in(prospects);
  run_parallel(groups.size(), task.control.options().threads, [&](std::size_t i) {
    const Prospect& first = prospects[groups[i].front()];
    relax_one(task, prospects[groups[i].front()]);
    for (const std::size_t other : groups[i]) {
      prospects[other].relaxed = first.relaxed;
      prospects[other].poles = first.poles;
    }
  });
  return prospects;
}

void sort_by_promise(std::vector<Prospect>& prospects) {
  std::stable_sort(prospects.begin(), prospects.end(),
                   [](const Prospect& a, const Prospect& b) { return better(a.relaxed, b.relaxed); });
}

std::vector<Prospect> relax(const SearchTask& task, const std::vector<RelaxedDesign>& known) {
  std::vector<Prospect> prospects = prospects_of(task, task.subproblems(), known);
  sort_by_promise(prospects);
  return prospects;
}

}  // namespace kempe
