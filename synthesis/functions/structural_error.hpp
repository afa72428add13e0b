#pragma once
// Structural error: what a family of functions with n parameters leaves of a wanted function between the
// points where it is exact. Three ways to spend the parameters, to be shown against each other: precision
// points, least squares and minimax by equal ripples (Chebyshev's theorem; Remez's exchange with Newton steps
// for nonlinear families).
//
// Nothing here knows of linkages: a caller gives the residual, generated minus wanted.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace kempe {

/// The residual at a place x for parameters p; `gradient` (if not null, of p's size) receives d residual / d
/// p. Nothing where the family is not defined (a linkage that does not assemble).
using Residual =
    std::function<std::optional<double>(double x, const Eigen::VectorXd& p, Eigen::VectorXd* gradient)>;

struct StructuralErrorTask {
  Residual residual;
  double lower = -1, upper = 1;  ///< the range of x, lower < upper
  Eigen::VectorXd start;         ///< parameters near which the fit is looked for
  int places = 241;              ///< where the error is watched; Chebyshev's spacing, denser towards the ends
};

/// One place of the structural error's curve.
struct StructuralErrorSample {
  double x, y_wanted, y_generated;
  double input_angle, output_angle;  ///< rad
  double error;                      ///< rad at the output crank: generated - wanted
};

/// A largest or smallest value of the residual between two of its zeros, or at an end of the range.
struct Ripple {
  double x = 0, error = 0;
};

enum class FitVerdict {
  exact_at_points,  ///< precision points: the residual vanishes there
  least_squares,    ///< the sum of squares does not fall any more
  equal_ripples,    ///< minimax: n + 1 ripples of alternating sign and equal height. For a linear family (or
                    ///< any that obeys Haar's condition) no parameters do better
  fewer_ripples  ///< minimax: the error has fewer ripples than that; the best found, no proof that it is the
                 ///< best
};
std::string_view name(FitVerdict verdict);

struct StructuralFit {
  Eigen::VectorXd parameters;
  FitVerdict verdict = FitVerdict::least_squares;
  double largest = 0;           ///< largest |residual| over the range
  double rms = 0;               ///< over the range, every part of it with equal weight
  std::vector<Ripple> ripples;  ///< in rising x, signs alternate
  std::vector<double> zeros;    ///< where the residual vanishes, rising
  int iterations = 0;

  /// Smallest over largest height of the ripples: 1 where all are equal. 0 without ripples.
  double evenness() const;
};

/// Why there is no fit: an outcome.
enum class NoFit {
  not_defined,   ///< the family is not defined over the range for the start or on the way
  dependent,     ///< the parameters depend on each other: the equations are singular
  not_converged  ///< the iteration does not converge
};
std::string_view name(NoFit why);

/// Exact at as many points as there are parameters (Newton's method).
tl::expected<StructuralFit, NoFit> fit_through_points(const StructuralErrorTask& task,
                                                      const std::vector<double>& points);
/// The same at the Chebyshev points of the range.
tl::expected<StructuralFit, NoFit> fit_through_chebyshev_points(const StructuralErrorTask& task);

/// Smallest mean square over the range (Levenberg-Marquardt).
tl::expected<StructuralFit, NoFit> fit_least_squares(const StructuralErrorTask& task);

/// Smallest largest |residual|. Guarantee: no larger than that of least squares from the same start.
tl::expected<StructuralFit, NoFit> fit_minimax(const StructuralErrorTask& task);

}  // namespace kempe
