#pragma once
// What is wrong with a real instrument, from what it drew.

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

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

}  // namespace kempe
