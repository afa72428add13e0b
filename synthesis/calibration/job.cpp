#include "synthesis/calibration/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/calibration/advice.hpp"
#include "synthesis/calibration/settings.hpp"
#include "synthesis/calibration/slack.hpp"
#include "synthesis/calibration/task.hpp"

namespace kempe {
namespace {

InputError input_error(const CalibrationFault& fault, const Measurements& measurements,
                       const std::vector<std::size_t>& readings, const std::string& file) {
  InputError error{file, 0, "reading", fault.found, fault.allowed};
  if (fault.reading) {
    const ReadingSpec& reading = measurements.readings[readings[*fault.reading]];
    error.line = reading.line;
    error.key = reading.arm_angle ? "reading.arm_angle_deg" : "reading.tracer_mm";
  } else if (!readings.empty()) {
    error.line = measurements.readings[readings.front()].line;
  }
  return error;
}

/// Departures once the corrections are set: by the exact instrument that best explains the readings.
double residual_of(const CalibrationTask& task, const Calibration& calibration, CalibrationMethod method) {
  if (method == CalibrationMethod::least_squares) return calibration.left_largest;
  const auto exact = calibrate(task);
  const auto left = exact ? departure_with(task, exact->deviations, -calibration.deviations) : std::nullopt;
  return std::max(left.value_or(calibration.left_largest), calibration.left_largest);
}

double largest_departure(const Calibration& calibration) {
  double largest = 0;
  for (const ReadingFit& reading : calibration.readings)
    largest = std::max(largest, reading.departure.norm());
  return largest;
}

/// Of a drawn length: what one that was made is off by at most.
constexpr double largest_share = 0.05;

class Job {
 public:
  Job(const Measurements& measurements, const std::optional<DrawnDesign>& design, const std::string& file)
      : measurements_(measurements), design_(design), file_(file) {}

  tl::expected<CalibrationRecord, InputError> run() {
    record_.measurements = measurements_;
    record_.design = design_;
    record_.method = method_for(measurements_);
    TaskMaking present(measurements_, design_);
    if (const auto fault = length_fault(present.task())) return tl::unexpected(*fault);
    for (const std::vector<std::size_t>& readings : readings_by_round()) {
      present = TaskMaking(measurements_, design_);
      for (const std::size_t i : readings) present.add(measurements_.readings[i]);
      if (const auto fault = add_round(present.task(), readings)) return tl::unexpected(*fault);
    }
    finish(present);
    return std::move(record_);
  }

 private:
  std::vector<std::vector<std::size_t>> readings_by_round() const {
    std::vector<std::vector<std::size_t>> rounds;
    for (std::size_t i = 0; i < measurements_.readings.size(); ++i) {
      rounds.resize(static_cast<std::size_t>(measurements_.readings[i].round));
      rounds.back().push_back(i);
    }
    return rounds;
  }

  /// A measured length that cannot be that of the drawn instrument, or that would go unused.
  std::optional<InputError> length_fault(const CalibrationTask& task) const {
    const MeasuredLengths drawn = lengths_of(task.setups.front().drawn);
    for (std::size_t k = 0; k < measurements_.lengths.size(); ++k) {
      const LengthSpec& given = measurements_.lengths[k];
      const auto row = static_cast<Eigen::Index>(task.lengths[k].length);
      const double as_drawn = drawn.values[row];
      if (std::abs(given.value - as_drawn) > largest_share * as_drawn)
        return InputError{file_, given.line, "lengths_mm." + given.name,
                          fmt::format("{:.6g} mm, of {:.6g} mm drawn", given.value, as_drawn),
                          "a length within a twentieth of the drawn one"};
      const bool counts = std::any_of(task.free.begin(), task.free.end(),
                                      [&](Measure measure) { return drawn.by(row, index_of(measure)) != 0; });
      if (!counts)
        return InputError{file_, given.line, "lengths_mm." + given.name,
                          "a length that stays as drawn, for nothing that is free changes it",
                          fmt::format("it where fit.free has \"{}\"", design_ ? "lengths" : "arms")};
    }
    return std::nullopt;
  }

  std::optional<InputError> add_round(const CalibrationTask& task, const std::vector<std::size_t>& readings) {
    const bool knight = record_.method == CalibrationMethod::knight;
    if (knight && !knights_case(measurements_))
      return InputError{
          file_, 0, "fit.method",
          "Knight's method for readings of places, with lengths or with more than the scales free",
          "readings with arm_angle_deg and error_mm, or method = \"least_squares\""};
    auto found = knight ? calibrate_by_knight(task, measurements_, readings) : calibrate(task);
    if (!found) return input_error(found.error(), measurements_, readings, file_);
    RoundRecord round;
    round.round = static_cast<int>(record_.rounds.size()) + 1;
    round.readings = readings;
    round.departure_largest = largest_departure(*found);
    round.residual = residual_of(task, *found, record_.method);
    round.deviations = found->deviations;
    round.corrections = scale_corrections(found->deviations);
    round.quantities = quantities_of(task.setups.front(), !design_, task.free, *found).quantities;
    record_.rounds.push_back(std::move(round));
    record_.otherwise.clear();
    if (found->otherwise) {
      Calibration otherwise = *found;
      otherwise.deviations = *found->otherwise;
      record_.otherwise = quantities_of(task.setups.front(), !design_, task.free, otherwise).quantities;
    }
    record_.calibration = std::move(*found);
    fill_readings(task, readings);
    return std::nullopt;
  }

