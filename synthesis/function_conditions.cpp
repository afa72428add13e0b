#include "synthesis/function_conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/golden_section.hpp"

namespace kempe {
namespace {

constexpr int places = 121;

/// Chebyshev's spacing: denser towards the ends, where ripples are narrow.
double place(const FunctionTask& task, int i) {
  const double share = 0.5 - 0.5 * std::cos(pi * i / (places - 1));
  return task.x_lower + share * (task.x_upper - task.x_lower);
}

/// The top of a ripple between two places: golden section.
ErrorRipple top_between(const GeneratorError& error, const GeneratorVector& u, double lower, double upper,
                        int sign) {
  const auto height = [&](double x) { return sign * error.at(u, x).value; };
  const double x = top_by_golden_section(height, lower, upper, 40);
  return {x, height(x), sign};
}

}  // namespace

std::vector<ErrorRipple> ripples_of(const GeneratorError& error, const GeneratorVector& u) {
  const FunctionTask& task = error.task();
  std::array<double, places> e;
  double highest = 0;
  for (int i = 0; i < places; ++i) {
    e[static_cast<std::size_t>(i)] = error.at(u, place(task, i)).value;
    highest = std::max(highest, std::abs(e[static_cast<std::size_t>(i)]));
  }
  const auto height = [&](int i) { return std::abs(e[static_cast<std::size_t>(i)]); };
  std::vector<ErrorRipple> ripples;
  for (int i = 0; i < places; ++i) {
    if ((i > 0 && height(i - 1) > height(i)) || (i + 1 < places && height(i + 1) >= height(i))) continue;
    ErrorRipple ripple{place(task, i), height(i), e[static_cast<std::size_t>(i)] < 0 ? -1 : 1};
    if (i > 0 && i + 1 < places && ripple.height > 0.9 * highest) {
      const ErrorRipple top = top_between(error, u, place(task, i - 1), place(task, i + 1), ripple.sign);
      if (top.height > ripple.height) ripple = top;
    }
    ripples.push_back(ripple);
  }
  if (ripples.empty()) ripples.push_back({task.x_lower, height(0), e[0] < 0 ? -1 : 1});
  std::stable_sort(ripples.begin(), ripples.end(),
                   [](const ErrorRipple& a, const ErrorRipple& b) { return a.height > b.height; });
  return ripples;
}

std::vector<GeneratorLimit> limits_of(const GeneratorError& error, const GeneratorVector& u) {
  const double cosine = std::cos(kept_transmission(error.task()));
  const double ratio = std::log(error.task().longest_ratio) - 1e-12;
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
