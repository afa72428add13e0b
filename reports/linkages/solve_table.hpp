#pragma once
// The table of `kempe solve`: a row a step, units in the column names.

#include <optional>
#include <string>
#include <vector>

#include "specs/linkages/model.hpp"

namespace kempe {

/// Columns: step, time_s; for each wanted point P its P_x_m, P_y_m (in the file's unit), on request
/// P_vx_m_per_s, P_vy_m_per_s, P_ax_m_per_s2, P_ay_m_per_s2; for each wanted link L its L_angle_deg with
/// L_rate_rad_per_s and L_acceleration_rad_per_s2 where velocities and accelerations are wanted;
/// transmission_A_B_C_deg; where there are loads, the forces (forces.hpp). A value is absent where it does not exist: rates and
/// forces at a dead point, reactions that rigid links do not determine. Never NaN.
enum class ColumnKind { step, time, place, velocity, acceleration, angle, spin, spin_change, force, moment };

struct SolveTable {
  std::vector<std::string> columns;
  std::vector<ColumnKind> kinds;  ///< of each column
  std::vector<std::vector<std::optional<double>>> rows;
};

/// The table of a run; `steps` is how many equal parts the motion has. The last row of a run that stopped has
/// a fractional step.
SolveTable solve_table(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run, int steps);

/// Comma-separated, one header line; absent values are empty. Numbers are rounded at the 15th digit of the
/// largest value of their kind, where rounding errors begin.
std::string csv_text(const SolveTable& table);

}  // namespace kempe
