// What makes a calibration hopeless, and what to give or to measure instead.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/calibration/slack.hpp"
#include "synthesis/calibration/weighted_fit.hpp"

namespace kempe::calibration_detail {
namespace {

using Fault = std::optional<CalibrationFault>;

using Readings = std::vector<const CalibrationReading*>;

/// How much farther apart two readings were read than set: the middle of all pairs that lie at least half as far apart as
/// the farthest, so that one wrong reading does not decide. 0 where all lie together.
double enlargement(const Readings& readings, double far_enough) {
  constexpr std::size_t many = 300;
  const std::size_t step = 1 + readings.size() / many;
  struct Apart {
    double in, out;
  };
  std::vector<Apart> pairs;
  double farthest = 0;
  for (std::size_t i = 0; i < readings.size(); i += step)
    for (std::size_t j = i + step; j < readings.size(); j += step) {
      pairs.push_back({(readings[i]->input - readings[j]->input).norm(),
                       (readings[i]->output - readings[j]->output).norm()});
      farthest = std::max(farthest, pairs.back().in);
    }
  if (farthest < far_enough) return 0;
  std::vector<double> factors;
  for (const Apart& pair : pairs)
    if (pair.in >= 0.5 * farthest) factors.push_back(pair.out / pair.in);
  const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
  std::nth_element(factors.begin(), middle, factors.end());
  return *middle;
}

/// The copy's size against the ratio.
Fault fault_of_size(const CalibrationTask& task, std::size_t setup) {
  Readings readings;
  for (const auto& reading : task.readings)
    if (reading.setup == setup) readings.push_back(&reading);
  const double size = task.setups[setup].drawn.head<8>().cwiseAbs().maxCoeff(),
               k = std::abs(task.setups[setup].ratio);
  constexpr double far_enough = 0.02, near_enough = 0.25;
  const double enlarged = enlargement(readings, far_enough * size), factor = enlarged / k;
  if (enlarged == 0 || std::abs(factor - 1) < near_enough) return {};
  const auto near = [&](double other) { return std::abs(factor / other - 1) < 0.1; };
  std::string hint;
  if (near(1 / (k * k))) hint = "; are the place set and the place read exchanged?";
  for (const double unit : {1000.0, 25.4, 10.0})
    if (near(unit) || near(1 / unit)) hint = fmt::format("; a factor of {} looks like another unit", unit);
  return CalibrationFault{
      {},
      fmt::format("points read that lie {:.4g} times as far apart as the points set", enlarged),
      fmt::format("about {:.4g} times, the instrument's ratio, all in millimetres{}", k, hint)};
}

/// Another unit that would bring the place within reach, for the message.
std::string unit_hint(const Instrument& setup, const Point& input) {
  for (const auto& [factor, unit] : {std::pair{1000.0, "metres"}, {25.4, "inches"}, {10.0, "centimetres"}})
    if (output_at(setup, setup.drawn, factor * input)) return fmt::format("; is it in {}?", unit);
  if (output_at(setup, setup.drawn, input / 1000)) return "; is it in micrometres?";
  return "";
}

Fault fault_of_reach(const CalibrationTask& task) {
  for (std::size_t i = 0; i < task.readings.size(); ++i) {
    const auto& reading = task.readings[i];
    const Instrument& setup = task.setups[reading.setup];
    const auto closed = output_at(setup, setup.drawn, reading.input);
    if (closed) continue;
    const Point from_pole(reading.input - Point(setup.drawn[index_of(Measure::pole_x)],
                                                setup.drawn[index_of(Measure::pole_y)]));
    return CalibrationFault{
        i, fmt::format("a place {:.6g} mm from the pole, {}", from_pole.norm(), name(closed.error())),
        "a place that the instrument reaches, in millimetres" + unit_hint(setup, reading.input)};
  }
  return {};
}

Fault fault_of_count(const CalibrationTask& task) {
  const std::size_t rows = 2 * task.readings.size() + task.lengths.size();
  if (rows < task.free.size()) {
    const std::size_t needed = (task.free.size() - task.lengths.size() + 1) / 2;
    return CalibrationFault{
        {},
        fmt::format("{} readings for {} unknown measures", task.readings.size(), task.free.size()),
        fmt::format("at least {} readings; better {}, at places spread over the whole reach", needed,
                    2 * needed)};
  }
  return {};
}

Fault fault_of_spread(const CalibrationTask& task) {
  if (task.readings.empty()) return {};
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (const auto& reading : task.readings) {
    const Instrument& setup = task.setups[reading.setup];
    if (reading.setup != task.readings.front().setup) return {};
    const Point pole(setup.drawn[index_of(Measure::pole_x)], setup.drawn[index_of(Measure::pole_y)]);
    lowest = std::min(lowest, (reading.input - pole).norm());
    highest = std::max(highest, (reading.input - pole).norm());
  }
  if (highest - lowest > slack::one_opening * highest) return {};
  return CalibrationFault{
      {},
      fmt::format("all readings {:.4g} mm from the pole, at one opening of the linkage", highest),
      "readings near to and far from the pole, a few at each"};
}

}  // namespace

std::optional<CalibrationFault> fault_of(const CalibrationTask& task) {
  if (auto fault = fault_of_count(task)) return fault;
  if (auto fault = fault_of_reach(task)) return fault;
  if (auto fault = fault_of_spread(task)) return fault;
  for (std::size_t setup = 0; setup < task.setups.size(); ++setup)
    if (auto fault = fault_of_size(task, setup)) return fault;
  return {};
}

}  // namespace kempe::calibration_detail
