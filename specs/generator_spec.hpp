#pragma once
// The specs of `kempe function` and `kempe inversor`: checked values from TOML, in millimetre and radian.

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "kempe/input_error.hpp"

namespace kempe {

/// A function-generating four-bar, as asked for.
struct FunctionSpec {
  std::string expression;  ///< of x, for the expression parser; empty if a table is given
  std::vector<std::pair<double, double>> table;  ///< (x, y), x rising; at least 4 rows
  double x_lower = 0, x_upper = 0;
  double input_range = 0;                           ///< rad
  double output_range = 0;                          ///< rad
  std::optional<double> input_start, output_start;  ///< rad
  std::string method = "precision_points";          ///< or least_squares, minimax
  int points = 3;                                   ///< 3..5
  double ground = 100;                              ///< mm
  double transmission = 0;                          ///< rad
  double longest_ratio = 20;
};

/// An inversor, as asked for.
struct InversorSpec {
  double focal_length = 0;  ///< mm
  double magnification_lower = 0, magnification_upper = 0;
  double transmission = 0;               ///< rad
  double shortest = 0, longest = 1e300;  ///< mm
};

/// Reads and checks; the error names file, line, key, what stands there and what is allowed.
tl::expected<FunctionSpec, InputError> read_function_spec(std::string_view text, const std::string& file);
tl::expected<InversorSpec, InputError> read_inversor_spec(std::string_view text, const std::string& file);

}  // namespace kempe