  /// Arms and bearings cannot be set: the scales then take up what they can at the instrument's own ratio.
  ScaleErrors scale_corrections(const Measures& deviations) const {
    Measures unsettable = deviations;
    for (const Scale& scale : scales) unsettable[index_of(scale.measure)] = 0;
    unsettable.tail<5>().setZero();
    if (design_ || unsettable.isZero(0)) return -scale_errors_of(deviations);
    SettingTask task = setting_task();
    task.deviations = deviations;
    task.deviations.tail<5>().setZero();
    return setting_for(task, {"", measurements_.instrument->ratio}, false).corrections;
  }

  void fill_readings(const CalibrationTask& task, const std::vector<std::size_t>& readings) {
    record_.readings.clear();
    for (std::size_t i = 0; i < readings.size(); ++i) {
      const CalibrationReading& reading = task.readings[i];
      record_.readings.push_back({readings[i], reading.input,
                                  wanted_output(task.setups[reading.setup], reading.input), reading.output,
                                  record_.calibration.readings[i]});
    }
  }

  void finish(TaskMaking& present) {
    const CalibrationTask& task = present.task();
    if (!record_.rounds.empty()) {
      finish_errors(task);
      record_.indistinct = advice_for(present, record_.calibration);
    }
    if (measurements_.instrument) record_.settings = setting_table(setting_task(), measurements_.ratios);
    if (measurements_.plan) record_.plan = plan_for(measurements_, design_);
    record_.setups = task.setups;
  }

  void finish_errors(const CalibrationTask& task) {
    const auto table = quantities_of(task.setups.front(), !design_, task.free, record_.calibration);
    const Eigen::MatrixXd covariance = table.by * record_.calibration.covariance * table.by.transpose();
    const Eigen::VectorXd deviations = covariance.diagonal().cwiseMax(0).cwiseSqrt();
    record_.correlations = Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols());
    for (Eigen::Index i = 0; i < covariance.rows(); ++i)
      for (Eigen::Index j = 0; j < covariance.cols(); ++j)
        if (i != j) {
          const double scale = deviations[i] * deviations[j];
          record_.correlations(i, j) = scale > 0 ? std::clamp(covariance(i, j) / scale, -1.0, 1.0) : 0;
        }
    record_.total = table.quantities;
    for (std::size_t i = 0; i < record_.total.size(); ++i) {
      record_.total[i].error = 0;
      for (const RoundRecord& round : record_.rounds) record_.total[i].error += round.quantities[i].error;
    }
    record_.reached = record_.rounds.back().departure_largest <= measurements_.fit.target;
  }

  SettingTask setting_task() const {
    SettingTask task;
    task.arm = measurements_.instrument->arm;
    task.deviations = record_.calibration.deviations;
    task.deviations.tail<5>().setZero();
    task.covariance = record_.calibration.covariance;
    task.coverage_factor = record_.calibration.coverage_factor;
    task.arm_angles = measurements_.arm_angles;
    return task;
  }

  const Measurements& measurements_;
  const std::optional<DrawnDesign>& design_;
  const std::string& file_;
  CalibrationRecord record_;
};

}  // namespace

std::string words_of(const FitCheck& check, bool outliers_named) {
  if (check.contradicts())
    return fmt::format(
        "the residuals are larger than the stated uncertainty explains: chance gives as much in {:.2g} of "
        "all fits. {}",
        check.probability,
        outliers_named ? "The outliers contribute if they are kept"
                       : "No single reading explains it: all are less accurate than stated, or there are too "
                         "few to find the wrong one, or a measure that is not free is wrong");
  if (check.probability > 1 - slack::rare)
    return "the residuals are smaller than the stated uncertainty explains: it is stated too large";
  return "the residuals agree with the stated uncertainty";
}

double correction_of(const CalibrationRecord& record, const RoundRecord& round, const Quantity& quantity) {
  for (std::size_t i = 0; i < 4 && !record.design; ++i)
    if (quantity.name == ScaleErrors::names[i]) return round.corrections.values()[i];
  return -quantity.error;
}

tl::expected<CalibrationRecord, InputError> run_calibration(const Measurements& measurements,
                                                            const std::optional<DrawnDesign>& design,
                                                            const std::string& file) {
  if (measurements.readings.empty() && !measurements.plan && !measurements.simulation)
    return tl::unexpected(
        InputError{file, 0, "reading", "no readings",
                   "at least two [[reading]] tables, or --plan (where to measure), or --simulate"});
  return Job(measurements, design, file).run();
}

}  // namespace kempe
