// The least error over all four-bars: many starts, judged coarsely, kept apart from each other; from each of
// the best a local fit within the limits; the best of these settled to rounding.

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/function_error.hpp"
#include "synthesis/structural_error.hpp"

namespace kempe {
namespace {

constexpr int coarse_places = 25;
constexpr int scattered_starts = 40000;
constexpr std::size_t tried_by_least_squares = 300, tried_by_minimax = 300;

/// A linkage with its starts and how it looks at a few places.
struct Start {
  FunctionDesign design;
  double score = 0;  ///< rad: largest error, plus what the limits are broken by
};

/// Errors at a few places, unwrapped, with the output's start zero.
struct CoarseError {
  double lower = 0, upper = 0;
  bool closes = true;
};

class CoarseLook {
 public:
  CoarseLook(const FunctionTask& task, const WantedAngles& wanted)
      : task_(task), cosine_limit_(std::cos(kept_transmission(task))),
        ratio_limit_(std::log(task.longest_ratio)) {
    for (int i = 0; i < coarse_places; ++i) {
      const double share = 0.5 - 0.5 * std::cos(pi * i / (coarse_places - 1));
      const double x = task.x_lower + share * (task.x_upper - task.x_lower);
      input_turns_.push_back(wanted.input_turn(x));
      output_turns_.push_back(wanted.output_turn(x));
    }
  }

  /// Puts the output's start in the middle of the errors where it is free; infinite where the loop comes
  /// apart.
  double score(FunctionDesign& design) const {
    constexpr double never = 1e300;
    double lower = 0, upper = 0, before = 0, cosine = 0;
    const FourBar& bar = design.linkage;
    for (std::size_t i = 0; i < input_turns_.size(); ++i) {
      const double phi = design.input_start + input_turns_[i];
      const auto psi = bar.output_angle(phi);
      if (!psi) return never;
      const double e_squared = std::norm(std::polar(bar.input, phi) - bar.ground);
      cosine = std::max(cosine, std::abs(bar.coupler * bar.coupler + bar.output * bar.output - e_squared) /
                                    (2 * bar.coupler * bar.output));
      double error = *psi - output_turns_[i];
      error = i == 0 ? error : before + std::remainder(error - before, 2 * pi);
      before = error;
      lower = i == 0 ? error : std::min(lower, error);
      upper = i == 0 ? error : std::max(upper, error);
    }
    const double broken =
        std::max(0.0, cosine - cosine_limit_) + std::max(0.0, log_ratio(bar) - ratio_limit_);
    if (!task_.output_start) {
      design.output_start = std::remainder(0.5 * (lower + upper), 2 * pi);
      return 0.5 * (upper - lower) + broken;
    }
    const double middle = std::remainder(0.5 * (lower + upper) - *task_.output_start, 2 * pi);
    return std::abs(middle) + 0.5 * (upper - lower) + broken;
  }

 private:
  static double log_ratio(const FourBar& bar) {
    const auto [least, most] = std::minmax({bar.ground, bar.input, bar.coupler, bar.output});
    return std::log(most / least);
  }

