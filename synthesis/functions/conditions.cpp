#include "synthesis/functions/conditions.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/functions/slack.hpp"
#include "synthesis/solvers/golden_section.hpp"

namespace kempe {
namespace {

constexpr int golden_steps = 28;  ///< to a millionth of a cell: the height there is right to rounding

/// The top of a ripple between two places: golden section.
ErrorRipple top_between(const GeneratorError& error, const GeneratorVector& u, double lower, double upper,
                        int sign) {
  const auto height = [&](double x) { return sign * error.value_at(u, x); };
  const double x = top_by_golden_section(height, lower, upper, golden_steps);
  return {x, height(x), sign};
}

}  // namespace

std::vector<ErrorRipple> ripples_of(const GeneratorError& error, const GeneratorVector& u) {
  const std::vector<WantedPlace>& places = error.wanted().places();
  const std::vector<double> e = error.values(u, places);
  double highest = 0;
  for (const double value : e) highest = std::max(highest, std::abs(value));
  const auto height = [&](std::size_t i) { return std::abs(e[i]); };
  std::vector<ErrorRipple> ripples;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool at_end = i == 0 || i + 1 == places.size();
    if ((i > 0 && height(i - 1) > height(i)) || (i + 1 < places.size() && height(i + 1) >= height(i)))
      continue;
    ErrorRipple ripple{places[i].x, height(i), e[i] < 0 ? -1 : 1};
    if (!at_end && ripple.height > 0.9 * highest) {
      const ErrorRipple top = top_between(error, u, places[i - 1].x, places[i + 1].x, ripple.sign);
      if (top.height > ripple.height) ripple = top;
    }
    ripples.push_back(ripple);
  }
  if (ripples.empty()) ripples.push_back({places.front().x, height(0), e[0] < 0 ? -1 : 1});
  std::stable_sort(ripples.begin(), ripples.end(),
                   [](const ErrorRipple& a, const ErrorRipple& b) { return a.height > b.height; });
  return ripples;
}

namespace {

/// The output crank turns back by no more than is allowed: the worst retreat, its ends moved to where it is largest.
GeneratorLimit retreat_limit(const GeneratorError& error, const GeneratorVector& u) {
  const std::vector<WantedPlace>& places = error.wanted().places();
  const Retreat retreat = worst_retreat(places, error.values(u, places));
  GeneratorLimit limit{"turning back", {-allowed_retreat(error.task()), GeneratorVector::Zero(u.size())}};
  if (retreat.amount == 0) return limit;
  const auto end = [&](std::size_t i, int sign) {
    const auto generated = [&](double x) {
      return sign * (error.wanted().output_turn(x) + error.value_at(u, x));
    };
    if (i == 0 || i + 1 == places.size()) return places[i].x;
    const double x = top_by_golden_section(generated, places[i - 1].x, places[i + 1].x, golden_steps);
    return generated(x) > generated(places[i].x) ? x : places[i].x;
  };
  const double from = end(retreat.from, retreat.direction), to = end(retreat.to, -retreat.direction);
  const Sloped first = error.at(u, from), last = error.at(u, to);
  const double turn = error.wanted().output_turn(from) - error.wanted().output_turn(to);
  limit.excess.value += retreat.direction * (turn + first.value - last.value);
  limit.excess.slope = retreat.direction * (first.slope - last.slope);
  return limit;
}

}  // namespace

std::vector<GeneratorLimit> limits_of(const GeneratorError& error, const GeneratorVector& u) {
  const double cosine = std::cos(kept_transmission(error.task()));
  const double ratio = std::log(error.task().longest_ratio) - slack::inside_ratio;
  const std::string transmission = error.task().transmission > 0 ? "transmission_deg" : "dead point";
  const Sloped largest = error.largest_cosine(u), smallest = error.smallest_cosine(u);
  std::vector<GeneratorLimit> limits{{transmission, {largest.value - cosine, largest.slope}},
                                     {transmission, {-smallest.value - cosine, -smallest.slope}}};
  for (Eigen::Index i = -1; i < 3; ++i)  // -1: the ground, whose logarithm is 0
    for (Eigen::Index j = -1; j < 3; ++j) {
      if (i == j) continue;
      Sloped excess{(i < 0 ? 0 : u[i]) - (j < 0 ? 0 : u[j]) - ratio, GeneratorVector::Zero(u.size())};
      if (i >= 0) excess.slope[i] = 1;
      if (j >= 0) excess.slope[j] = -1;
      limits.push_back({"longest_ratio", excess});
    }
  limits.push_back(retreat_limit(error, u));
  return limits;
}

FunctionDesign with_unknowns(const GeneratorError& error, const FunctionDesign& like,
                             const GeneratorVector& u) {
  FunctionDesign design = like;
  design.linkage = error.linkage(u);
  design.motion = design.linkage.motion();
  design.input_start = std::remainder(error.starts(u).input, 2 * pi);
  design.output_start = std::remainder(error.starts(u).output, 2 * pi);
  return design;
}

}  // namespace kempe
