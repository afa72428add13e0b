#include "synthesis/problem/requirements.hpp"

#include <algorithm>
#include <array>
#include <variant>

namespace kempe {

Requirements requirements_of(const Spec& spec) {
  Requirements limits{spec.limits};
  limits.shortest = least_joint_distance(spec);
  limits.longest = largest_joint_distance(spec);
  return limits;
}

Spec with_limits(Spec spec, const Requirements& limits) {
  spec.limits = static_cast<const Limits&>(limits);
  spec.links.longest = limits.longest;
  if (auto& strip = spec.limits.longest_strip)
    *strip = std::max(
        *strip, limits.longest + spec.links.style.width);  // a limit moved is not held back by the strip
  return spec;
}

namespace {

/// What a goal is, in a line.
struct GoalFacts {
  Goal goal;
  std::string_view name;
  bool is_maximized;
  std::optional<Objective> objective;
  double Attained::*attained;
  std::variant<double Requirements::*, std::optional<double> Requirements::*> limit;
};

constexpr auto none = std::nullopt;
constexpr std::array<GoalFacts, 12> goals{{
    {Goal::size, "size", false, Objective::size, &Attained::size, &Requirements::size},
    {Goal::transmission, "transmission", true, Objective::transmission, &Attained::transmission,
     &Requirements::transmission},
    {Goal::copy_error, "copy_error", false, Objective::copy_error, &Attained::copy_error,
     &Requirements::copy_error},
    {Goal::footprint, "footprint", false, Objective::footprint, &Attained::footprint,
     &Requirements::footprint},
    {Goal::load_error, "load_error", false, Objective::load_error, &Attained::load_error,
     &Requirements::load_error},
    {Goal::mass, "mass", false, Objective::mass, &Attained::mass, &Requirements::mass},
    {Goal::sag, "sag", false, none, &Attained::sag, &Requirements::sag},
    {Goal::clearance, "clearance", true, none, &Attained::clearance, &Requirements::clearance},
    {Goal::shortest, "shortest", true, none, &Attained::shortest, &Requirements::shortest},
    {Goal::longest, "longest", false, none, &Attained::longest, &Requirements::longest},
    {Goal::copy_gap, "sheets_gap", true, none, &Attained::copy_gap, &Requirements::copy_gap},
    {Goal::pole_margin, "pole_margin", false, none, &Attained::pole_margin, &Requirements::pole_margin},
}};

const GoalFacts& facts(Goal goal) { return goals[static_cast<std::size_t>(goal)]; }

}  // namespace

std::string_view name(Goal goal) { return facts(goal).name; }

bool is_maximized(Goal goal) { return facts(goal).is_maximized; }

Goal goal_of(Objective objective) {
  return std::find_if(goals.begin(), goals.end(),
                      [&](const GoalFacts& each) { return each.objective == objective; })
      ->goal;
}

std::optional<Objective> objective_of(Goal goal) { return facts(goal).objective; }

std::optional<double> limit_on(const Requirements& limits, Goal goal) {
  return std::visit([&](auto limit) -> std::optional<double> { return limits.*limit; }, facts(goal).limit);
}

Requirements with_limit(Requirements limits, Goal goal, double value) {
  std::visit([&](auto limit) { limits.*limit = value; }, facts(goal).limit);
  return limits;
}

double Attained::of(Goal goal) const { return this->*facts(goal).attained; }

}  // namespace kempe
