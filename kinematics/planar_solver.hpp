#pragma once
// Closing a linkage's loops from a guess: Newton's method on rigid-body coordinates, every step a
// rank-revealing least-squares solution, so that redundant equations and free coordinates do no harm.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/planar_linkage.hpp"

namespace kempe {

struct Assembled {
  PlanarPosition position;
  double closure_error = 0;  ///< mm, largest over all constraints; at most closing_tolerance of the linkage
  int iterations = 0;
};

/// The loops do not close near the guess: where the search ended, an outcome and not an error.
struct NotAssembled {
  PlanarPosition nearest;
  double closure_error = 0;  ///< mm, left there
  std::string worst;         ///< name of the constraint that is violated most
  int constraint = 0;        ///< its number
};

/// Largest closure error that counts as closed, mm: 1e-13 of the linkage's size and of the coordinates'
/// magnitude.
double closing_tolerance(const PlanarLinkage& linkage, const PlanarPosition& position);

/// Closes the loops near `guess` with the drivers at `driver_values` (as many as the linkage has drivers; the
/// position has one placement a body). Without enough drivers the nearest closing position comes back. Damped
/// (Levenberg-Marquardt) far away, plain Newton at the end. Deterministic.
tl::expected<Assembled, NotAssembled> solve_from(const PlanarLinkage& linkage, const PlanarPosition& guess,
                                                 const std::vector<double>& driver_values);

/// The same at the values the drivers were added with.
tl::expected<Assembled, NotAssembled> solve_from(const PlanarLinkage& linkage, const PlanarPosition& guess);

}  // namespace kempe
