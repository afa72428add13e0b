// A four-bar driven over the range: its error, its defects, and by how much it exceeds its limits.

#include <algorithm>
#include <cmath>

#include "synthesis/functions/refinement.hpp"
#include "synthesis/functions/slack.hpp"
#include "synthesis/solvers/golden_section.hpp"

namespace kempe {
namespace {

constexpr int curve_places = 181;
constexpr int most_evaluations = 400000;  ///< of the integral of the squared error

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }

/// Generated less wanted output angle; nothing where the loop does not close.
std::optional<double> error_at(const FunctionDesign& design, double input_turn, double output_turn) {
  const auto psi = design.linkage.output_angle(design.input_start + input_turn);
  if (!psi) return std::nullopt;
  return wrapped(*psi - design.output_start - output_turn);
}

std::optional<std::vector<double>> errors_of(const WantedAngles& wanted, const FunctionDesign& design) {
  std::vector<double> errors;
  errors.reserve(wanted.places().size());
  for (const WantedPlace& at : wanted.places()) {
    const auto error = error_at(design, at.input_turn, at.output_turn);
    if (!error) return std::nullopt;
    errors.push_back(*error);
  }
  return errors;
}

double height_at(const WantedAngles& wanted, const FunctionDesign& design, double x) {
  return std::abs(error_at(design, wanted.input_turn(x), wanted.output_turn(x)).value_or(0));
}

/// The largest |error| over the whole range, between the places too.
double largest_error(const WantedAngles& wanted, const FunctionDesign& design,
                     const std::vector<double>& errors) {
  double seen = 0;
  for (const double error : errors) seen = std::max(seen, std::abs(error));
  double largest = seen;
  const auto& places = wanted.places();
  for (std::size_t i = 1; i + 1 < errors.size(); ++i) {
    const double here = std::abs(errors[i]);
    if (here < 0.98 * seen || here < std::abs(errors[i - 1]) || here < std::abs(errors[i + 1])) continue;
    const auto height = [&](double x) { return height_at(wanted, design, x); };
    largest = std::max(largest, height(top_by_golden_section(height, places[i - 1].x, places[i + 1].x, 40)));
  }
  return largest;
}

double mean_square(const WantedAngles& wanted, const std::vector<double>& errors) {
  double sum = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) sum += wanted.places()[i].weight * errors[i] * errors[i];
  return sum;
}

bool lengths_fit(const FunctionTask& task, const FourBar& l) {
  const auto [shortest, longest] = std::minmax({l.ground, l.input, l.coupler, l.output});
  return shortest > 0 && longest <= task.longest_ratio * shortest;
}

/// |cos mu| where it is largest over the range; beyond 1 where the loop does not close.
double largest_cosine(const FunctionTask& task, const FunctionDesign& design) {
  const FourBar& l = design.linkage;
  const auto [low, high] = std::minmax({design.input_start, design.input_start + task.input_range});
  const auto cosine = [&](double phi) {
    const double e_squared = l.input * l.input + l.ground * l.ground - 2 * l.input * l.ground * std::cos(phi);
    return std::abs(l.coupler * l.coupler + l.output * l.output - e_squared) / (2 * l.coupler * l.output);
  };
  double largest = std::max(cosine(low), cosine(high));
  for (double half_turns = std::ceil(low / pi); half_turns * pi < high; ++half_turns)
    largest = std::max(largest, cosine(half_turns * pi));
  return largest;
}

/// Adaptive Simpson: halves a cell until both halves agree with the whole. A function may bend everywhere, however small a cell
/// is: once the evaluations are spent, or the work is stopped, cells stay as they are.
class SquareIntegral {
 public:
  SquareIntegral(const FunctionTask& task, const WantedAngles& wanted, const FunctionDesign& design,
                 double tolerance)
      : task_(task), wanted_(wanted), design_(design), tolerance_(tolerance) {}

  double over(double lower, double upper) {
    const double middle = 0.5 * (lower + upper);
    return halved(lower, upper, square(lower), square(middle), square(upper), 30);
  }
  /// What the cells that stayed may be wrong by, together.
  double doubt() const { return doubt_; }
  /// A place where the error is no number.
  const std::optional<double>& without_value() const { return without_value_; }

 private:
  double square(double x) {
    const double height = height_at(wanted_, design_, x);
    if (!std::isfinite(height) && !without_value_) without_value_ = x;
    return height * height;
  }
  double halved(double lower, double upper, double f0, double f2, double f4, int depth) {
    const double middle = 0.5 * (lower + upper), h = upper - lower;
    const double f1 = square(0.5 * (lower + middle)), f3 = square(0.5 * (middle + upper));
    const double whole = h / 6 * (f0 + 4 * f2 + f4), halves = h / 12 * (f0 + 4 * f1 + 2 * f2 + 4 * f3 + f4);
    const double better = halves + (halves - whole) / 15;
    if (depth == 0 || without_value_ || std::abs(halves - whole) <= 15 * tolerance_ * h) return better;
    left_ -= 4;
    if (left_ < 0 || task_.stop()) {
      doubt_ += std::abs(halves - whole);
      return better;
    }
    return halved(lower, middle, f0, f1, f2, depth - 1) + halved(middle, upper, f2, f3, f4, depth - 1);
  }
  const FunctionTask& task_;
  const WantedAngles& wanted_;
  const FunctionDesign& design_;
  double tolerance_, doubt_ = 0;
  int left_ = most_evaluations;
  std::optional<double> without_value_;
};

}  // namespace

