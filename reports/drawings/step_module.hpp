#pragma once
// The border between the program and the module that writes STEP: plain data go one way, a sentence the other.
// The module alone knows OpenCASCADE. It is loaded when the first assembly is written, so that no other command waits for
// OpenCASCADE's libraries.

#include <string>
#include <vector>

namespace kempe {

/// A corner of an outline and the arc to the next one (its bulge: the tangent of a quarter of the angle); mm.
struct StepCorner {
  double x = 0, y = 0, bulge = 0;
};

/// A round hole, mm.
struct StepHole {
  double x = 0, y = 0, diameter = 0;
};

/// A plate with round holes, lying between two heights above the table, mm.
struct StepPlate {
  std::string name;
  std::vector<StepCorner> outline;  ///< counter-clockwise
  std::vector<StepHole> holes;
  double bottom = 0, top = 0;
};

/// An upright cylinder, mm.
struct StepCylinder {
  std::string name;
  double x = 0, y = 0, diameter = 0;
  double bottom = 0, top = 0;
};

/// The parts of one assembly.
struct StepParts {
  std::string name;
  std::vector<StepPlate> plates;
  std::vector<StepCylinder> cylinders;
};

/// What the module exports: writes the parts to the file (OpenCASCADE writes to files only) and returns true, or says
/// in `fault` why not.
using WriteStep = bool (*)(const StepParts& parts, const char* file, std::string& fault);
inline constexpr const char* write_step_symbol = "kempe_write_step";

}  // namespace kempe
