#pragma once
// The structural error of a four-bar function generator and its derivatives, in closed form.
//
// Unknowns u = (ln a/d, ln b/d, ln c/d, phi0, psi0), a start only where it is free. With the loop's closure
//   F = a^2 - b^2 + c^2 + d^2 + 2 d c cos psi - 2 a d cos phi - 2 a c cos(phi - psi) = 0
// the output angle's derivatives are d psi/d w = -F_w / F_psi, and
//   F_a = 2a - 2d cos phi - 2c cos(phi-psi)      F_b = -2b      F_c = 2c + 2d cos psi - 2a cos(phi-psi)
//   F_phi = 2ad sin phi + 2ac sin(phi-psi)       F_psi = -2dc sin psi - 2ac sin(phi-psi)
// Structural error e = psi - psi0 - turn(x). Transmission: cos mu = (b^2 + c^2 - a^2 - d^2 + 2 a d cos phi) /
// (2 b c).

#include <Eigen/Core>

#include "synthesis/functions/refinement.hpp"

namespace kempe {

/// Unknowns, and slopes along them.
using GeneratorVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1>;

/// A figure and its derivatives.
struct Sloped {
  double value = 0;
  GeneratorVector slope;
};

/// The error of one task on one branch. Keeps references to its arguments.
class GeneratorError {
 public:
  GeneratorError(const FunctionTask& task, const WantedAngles& wanted, FourBarBranch branch)
      : task_(&task), wanted_(&wanted), branch_(branch) {}

  const FunctionTask& task() const { return *task_; }
  const WantedAngles& wanted() const { return *wanted_; }
  FourBarBranch branch() const { return branch_; }
  bool free_input() const { return !task_->input_start; }
  bool free_output() const { return !task_->output_start; }
  Eigen::Index size() const { return 3 + (free_input() ? 1 : 0) + (free_output() ? 1 : 0); }

  GeneratorVector unknowns_of(const FunctionDesign& design) const;
  FourBar linkage(const GeneratorVector& u) const;
  Starts starts(const GeneratorVector& u) const;

  /// Generated less wanted output angle at a place, rad, in (-pi, pi]. Where the loop does not close: with coupler
  /// and output crank in line, as near as they come, and no slopes.
  Sloped at(const GeneratorVector& u, const WantedPlace& place) const;
  Sloped at(const GeneratorVector& u, double x) const { return at(u, wanted_->place_at(x)); }
  /// The same without slopes.
  double value_at(const GeneratorVector& u, double x) const;
  std::vector<double> values(const GeneratorVector& u, const std::vector<WantedPlace>& places) const;

  /// cos mu where it is largest and where it is smallest over the range: exact, as it rises with cos phi.
  /// Beyond -1..1 where the loop does not close.
  Sloped largest_cosine(const GeneratorVector& u) const;
  Sloped smallest_cosine(const GeneratorVector& u) const;

 private:
  /// The input angle at which cos phi is largest (sign 1) or smallest (sign -1) over the range, and whether
  /// it moves with the start.
  std::pair<double, bool> extreme_input(const GeneratorVector& u, int sign) const;
  Sloped cosine(const GeneratorVector& u, int sign) const;

  const FunctionTask* task_;
  const WantedAngles* wanted_;
  FourBarBranch branch_;
};

}  // namespace kempe
