#pragma once
// The equations that close a linkage's loops, written out with the numbers of one moment.

#include <string>
#include <utility>
#include <vector>

#include "specs/linkages/model.hpp"

namespace kempe {

/// One equation, left = right. Lengths are in the file's unit, angles in degrees: cos and sin take degrees, and so is what an
/// angle's own equation says.
struct LoopEquation {
  std::string of;       ///< the joint, slider, distance, pair or driver, for people
  std::string symbols;  ///< "x_rod + 12 cos(t_rod) - x_crank = 0"
  std::string numbers;  ///< the same with the unknowns' values in their places
  /// The row of the Jacobian: unknowns with the derivative of left - right, in the file's unit or degrees by the same; zeros left
  /// out.
  std::vector<std::pair<std::string, double>> slopes;
};

/// The unknowns' names ("x_crank", "y_crank", "t_crank") and values (file's unit, degrees), three a link in the solver's order.
std::vector<std::pair<std::string, double>> unknowns_at(const LinkageFile& file, const LinkageModel& model,
                                                        const RunFrame& frame);

/// All equations, the drivers' with their values at the moment; joints have two. In the solver's order of constraints.
std::vector<LoopEquation> loop_equations(const LinkageFile& file, const LinkageModel& model,
                                         const RunFrame& frame);

/// Both for people: unknowns, then each equation with its numbers and its row of the Jacobian; the count at the end.
std::string loop_equations_text(const LinkageFile& file, const LinkageModel& model, double step,
                                const RunFrame& frame);

/// The same as one JSON object: linkage, unit, step, unknowns, equations.
std::string loop_equations_json(const LinkageFile& file, const LinkageModel& model, double step,
                                const RunFrame& frame);

}  // namespace kempe
