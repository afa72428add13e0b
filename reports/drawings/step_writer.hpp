#pragma once
// Solids as STEP (ISO 10303-21, AP214), which every CAD program reads: plates with round holes and upright cylinders, each a
// product of one assembly.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/arc_polygon.hpp"

namespace kempe {

/// A plate with round holes, lying between two heights above the table, mm.
struct StepPlate {
  struct Hole {
    Point centre;
    double diameter;
  };
  std::string name;
  ArcRing outline;          ///< counter-clockwise, mm
  std::vector<Hole> holes;  ///< inside the outline, apart from each other
  double bottom = 0, top = 0;
};

/// An upright cylinder, mm.
struct StepCylinder {
  std::string name;
  Point centre;
  double diameter = 0;
  double bottom = 0, top = 0;
};

/// The parts of one assembly.
struct StepParts {
  std::string name;
  std::vector<StepPlate> plates;
  std::vector<StepCylinder> cylinders;
};

/// The file's text: units mm, each part a solid (MANIFOLD_SOLID_BREP) of planes and cylinders bounded by true lines and arcs, where it
/// lies in the assembly. No time of writing: the same parts give the same bytes. Corners nearer than the file's accuracy of 1e-7 mm are
/// written as one. The error, a sentence that names the part, is of a solid without height, a hole or cylinder without diameter, an
/// outline of less than two corners, or a number that is not finite.
tl::expected<std::string, std::string> step_text(const StepParts& parts);

}  // namespace kempe
