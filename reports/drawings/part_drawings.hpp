#pragma once
// The links as parts to cut: outline, holes and engraving of each, in a frame of its own.

#include <array>
#include <string>
#include <vector>

#include "reports/drawings/drawing.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// A link as it lies on the sheet, seen from above (never mirrored). Its first joint is the origin; it is
/// turned so that its bounding box is smallest and lies down.
struct CutPart {
  struct Hole {
    Joint joint;
    Point centre;         ///< mm
    double diameter = 6;  ///< mm, as drawn: of the pin, plus the fit, less the kerf; 0 if that leaves nothing
  };
  std::string name;         ///< "ACX"
  int layer = 1;            ///< of the mechanism, 1 is next to the table
  double thickness = 4;     ///< mm
  double wall = 3;          ///< mm, as drawn: the least beside a hole and between two; none if not above 0
  ArcRing outline;          ///< counter-clockwise, grown by half the kerf
  std::vector<Hole> holes;  ///< at every joint, as far apart as the link's lengths say
  std::vector<TextShape> labels;  ///< engraved: the name and the joints' letters
};

/// The part of one link, to be drawn in any case; parts_fault.hpp says whether it can be cut.
CutPart cut_part(const Design& design, Link link, const CuttingSpec& cutting);
/// All four, in the order of all_links.
std::array<CutPart, 4> cut_parts(const Design& design, const CuttingSpec& cutting);

/// The same without the kerf: with it a link is drawn as it is once it is cut.
CuttingSpec finished(CuttingSpec cutting);

/// Diameter of its widest hole, mm.
double widest_hole(const CutPart& part);

/// Area of the part as drawn, mm^2: the outline less its holes.
double area(const CutPart& part);

/// The part alone: its outline and holes (none of no diameter) on a layer of its name, the engraving on the layer LABELS.
Drawing part_drawing(const CutPart& part);

/// The name of the layer that carries everything engraved.
inline constexpr std::string_view label_layer = "LABELS";

}  // namespace kempe
