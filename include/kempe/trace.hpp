#pragma once
// A drawing copied through a design's mechanism, pose by pose.

#include <cstddef>
#include <variant>
#include <vector>

#include "kempe/design.hpp"
#include "kempe/export.hpp"
#include "kempe/input_error.hpp"
#include "kempe/region.hpp"

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
};

/// Copies lines (mm, table frame), poses at most `step` (mm) apart. Every point of a drawn line is the pen's place in a
/// pose whose loops close, without contact with an obstacle (docs/verification.md); the similarity is never used to place the
/// pen. Where the tracer cannot follow, the line is cut to 1e-9 mm of the last place that it reaches; a place beyond reach is an
/// outcome, told in `missing`. Errors: `step` that is not finite and > 0 (key "step"), a point that is not finite (key
/// "lines[2]" for the third line).
KEMPE_EXPORT std::variant<CopiedDrawing, InputError> trace(const FinishedDesign& design,
                                                           const std::vector<Polyline>& lines,
                                                           double step = 0.5);

}  // namespace kempe
