#pragma once
// The specs of `kempe function`, `kempe inversor` and `kempe path`: checked values from TOML, in millimetre and radian.

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "kempe/input_error.hpp"
#include "kempe/point.hpp"
#include "kinematics/four_bar.hpp"
#include "kinematics/planar/linkage.hpp"

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
  double transmission = 0;           ///< rad
  double shortest = 0, longest = 0;  ///< mm; the longest is 1e6 where the file says nothing
};

/// A path-generating four-bar, as asked for.
struct PathSpec {
  std::vector<Point> points;  ///< mm, 3 to 60, not all in one place; empty where poses are given
  std::vector<BodyPlacement>
      poses;  ///< mm, rad: 3 to 5, all different, not all in one place; empty where points are given
  std::vector<double>
      turns;  ///< rad, from the first point on: 0, then rising or falling, less than a turn; empty: free
  bool largest_distance = false;       ///< what is made small: the largest distance, not the mean square
  double longest = 0;                  ///< mm; of ten times the path's size where the file says nothing
  double transmission = 0;             ///< rad
  std::vector<Point> pivots_within;    ///< mm, a convex polygon, counter-clockwise; empty: anywhere
  std::vector<CrankMotion> motions;    ///< one of these; empty: any
  std::optional<Point> crank_pivot;    ///< mm, within pivots_within; nothing: free
  std::optional<double> ground_angle;  ///< rad, from the crank's pivot to the rocker's; nothing: free
  /// rad, of the crank from the ground link at the first point; nothing: free
  std::optional<double> first_angle;
};

/// Reads and checks; the error names file, line, key, what stands there and what is allowed.
tl::expected<FunctionSpec, InputError> read_function_spec(std::string_view text, const std::string& file);
tl::expected<InversorSpec, InputError> read_inversor_spec(std::string_view text, const std::string& file);
tl::expected<PathSpec, InputError> read_path_spec(std::string_view text, const std::string& file);

}  // namespace kempe
