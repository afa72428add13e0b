#include "synthesis/problem/requirements.hpp"

namespace kempe {

Requirements requirements_of(const Spec& spec) {
  return {.transmission = spec.limits.transmission,
          .clearance = spec.limits.clearance,
          .shortest = least_joint_distance(spec),
          .longest = spec.links.longest,
          .sheets_gap = spec.limits.sheets_gap,
          .copy_error = spec.limits.copy_error};
}

std::string_view name(Goal goal) {
  switch (goal) {
    case Goal::size: return "size";
    case Goal::transmission: return "transmission";
    case Goal::copy_error: return "copy_error";
    case Goal::footprint: return "footprint";
    case Goal::clearance: return "clearance";
    case Goal::shortest: return "shortest";
    case Goal::longest: return "longest";
    case Goal::sheets_gap: return "sheets_gap";
    case Goal::pole_margin: return "pole_margin";
  }
  return "";
}

bool is_maximized(Goal goal) {
  return goal == Goal::transmission || goal == Goal::clearance || goal == Goal::shortest ||
         goal == Goal::sheets_gap;
}

Goal goal_of(Objective objective) {
  switch (objective) {
    case Objective::size: return Goal::size;
    case Objective::transmission: return Goal::transmission;
    case Objective::copy_error: return Goal::copy_error;
    case Objective::footprint: break;
  }
  return Goal::footprint;
}

double Attained::of(Goal goal) const {
  switch (goal) {
    case Goal::size: return size;
    case Goal::transmission: return transmission;
    case Goal::copy_error: return copy_error;
    case Goal::footprint: return footprint;
    case Goal::clearance: return clearance;
    case Goal::shortest: return shortest;
    case Goal::longest: return longest;
    case Goal::sheets_gap: return sheets_gap;
    case Goal::pole_margin: break;
  }
  return pole_margin;
}

}  // namespace kempe
