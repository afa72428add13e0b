#pragma once
// At which openings the linkage does not touch itself. Depends on the opening alone.
//
// Every pair that can meet keeps its two directions parallel or can be written so (a link and a pin), so that
// one part only translates against the other, on a circle: contact is "a point on a circle lies within h of a
// convex polygon", and its openings have a closed form. Derivation at the head of self_contact.cpp and in
// docs/contact.md.

#include <optional>
#include <utility>
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

/// Openings at which one pair is nearer than the clearance.
struct ContactOpenings {
  OpeningInterval interval;
  ContactPair pair;
};
/// All of them within `within`, sorted by their lower ends; they may overlap.
std::vector<ContactOpenings> contact_openings(const CopyingLinkage& linkage, const LinkStyle& style,
                                              const LayerAssignment& layers, double clearance,
                                              const OpeningInterval& within);

/// A maximal interval of openings and what ends it.
struct FreeOpenings {
  OpeningInterval interval;
  std::optional<ContactPair> below,
      above;  ///< the contact just outside either end; nothing if `within` ends there
};

/// The intervals of `within` in which every pair keeps `clearance`, in rising order.
///  1. Every opening returned keeps the clearance: the ends are closed forms, moved inwards by `precision`
///  (rad) where
///     a contact ends the interval, and the distance kept is larger than asked by more than its rounding.
///  2. Every opening of `within` that is not returned is in contact or within 2 `precision` of a contact or
///  of a gap
///     equal to the clearance up to rounding.
std::vector<FreeOpenings> contact_free_openings(const CopyingLinkage& linkage, const LinkStyle& style,
                                                const LayerAssignment& layers, double clearance,
                                                const OpeningInterval& within, double precision = 1e-9);

}  // namespace kempe
