#include "synthesis/calibration/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"

namespace kempe {
namespace {

std::string part_words(const Indistinct::Part& part, Measure first, bool variable_ratio) {
  // Scales speak in Knight's sign: a longer DE is a smaller reading of its scale.
  double amount = part.factor;
  if (variable_ratio && part.measure == Measure::VB) amount = -amount;
  if (variable_ratio && first == Measure::VB) amount = -amount;
  if (part.measure == Measure::turn) return fmt::format("turn {:+.4g} degrees", degrees(amount));
  return fmt::format("{} {:+.3g} mm", spoken_name(part.measure, variable_ratio), amount);
}

bool has_part(const Indistinct& combination, std::initializer_list<Measure> measures) {
  return std::any_of(combination.parts.begin(), combination.parts.end(), [&](const Indistinct::Part& part) {
    return std::find(measures.begin(), measures.end(), part.measure) != measures.end();
  });
}

class Advice {
 public:
  Advice(TaskMaking& making, const Calibration& calibration)
      : making_(making), variable_ratio_(making.measurements().instrument.has_value()),
        noise_(calibration.noise) {
    if (variable_ratio_)
      for (const double ratio : {0.25, 0.75})
        if (std::abs(ratio - making_.reference_ratio()) > 0.1)
          other_settings_.emplace_back(making_.setup_number(ratio, false), ratio);
  }

  std::vector<Remedy> remedies(const Indistinct& combination) const {
    std::vector<Remedy> all;
    add_lengths(combination, all);
    add_settings(combination, all);
    add_places(combination, all);
    const double plausible = making_.task().plausible_deviation;
    std::erase_if(all, [&](const Remedy& remedy) { return !(remedy.uncertainty <= plausible); });
    std::stable_sort(all.begin(), all.end(),
                     [](const Remedy& a, const Remedy& b) { return a.uncertainty < b.uncertainty; });
    constexpr std::size_t most = 3;
    if (all.size() > most) all.resize(most);
    if (all.empty())
      all.push_back(
          {fmt::format("take {} as drawn", spoken_name(combination.parts.front().measure, variable_ratio_)),
           0});
    return all;
  }

 private:
  void add_lengths(const Indistinct& combination, std::vector<Remedy>& all) const {
    constexpr double by_caliper = 0.02;
    for (const std::string_view length : measurable_lengths(variable_ratio_))
      all.push_back({fmt::format("measure {} on the instrument and give it in [lengths_mm]", length),
                     uncertainty_after(making_.task(), combination, length_index(length), by_caliper)});
  }

  void add_settings(const Indistinct& combination, std::vector<Remedy>& all) const {
    const ArmAngles& angles = making_.measurements().arm_angles;
    for (const auto& [setup, ratio] : other_settings_)
      for (const Candidate& candidate :
           candidates_on_axis(making_.task(), setup, making_.measurements().instrument->arm, angles.lower,
                              angles.upper, 11)) {
        const double angle = std::acos(candidate.input.norm() / (2 * making_.measurements().instrument->arm));
        all.push_back({fmt::format("read at {:.0f} degrees with the scales set to {} (ratio = {})",
                                   degrees(angle), ratio, ratio),
                       uncertainty_after(making_.task(), combination, candidate, noise_)});
      }
  }

  void add_places(const Indistinct& combination, std::vector<Remedy>& all) const {
    if (has_part(combination, {Measure::pole_x, Measure::pole_y}))
      all.push_back({"measure where the pole stands and leave \"pole\" out of [fit] free",
                     0.1 * making_.task().plausible_deviation});
    if (has_part(combination, {Measure::origin_x, Measure::origin_y, Measure::turn}))
      all.push_back({"read original and copy in one frame and leave \"frame\" out of [fit] free",
                     0.1 * making_.task().plausible_deviation});
  }

