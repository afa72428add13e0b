#pragma once
// What is asked of a calibration beside its file.

#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "specs/measurements.hpp"
#include "specs/text/ratio.hpp"

namespace kempe {

/// Each as the option of `kempe calibrate` with its name.
struct CalibrationChoices {
  std::optional<double> target;  ///< mm
  std::optional<CalibrationMethod> method;
  std::vector<std::string> ratios;
  bool plan = false, simulate = false;
  std::optional<int> plan_readings;
};

/// Measurements with these choices over the file's own. An error's key is `dashes` and the option's name.
inline tl::expected<Measurements, InputError> with_choices(Measurements measurements,
                                                           const CalibrationChoices& choices,
                                                           const std::string& dashes) {
  if (choices.target) measurements.fit.target = *choices.target;
  if (choices.method) measurements.fit.method = *choices.method;
  if (measurements.fit.method == CalibrationMethod::knight && !measurements.instrument)
    return tl::unexpected(
        InputError{"", 0, dashes + "method", "Knight's method for a design", "least_squares"});
  for (const std::string& text : choices.ratios) {
    const auto value = parse_ratio(text);
    if (!value || *value < 0.01 || *value > 100)
      return tl::unexpected(
          InputError{"", 0, dashes + "ratios", text, "ratios from 0.01 to 100, such as 1:3 or 0.4"});
    measurements.ratios.push_back({text, *value});
  }
  if (choices.plan && !measurements.plan) measurements.plan.emplace();
  if (measurements.plan && choices.plan_readings) measurements.plan->readings = *choices.plan_readings;
  if (choices.simulate && !measurements.simulation) measurements.simulation.emplace();
  if (!choices.simulate) measurements.simulation.reset();
  return measurements;
}

}  // namespace kempe
