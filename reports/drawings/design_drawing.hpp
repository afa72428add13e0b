#pragma once
// The sheet that a workshop gets: every link 1:1 beside the others, the assembly, the title block.

#include <string>

#include "reports/drawings/drawing.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// One drawing of everything: the four links side by side, each on a layer of its name; engraving on LABELS;
/// the mechanism in a pose with region and copy on ASSEMBLY, REGION and COPY; ratio, rotation, units, layers
/// and the table of lengths on TITLE. 1:1, mm. What must be cut is on the links' layers alone.
Drawing design_drawing(const Design& design, const CuttingSpec& cutting = {});

/// The pose of the assembly view: the tracer in the middle of the region's box, or, where it cannot stand
/// there, in the middle of its reach towards it.
Pose assembly_pose(const Design& design);

/// The drawing's title: the design's, cut short where it is long; if it has none, "Copying linkage, scale 1.4, rotation 90 deg".
std::string drawing_title(const Design& design);

}  // namespace kempe
