// kempe/calibrate.hpp.

#include "kempe/calibrate.hpp"

#include <optional>

#include "reports/calibration/named_design.hpp"
#include "reports/calibration/report.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {

std::variant<std::string, InputError> calibrate_text(std::string_view measurements, const std::string& name,
                                                     const std::filesystem::path& folder) {
  auto read = read_measurements(measurements, name);
  if (!read) return read.error();
  read->simulation.reset();
  const auto design = named_design(*read, folder);
  if (!design) return design.error();
  const auto record = run_calibration(*read, *design, name);
  if (!record) return record.error();
  return calibration_json(*record, std::nullopt);
}

std::variant<std::string, InputError> calibrate(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return calibrate_text(*text, file.string(), file.parent_path());
}

}  // namespace kempe
