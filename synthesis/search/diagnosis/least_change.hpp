#pragma once
// What is the more of use the farther it goes: a size larger, a play smaller. How far is estimated; the least that does is sought about that.

#include <cmath>
#include <optional>
#include <utility>

#include "synthesis/search/diagnosis/relaxations.hpp"

namespace kempe {

/// One value of a spec changed, mm.
struct Changed {
  double value;
  FoundDesign design;  ///< of the spec with that value
  bool is_least;       ///< as in Relaxation
};

/// The first of a few values, at and beyond an estimate, with which there is a design, then less by halving the way back to the spec's own
/// value; nothing if there is none. `estimate(share)`: the value where so many times as much is done as should be needed; `rounded(value)`:
/// the next one that a maker would ask for, no nearer to the spec's own; `with(value)`: the best design with it, if any.
template <typename Estimate, typename Rounded, typename With>
std::optional<Changed> least_change(Questions& questions, double given, const Estimate& estimate,
                                    const Rounded& rounded, const With& with) {
  const auto is_farther = [&](double one, double other) {
    return std::abs(one - given) > std::abs(other - given);
  };
  double too_little = given;
  std::optional<Changed> enough;
  for (const double share : questions.budget().stiffer) {
    if (enough || questions.stopped()) break;
    const double value = rounded(estimate(share));
    if (!is_farther(value, too_little)) continue;
    if (auto design = with(value))
      enough = Changed{value, *std::move(design), false};
    else
      too_little = value;
  }
  while (enough && !enough->is_least && !questions.stopped()) {
    const double value = rounded(0.5 * (too_little + enough->value));
    if (!is_farther(enough->value, value))
      enough->is_least = true;
    else if (auto design = with(value))
      enough = Changed{value, *std::move(design), false};
    else
      too_little = value;
  }
  return enough;
}

}  // namespace kempe
