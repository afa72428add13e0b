#pragma once
// Contact for the proven bound: which pairs of parts can matter, and which two points of theirs are nearest.

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "synthesis/bound/box.hpp"
#include "workspace/contact/layer_demands.hpp"
#include "workspace/contact/self_contact.hpp"

namespace kempe::bounding {

/// A part whatever its layers, and two of them in a fixed order: what makes pairs of two layer assignments
/// the same.
using PartKey = std::tuple<int, int, int>;
using PairKey = std::pair<PartKey, PartKey>;
PairKey key_of(const ContactPair& pair);

/// A layer assignment with the pairs of parts that must keep their clearance in it, sorted.
struct LayerCandidate {
  LayerAssignment layers;
  std::vector<PairKey> pairs;
  std::size_t like = 0;              ///< the place of the first assignment with the same pairs
  std::vector<ContactPair> parts{};  ///< the same pairs, as parts
  bool has(const PairKey& pair) const { return std::binary_search(pairs.begin(), pairs.end(), pair); }
};

/// The least demanding layer assignments of a grounding (layer_demands.hpp): if no design keeps its clearance in one of
/// these, none does in any. With obstacles or bodies more contact among the links may be worth it. `as_searched`: those that a search
/// in which the sag counts, or not, looks at.
std::vector<LayerCandidate> layer_candidates(Complex k, Grounding grounding, int layers,
                                             const std::vector<Obstacle>& obstacles,
                                             const std::vector<Body>& bodies,
                                             std::optional<SagCounts> as_searched = {});

/// A joint as a material point, for plates of shape s.
MaterialPoint material_point(Joint joint, Complex s);

/// Two points, one of each part of a pair, that are nearest (or coincide) in a pose with these lengths and
/// opening, and how far apart they must stay, mm.
struct NearestPoints {
  MaterialPoint first, second;
  double needed = 0;  ///< both half widths; the clearance is not in it and comes on top
};
NearestPoints nearest_points(const ContactPair& pair, Complex shape, const LinkStyle& style, double a,
                             double b, double psi);

}  // namespace kempe::bounding
