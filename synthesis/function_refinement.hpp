#pragma once
// The inner nouns of the function generator, shared by its fit through precision points and its search for
// the least error.

#include <optional>

#include "synthesis/function_generator.hpp"

namespace kempe {

/// The dials' pointers at x_lower and at y's smallest value, rad.
struct Starts {
  double input, output;
};

/// The wanted pairs of angles, measured from the starts.
class WantedAngles {
 public:
  explicit WantedAngles(const FunctionTask& task);
  double input_turn(double x) const;          ///< rad, 0 at x_lower
  double output_turn(double x) const;         ///< rad, 0 at y's smallest value
  double value_at(double output_turn) const;  ///< y that the dial shows
  double y_lower() const { return y_lower_; }
  double y_upper() const { return y_upper_; }
  bool usable() const;                                                        ///< finite and not constant
  const std::vector<double>& precision_points() const { return precision_; }  ///< ascending

 private:
  const FunctionTask& task_;
  double y_lower_, y_upper_;
  bool finite_ = true;
  std::vector<double> precision_;
};

struct FunctionCandidate {
  FunctionDesign design;
  FunctionDefect defect = FunctionDefect::lengths;
};

/// A linkage with its starts, not yet driven: nothing if the coefficients are none of a four-bar.
std::optional<FunctionDesign> design_from(const FunctionTask& task, const WantedAngles& wanted,
                                          const Starts& starts, const FreudensteinCoefficients& coefficients);

/// The linkage of these coefficients, driven over the whole range and judged.
FunctionCandidate judged(const FunctionTask& task, const WantedAngles& wanted, const Starts& starts,
                         const FreudensteinCoefficients& coefficients);

/// Fills the design's curve and figures for its linkage and starts; the first defect found.
FunctionDefect trace_curve(const FunctionTask& task, const WantedAngles& wanted, FunctionDesign& design);

/// Every choice of starts, on a grid where they are free, for which one linkage passes `points` Chebyshev
/// points.
std::vector<Starts> precise_starts(const FunctionTask& task, const WantedAngles& wanted);

/// Freudenstein's linear equations at the first three precision points.
std::optional<FreudensteinCoefficients> coefficients_through_first_three(const WantedAngles& wanted,
                                                                         const Starts& starts);

/// Precision points with a freedom left: the starts that make the largest error smallest, near a design's.
/// The design itself if nothing better is found.
FunctionDesign with_best_starts(const FunctionTask& task, const WantedAngles& wanted,
                                const FunctionDesign& design);

/// Least transmission angle that the search keeps, rad: at 0 the output crank stands at its dead point.
double kept_transmission(const FunctionTask& task);

/// The smallest mean square error near a design (which need not keep the limits), all lengths and free starts
/// varied, the limits kept. Nothing if none is found that keeps them.
std::optional<FunctionDesign> least_squares_fit(const FunctionTask& task, const WantedAngles& wanted,
                                                const FunctionDesign& start);

/// The same for the smallest largest error.
std::optional<FunctionDesign> minimax_fit(const FunctionTask& task, const WantedAngles& wanted,
                                          const FunctionDesign& start);

/// Makes the conditions that hold a minimax design exact and looks whether they prove a local minimum. Fills
/// design.optimum; moves the design only to an error that is not larger.
void settle_optimum(const FunctionTask& task, const WantedAngles& wanted, FunctionDesign& design);

/// The best design by the task's method (least squares or minimax) over many starts.
struct FunctionSearch {
  std::optional<FunctionDesign> best;
  std::vector<FunctionDefect> defects;  ///< of the starts that led nowhere
};
FunctionSearch search_function(const FunctionTask& task, const WantedAngles& wanted);

}  // namespace kempe
