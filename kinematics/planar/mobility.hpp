#pragma once
// How many freedoms a linkage has: counted, and in truth.

#include <cstdint>
#include <vector>

#include "kinematics/planar/linkage.hpp"

namespace kempe {

/// What a closed position of a linkage tells of its freedoms. Drivers are left out.
struct Mobility {
  int links = 0;          ///< the ground included
  int particles = 0;      ///< points that belong to no link: two freedoms each
  int full_joints = 0;    ///< revolute joints and sliding pairs: each takes two freedoms
  int sliding_pairs = 0;  ///< those of the full joints in which a link slides along another without turning
  int half_joints = 0;    ///< every other equation: each takes one
  int unknowns = 0, equations = 0;
  int gruebler = 0;  ///< unknowns - equations: the count alone

  int rank_here = 0;  ///< of the constraints at the position given
  int rank = 0;       ///< at a general position near it
  int mobility = 0;   ///< freedoms of finite motion at the general position

  /// Sets of constraints (numbers) with a redundant equation: each set is dependent at every position near,
  /// so that one of its equations says nothing new. As many sets as redundant equations.
  std::vector<std::vector<int>> redundant;

  /// Sets that are dependent at the position given only.
  std::vector<std::vector<int>> dependent_here;

  /// The position given has more freedoms at first order than positions near it.
  bool singular_here() const { return rank_here < rank; }

  /// Freedoms at first order that no finite motion follows, at every position near: the linkage is shaky.
  int shaky_freedoms() const { return unknowns - rank - mobility; }
};

/// Mobility at a closed position. The general position is found by a small random motion along the freedoms;
/// finite freedoms are counted by the directions in which closed positions really lie around it. Same seed,
/// same result.
Mobility mobility_of(const PlanarLinkage& linkage, const PlanarPosition& closed, std::uint64_t seed = 1);

/// How many links have 2, 3, 4, ... joints: count[0] binary, count[1] ternary, and so on.
struct LinkAssortment {
  std::vector<int> count;
  bool operator==(const LinkAssortment&) const = default;
};

struct NumberSynthesis {
  int joints = 0;                           ///< j = (3 (n - 1) - F) / 2
  int loops = 0;                            ///< L = j - n + 1 = (n - 1 - F) / 2, independent ones
  int largest_link = 0;                     ///< most joints that a link can have: L + min(L, max(1, F))
  std::vector<LinkAssortment> assortments;  ///< of which a chain can be made; fewest binary links first
  std::vector<LinkAssortment> too_large;    ///< those that meet both sums, but only with a larger link
  std::vector<LinkAssortment> stiff;  ///< every chain of them holds a stiff part, though no link is too large
};

/// Every assortment of n links with single revolute joints and mobility F: n2 + n3 + ... = n, 2 n2 + 3 n3 +
/// ... = 2 j. A chain is connected, each link has two joints or more, and no part of it is stiff: any m of its links,
/// 1 < m < n, keep a freedom against each other, 3 (m - 1) - 2 j_m >= 1. No joints and no assortments if 3 (n - 1) - F
/// is odd or not positive; no assortments if there are fewer joints than links, too few for a loop.
NumberSynthesis number_synthesis(int links, int freedoms);

}  // namespace kempe
