#include "specs/objective_unit.hpp"

namespace kempe {

std::string_view unit_of(Objective objective) {
  switch (objective) {
    case Objective::transmission: return "deg";
    case Objective::footprint: return "mm2";
    case Objective::mass: return "kg";
    case Objective::size:
    case Objective::copy_error:
    case Objective::load_error: break;
  }
  return "mm";
}

double in_file_unit(Objective objective, double value) {
  return objective == Objective::transmission ? degrees(value) : value;
}

}  // namespace kempe
