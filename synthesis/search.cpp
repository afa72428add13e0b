#include "synthesis/search.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "synthesis/choice_search.hpp"
#include "synthesis/nlopt_backend.hpp"

namespace kempe {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<Choice> all_choices(const Spec& spec) {
  std::vector<Choice> choices;
  for (const Vertex vertex : spec.objective.groundings) {
    const int count = static_cast<int>(assemblies(shape_of(spec.copy.k, vertex)).size());
    for (int assembly = 0; assembly < count; ++assembly)
      for (const LayerAssignment& layers : layer_assignments(spec.links.layers))
        choices.push_back({vertex, assembly, layers});
  }
  return choices;
}

}  // namespace

SearchOutcome synthesize(const Spec& spec, const SearchOptions& options) {
  const auto start = Clock::now();
  const StopFlag stop = [&] {
    return (options.stop && options.stop->load()) ||
           std::chrono::duration<double>(Clock::now() - start).count() > options.time_limit;
  };
  const SearchSpace space(spec);
  const Requirements limits = requirements_of(spec);
  const Goal goal = goal_of(spec.objective.objective);
  ChoiceResult best = no_result();
  Choice best_choice;
  std::uint64_t evaluations = 0;
  for (const Choice& choice : all_choices(spec)) {
    const auto linkage = CopyingLinkage::make(spec.copy.k, choice.vertex, 1, 1, choice.assembly);
    if (!linkage || stop()) continue;
    const Reach reach(spec.copy.k, choice.vertex, choice.assembly);
    const DesignProblem problem(space, choice, limits, goal,
                                openings_with_transmission(reach, limits.transmission),
                                gap_terms(*linkage, choice.layers, spec.links.style));
    const ChoiceResult found =
        search_choice(problem, {.evaluations = problem.layout().pole_is_free ? 600 : 200,
                                .seed = options.seed,
                                .hints = {},
                                .stop = stop});
    evaluations += found.evaluations;
    if (better(found, best)) best = found, best_choice = choice;
  }
  if (!best.feasible) {
    if (stop()) return Stopped{evaluations};
    return NoDesign{.requirement = "limits",
                    .sentence = "no design keeps all limits",
                    .relaxations = {},
                    .evaluations = evaluations};
  }
  const auto linkage =
      CopyingLinkage::make(spec.copy.k, best_choice.vertex, std::exp(best.point.lengths.u),
                           std::exp(best.point.lengths.v), best_choice.assembly, best.point.pole);
  FoundDesign design{.linkage = *linkage, .layers = best_choice.layers, .goal = goal};
  design.value = is_maximized(goal) ? -best.cost : best.cost;
  design.opening = linkage->openings_with_transmission(limits.transmission);
  const Reach reach(spec.copy.k, best_choice.vertex, best_choice.assembly);
  const DesignProblem problem(space, best_choice, limits, goal,
                              openings_with_transmission(reach, limits.transmission),
                              gap_terms(*linkage, best_choice.layers, spec.links.style));
  design.attained = problem.assess(best.point, 129).attained;
  design.solvers = {nlopt_name() + " DIRECT-L", nlopt_name() + " CRS2", nlopt_name() + " SLSQP"};
  design.evaluations = evaluations;
  design.seed = options.seed;
  design.complete = !stop();
  return design;
}

}  // namespace kempe
