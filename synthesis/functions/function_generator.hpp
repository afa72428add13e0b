#pragma once
// Four-bar function generators: link lengths for which the output crank's dial shows a function of the input
// crank's.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/four_bar.hpp"
#include "kinematics/stop_flag.hpp"
#include "synthesis/functions/defects.hpp"

namespace kempe {

/// How the free parameters are spent.
enum class FunctionMethod {
  precision_points,  ///< exact at n = 3, 4 or 5 Chebyshev points
  least_squares,     ///< smallest mean square structural error over many points
  minimax            ///< smallest largest structural error: its ripples come out equal
};
std::string_view name(FunctionMethod method);

/// What is asked for. Angles rad, measured from the ground link (input pivot to output pivot),
/// counter-clockwise.
struct FunctionTask {
  std::function<double(double)> wanted;  ///< y(x), finite on [x_lower, x_upper]
  double x_lower = 0, x_upper = 1;
  double input_range = 0;   ///< turn of the input crank from x_lower to x_upper, != 0
  double output_range = 0;  ///< turn of the output crank while y goes from its smallest to its largest, != 0
  std::optional<double> input_start;   ///< the input crank's angle at x_lower; absent: chosen
  std::optional<double> output_start;  ///< the output crank's angle at y's smallest value; absent: chosen
  int points = 3;                      ///< precision points, 3..5; ignored by the other methods
  FunctionMethod method = FunctionMethod::precision_points;
  double ground = 100;        ///< mm, > 0
  double transmission = 0;    ///< rad, limit kept over the range
  double longest_ratio = 20;  ///< longest over shortest link, at most
  StopFlag stop{};            ///< set: the best so far at once
};

/// What is known of a minimax design beyond its error: the conditions that hold it.
struct MinimaxOptimum {
  int ripples = 0;   ///< as high as the largest error
  int unknowns = 0;  ///< lengths and free starts that were varied
  /// That stop the error from falling further: "transmission_deg", "longest_ratio", "turning back".
  std::vector<std::string> limits;
  /// True if first- or second-order conditions prove that every near linkage within the limits has a larger
  /// error.
  bool proven = false;
};

/// One place of the structural error's curve.
struct StructuralErrorSample {
  double x, y_wanted, y_generated;
  double input_angle, output_angle;  ///< rad
  double error;                      ///< rad at the output crank: generated - wanted
};

struct FunctionDesign {
  FourBar linkage;
  double input_start = 0, output_start = 0;  ///< rad
  double y_lower = 0, y_upper = 0;           ///< smallest and largest wanted value: the dial's ends
  std::vector<double> precision_points;      ///< x where the error is meant to vanish (or vanishes)
  std::vector<StructuralErrorSample> curve;  ///< over the range, 181 places
  double error_largest = 0;                  ///< rad, over the whole range
  double error_rms = 0;                      ///< rad, the mean taken over x
  double transmission_min = 0;               ///< rad
  CrankMotion motion = CrankMotion::double_rocker;
  std::optional<MinimaxOptimum> optimum;  ///< minimax only
  bool complete = true;                   ///< false: the search was stopped, and this is the best it had
  /// rad: so far the errors told may be off, about, where the function bends in more places than are looked at; else 0.
  double unseen = 0;
  std::size_t rejected_branch = 0, rejected_order = 0, rejected_other = 0;  ///< candidates with defects
};

/// Why no design came out, for a person.
struct NoFunctionDesign {
  FunctionDefect commonest = FunctionDefect::none;  ///< of the candidates
  std::string sentence;  ///< what was searched and what was found; claims no more than that
  bool proven = false;  ///< true: no four-bar can, because the function has no dial; else a search found none
  std::string
      allowed{};  ///< what the function may be, where it is the function that stands against every four-bar
  bool stopped = false;  ///< before anything was found
};

/// The best design without defect that is found: smallest largest structural error (least squares: smallest mean
/// square). Where finitely many four-bars pass the precision points all are looked at; free starts and free lengths are
/// searched over their whole range. Deterministic, unless task.stop is set: then what was found by then.
tl::expected<FunctionDesign, NoFunctionDesign> generate_function(const FunctionTask& task);

/// Coefficients through three pairs of angles (Freudenstein's linear equations); nothing if they are
/// dependent.
std::optional<FreudensteinCoefficients> freudenstein_three_points(const std::vector<double>& input_angles,
                                                                  const std::vector<double>& output_angles);

}  // namespace kempe
