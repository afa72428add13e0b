#include "synthesis/calibration/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/decompositions.hpp"
#include "synthesis/calibration/outliers.hpp"
#include "synthesis/calibration/slack.hpp"
#include "synthesis/calibration/statistics.hpp"

namespace kempe {
namespace detail = calibration_detail;

std::string_view name(NoiseSource source) {
  switch (source) {
    case NoiseSource::stated: return "stated";
    case NoiseSource::residuals: return "residuals";
    case NoiseSource::larger_residuals: return "residuals larger than stated";
    case NoiseSource::assumed: break;
  }
  return "assumed";
}

std::optional<double> departure_with(const CalibrationTask& task, const Measures& deviations,
                                     const Measures& corrections) {
  double largest = 0;
  for (const CalibrationReading& reading : task.readings) {
    const Instrument& setup = task.setups[reading.setup];
    const auto output = output_at(setup, setup.drawn + deviations + corrections, reading.input);
    if (!output) return std::nullopt;
    largest = std::max(largest, (output->at - wanted_output(setup, reading.input)).norm());
  }
  return largest;
}

namespace {

std::vector<Measure> without_held(const std::vector<Measure>& free,
                                  const std::vector<Indistinct>& indistinct) {
  std::vector<Measure> rest;
  for (const Measure measure : free)
    if (std::none_of(indistinct.begin(), indistinct.end(),
                     [&](const Indistinct& one) { return one.parts.front().measure == measure; }))
      rest.push_back(measure);
  return rest;
}

/// A fit with what was held for it and the noise that it was weighed by.
struct Fitted {
  detail::FitOutcome outcome;
  std::vector<Measure> free;  ///< that were fitted
  std::vector<Indistinct> indistinct;
  double noise = 0;
  NoiseSource source = NoiseSource::assumed;
  double freedom = 0;
};

/// Held measures that are off by what is plausible leave traces of second order in all others, and in what is
/// left.
double second_order(const CalibrationTask& task, const Fitted& fitted) {
  if (fitted.indistinct.empty()) return 0;
  const double size = 1 / detail::units_of(task)[index_of(Measure::turn)];
  return 0.5 * task.plausible_deviation * task.plausible_deviation / size;
}

/// One calibration in the making: which measures can be told, and their fit.
class Fitting {
 public:
  Fitting(const CalibrationTask& task, std::vector<std::size_t> used)
      : task_(task), used_(std::move(used)), units_(detail::units_of(task)) {}

  /// Nothing where the instrument as drawn cannot be closed at a reading (checked before).
  std::optional<Fitted> run() const {
    // What no noise at all would let the readings tell, then what this noise does not.
    auto fitted = held_fit(initial_noise(), std::numeric_limits<double>::infinity());
    if (!fitted) return fitted;
    auto hidden_by_noise = indistinct_as_drawn(fitted->noise, task_.plausible_deviation);
    if (hidden_by_noise.size() > fitted->indistinct.size()) {
      fitted = held_fit(fitted->noise, task_.plausible_deviation);
    } else if (weighs_all_alike()) {
      fitted->indistinct = std::move(hidden_by_noise);
    }
    if (!fitted || fitted->indistinct.empty()) return fitted;
    auto all = full_fit(*fitted);
    return all ? all : fitted;
  }

 private:
  double initial_noise() const { return task_.reading_uncertainty.value_or(assumed_reading_uncertainty); }

  detail::WeightedTask weighted(double noise) const { return {task_, used_, noise, units_}; }

  std::vector<Indistinct> indistinct_as_drawn(double noise, double plausible) const {
    Eigen::VectorXd residuals(weighted(noise).rows());
    Eigen::MatrixXd slopes(residuals.size(), static_cast<Eigen::Index>(task_.free.size()));
    if (!weighted(noise).evaluate(Measures::Zero(), task_.free, residuals, &slopes)) return {};
    return detail::indistinct_combinations(slopes, task_.free, units_, plausible);
  }

