#include "synthesis/bound/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "geometry/complex_vectors.hpp"
#include "workspace/contact/layer_demands.hpp"

namespace kempe::bounding {
namespace {

PartKey part_key(const Part& part) {
  if (part.kind == Part::Kind::link) return {0, static_cast<int>(part.link), 0};
  return {1 + static_cast<int>(part.kind), 0, static_cast<int>(part.joint)};
}

std::vector<PairKey> keys_of(const std::vector<ContactPair>& pairs) {
  std::vector<PairKey> keys;
  for (const ContactPair& pair : pairs) keys.push_back(key_of(pair));
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// A convex piece of a part: its corners as material points and where they are in the pose.
struct Piece {
  std::array<MaterialPoint, 3> corner;
  std::array<Complex, 3> at;
  std::size_t count;
  std::size_t edges() const { return count == 3 ? 3 : count - 1; }
  std::size_t next(std::size_t i) const { return (i + 1) % count; }
};

/// The nearest points met so far.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  MaterialPoint first, second;
};

MaterialPoint between(const MaterialPoint& from, const MaterialPoint& to, double share) {
  return {from.of_a + share * (to.of_a - from.of_a), from.of_b + share * (to.of_b - from.of_b)};
}

/// Corners of `piece` against corners and edges of `other`; `swapped` if `piece` is the pair's second part.
void approach(const Piece& piece, const Piece& other, bool swapped, Nearest& best) {
  for (std::size_t i = 0; i < piece.count; ++i)
    for (std::size_t j = 0; j < std::max<std::size_t>(1, other.edges()); ++j) {
      const Complex from = other.at[j], edge = other.at[other.next(j)] - from;
      const double share = nearest_share(piece.at[i], from, other.at[other.next(j)]);
      const double distance = std::abs(piece.at[i] - from - share * edge);
      if (distance >= best.distance) continue;
      const MaterialPoint on_edge = between(other.corner[j], other.corner[other.next(j)], share);
      best =
          swapped ? Nearest{distance, on_edge, piece.corner[i]} : Nearest{distance, piece.corner[i], on_edge};
    }
}

/// Edges that cross.
void cross_edges(const Piece& one, const Piece& other, Nearest& best) {
  for (std::size_t i = 0; i < one.edges(); ++i)
    for (std::size_t j = 0; j < other.edges(); ++j) {
      const Complex u = one.at[one.next(i)] - one.at[i], v = other.at[other.next(j)] - other.at[j];
      const double turn = cross(u, v);
      if (turn == 0) continue;
      const Complex gap = other.at[j] - one.at[i];
      const double share = cross(gap, v) / turn, other_share = cross(gap, u) / turn;
      if (share < 0 || share > 1 || other_share < 0 || other_share > 1) continue;
      best = {0, between(one.corner[i], one.corner[one.next(i)], share),
              between(other.corner[j], other.corner[other.next(j)], other_share)};
    }
}

/// A corner of one piece inside the other's triangle: the triangle's own point there.
void contain(const Piece& triangle, const Piece& other, bool swapped, Nearest& best) {
  if (triangle.count != 3) return;
  const Complex u = triangle.at[1] - triangle.at[0], v = triangle.at[2] - triangle.at[0];
  const double area = cross(u, v);
  if (area == 0) return;
  for (std::size_t i = 0; i < other.count; ++i) {
    const Complex to = other.at[i] - triangle.at[0];
    const double x = cross(to, v) / area, y = cross(u, to) / area;
    if (x < 0 || y < 0 || x + y > 1) continue;
    const auto& [p, q, r] = triangle.corner;
    const MaterialPoint inside{p.of_a + x * (q.of_a - p.of_a) + y * (r.of_a - p.of_a),
                               p.of_b + x * (q.of_b - p.of_b) + y * (r.of_b - p.of_b)};
    best = swapped ? Nearest{0, other.corner[i], inside} : Nearest{0, inside, other.corner[i]};
  }
}

std::vector<Piece> pieces_of(const Part& part, Complex s, const LinkStyle& style, double a, Complex b) {
  std::vector<Piece> pieces;
  for (const JointHull& hull : axis_of(part, s, style.plate)) {
    Piece piece{{}, {}, static_cast<std::size_t>(hull.count)};
    for (std::size_t i = 0; i < piece.count; ++i) {
      piece.corner[i] = material_point(hull.joints[i], s);
      piece.at[i] = piece.corner[i].of_a * a + piece.corner[i].of_b * b;
    }
    pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace

MaterialPoint material_point(Joint joint, Complex s) {
  switch (joint) {
    case Joint::V: return {0, 0};
    case Joint::A: return {1, 0};
    case Joint::B: return {0, s};
    case Joint::C: return {1, s};
    case Joint::X: return {1, 1};
    case Joint::Y: break;
  }
  return {s, s};
}

PairKey key_of(const ContactPair& pair) { return std::minmax(part_key(pair.first), part_key(pair.second)); }

std::vector<LayerCandidate> layer_candidates(Complex k, Grounding grounding, int layers,
                                             const std::vector<Obstacle>& obstacles,
                                             const std::vector<Body>& bodies,
                                             std::optional<SagCounts> as_searched) {
  const auto any = CopyingLinkage::make(k, grounding, 100, 100, 0);
  std::vector<LayerCandidate> choices;
  if (!any) return choices;
  for (const LayerAssignment& each :
       as_searched ? assignments_worth_trying(*any, layers, obstacles, bodies, *as_searched)
                   : least_demanding_assignments(*any, layers, obstacles, bodies)) {
    auto parts = contact_pairs(*any, each);
    choices.push_back({each, keys_of(parts)});
    choices.back().parts = std::move(parts);
    const auto like = std::find_if(choices.begin(), choices.end(), [&](const LayerCandidate& other) {
      return other.pairs == choices.back().pairs;
    });
    choices.back().like = static_cast<std::size_t>(like - choices.begin());
  }
  return choices;
}

NearestPoints nearest_points(const ContactPair& pair, Complex shape, const LinkStyle& style, double a,
                             double b, double psi) {
  const Complex turned = std::polar(b, psi);
  Nearest best;
  for (const Piece& one : pieces_of(pair.first, shape, style, a, turned))
    for (const Piece& other : pieces_of(pair.second, shape, style, a, turned)) {
      approach(one, other, false, best);
      approach(other, one, true, best);
      cross_edges(one, other, best);
      contain(one, other, false, best);
      contain(other, one, true, best);
    }
  return {best.first, best.second, half_width(pair.first, style) + half_width(pair.second, style)};
}

}  // namespace kempe::bounding
