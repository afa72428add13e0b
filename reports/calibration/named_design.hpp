#pragma once
// The design that measurements name.

#include <filesystem>
#include <optional>
#include <tl/expected.hpp>

#include "reports/data/design_json.hpp"
#include "specs/text/text_file.hpp"
#include "synthesis/calibration/job.hpp"

namespace kempe {

/// The design that the measurements name, looked for in `folder`; nothing for a variable ratio instrument.
inline tl::expected<std::optional<DrawnDesign>, InputError> named_design(
    const Measurements& measurements, const std::filesystem::path& folder) {
  if (measurements.design.empty()) return std::nullopt;
  const auto path = (folder / measurements.design).string();
  const auto text = read_text_file(path);
  if (!text) return tl::unexpected(text.error());
  const auto design = read_design(*text, path);
  if (!design) return tl::unexpected(design.error());
  const auto linkage = linkage_of(*design, path);
  if (!linkage) return tl::unexpected(linkage.error());
  return drawn_design(*linkage, design->mechanism.opening, design->region);
}

}  // namespace kempe
