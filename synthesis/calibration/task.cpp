#include "synthesis/calibration/task.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "synthesis/calibration/knight.hpp"
#include "synthesis/calibration/slack.hpp"

namespace kempe {
namespace {

constexpr std::array<Measure, 6> link_lengths{Measure::VA, Measure::VB, Measure::AX,
                                              Measure::CX, Measure::BC, Measure::CY};

void add(std::vector<Measure>& all, std::initializer_list<Measure> more) { all.insert(all.end(), more); }

std::string_view fault_words(KnightFault fault) {
  switch (fault) {
    case KnightFault::too_few: return "two readings, at arm angles of 30 and 60 degrees";
    case KnightFault::at_an_end:
      return "arm angles from 5 to 85 degrees: next to 0 and 90 the equations lose rank; measure at 30 and "
             "60";
    case KnightFault::one_angle: break;
  }
  return "readings at two arm angles well apart, such as 30 and 60 degrees";
}

}  // namespace

namespace {

/// The standard deviation of rounding to the decimals in which the readings are written, at most of a
/// hundredth of a millimetre: ten readings of 0.00 do not say that the instrument is perfect.
double rounding_of(const Measurements& measurements) {
  constexpr int fewest = 2, most = 6;
  double step = 1;
  for (int decimals = 0; decimals <= most; ++decimals, step /= 10) {
    if (decimals < fewest) continue;
    const auto is_multiple = [step](double value) {
      return std::abs(value / step - std::round(value / step)) < slack::is_multiple;
    };
    const bool all = std::all_of(measurements.readings.begin(), measurements.readings.end(),
                                 [&](const ReadingSpec& reading) {
                                   const Point& read = reading.arm_angle ? reading.error : reading.pen;
                                   return is_multiple(read.x()) && is_multiple(read.y());
                                 });
    if (all) return step / std::sqrt(12.0);
  }
  return 0;
}

}  // namespace

std::size_t length_index(std::string_view name) {
  const std::string_view own = name == "arm_AC" ? "CX" : name == "arm_CF" ? "CY" : name;
  return static_cast<std::size_t>(std::find(LinkLengths::names.begin(), LinkLengths::names.end(), own) -
                                  LinkLengths::names.begin());
}

TaskMaking::TaskMaking(const Measurements& measurements, const std::optional<DrawnDesign>& design)
    : measurements_(&measurements), design_(&design) {
  task_.setups.push_back(setup(reference_ratio(), false));
  keys_.emplace_back(reference_ratio(), false);
  const FitSpec& fit = measurements.fit;
  task_.free = free_measures(fit.free, !design, is_straight(task_.setups.front()));
  task_.reading_uncertainty = fit.reading_uncertainty;
  task_.setting_uncertainty = fit.tracer_uncertainty;
  task_.keep_outliers = fit.keep_outliers;
  task_.rounding = rounding_of(measurements);
  const double size = task_.setups.front().drawn.head<8>().cwiseAbs().maxCoeff();
  constexpr double usual_share = 0.002;  // a millimetre on Knight's 500 mm
  task_.plausible_deviation = fit.plausible_deviation.value_or(usual_share * size);
  const auto known = [&](Measure measure, double percent) {
    const bool is_free = std::find(task_.free.begin(), task_.free.end(), measure) != task_.free.end();
    if (percent > 0 && !is_free)
      task_.known_within.push_back({measure, percent / 100 * size / std::sqrt(3.0)});
  };
  for (const Measure arm : {Measure::CX, Measure::CY}) known(arm, fit.arm_tolerance_percent);
  for (const Measure offset : {Measure::offset_A, Measure::offset_B})
    known(offset, fit.bearing_tolerance_percent);
  for (const LengthSpec& length : measurements.lengths)
    task_.lengths.push_back({length_index(length.name), length.value, length.uncertainty});
}

void TaskMaking::add(const ReadingSpec& reading) {
  const std::size_t number = setup_number(reading.ratio.value_or(reference_ratio()), reading.exchanged);
  CalibrationReading made{number, reading.tracer, reading.pen};
  if (reading.arm_angle) {
    const double arm = measurements_->instrument->arm;
    made.input =
        candidates_on_axis(task_, number, arm, *reading.arm_angle, *reading.arm_angle, 1).front().input;
    made.output = wanted_output(task_.setups[number], made.input) + reading.error;
  }
  task_.readings.push_back(made);
}

std::size_t TaskMaking::setup_number(double ratio, bool exchanged) {
  const std::pair key{ratio, exchanged};
  const auto known = std::find(keys_.begin(), keys_.end(), key);
  if (known != keys_.end()) return static_cast<std::size_t>(known - keys_.begin());
  keys_.push_back(key);
  task_.setups.push_back(setup(ratio, exchanged));
  return keys_.size() - 1;
}

double TaskMaking::reference_ratio() const {
  return measurements_->instrument ? measurements_->instrument->ratio : 0;
}

Instrument TaskMaking::setup(double ratio, bool exchanged) const {
  const Instrument drawn = *design_ ? instrument_of((*design_)->linkage)
                                    : variable_ratio_instrument(measurements_->instrument->arm, ratio);
  return exchanged ? drawn.exchanged() : drawn;
}

TaskMaking last_round(const Measurements& measurements, const std::optional<DrawnDesign>& design) {
  TaskMaking making(measurements, design);
  for (const ReadingSpec& reading : measurements.readings)
    if (reading.round == measurements.readings.back().round) making.add(reading);
  return making;
}

bool knights_case(const Measurements& measurements) {
  const FitSpec& fit = measurements.fit;
  if (!measurements.instrument || !measurements.lengths.empty()) return false;
  if (!fit.free.empty() && fit.free != std::vector<std::string>{"scales"}) return false;
  return std::all_of(measurements.readings.begin(), measurements.readings.end(),
                     [](const ReadingSpec& reading) { return reading.arm_angle.has_value(); });
}

CalibrationMethod method_for(const Measurements& measurements) {
  if (measurements.fit.method) return *measurements.fit.method;
  std::map<int, int> readings_of_round;
  int most = 0;
  for (const ReadingSpec& reading : measurements.readings)
    most = std::max(most, ++readings_of_round[reading.round]);
  return knights_case(measurements) && most <= 2 ? CalibrationMethod::knight
                                                 : CalibrationMethod::least_squares;
}

namespace {

/// Arms and bearings off by what Knight allows them move E in his readings, and so his errors.
void add_known_within(const CalibrationTask& task, const Eigen::Matrix<double, 4, Eigen::Dynamic>& by_reading,
                      Calibration& result) {
  for (const auto& [measure, uncertainty] : task.known_within) {
    Eigen::VectorXd moved(static_cast<Eigen::Index>(2 * task.readings.size()));
    for (std::size_t i = 0; i < task.readings.size(); ++i) {
      const Instrument& setup = task.setups[task.readings[i].setup];
      const auto output = output_at(setup, setup.drawn, task.readings[i].input);
      moved.segment<2>(static_cast<Eigen::Index>(2 * i)) =
          output ? Point(output->by.col(index_of(measure))) : Point(0, 0);
    }
    const Eigen::Vector4d errors = by_reading * moved;
    Measures shift = -deviations_of({errors[0], errors[1], errors[2], errors[3]});
    shift[index_of(measure)] += 1;
    result.covariance += uncertainty * uncertainty * shift * shift.transpose();
  }
}

}  // namespace

namespace {

tl::expected<Calibration, CalibrationFault> by_all_of(const CalibrationTask& task,
                                                      const Measurements& measurements,
                                                      const std::vector<std::size_t>& readings) {
  std::vector<KnightReading> knights;
  std::vector<double> factors;
  for (const std::size_t i : readings) {
    const ReadingSpec& reading = measurements.readings[i];
    // Read at F while E is held right, the departure appears enlarged by 1/k and turned about: E would err by
    // -k times it.
    const double k = reading.ratio.value_or(measurements.instrument->ratio);
    factors.push_back(reading.exchanged ? -k : 1);
    knights.push_back({*reading.arm_angle, factors.back() * reading.error});
  }
  const auto found = knight_errors(knights);
  if (!found)
    return tl::unexpected(
        CalibrationFault{{}, std::string(name(found.error())), std::string(fault_words(found.error()))});
  Calibration result;
  result.deviations = deviations_of(found->errors);
  result.noise = task.reading_uncertainty.value_or(assumed_reading_uncertainty);
  result.noise_source = task.reading_uncertainty ? NoiseSource::stated : NoiseSource::assumed;
  result.degrees_of_freedom = static_cast<int>(2 * readings.size()) - 4;
  result.coverage_factor = 1.959963984540054;
  auto by_reading = found->by_reading;
  for (std::size_t i = 0; i < factors.size(); ++i)
    by_reading.middleCols<2>(static_cast<Eigen::Index>(2 * i)) *= factors[i];
  const Eigen::Matrix4d covariance = result.noise * result.noise * by_reading * by_reading.transpose();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Scale &a = scales[static_cast<std::size_t>(i)], &b = scales[static_cast<std::size_t>(j)];
      result.covariance(index_of(a.measure), index_of(b.measure)) = a.sign * b.sign * covariance(i, j);
    }
  add_known_within(task, by_reading, result);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const CalibrationReading& reading = task.readings[i];
    result.readings.push_back(
        {.departure = reading.output - wanted_output(task.setups[reading.setup], reading.input),
         .left = found->left[i]});
    result.left_largest = std::max(result.left_largest, found->left[i].norm());
  }
  return result;
}

}  // namespace