  std::optional<Fitted> held_fit(double noise, double plausible) const {
    Fitted fitted;
    fitted.indistinct = indistinct_as_drawn(noise, plausible);
    fitted.free = without_held(task_.free, fitted.indistinct);
    return settle_noise(std::move(fitted), Measures::Zero(), noise);
  }

  /// Fits, and where the noise is not stated weighs anew by what is left, until both agree.
  std::optional<Fitted> settle_noise(Fitted fitted, Measures start, double noise) const {
    constexpr int most_rounds = 8;
    for (int round = 0; round < most_rounds; ++round) {
      auto outcome = detail::fit(weighted(noise), fitted.free, start);
      if (!outcome) return std::nullopt;
      fitted.outcome = *outcome;
      start = outcome->deviations;
      const auto estimate = detail::estimated_noise(weighted(noise), fitted.outcome);
      fitted.freedom = estimate.freedom;
      fitted.noise = choose_noise(estimate, fitted.source);
      const bool settled = std::abs(fitted.noise - noise) <= slack::noise_settled * noise;
      if (settled || weighs_all_alike()) {
        weigh_anew(fitted.outcome, noise / fitted.noise);
        break;
      }
      noise = fitted.noise;
    }
    return fitted;
  }

  /// Then another noise changes no weight against another.
  bool weighs_all_alike() const { return task_.lengths.empty() && task_.setting_uncertainty == 0; }

  static void weigh_anew(detail::FitOutcome& outcome, double factor) {
    outcome.residuals *= factor;
    outcome.slopes *= factor;
    outcome.square_sum *= factor * factor;
  }

  static bool beyond_chance(const detail::NoiseEstimate& estimate, double known) {
    const double squares = estimate.freedom * std::pow(estimate.noise / known, 2);
    return chi_squared_upper_probability(squares, static_cast<int>(std::lround(estimate.freedom))) <
           slack::named_by_chance;
  }

  double choose_noise(const detail::NoiseEstimate& estimate, NoiseSource& source) const {
    const double least = std::max(task_.rounding, slack::noise_rounding / units_[index_of(Measure::turn)]);
    const bool estimable = estimate.freedom >= 1.5;
    source = task_.reading_uncertainty ? NoiseSource::stated
             : estimable               ? NoiseSource::residuals
                                       : NoiseSource::assumed;
    if (source == NoiseSource::residuals) return std::max(estimate.noise, least);
    const double known = initial_noise();
    if (source == NoiseSource::stated && estimable && beyond_chance(estimate, known)) {
      source = NoiseSource::larger_residuals;
      return estimate.noise;
    }
    return known;
  }

  /// Everything free at once, from the held solution: without noise even the second-order traces of the held
  /// combinations tell them. Believed only if it converged, rests on enough readings, and tells all of them
  /// well.
  std::optional<Fitted> full_fit(const Fitted& held) const {
    constexpr double least_freedom = 3.5;
    if (static_cast<double>(weighted(1).rows()) - static_cast<double>(task_.free.size()) < least_freedom)
      return std::nullopt;
    if (noise_hides_all(held)) return std::nullopt;
    for (const Measures& start : {held.outcome.deviations, Measures(Measures::Zero())}) {
      Fitted all;
      all.free = task_.free;
      auto fitted = settle_noise(std::move(all), start, held.noise);
      if (fitted && fitted->outcome.converged && tells_all(*fitted)) return fitted;
    }
    return std::nullopt;
  }

  bool tells_all(const Fitted& fitted) const {
    constexpr double clearly = 0.1;
    return detail::indistinct_combinations(fitted.outcome.slopes, task_.free, units_,
                                           clearly * task_.plausible_deviation)
        .empty();
  }

