#pragma once
// The top of a smooth function over an interval of openings.

#include <algorithm>
#include <array>
#include <cstddef>

#include "kinematics/opening_interval.hpp"
#include "synthesis/solvers/golden_section.hpp"

namespace kempe {

/// The opening at which value(opening) is largest: of evenly spaced ones with the interval's ends those that stand above their neighbours,
/// each refined between these by golden section in so many steps if it comes near the best. A top narrower than the spacing may be missed;
/// forces and deflections change over tens of degrees, and fastest at the ends.
template <class Function>
double top_over(const OpeningInterval& openings, const Function& value, int steps = 18) {
  constexpr std::size_t last = 16;
  constexpr double near_the_best = 0.05;  // of the range of values
  const auto place = [&](std::size_t i) {
    return i == last ? openings.upper
                     : openings.lower + openings.width() * static_cast<double>(i) / static_cast<double>(last);
  };
  std::array<double, last + 1> seen;
  for (std::size_t i = 0; i <= last; ++i) seen[i] = value(place(i));
  const auto [lowest, highest] = std::minmax_element(seen.begin(), seen.end());
  const double worth_it = *highest - near_the_best * (*highest - *lowest);
  double best_value = *highest, best = place(static_cast<std::size_t>(highest - seen.begin()));
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = i == last ? last : i + 1;
    if (seen[i] < worth_it || seen[i] < seen[before] || seen[i] < seen[after]) continue;
    const double refined = top_by_golden_section(value, place(before), place(after), steps);
    if (const double here = value(refined); here > best_value) {
      best = refined;
      best_value = here;
    }
  }
  return best;
}

}  // namespace kempe