tl::expected<Calibration, CalibrationFault> calibrate_by_knight(const CalibrationTask& task,
                                                                const Measurements& measurements,
                                                                const std::vector<std::size_t>& readings) {
  auto of_all = by_all_of(task, measurements, readings);
  constexpr std::size_t least_to_tell = 3;
  if (!of_all || readings.size() < least_to_tell) return of_all;
  const auto judged = calibrate(task);
  if (!judged) return of_all;
  of_all->check = judged->check;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    of_all->readings[i].studentised = judged->readings[i].studentised;
    of_all->readings[i].outlier = judged->readings[i].outlier;
  }
  CalibrationTask rest = task;
  std::vector<std::size_t> used, places;
  rest.readings.clear();
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (!judged->readings[i].outlier) {
      rest.readings.push_back(task.readings[i]);
      used.push_back(readings[i]);
      places.push_back(i);
    }
  if (used.size() == readings.size()) return of_all;
  auto without = by_all_of(rest, measurements, used);
  if (!without) return of_all;
  if (task.keep_outliers) {
    of_all->otherwise = without->deviations;
    return of_all;
  }
  std::vector<ReadingFit> all = judged->readings;  // what is left at those left out, by the exact instrument
  for (std::size_t i = 0; i < places.size(); ++i) all[places[i]].left = without->readings[i].left;
  without->readings = std::move(all);
  without->check = judged->check;
  without->otherwise = of_all->deviations;
  return without;
}

std::vector<Measure> free_measures(const std::vector<std::string>& groups, bool variable_ratio,
                                   bool straight) {
  std::vector<std::string> wanted = groups;
  if (wanted.empty())
    wanted = variable_ratio ? std::vector<std::string>{"scales"}
                            : std::vector<std::string>{"lengths", "bearings", "pole"};
  std::vector<Measure> free;
  for (const std::string& group : wanted) {
    if (group == "scales")
      for (const Scale& scale : scales) free.push_back(scale.measure);
    if (group == "arms") add(free, {Measure::CX, Measure::CY});
    if (group == "lengths") free.insert(free.end(), link_lengths.begin(), link_lengths.end());
    if (group == "bearings" || (group == "lengths" && !straight))
      add(free, {Measure::offset_A, Measure::offset_B});
    if (group == "pole") add(free, {Measure::pole_x, Measure::pole_y});
    if (group == "frame") add(free, {Measure::origin_x, Measure::origin_y, Measure::turn});
  }
  std::sort(free.begin(), free.end());
  free.erase(std::unique(free.begin(), free.end()), free.end());
  return free;
}

}  // namespace kempe
