#include "synthesis/search/movable_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/search/relaxation_words.hpp"
#include "synthesis/search/steps/tolerances.hpp"

namespace kempe {

std::optional<double> value_of(const Requirements& limits, const Spec& spec, Goal goal) {
  switch (goal) {
    case Goal::transmission: return limits.transmission;
    case Goal::clearance: return limits.clearance;
    case Goal::longest: return limits.longest;
    case Goal::shortest: return limits.shortest;
    case Goal::sheets_gap: return limits.sheets_gap;
    case Goal::copy_error: return limits.copy_error;
    case Goal::pole_margin:
      return spec.pole.is_fixed() ? std::nullopt : std::optional<double>(limits.pole_margin);
    default: return std::nullopt;
  }
}

Requirements moved(Requirements limits, Goal goal, double value) {
  switch (goal) {
    case Goal::transmission: limits.transmission = value; break;
    case Goal::clearance: limits.clearance = value; break;
    case Goal::longest: limits.longest = value; break;
    case Goal::shortest: limits.shortest = value; break;
    case Goal::sheets_gap: limits.sheets_gap = value; break;
    case Goal::copy_error: limits.copy_error = value; break;
    case Goal::pole_margin: limits.pole_margin = value; break;
    default: break;
  }
  return limits;
}

double possible_value(const MovableLimit& limit, double demanded, double attained) {
  const double best = attained / limit.unit, way = std::abs(best - demanded / limit.unit);
  const double give =
      std::max(std::min(tolerance::give_of_value * std::abs(best), tolerance::give_of_way * way),
               tolerance::least_give);
  const double digits = std::max(std::log10(give), std::log10(std::abs(best) + give) - 5);
  const double step = std::pow(10, std::floor(digits));
  const bool at_least = is_maximized(limit.goal);
  const double rounded = at_least ? std::floor((best - give) / step) : std::ceil((best + give) / step);
  const double value = rounded * step * limit.unit;
  return at_least ? std::max(value, limit.loosest) : std::min(value, limit.loosest);
}

std::string sentence_of(const MovableLimit& limit, double demanded, double possible) {
  if (limit.goal == Goal::pole_margin)
    return fmt::format("{} is in the way; the pole {:.6g} mm outside it would do", limit.key, possible);
  return would_do(limit.key, demanded / limit.unit, possible / limit.unit);
}

}  // namespace kempe
