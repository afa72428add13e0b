// The least error over all four-bars: many starts, judged coarsely, kept apart from each other; from each of
// the best a local fit within the limits; the best of these settled to rounding.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/point.hpp"
#include "synthesis/functions/error.hpp"
#include "synthesis/functions/slack.hpp"
#include "synthesis/solvers/van_der_corput.hpp"

namespace kempe {
namespace {

constexpr int coarse_places = 33, fitted_places = 61;
constexpr int precise_grid = 48, precise_line = 480;  ///< starts on half a turn: both free, one free
constexpr int scattered_starts = 40000;
constexpr std::size_t tried_starts = 300, tried_by_minimax = 100, tried_leaps_from = 10;
constexpr int leaps_each = 12;

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
    for (const WantedPlace& place : wanted.some_places(coarse_places)) {
      input_turns_.push_back(place.input_turn);
      output_turns_.push_back(place.output_turn);
    }
  }

  /// Puts the output's start in the middle of the errors where it is free; infinite where the loop comes
  /// apart.
  double score(FunctionDesign& design) const {
    double lower = 0, upper = 0, before = 0, cosine = 0;
    const FourBar& bar = design.linkage;
    for (std::size_t i = 0; i < input_turns_.size(); ++i) {
      const double phi = design.input_start + input_turns_[i];
      const auto psi = bar.output_angle(phi);
      if (!psi) return infinity;
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

void add_scattered(const FunctionTask& task, const CoarseLook& look, std::vector<Start>& starts) {
  const double reach = std::log(task.longest_ratio);
  const auto length = [&](std::size_t n, unsigned base) {
    return task.ground * std::exp(reach * (2 * van_der_corput(n, base) - 1));
  };
  for (std::size_t n = 1; n <= scattered_starts && !task.stop(); ++n)
    for (const FourBarBranch branch : {FourBarBranch::first, FourBarBranch::second}) {
      Start start;
      start.design.linkage = {task.ground, length(n, 2), length(n, 3), length(n, 5), branch};
      start.design.input_start = task.input_start.value_or(pi * (2 * van_der_corput(n, 7) - 1));
      start.design.output_start = task.output_start.value_or(0);
      start.score = look.score(start.design);
      if (start.score < 0.5) starts.push_back(std::move(start));
    }
}

/// The starts tried on half a turn: half a turn more turns a crank round and changes no linkage.
std::vector<double> starts_on_half_a_turn(const std::optional<double>& given, int places) {
  if (given) return {*given};
  std::vector<double> all;
  for (int i = 0; i < places; ++i) all.push_back(pi * (i + 0.5) / places);
  return all;
}

/// The linkages through three Chebyshev points, for starts on a grid.
void add_precise(const FunctionTask& task, const WantedAngles& wanted, const CoarseLook& look,
                 std::vector<Start>& starts) {
  const auto add = [&](const Starts& angles) {
    const auto coefficients = coefficients_through_first_three(wanted, angles);
    const auto design = coefficients ? design_from(task, wanted, angles, *coefficients) : std::nullopt;
    if (!design) return;
    for (const FourBarBranch branch : {FourBarBranch::first, FourBarBranch::second}) {
      Start start{*design, 0};
      start.design.linkage.branch = branch;
      start.design.input_start = task.input_start.value_or(start.design.input_start);
      start.design.output_start = task.output_start.value_or(start.design.output_start);
      start.score = look.score(start.design);
      if (start.score < 0.5) starts.push_back(std::move(start));
    }
  };
  const int places = task.input_start || task.output_start ? precise_line : precise_grid;
  for (const double input : starts_on_half_a_turn(task.input_start, places))
    for (const double output : starts_on_half_a_turn(task.output_start, places)) {
      if (task.stop()) return;
      add({input, output});
    }
}

/// How unlike two linkages are: the largest of their logarithms' and starts' differences.
double distance(const FunctionDesign& a, const FunctionDesign& b) {
  if (a.linkage.branch != b.linkage.branch) return infinity;
  return std::max({std::abs(std::log(a.linkage.input / b.linkage.input)),
                   std::abs(std::log(a.linkage.coupler / b.linkage.coupler)),
                   std::abs(std::log(a.linkage.output / b.linkage.output)),
                   std::abs(std::remainder(a.input_start - b.input_start, 2 * pi)),
                   std::abs(std::remainder(a.output_start - b.output_start, 2 * pi))});
}

/// The best of the starts that stand apart from each other.
std::vector<FunctionDesign> chosen(std::vector<Start> starts, std::size_t count, double apart,
                                   const StopFlag& stop) {
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.score < b.score; });
  std::vector<FunctionDesign> result;
  for (const Start& start : starts) {
    if (result.size() == count || (stop() && !result.empty())) break;
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

/// The local optima found so far, and what led nowhere.
class Found {
 public:
  Found(const FunctionTask& task, const WantedAngles& wanted, FunctionSearch& search)
      : task_(task), wanted_(wanted), search_(search) {}

  void squares_from(const FunctionDesign& start) {
    const bool minimax = task_.method == FunctionMethod::minimax;
    keep(least_squares_fit(task_, wanted_, start,
                           minimax ? SquareWeights::even_in_places : SquareWeights::even_in_x, fitted_places),
         start);
  }
  void minimax_from(const FunctionDesign& start) { keep(minimax_fit(task_, wanted_, start), start); }

  /// By the task's method.
  void fit_from(const FunctionDesign& start) {
    if (task_.method == FunctionMethod::minimax)
      minimax_from(start);
    else
      squares_from(start);
  }

  /// The best that stand apart from each other.
  std::vector<FunctionDesign> best(std::size_t count) const {
    return chosen(all_, count, slack::designs_apart, task_.stop);
  }

 private:
  void keep(const std::optional<FunctionDesign>& design, const FunctionDesign& start) {
    if (!design && task_.stop()) return;  // nothing is known of the start
    if (design) {
      all_.push_back({*design, cost(task_.method, *design)});
      return;
    }
    FunctionDesign measured = start;
    ++search_.seen[static_cast<std::size_t>(measure_design(task_, wanted_, measured))];
  }

  const FunctionTask& task_;
  const WantedAngles& wanted_;
  FunctionSearch& search_;
  std::vector<Start> all_;
};

/// A linkage beside another: every unknown moved by up to a size that grows from leap to leap.
FunctionDesign leap(const FunctionTask& task, const FunctionDesign& from, std::size_t number) {
  const double size = 0.1 + 0.7 * van_der_corput(number, 2);
  const auto moved = [&](unsigned base) { return size * (2 * van_der_corput(number, base) - 1); };
  FunctionDesign to = from;
  to.linkage.input *= std::exp(moved(3));
  to.linkage.coupler *= std::exp(moved(5));
  to.linkage.output *= std::exp(moved(7));
  if (!task.input_start) to.input_start += moved(11);
  if (!task.output_start) to.output_start += moved(13);
  return to;
}

}  // namespace

FunctionSearch search_function(const FunctionTask& task, const WantedAngles& wanted) {
  const CoarseLook look(task, wanted);
  std::vector<Start> starts;
  add_precise(task, wanted, look, starts);
  add_scattered(task, look, starts);
  FunctionSearch search;
  Found found(task, wanted, search);
  const std::vector<FunctionDesign> tried = chosen(std::move(starts), tried_starts, 0.2, task.stop);
  const auto each = [&](const auto& designs, std::size_t count, const auto& fit) {
    for (std::size_t i = 0; i < std::min(count, designs.size()) && !task.stop(); ++i) fit(designs[i]);
  };
  each(tried, tried.size(), [&](const FunctionDesign& start) { found.squares_from(start); });
  if (task.method == FunctionMethod::minimax) {
    const auto minimax = [&](const FunctionDesign& start) { found.minimax_from(start); };
    each(found.best(tried_by_minimax), tried_by_minimax, minimax);
    each(tried, tried_by_minimax, minimax);
  }
  std::size_t number = 0;
  for (const FunctionDesign& design : found.best(tried_leaps_from))
    for (int i = 0; i < leaps_each && !task.stop(); ++i) found.fit_from(leap(task, design, ++number));
  search.extent = fmt::format(
      "{} four-bars scattered over all lengths and starts and those through three points; fits from the {} "
      "best that differ; not a proof that none exists",
      2 * scattered_starts, tried.size());
  for (const FunctionDesign& design : found.best(5)) {
    if (search.best && task.stop()) break;
    auto last = task.method == FunctionMethod::minimax
                    ? minimax_fit(task, wanted, design)
                    : least_squares_fit(task, wanted, design, SquareWeights::even_in_x, all_places);
    if (!last || cost(task.method, design) < cost(task.method, *last)) last = design;
    if (!search.best || cost(task.method, *last) < cost(task.method, *search.best)) search.best = last;
  }
  if (search.best && task.method == FunctionMethod::minimax && !task.stop())
    settle_optimum(task, wanted, *search.best);
  return search;
}

}  // namespace kempe
