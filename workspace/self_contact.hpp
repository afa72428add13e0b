#pragma once
// At which openings the linkage does not touch itself. Depends on the opening alone.

#include <optional>
#include <utility>
#include <vector>

#include "workspace/parts.hpp"

namespace kempe {

/// Two parts that may meet: they share a layer and are not joined.
struct ContactPair {
  Part first, second;
};
/// The pairs that must keep their clearance (posts against each other always: all stand on the table).
std::vector<ContactPair> contact_pairs(const CopyingLinkage& linkage, const LayerAssignment& layers);

/// Gap between two parts in a pose, mm: distance between their axes less their half widths (negative: they overlap).
double gap(const ContactPair& pair, const Pose& pose, const LinkStyle& style);

/// The smallest gap of any pair in a pose and the pair that has it.
struct Tightest {
  double gap;  ///< mm; +infinity if there is no pair
  std::optional<ContactPair> pair;
};
Tightest tightest_gap(const CopyingLinkage& linkage, const Pose& pose, const LinkStyle& style,
                      const LayerAssignment& layers);

/// A maximal interval of openings and what ends it.
struct FreeOpenings {
  OpeningInterval interval;
  std::optional<ContactPair> below, above;  ///< the contact just outside either end; nothing if `within` ends there
};

/// The intervals of `within` in which every pair keeps `clearance`, certified: the gaps' rate of change is bounded, so
/// no contact can hide between samples. Ends are inside the true interval by at most `precision` (rad).
std::vector<FreeOpenings> contact_free_openings(const CopyingLinkage& linkage, const LinkStyle& style,
                                                const LayerAssignment& layers, double clearance,
                                                const OpeningInterval& within, double precision = 1e-9);

}  // namespace kempe
