#include "synthesis/search/diagnosis/movable_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/steps/slack.hpp"

namespace kempe {

std::optional<double> value_of(const Requirements& limits, const Spec& spec, Goal goal) {
  return goal == Goal::pole_margin && spec.pole.is_fixed() ? std::nullopt : limit_on(limits, goal);
}

double possible_value(const MovableLimit& limit, double demanded, double attained) {
  const double best = attained / limit.unit, way = std::abs(best - demanded / limit.unit);
  const double of_value = slack::give_of_value * std::abs(best);
  // An error is above 0, of a small instrument perhaps by a few nanometres alone.
  const bool is_of_an_error = limit.goal == Goal::load_error || limit.goal == Goal::copy_error;
  const double least = is_of_an_error ? std::min(slack::least_give, of_value) : slack::least_give;
  const double give = std::max(std::min(of_value, slack::give_of_way * way), least);
  const double digits = std::max(std::log10(give), std::log10(std::abs(best) + give) - 5);
  const double step = std::pow(10, std::floor(digits));
  const bool at_least = is_maximized(limit.goal);
  const double rounded = at_least ? std::floor((best - give) / step) : std::ceil((best + give) / step);
  const double value = rounded * step * limit.unit;
  return at_least ? std::max(value, limit.loosest) : std::min(value, limit.loosest);
}

MovableLimit stated_in(SpecUnit unit, MovableLimit limit) {
  if (limit.goal != Goal::transmission) limit.unit *= in_mm(unit);
  return limit;
}

std::string sentence_of(const MovableLimit& limit, double demanded, double possible, SpecUnit unit) {
  if (limit.goal == Goal::pole_margin)
    return fmt::format("{} is in the way; the pole {} {} outside it would do", name_in(unit, limit.key),
                       six_digits(possible, unit), name(unit));
  return would_do(name_in(unit, limit.key), demanded / limit.unit, possible / limit.unit);
}

}  // namespace kempe
