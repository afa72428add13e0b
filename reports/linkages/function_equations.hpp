#pragma once
// A function generator's way from the function to its lengths, written out with its numbers: Chebyshev's spacing, the cranks'
// angles, Freudenstein's equations, the lengths, and the ripples of the structural error.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "synthesis/functions/function_generator.hpp"

namespace kempe {

/// Where the design shows the function exactly, and Freudenstein's equation of that place.
struct FunctionPoint {
  double x = 0, y = 0;
  double input_angle = 0, output_angle = 0;  ///< wanted, rad from the ground link
  std::string spacing;   ///< Chebyshev's formula with its numbers; empty where the error's zeros were found
  std::string equation;  ///< "K1 cos(psi) - K2 cos(phi) + K3 = cos(phi - psi)" with its numbers, degrees
  double residual = 0;   ///< left less right
};

/// A local extreme of the structural error.
struct StructuralRipple {
  double x = 0, error = 0;  ///< rad
};

/// All places where the design is exact, in the order of x.
std::vector<FunctionPoint> function_points(const FunctionTask& task, const FunctionDesign& design);

/// The largest error between each two zeros of design.curve and at its ends, in the order of x: seen at the curve's 181 places, then
/// refined by golden section between the neighbours.
std::vector<StructuralRipple> structural_ripples(const FunctionTask& task, const FunctionDesign& design);

/// All of it for people.
std::string function_equations_text(const FunctionTask& task, const FunctionDesign& design);

/// The same as an object: points (x, y, input_deg, output_deg, spacing, equation, residual), coefficients, ripples (x, error_deg).
nlohmann::ordered_json function_equations_json(const FunctionTask& task, const FunctionDesign& design);

}  // namespace kempe
