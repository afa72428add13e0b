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

#include "workspace/contact/gap.hpp"

namespace kempe {

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
  /// The contact just outside either end; nothing if `within` ends there.
  std::optional<ContactPair> below, above;
};

/// The intervals of `within` in which every pair keeps `clearance`, in rising order.
///  1. Every opening returned keeps the clearance: the ends are closed forms, moved inwards by `precision` (rad) where
///     a contact ends the interval, and the distance kept is larger than asked by more than its rounding.
///  2. Every opening of `within` that is not returned is in contact or within 2 `precision` of a contact or of a gap
///     equal to the clearance up to rounding.
std::vector<FreeOpenings> contact_free_openings(const CopyingLinkage& linkage, const LinkStyle& style,
                                                const LayerAssignment& layers, double clearance,
                                                const OpeningInterval& within, double precision = 1e-9);

}  // namespace kempe
