#pragma once
// A drawing (SVG) copied through a stored design: placed on the table, traced, and told. What `kempe trace` does.

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "kempe/drawing_options.hpp"
#include "reports/data/design_json.hpp"
#include "specs/drawings/svg_reader.hpp"
#include "synthesis/verification/drawing_trace.hpp"

namespace kempe {

/// What an option's number may be.
struct OptionRange {
  double lowest, highest;
};
inline constexpr OptionRange drawing_scales{1e-6, 1e6};
inline constexpr OptionRange drawing_tolerances{1e-7, 10};  ///< mm
inline constexpr OptionRange drawing_steps{1e-4, 1e3};      ///< mm

/// A drawing and what became of it.
struct DrawingCopy {
  StrokeDrawing drawing;  ///< placed on the table
  Trace trace;
  std::optional<HandWork> work;  ///< with DrawingOptions::load or keep_forces
};

/// Copies the drawing that `svg` is; the names stand for the files in messages. Errors: a design whose figures contradict each other, or
/// without the load that is asked for; what is no SVG; a drawing without lines.
tl::expected<DrawingCopy, InputError> copy_drawing(const StoredDesign& design, const std::string& design_file,
                                                   std::string_view svg, const std::string& drawing_file,
                                                   const DrawingOptions& options);

/// "12 beyond the outer reach, 3 among obstacles": the positions that were missed, by cause.
std::string causes(const Trace& trace);

/// The copy as `kempe trace --json` tells it; `file` is where it was written. Empty: without the key "copy".
std::string drawing_copy_json(const DrawingCopy& copy, const DrawingOptions& options,
                              const std::string& file);

/// What the copy's picture is called: "letter.svg, copied".
std::string copy_title(const std::string& drawing_file);

}  // namespace kempe
