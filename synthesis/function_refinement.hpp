#pragma once
// The inner nouns of the function generator, shared by its fit through precision points and its refinement.

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
  bool usable() const;  ///< finite and not constant
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

/// The linkage of these coefficients, driven over the whole range and judged.
FunctionCandidate judged(const FunctionTask& task, const WantedAngles& wanted, const Starts& starts,
                         const FreudensteinCoefficients& coefficients);

/// Fills the design's curve and figures for its linkage and starts; the first defect found.
FunctionDefect trace_curve(const FunctionTask& task, const WantedAngles& wanted, FunctionDesign& design);

/// A design at least as good by the task's method, from a start without defect. Precision points with free starts: the
/// starts that make the largest error smallest. Least squares and minimax: all lengths and the free starts.
FunctionDesign refined(const FunctionTask& task, const WantedAngles& wanted, const FunctionDesign& start);

}  // namespace kempe
