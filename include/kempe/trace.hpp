#pragma once
// A drawing copied through a design's mechanism, pose by pose.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/design.hpp"
#include "kempe/drawing_options.hpp"
#include "kempe/export.hpp"
#include "kempe/input_error.hpp"
#include "kempe/point.hpp"

namespace kempe {

/// A line that the pen drew, or where it should have drawn one, mm on the table.
struct CopiedLine {
  std::size_t original = 0;  ///< which of the given lines, from 0
  Polyline points;           ///< the pen's places
};

/// What became of a drawing.
struct CopiedDrawing {
  std::vector<CopiedLine> drawn;    ///< in the original's order and direction
  std::vector<CopiedLine> missing;  ///< where the pen should have been
  double drawn_length = 0;          ///< mm of the original
  double missing_length = 0;        ///< mm of the original
  std::size_t poses = 0;            ///< tried
  std::size_t poses_missed = 0;     ///< of them, those that do not exist
  double departure = 0;             ///< mm, largest distance of the pen from the similar image at any pose
  bool complete = true;             ///< false: stopped before every line had been followed to its end
};

/// Copies lines (mm, table frame), poses at most `step` (mm) apart. Every point of a drawn line is the pen's place in a
/// pose whose loops close, without contact with an obstacle (docs/verification.md); the similarity is never used to place the
/// pen. Where the tracer cannot follow, the line is cut to 1e-9 mm of the last place that it reaches; a place beyond reach is an
/// outcome, told in `missing`. An obstacle narrower than the step may stand between two poses. A line without points is left out. `stop` (true ends it) is asked at every
/// pose; then the copy so far is returned, not `complete`. Errors:
/// `step` that is not finite and > 0, or makes more than five million poses (key "step"), a point that is not finite (key
/// "lines[2]" for the third line).
KEMPE_EXPORT std::variant<CopiedDrawing, InputError> trace(const FinishedDesign& design,
                                                           const std::vector<Polyline>& lines,
                                                           double step = 0.5,
                                                           const std::function<bool()>& stop = {});

/// A drawing's file copied, with what `kempe trace` writes of it.
struct TracedDrawing {
  CopiedDrawing copy;  ///< `original`: which line of the drawing, from 0; closed lines end where they begin
  std::string json;    ///< what `kempe trace --json` prints, without the name of the copy's file
  std::string
      svg;  ///< the copy, 1:1, what is missing in red; with DrawingOptions::keep_forces coloured by them
  /// CSV, a row for each pose: stroke, reached, tracer's place, opening, the six joints' places (mm, degrees); empty without
  /// DrawingOptions::keep_joints.
  std::string joints_csv;
  /// CSV, a row for each pose reached: what the hand and the pins feel, N (docs/loads.md); empty without DrawingOptions::keep_forces.
  std::string forces_csv;
};

/// Copies a drawing (the text of an SVG file, docs/drawings-in.md) as `kempe trace` does with the file of the design; `name` stands for the
/// drawing's file in messages and in the copy's title. Errors: what is no SVG, or has no lines; an option that cannot be, its key the
/// member's name ("tolerance_mm" and "step_mm" for `tolerance` and `step`); `load` or `keep_forces` with a design without material or load
/// (key "material" or "load").
KEMPE_EXPORT std::variant<TracedDrawing, InputError> trace_svg(const FinishedDesign& design,
                                                               std::string_view drawing,
                                                               const DrawingOptions& options = {},
                                                               const std::string& name = "");
/// The same of a file.
KEMPE_EXPORT std::variant<TracedDrawing, InputError> trace_svg_file(const FinishedDesign& design,
                                                                    const std::filesystem::path& drawing,
                                                                    const DrawingOptions& options = {});

}  // namespace kempe