  const FunctionTask& task_;
  double cosine_limit_, ratio_limit_;
  std::vector<double> input_turns_, output_turns_;
};

/// The n-th number of van der Corput's sequence in a base: evenly scattered over 0..1 (Halton, 1960, uses one
/// base a dimension).
double van_der_corput(int n, int base) {
  double result = 0, digit = 1;
  for (; n > 0; n /= base) {
    digit /= base;
    result += digit * (n % base);
  }
  return result;
}

void add_scattered(const FunctionTask& task, const CoarseLook& look, std::vector<Start>& starts) {
  const double reach = std::log(task.longest_ratio);
  const auto length = [&](int n, int base) {
    return task.ground * std::exp(reach * (2 * van_der_corput(n, base) - 1));
  };
  for (int n = 1; n <= scattered_starts; ++n)
    for (const FourBarBranch branch : {FourBarBranch::first, FourBarBranch::second}) {
      Start start;
      start.design.linkage = {task.ground, length(n, 2), length(n, 3), length(n, 5), branch};
      start.design.input_start = task.input_start.value_or(pi * (2 * van_der_corput(n, 7) - 1));
      start.design.output_start = task.output_start.value_or(0);
      start.score = look.score(start.design);
      if (start.score < 0.5) starts.push_back(std::move(start));
    }
}

/// The linkages through three Chebyshev points, for starts on a grid.
void add_precise(const FunctionTask& task, const WantedAngles& wanted, const CoarseLook& look,
                 std::vector<Start>& starts) {
  for (const Starts& angles : precise_starts(task, wanted)) {
    const auto coefficients = coefficients_through_first_three(wanted, angles);
    if (!coefficients) continue;
    const auto design = design_from(task, wanted, angles, *coefficients);
    if (!design) continue;
    for (const FourBarBranch branch : {FourBarBranch::first, FourBarBranch::second}) {
      Start start{*design, 0};
      start.design.linkage.branch = branch;
      start.design.input_start = task.input_start.value_or(start.design.input_start);
      start.score = look.score(start.design);
      if (start.score < 0.5) starts.push_back(std::move(start));
    }
  }
}

/// How unlike two linkages are: the largest of their logarithms' and starts' differences.
double distance(const FunctionDesign& a, const FunctionDesign& b) {
  if (a.linkage.branch != b.linkage.branch) return 1e300;
  return std::max({std::abs(std::log(a.linkage.input / b.linkage.input)),
                   std::abs(std::log(a.linkage.coupler / b.linkage.coupler)),
                   std::abs(std::log(a.linkage.output / b.linkage.output)),
                   std::abs(std::remainder(a.input_start - b.input_start, 2 * pi)),
                   std::abs(std::remainder(a.output_start - b.output_start, 2 * pi))});
}

/// The best of the starts that stand apart from each other.
std::vector<FunctionDesign> chosen(std::vector<Start> starts, std::size_t count, double apart) {
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.score < b.score; });
  std::vector<FunctionDesign> result;
  for (const Start& start : starts) {
    if (result.size() == count) break;
    const bool near = std::any_of(result.begin(), result.end(), [&](const FunctionDesign& other) {
      return distance(start.design, other) < apart;
    });
    if (!near) result.push_back(start.design);
  }
  return result;
}

double cost(FunctionMethod method, const FunctionDesign& design) {
  return method == FunctionMethod::least_squares ? design.error_rms : design.error_largest;
}

/// Where the error vanishes: now a result, not a choice.
std::vector<double> zeros(const std::vector<StructuralErrorSample>& curve) {
  std::vector<double> x;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const auto &left = curve[i - 1], &right = curve[i];
    if ((left.error < 0) != (right.error < 0))
      x.push_back(left.x + (right.x - left.x) * left.error / (left.error - right.error));
  }
  return x;
}

}  // namespace

FunctionSearch search_function(const FunctionTask& task, const WantedAngles& wanted) {
  const CoarseLook look(task, wanted);
  std::vector<Start> starts;
  add_precise(task, wanted, look, starts);
  add_scattered(task, look, starts);
  FunctionSearch search;
  std::vector<Start> squares;
  for (const FunctionDesign& start : chosen(std::move(starts), tried_by_least_squares, 0.2)) {
    const auto fit = least_squares_fit(task, wanted, start);
    if (fit) {
      squares.push_back({*fit, cost(task.method, *fit)});
    } else {
      FunctionDesign traced = start;
      search.defects.push_back(trace_curve(task, wanted, traced));
    }
  }
  for (const FunctionDesign& start : chosen(std::move(squares), tried_by_minimax, 1e-3)) {
    const auto fit =
        task.method == FunctionMethod::minimax ? minimax_fit(task, wanted, start) : std::optional(start);
    const FunctionDesign& found = fit ? *fit : start;
    if (!search.best || cost(task.method, found) < cost(task.method, *search.best)) search.best = found;
  }
  if (!search.best) return search;
  if (task.method == FunctionMethod::minimax) settle_optimum(task, wanted, *search.best);
  search.best->y_lower = wanted.y_lower();
  search.best->y_upper = wanted.y_upper();
  search.best->precision_points = zeros(search.best->curve);
  return search;
}

}  // namespace kempe
