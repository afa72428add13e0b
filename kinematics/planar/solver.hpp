#pragma once
// Closing a linkage's loops from a guess: Newton's method on rigid-body coordinates, every step a
// rank-revealing least-squares solution, so that redundant equations and free coordinates do no harm.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/planar/equations.hpp"

namespace kempe {

struct Assembled {
  PlanarPosition position;
  double closure_error = 0;  ///< mm, largest over all constraints; at most closing_tolerance of the linkage
  int iterations = 0;
};

/// The loops do not close near the guess: where the search ended, an outcome and not an error.
struct NotAssembled {
  PlanarPosition nearest;
  double closure_error = 0;  ///< mm, left there; of an angle times the linkage's size
  std::string worst;         ///< name of the constraint that is violated most
  int constraint = 0;        ///< its number
  int iterations = 0;
};

/// What is missing where a linkage does not close: everything else closed, one constraint is open by this and, near the
/// position, can be by no less.
struct Missing {
  int constraint = 0;
  std::string name;   ///< the constraint's
  ConstraintGap gap;  ///< mm or rad
};

/// Opens the constraint that is violated most at `open`, closes all others as far as they go and tells what it is then off
/// by. Of several violated alike the first is opened, so that rounding does not choose.
Missing missing_at(const PlanarLinkage& linkage, const NotAssembled& open,
                   const std::vector<double>& driver_values);

/// Largest closure error that counts as closed, mm: 1e-13 of the linkage's size, of the coordinates' magnitude, and of
/// the size for every turn that an angle counts.
double closing_tolerance(const PlanarLinkage& linkage, const PlanarPosition& position);

/// Closes the loops near `guess` with the drivers at `driver_values` (as many as the linkage has drivers; the
/// position has one placement a body). Without enough drivers the nearest closing position comes back. Damped
/// (Levenberg-Marquardt) far away, plain Newton at the end. Deterministic.
tl::expected<Assembled, NotAssembled> solve_from(const PlanarLinkage& linkage, const PlanarPosition& guess,
                                                 const std::vector<double>& driver_values);

/// The same at the values the drivers were added with.
tl::expected<Assembled, NotAssembled> solve_from(const PlanarLinkage& linkage, const PlanarPosition& guess);

}  // namespace kempe
