#pragma once
// What to measure next: in words for combinations that the readings cannot tell, and as a plan of readings.

#include <vector>

#include "synthesis/calibration/job.hpp"
#include "synthesis/calibration/task.hpp"

namespace kempe {

/// For each combination of the calibration: its words, and the extra measurements that would tell it, best
/// first.
std::vector<UndeterminedCombination> advice_for(TaskMaking& making, const Calibration& calibration);

/// The readings of [plan], to be taken besides those of the last round.
PlanRecord plan_for(const Measurements& measurements, const std::optional<DrawnDesign>& design);

/// "CY +1 mm together with VA +0.5 mm and BC +0.5 mm"
std::string words_of(const Indistinct& combination, bool variable_ratio);

}  // namespace kempe