  TaskMaking& making_;
  bool variable_ratio_;
  double noise_;
  std::vector<std::pair<std::size_t, double>> other_settings_;
};

/// The plan of a task whose setups are the instrument and, where wanted, the instrument exchanged.
struct PlanSpace {
  CalibrationTask task;
  std::vector<Candidate> candidates, evenly;
};

PlanSpace plan_space(TaskMaking& making) {
  const Measurements& measurements = making.measurements();
  const std::optional<DrawnDesign>& design = making.design();
  PlanSpace space;
  const double ratio = measurements.instrument ? measurements.instrument->ratio : 0;
  std::vector<std::size_t> setups{0};
  if (measurements.plan->exchange) setups.push_back(making.setup_number(ratio, true));
  space.task = making.task();
  const ArmAngles& angles = measurements.arm_angles;
  for (const std::size_t setup : setups) {
    const auto more = design ? candidates_over_reach(*design, setup != 0, setup, 8, 8)
                             : candidates_on_axis(space.task, setup, measurements.instrument->arm,
                                                  angles.lower, angles.upper, 21);
    space.candidates.insert(space.candidates.end(), more.begin(), more.end());
  }
  const int count = measurements.plan->readings;
  if (design) {
    constexpr double golden = 0.6180339887498949;
    for (int i = 0; i < count; ++i)
      space.evenly.push_back({0, design->place((i + 0.5) / count, std::fmod(golden * i, 1.0))});
  } else {
    space.evenly =
        candidates_on_axis(space.task, 0, measurements.instrument->arm, angles.lower, angles.upper, count);
  }
  return space;
}

Eigen::MatrixXd with_plausible(const CalibrationTask& task, Eigen::MatrixXd information) {
  information.diagonal().array() += 1 / (task.plausible_deviation * task.plausible_deviation);
  return information;
}

/// Covariance of the measures that planned readings would give, in mm and rad.
Calibration expected_calibration(const CalibrationTask& task, const Eigen::MatrixXd& information,
                                 double noise) {
  Calibration expected;
  expected.noise = noise;
  const Eigen::MatrixXd small = inverse_of(information);
  const double size = task.setups.front().drawn.head<8>().cwiseAbs().maxCoeff();
  const auto unit = [&](Measure measure) { return measure == Measure::turn ? 1 / size : 1.0; };
  for (std::size_t i = 0; i < task.free.size(); ++i)
    for (std::size_t j = 0; j < task.free.size(); ++j)
      expected.covariance(index_of(task.free[i]), index_of(task.free[j])) =
          small(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * unit(task.free[i]) *
          unit(task.free[j]);
  return expected;
}

}  // namespace

std::string words_of(const Indistinct& combination, bool variable_ratio) {
  const Measure first = combination.parts.front().measure;
  std::string words;
  constexpr double milliradian = 1e-3;
  const double step = first == Measure::turn ? milliradian : 1;
  for (std::size_t i = 0; i < combination.parts.size(); ++i) {
    const char* separator = i == 0                              ? ""
                            : i == 1                            ? " together with "
                            : i + 1 == combination.parts.size() ? " and "
                                                                : ", ";
    const auto& [measure, factor] = combination.parts[i];
    words += separator + part_words({measure, step * factor}, first, variable_ratio);
  }
  return words;
}

std::vector<UndeterminedCombination> advice_for(TaskMaking& making, const Calibration& calibration) {
  std::vector<UndeterminedCombination> all;
  if (calibration.indistinct.empty()) return all;
  const Advice advice(making, calibration);
  for (const Indistinct& one : calibration.indistinct)
    all.push_back({one, words_of(one, making.measurements().instrument.has_value()), advice.remedies(one)});
  return all;
}

PlanRecord plan_for(const Measurements& measurements, const std::optional<DrawnDesign>& design) {
  TaskMaking making = last_round(measurements, design);
  const PlanSpace space = plan_space(making);
  const double noise = measurements.fit.reading_uncertainty.value_or(assumed_reading_uncertainty);
  const auto chosen =
      d_optimal(space.task, space.candidates, static_cast<std::size_t>(measurements.plan->readings), noise);
  PlanRecord plan;
  for (const Candidate& one : chosen) {
    const Instrument& setup = space.task.setups[one.setup];
    PlannedReading reading{.exchanged = one.setup != 0,
                           .arm_angle = {},
                           .input = one.input,
                           .wanted = wanted_output(setup, one.input)};
    if (measurements.instrument) {
      const double tracer_to_pole = std::max(reading.input.norm(), reading.wanted.norm());
      reading.arm_angle =
          std::acos(std::clamp(tracer_to_pole / (2 * measurements.instrument->arm), -1.0, 1.0));
    }
    plan.readings.push_back(reading);
  }
  const Eigen::MatrixXd best = with_plausible(space.task, information_of(space.task, chosen, noise));
  const Eigen::MatrixXd even = with_plausible(space.task, information_of(space.task, space.evenly, noise));
  plan.quantities = quantities_of(space.task.setups.front(), !design, space.task.free,
                                  expected_calibration(space.task, best, noise))
                        .quantities;
  const double ratio = std::log(best.determinant()) - std::log(even.determinant());
  plan.gain = std::exp(0.5 * ratio / static_cast<double>(space.task.free.size()));
  return plan;
}

}  // namespace kempe
