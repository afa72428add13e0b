#pragma once
// A traced drawing as files: the copy as SVG, every joint's place as CSV.

#include <string>
#include <string_view>

#include "kinematics/copying_linkage.hpp"
#include "synthesis/verification/drawing_trace.hpp"

namespace kempe {

/// The copy, 1:1 in mm: group "copy" with a path a line drawn, in the original's order and direction; group
/// "left-out" with the missing lines in red, where they should be. The viewBox is in the table's frame with y
/// turned downward. Lines with TracedLine::hand are coloured by it, with a legend below. Nothing of the original's file is taken over but `title`, escaped.
std::string copy_svg(const Trace& trace, std::string_view title);

/// stroke, reached, tracer_x_mm, tracer_y_mm, opening_deg, then x and y of V, A, B, C, X, Y in mm; the pose's
/// columns are empty where it was not reached. Needs TraceOptions::keep_poses.
std::string poses_csv(const Trace& trace);

}  // namespace kempe
