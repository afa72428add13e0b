#pragma once
// The gap of two parts, and the tightest one of a linkage: in a pose, and anywhere in an interval of openings.

#include <optional>
#include <string>
#include <vector>

#include "workspace/parts.hpp"

namespace kempe {

/// Two parts that may meet: they share a layer and are not joined.
struct ContactPair {
  Part first, second;
};
/// "link VA and link BCY"
std::string name(const ContactPair& pair);

/// The pairs that must keep their clearance (posts against each other always: all stand on the table). Parts
/// that share a joint are no pair. Two pins or posts of one link are a pair, though their distance never
/// changes.
std::vector<ContactPair> contact_pairs(const CopyingLinkage& linkage, const LayerAssignment& layers);

/// Gap between two parts in a pose, mm: distance between their axes less their half widths (negative: they
/// overlap).
double gap(const ContactPair& pair, const Pose& pose, Complex shape, const LinkStyle& style);

/// The smallest gap of any pair and the pair that has it.
struct Tightest {
  double gap;  ///< mm
  std::optional<ContactPair> pair;
  double opening = 0;  ///< where, rad; set by smallest_gap_over
};
/// In one pose, from the positions of its joints.
Tightest tightest_gap(const CopyingLinkage& linkage, const Pose& pose, const LinkStyle& style,
                      const LayerAssignment& layers);

/// The smallest gap that any pair has anywhere in an interval of openings (not empty): exact up to rounding,
/// in a few microseconds. gap is +infinity for an empty interval.
Tightest smallest_gap_over(const CopyingLinkage& linkage, const LinkStyle& style,
                           const LayerAssignment& layers, const OpeningInterval& openings);
/// The same of the pairs given: pairs of pins and posts, or with links of one direction (VA and BCY, or VB and ACX).
Tightest smallest_gap_over(const CopyingLinkage& linkage, const LinkStyle& style,
                           const std::vector<ContactPair>& pairs, const OpeningInterval& openings);
/// The place in `pairs` of one whose gap is less than `clearance` (mm); nothing if there is none. Known sooner than the smallest gap.
std::optional<std::size_t> pair_nearer_than(double clearance, const CopyingLinkage& linkage,
                                            const LinkStyle& style, const std::vector<ContactPair>& pairs,
                                            const OpeningInterval& openings);

}  // namespace kempe
