#include "specs/spec.hpp"

#include <algorithm>

namespace kempe {

std::string_view name(Objective objective) {
  switch (objective) {
    case Objective::size: return "size";
    case Objective::transmission: return "transmission";
    case Objective::copy_error: return "copy_error";
    case Objective::footprint: return "footprint";
  }
  return "";
}

bool is_maximized(Objective objective) { return objective == Objective::transmission; }

bool WorkshopSpec::any() const {
  return grid.has_value() || !stock.empty() ||
         std::any_of(locked.begin(), locked.end(), [](const auto& length) { return length.has_value(); });
}

}  // namespace kempe
