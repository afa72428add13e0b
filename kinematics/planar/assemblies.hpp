#pragma once
// The ways a linkage can be put together at given driver values.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "kinematics/planar/solver.hpp"

namespace kempe {

struct AssemblySearch {
  int starts = 200;                 ///< random first guesses after the given one
  std::uint64_t seed = 1;           ///< same seed, same result
  int enough = 64;                  ///< ends once so many assembly modes are known
  std::function<bool()> stop = {};  ///< looked at before every start, if there is one: true ends the search
  /// If there is one, `enough` ends the search only once an assembly mode is known of which this is true.
  std::function<bool(const PlanarPosition&)> wanted = {};
};

struct AssembliesFound {
  std::vector<PlanarPosition> assembly_modes;
  std::optional<NotAssembled> nearest;  ///< of the starts that led to none, the one that was left least open
};

/// find_assemblies below, with what was nearest where nothing closes.
AssembliesFound search_assembly_modes(const PlanarLinkage& linkage, const PlanarPosition& guess,
                                      const std::vector<double>& driver_values,
                                      const AssemblySearch& search = {});

/// Distinct closed positions, that nearest to no guess in particular: first the one that the guess leads to
/// (if it does), then those that random guesses lead to, in the order of finding. Two are the same if every
/// constrained point is at the same place within 1e-6 of the size. Found by search: none is invented, but one
/// may be missed. Where a start costs much (some hundred unknowns) fewer are tried: the work is bounded.
std::vector<PlanarPosition> find_assembly_modes(const PlanarLinkage& linkage, const PlanarPosition& guess,
                                                const std::vector<double>& driver_values,
                                                const AssemblySearch& search = {});

/// True if every constrained point is at the same place in both, within 1e-6 of the linkage's size.
bool same_assembly_mode(const PlanarLinkage& linkage, const PlanarPosition& a, const PlanarPosition& b);

}  // namespace kempe
