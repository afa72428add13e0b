#pragma once
// The log of a proof that no design is better than a bound, or that none exists: a closed tree of boxes of designs, written so
// that a reader who trusts nothing can check every line alone. Rules and theorems: docs/proof.md.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "specs/spec.hpp"

namespace kempe::certificate {

/// A point of the region's boundary: corner number `corner` of a ring (0 is the outer one) and `share` (0..1) of the way to the
/// next.
struct EdgePlace {
  std::size_t polygon = 0, ring = 0, corner = 0;
  double share = 0;
};
/// A place of the region, mm.
using Place = std::variant<EdgePlace, Point>;

/// A part whatever its layers: four links, pins at A, B, C, V, posts at V, X, Y.
struct PartName {
  std::uint8_t number = 0;
  bool operator==(const PartName&) const = default;
};
/// "VA", "pin A", "post X".
std::string text(PartName part);

/// A material point: of a bar the share along it; of a plate two shares along its sides from the first joint.
struct PartPoint {
  PartName part;
  double t = 0, u = 0;
};

enum class Variable : std::uint8_t { a, b, x, y };

/// The box is cut at a value of a variable, mm.
struct Split {
  Variable variable{};
  double at = 0;
};
/// The layer assignments in which both parts, or the part and the obstacle (or body, by the same numbers), share a layer; and the others.
struct Share {
  PartName one;
  std::variant<PartName, std::size_t> other;
};
/// Two points too near each other all over the box at |psi|, tan(|psi|/2) = u: the openings below it, and those above.
struct ContactCut {
  PartPoint one, other;
  double u = 0;
};
/// The cosines of |psi| between which the limit on the copy error may be kept; all other openings exceed it (with 1 or -1 there are
/// no others at that end). None are left if the first is no larger.
struct CopyErrorCut {
  double far_cosine = 0, near_cosine = 0;
};

/// What every design of the tree keeps, >= 0, with a weight.
struct Requirement {
  enum class Kind : std::uint8_t { far, near, posts, bound } kind{};
  Place place;
  double weight = 0;
};
/// A weighted sum of requirements is negative all over the box.
struct SumLeaf {
  std::vector<Requirement> of;
};
/// The pole may stand nowhere in the box.
struct PoleLeaf {};
/// The copy of the first place is nearer to the second than the gap between original and copy.
struct CopyGapLeaf {
  Place one, other;
};
/// With the tracer at the place, the point is too near to an edge of the obstacle's outline, or to all of a convex one. The numbers
/// after the obstacles' are those of the bodies that keep their direction, each seen from the joint that carries it, and then that of the table's edge.
struct ObstacleLeaf {
  std::size_t obstacle = 0;
  std::optional<std::size_t> edge;
  Place place;
  PartPoint point;
};
/// No layer assignment is left.
struct LayersLeaf {};
/// Of a root: no lengths are permitted.
struct LengthsLeaf {};

using Line = std::variant<Split, Share, ContactCut, CopyErrorCut, SumLeaf, PoleLeaf, CopyGapLeaf,
                          ObstacleLeaf, LayersLeaf, LengthsLeaf>;

/// Trees of all permitted groundings and assembly modes in their order, each depth first.
struct ProofLog {
  Objective objective = Objective::size;
  std::optional<double> bound;  ///< mm of size, rad of transmission; absent: no design exists
  std::vector<Line> lines;
};

}  // namespace kempe::certificate
