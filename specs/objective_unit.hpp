#pragma once
// In what unit files and messages state the figure of an objective.

#include "specs/spec.hpp"

namespace kempe {

/// "mm", "mm2", or "deg" for an angle.
std::string_view unit_of(Objective objective);

/// A figure of the objective, as the library holds it (mm, mm^2, rad), in that unit.
double in_file_unit(Objective objective, double value);

}  // namespace kempe
