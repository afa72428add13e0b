#pragma once
// Knight's calibration written out with its numbers: what each reading says, the line through them, and the matrix that turns the
// readings into errors and corrections.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "kempe/input_error.hpp"
#include "synthesis/calibration/job.hpp"

namespace kempe {

/// True if the last round was solved by Knight's equations.
bool has_knight_equations(const CalibrationRecord& record);
/// The fault of who asks for the equations of a record without them; `key` names the wish.
InputError no_knight_equations(const CalibrationRecord& record, const std::string& key);

/// The last round's equations for people; every line after the heading "NAME = TERMS = VALUE", mm and degrees, ten digits. Of a
/// record that has them.
std::string knight_equations_text(const CalibrationRecord& record);

/// The same as an object: readings (name, arm_angle_deg, departure_mm) and matrix, whose four rows, for AC, CF, BE and DE, turn
/// x, y of the first reading, x, y of the second ... into errors.
nlohmann::ordered_json knight_equations_json(const CalibrationRecord& record);

}  // namespace kempe
