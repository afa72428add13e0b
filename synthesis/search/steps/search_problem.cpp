#include "synthesis/search/steps/search_problem.hpp"

#include <map>
#include <utility>

#include "synthesis/problem/obstacle_reach.hpp"
#include "synthesis/problem/slack.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe {
namespace {

/// The openings at which transmission and copy error keep their limits: one interval, or several.
std::vector<OpeningInterval> allowed_openings(const Spec& spec, const Choice& choice,
                                              const Requirements& limits) {
  const Reach reach(spec.copy.k(), choice.grounding, choice.assembly_mode);
  const OpeningInterval usable = openings_with_transmission(reach, limits.transmission);
  if (!limits.copy_error || !spec.tolerance || usable.empty()) return {usable};
  const CopyErrorProfile profile(spec.copy.k(), choice.grounding, CopyTolerance::uniform(*spec.tolerance));
  std::vector<OpeningInterval> allowed;
  for (const OpeningInterval& within : profile.openings_within(*limits.copy_error, usable))
    if (const OpeningInterval inside = shrink(within, slack::inward_opening); !inside.empty())
      allowed.push_back(inside);
  return allowed;
}

}  // namespace

bool are_alike(const Subproblem& a, const Subproblem& b) {
  const Choice &one = a.choice->choice, &other = b.choice->choice;
  return one.grounding == other.grounding && one.assembly_mode == other.assembly_mode &&
         a.allowed.lower == b.allowed.lower;
}

SearchProblem::SearchProblem(const Spec& spec) : SearchProblem(spec, requirements_of(spec)) {}

SearchProblem::SearchProblem(const Spec& spec, const Requirements& widest)
    : spec_(spec), widest_(widest), space_(with_obstacles_in_reach(spec, widest)),
      choices_(choices_of(space_.spec())) {}

std::size_t SearchProblem::obstacles_out_of_reach() const {
  return spec_.obstacles.size() - space_.spec().obstacles.size();
}

bool SearchProblem::covers(const Requirements& limits) const {
  return obstacles_out_of_reach() == 0 ||
         (limits.longest <= widest_.longest && limits.clearance <= widest_.clearance &&
          limits.pole_margin <= widest_.pole_margin);
}

std::vector<Subproblem> SearchProblem::subproblems(const Requirements& limits, Goal goal) const {
  return subproblems(limits, goal, goal == Goal::footprint || limits.footprint);
}

std::vector<Subproblem> SearchProblem::subproblems_with_mirror_images(const Requirements& limits,
                                                                      Goal goal) const {
  return subproblems(limits, goal, true);
}

std::vector<Subproblem> SearchProblem::subproblems(const Requirements& limits, Goal goal,
                                                   bool mirror_images) const {
  std::vector<Subproblem> all;
  std::map<std::pair<Grounding, int>, std::vector<OpeningInterval>> known;  // whatever the layers
  const auto allowed_of = [&](const Choice& choice) -> const std::vector<OpeningInterval>& {
    const auto [at, is_new] = known.try_emplace({choice.grounding, choice.assembly_mode});
    if (is_new) at->second = allowed_openings(spec_, choice, limits);
    return at->second;
  };
  for (const ContactChoice& choice : choices_)
    for (const OpeningInterval& allowed : allowed_of(choice.choice)) {
      if (choice.is_mirror_image && !mirror_images) continue;
      auto problem =
          std::make_unique<DesignProblem>(space_, choice.choice, limits, goal, allowed, choice.terms);
      if (problem->possible()) all.push_back({&choice, allowed, std::move(problem)});
    }
  return all;
}

}  // namespace kempe