double allowed_retreat(const FunctionTask& task) { return 0.01 * std::abs(task.output_range); }

Retreat worst_retreat(const std::vector<WantedPlace>& places, const std::vector<double>& errors) {
  Retreat worst;
  double direction = 0, farthest = 0;
  std::size_t at_farthest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double asked = i == 0 ? 0 : places[i].output_turn - places[i - 1].output_turn;
    const double generated = places[i].output_turn + errors[i];
    if (asked * direction <= 0) {  // the wanted function starts or turns: from the place before on
      direction = asked;
      at_farthest = i == 0 ? 0 : i - 1;
      farthest = places[at_farthest].output_turn + errors[at_farthest];
    }
    if (direction == 0 || (direction > 0 ? generated >= farthest : generated <= farthest)) {
      farthest = generated;
      at_farthest = i;
    } else if (std::abs(farthest - generated) > worst.amount) {
      worst = {std::abs(farthest - generated), at_farthest, i, direction > 0 ? 1 : -1};
    }
  }
  return worst;
}

double FunctionCandidate::cost() const {
  constexpr double beyond_every_error = 10;  // rad
  return defect == FunctionDefect::none ? design.error_largest : beyond_every_error + broken;
}

FunctionDefect measure_design(const FunctionTask& task, const WantedAngles& wanted, FunctionDesign& design) {
  if (!lengths_fit(task, design.linkage)) return FunctionDefect::lengths;
  const auto transmission =
      design.linkage.least_transmission_angle(design.input_start, design.input_start + task.input_range);
  if (!transmission) return FunctionDefect::does_not_assemble;
  design.transmission_min = *transmission;
  if (design.transmission_min < task.transmission) return FunctionDefect::transmission;
  const auto errors = errors_of(wanted, design);
  if (!errors) return FunctionDefect::does_not_assemble;
  if (worst_retreat(wanted.places(), *errors).amount > allowed_retreat(task)) return FunctionDefect::order;
  design.error_rms = std::sqrt(mean_square(wanted, *errors));
  design.error_largest = largest_error(wanted, design, *errors);
  return FunctionDefect::none;
}

double broken_limits(const FunctionTask& task, const WantedAngles& wanted, const FunctionDesign& design) {
  const FourBar& l = design.linkage;
  const auto [shortest, longest] = std::minmax({l.ground, l.input, l.coupler, l.output});
  const double ratio = std::max(0.0, std::log(longest / (shortest * task.longest_ratio)));
  const double cosine = std::max(0.0, largest_cosine(task, design) - std::cos(task.transmission));
  if (ratio > 0 || cosine > 0) return ratio + cosine;
  const auto errors = errors_of(wanted, design);
  if (!errors) return 0;  // by rounding, at a dead point
  const double retreat = worst_retreat(wanted.places(), *errors).amount - allowed_retreat(task);
  return std::max(0.0, retreat);
}

std::optional<double> complete_design(const FunctionTask& task, const WantedAngles& wanted,
                                      FunctionDesign& design) {
  design.y_lower = wanted.y_lower();
  design.y_upper = wanted.y_upper();
  design.motion = design.linkage.motion();
  design.curve.clear();
  for (int i = 0; i < curve_places; ++i) {
    const double x = task.x_lower + (task.x_upper - task.x_lower) * i / (curve_places - 1);
    const double phi = design.input_start + wanted.input_turn(x), turn = wanted.output_turn(x);
    const double psi = design.linkage.output_angle(phi).value_or(0);
    const double error = wrapped(psi - design.output_start - turn);
    design.curve.push_back({x, task.wanted(x), wanted.value_at(turn + error), phi, psi, error});
  }
  design.unseen = wanted.unseen();
  for (const StructuralErrorSample& sample : design.curve)
    if (!std::isfinite(sample.y_wanted)) return sample.x;
  if (!design.complete) return std::nullopt;
  const double rms = design.error_rms,
               tolerance = slack::integral_share * rms * rms + slack::integral_rounding * rms +
                           slack::integral_floor;  // rounding's share
  SquareIntegral square(task, wanted, design, tolerance);
  double sum = 0;
  for (std::size_t i = 2; i < wanted.places().size(); i += 2)
    sum += square.over(wanted.places()[i - 2].x, wanted.places()[i].x);
  if (square.without_value()) return square.without_value();
  const double width = task.x_upper - task.x_lower;
  design.error_rms = std::sqrt(sum / width);
  design.unseen = std::max(design.unseen, std::sqrt((sum + square.doubt()) / width) - design.error_rms);
  return std::nullopt;
}

std::vector<double> zeros_of(const FunctionTask& task, const WantedAngles& wanted,
                             const FunctionDesign& design) {
  std::vector<double> x;
  const auto errors = errors_of(wanted, design);
  for (std::size_t i = 1; errors && i < errors->size(); ++i) {
    const double before = (*errors)[i - 1], after = (*errors)[i];
    if ((before < 0) == (after < 0)) continue;
    double lower = wanted.places()[i - 1].x, upper = wanted.places()[i].x;
    if (task.stop()) {
      x.push_back(lower + (upper - lower) * before / (before - after));
      continue;
    }
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = 0.5 * (lower + upper);
      const double here = error_at(design, wanted.input_turn(middle), wanted.output_turn(middle)).value_or(0);
      ((here < 0) == (before < 0) ? lower : upper) = middle;
    }
    x.push_back(0.5 * (lower + upper));
  }
  return x;
}

}  // namespace kempe