  /// True if at the held solution the noise leaves the held measures unknown by far. What is left counts as
  /// noise once it is more than the held measures' own traces.
  bool noise_hides_all(const Fitted& held) const {
    const bool is_noise = task_.reading_uncertainty || held.noise > 5 * second_order(task_, held);
    if (!is_noise) return false;
    Eigen::VectorXd residuals(weighted(1).rows());
    Eigen::MatrixXd slopes(residuals.size(), static_cast<Eigen::Index>(task_.free.size()));
    if (!weighted(held.noise).evaluate(held.outcome.deviations, task_.free, residuals, &slopes)) return true;
    constexpr double by_far = 10;
    return !detail::indistinct_combinations(slopes, task_.free, units_, by_far * task_.plausible_deviation)
                .empty();
  }

  const CalibrationTask& task_;
  std::vector<std::size_t> used_;
  Measures units_;
};

Eigen::Matrix<double, measure_count, measure_count> covariance_of(const Fitted& fitted,
                                                                  const Measures& units) {
  Eigen::Matrix<double, measure_count, measure_count> covariance =
      Eigen::Matrix<double, measure_count, measure_count>::Zero();
  const Eigen::MatrixXd small = detail::inverse_normal(fitted.outcome.slopes);
  for (std::size_t i = 0; i < fitted.free.size(); ++i)
    for (std::size_t j = 0; j < fitted.free.size(); ++j) {
      const int row = index_of(fitted.free[i]), column = index_of(fitted.free[j]);
      covariance(row, column) =
          small(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * units[row] * units[column];
    }
  return covariance;
}

detail::WeightedTask weighted_for(const CalibrationTask& task, const Fitted& fitted,
                                  const std::vector<std::size_t>& used) {
  return {task, used, fitted.noise, detail::units_of(task), second_order(task, fitted)};
}

/// All readings about a fit, weighed by the noise that they are judged by: the stated one, never what outliers made of it.
struct Judged {
  detail::WeightedTask weighted;
  detail::LinearFit about;
  bool noise_is_known;
};

std::optional<Judged> judged_about(const CalibrationTask& task, const Fitted& fitted,
                                   const Measures& deviations) {
  std::vector<std::size_t> all(task.readings.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Judged judged{weighted_for(task, fitted, all), {}, fitted.source != NoiseSource::residuals};
  if (judged.noise_is_known) judged.weighted.noise = task.reading_uncertainty.value_or(fitted.noise);
  judged.about.residuals.resize(judged.weighted.rows());
  judged.about.slopes.resize(judged.weighted.rows(), static_cast<Eigen::Index>(fitted.free.size()));
  if (!judged.weighted.evaluate(deviations, fitted.free, judged.about.residuals, &judged.about.slopes))
    return std::nullopt;
  return judged;
}

std::vector<std::size_t> rest_of(const CalibrationTask& task, const std::vector<std::size_t>& outliers) {
  std::vector<std::size_t> rest;
  for (std::size_t i = 0; i < task.readings.size(); ++i)
    if (!std::binary_search(outliers.begin(), outliers.end(), i)) rest.push_back(i);
  return rest;
}

/// Where the search for outliers begins: the fit of all readings, or where wrong ones have led it astray, of those that
/// agree best; about a fit far off nothing is linear.
std::optional<Fitted> first_fit(const CalibrationTask& task, const std::optional<Fitted>& of_all) {
  constexpr double far_astray = 5, astray = 0.2;  // of a plausible deviation
  if (!of_all) return std::nullopt;
  const auto off = [&](const Measures& from) {
    return (of_all->outcome.deviations - from).head<8>().cwiseAbs().maxCoeff() / task.plausible_deviation;
  };
  const bool far = off(Measures::Zero()) > far_astray;
  const auto judged =
      judged_about(task, *of_all, far ? Measures(Measures::Zero()) : of_all->outcome.deviations);
  if (!judged) return of_all;
  auto core = Fitting(task, detail::agreeing_best(judged->weighted, judged->about)).run();
  return core && off(core->outcome.deviations) > astray ? core : of_all;
}

/// The readings that stand out, and the fit of the others: sought anew about every fit until they stay the same.
struct Cleaned {
  std::optional<Fitted> fitted;
  std::vector<std::size_t> outliers;
};
Cleaned without_outliers(const CalibrationTask& task, const std::optional<Fitted>& of_all) {
  Cleaned clean{of_all, {}};
  std::optional<Fitted> about = first_fit(task, of_all);
  constexpr int most_rounds = 6;
  for (int round = 0; round < most_rounds && about; ++round) {
    const auto judged = judged_about(task, *about, about->outcome.deviations);
    if (!judged) break;
    const auto outliers = detail::standing_out(judged->weighted, judged->about, judged->noise_is_known);
    if (outliers == clean.outliers) break;
    about = Fitting(task, rest_of(task, outliers)).run();
    if (about) clean = {about, outliers};
  }
  return clean;
}

/// What the determined measures move by when a held one is off by the plausible deviation, evenly spread.
void add_traces_of_held(const CalibrationTask& task, const Fitted& fitted,
                        const std::vector<std::size_t>& used, Calibration& result) {
  const auto weighted = weighted_for(task, fitted, used);
  for (const Indistinct& one : fitted.indistinct) {
    Measures shift = Measures::Zero();
    for (const double side : {-1.0, 1.0}) {
      Measures start = result.deviations;
      for (const Indistinct::Part& part : one.parts)
        start[index_of(part.measure)] += side * task.plausible_deviation / std::sqrt(3.0) * part.factor *
                                         weighted.units[index_of(one.parts.front().measure)];
      if (const auto moved = detail::fit(weighted, fitted.free, start))
        shift += 0.5 * side * moved->deviations;
    }
    for (int i = 0; i < measure_count; ++i)
      if (!result.determined[i]) shift[i] = 0;
    result.covariance += shift * shift.transpose();
  }
}

void fill_readings(const CalibrationTask& task, const Fitted& fitted, const std::vector<std::size_t>& used,
                   const std::vector<std::size_t>& outliers, Calibration& result) {
  result.readings.resize(task.readings.size());
  for (std::size_t i = 0; i < task.readings.size(); ++i) {
    const CalibrationReading& reading = task.readings[i];
    const Instrument& setup = task.setups[reading.setup];
    result.readings[i].departure = reading.output - wanted_output(setup, reading.input);
    if (const auto output = output_at(setup, setup.drawn + result.deviations, reading.input))
      result.readings[i].left = reading.output - output->at;
  }
  const auto judged = judged_about(task, fitted, result.deviations);
  if (judged) {
    const auto left_out =
        detail::leave_one_out(judged->weighted, judged->about, outliers, judged->noise_is_known);
    for (std::size_t i = 0; i < left_out.size(); ++i) {
      result.readings[i].studentised = left_out[i].studentised;
      result.readings[i].leverage = left_out[i].leverage;
    }
  }
  for (const std::size_t i : outliers) result.readings[i].outlier = true;
  double squares = 0;
  for (const std::size_t i : used) {
    result.left_largest = std::max(result.left_largest, result.readings[i].left.norm());
    squares += result.readings[i].left.squaredNorm();
  }
  result.left_rms = std::sqrt(squares / std::max<double>(1, static_cast<double>(2 * used.size())));
}

/// The sum of squares by the stated noise.
std::optional<FitCheck> check_of(const CalibrationTask& task, const Fitted& fitted,
                                 const std::vector<std::size_t>& used) {
  if (!task.reading_uncertainty) return std::nullopt;
  detail::WeightedTask weighted = weighted_for(task, fitted, used);
  weighted.noise = *task.reading_uncertainty;
  const auto freedom = static_cast<int>(weighted.rows()) - static_cast<int>(fitted.free.size());
  detail::LinearFit about{Eigen::VectorXd(weighted.rows()),
                          Eigen::MatrixXd(weighted.rows(), static_cast<Eigen::Index>(fitted.free.size()))};
  if (freedom < 1 ||
      !weighted.evaluate(fitted.outcome.deviations, fitted.free, about.residuals, &about.slopes))
    return std::nullopt;
  FitCheck check{detail::least_square_sum(about, used.size()), freedom, 1};
  check.probability = chi_squared_upper_probability(check.chi_squared, freedom);
  return check;
}

/// An unknown deviation of a measure that was taken as drawn is explained by the free ones instead: by minus
/// the least-squares solution of its own slopes.
void add_known_within(const CalibrationTask& task, const Fitted& fitted, const std::vector<std::size_t>& used,
                      Calibration& result) {
  if (task.known_within.empty()) return;
  std::vector<Measure> taken;
  for (const auto& known : task.known_within) taken.push_back(known.measure);
  const auto weighted = weighted_for(task, fitted, used);
  Eigen::VectorXd residuals(weighted.rows());
  Eigen::MatrixXd slopes(weighted.rows(), static_cast<Eigen::Index>(taken.size()));
  if (!weighted.evaluate(result.deviations, taken, residuals, &slopes)) return;
  const Eigen::MatrixXd explained =
      detail::inverse_normal(fitted.outcome.slopes) * fitted.outcome.slopes.transpose() * slopes;
  for (std::size_t k = 0; k < taken.size(); ++k) {
    Measures shift = Measures::Zero();
    for (std::size_t j = 0; j < fitted.free.size(); ++j)
      shift[index_of(fitted.free[j])] =
          -explained(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) *
          weighted.units[index_of(fitted.free[j])];
    shift[index_of(taken[k])] += weighted.units[index_of(taken[k])];
    result.covariance += std::pow(task.known_within[k].uncertainty, 2) * shift * shift.transpose();
  }
}

Calibration result_of(const CalibrationTask& task, const Fitted& fitted, const std::vector<std::size_t>& used,
                      const std::vector<std::size_t>& outliers) {
  Calibration result;
  result.deviations = fitted.outcome.deviations;
  result.indistinct = fitted.indistinct;
  for (const Indistinct& one : fitted.indistinct)
    for (const Indistinct::Part& part : one.parts) result.determined[index_of(part.measure)] = false;
  result.covariance = covariance_of(fitted, detail::units_of(task));
  add_traces_of_held(task, fitted, used, result);
  add_known_within(task, fitted, used, result);
  result.noise = fitted.noise;
  result.noise_source = fitted.source;
  result.degrees_of_freedom = static_cast<int>(std::lround(fitted.freedom));
  const bool estimated =
      fitted.source == NoiseSource::residuals || fitted.source == NoiseSource::larger_residuals;
  result.coverage_factor = estimated ? student_central_quantile(0.95, std::max(1, result.degrees_of_freedom))
                                     : normal_central_quantile(0.95);
  if (fitted.outcome.slopes.cols() > 0) {
    const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(fitted.outcome.slopes).singularValues();
    result.singular_values.assign(values.data(), values.data() + values.size());
  }
  fill_readings(task, fitted, used, outliers, result);
  result.check = check_of(task, fitted, used);
  return result;
}

}  // namespace

tl::expected<Calibration, CalibrationFault> calibrate(const CalibrationTask& task) {
  if (auto fault = detail::fault_of(task)) return tl::unexpected(*fault);
  const std::vector<std::size_t> all = rest_of(task, {});
  const auto of_all = Fitting(task, all).run();
  const Cleaned clean = without_outliers(task, of_all);
  const bool kept = task.keep_outliers && of_all.has_value();
  const std::optional<Fitted>& fitted = kept ? of_all : clean.fitted;
  if (!fitted) {
    return tl::unexpected(
        CalibrationFault{{},
                         "readings that no instrument near the nominal one gives",
                         "readings within a few per cent of those of the nominal instrument"});
  }
  Calibration result = result_of(task, *fitted, kept ? all : rest_of(task, clean.outliers), clean.outliers);
  if (!clean.outliers.empty() && of_all)
    result.otherwise = kept ? clean.fitted->outcome.deviations : of_all->outcome.deviations;
  return result;
}

bool FitCheck::contradicts() const { return probability < slack::named_by_chance; }

}  // namespace kempe
