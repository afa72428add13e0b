#pragma once
// What is wrong with a real instrument, from what it drew.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/export.hpp"
#include "kempe/input_error.hpp"

namespace kempe {

/// The calibration of an instrument from its readings (TOML, docs/calibration.md): calibration.json as `kempe calibrate` writes it, one
/// object with errors, their uncertainties, what to set, and what is left; mm. A table [simulate] plays no part. `name` stands for the
/// file in messages; a design that the text names is looked for in `folder`.
KEMPE_EXPORT std::variant<std::string, InputError> calibrate_text(std::string_view measurements,
                                                                  const std::string& name = "",
                                                                  const std::filesystem::path& folder = {});
/// The same of a file; a design that it names is looked for beside it.
KEMPE_EXPORT std::variant<std::string, InputError> calibrate(const std::filesystem::path& file);

/// What may be asked beside the file, as the options of `kempe calibrate` do.
struct CalibrationOptions {
  std::optional<double> target;      ///< mm, 1e-6 to 1000: the copy error that is good enough
  std::string method;                ///< "knight" or "least_squares"; "": what fits the readings
  std::vector<std::string> ratios;   ///< a table of settings for each, such as "1:3" or "0.4"; 0.01 to 100
  bool plan = false;                 ///< propose the readings that determine most (D-optimal)
  std::optional<int> plan_readings;  ///< how many, 1 to 100
  bool simulate = false;             ///< simulate instruments with hidden errors
  std::uint64_t seed = 1;            ///< of the simulation
  bool equations =
      false;  ///< write out Knight's equations of the last round, and their matrix, with their numbers, into the JSON
  /// Asked often; once true the simulation ends, and is left out of what comes back.
  std::function<bool()> stop{};
};

/// A calibration with its page.
struct CalibratedInstrument {
  std::string json;       ///< what `kempe calibrate --json` prints
  std::string text;       ///< what it prints for a person
  std::string page;       ///< HTML, loads nothing
  std::string simulated;  ///< the first simulated instrument's readings as a file of measurements; else ""
};

/// The calibration as `calibrate_text` gives it, with options. Errors: those of the file; an option that cannot be, its key the
/// member's name ("target_mm" for `target`).
KEMPE_EXPORT std::variant<CalibratedInstrument, InputError> calibrate_with(
    const CalibrationOptions& options, std::string_view measurements, const std::string& name = "",
    const std::filesystem::path& folder = {});

/// The same of a file; a design that it names is looked for beside it.
KEMPE_EXPORT std::variant<CalibratedInstrument, InputError> calibrate_file_with(
    const CalibrationOptions& options, const std::filesystem::path& file);

}  // namespace kempe
