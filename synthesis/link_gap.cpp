#include "synthesis/link_gap.hpp"

#include <cmath>
#include <limits>

namespace kempe {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double wedge(Complex a, Complex b) { return a.real() * b.imag() - a.imag() * b.real(); }
double dot(Complex a, Complex b) { return a.real() * b.real() + a.imag() * b.imag(); }

/// The features that decide the distance of two pieces: a corner and another corner, or a corner and an edge.
struct Features {
  double distance = infinity;  ///< signed
  Joint corner{}, from{}, to{};
  bool is_edge = false;
  double side = 1;  ///< the corner is outside where side * (to - from) x (corner - from) > 0
};

int edge_count(const JointHull& piece) { return piece.count == 3 ? 3 : piece.count - 1; }

Joint next(const JointHull& piece, int i) {
  return piece.joints[static_cast<std::size_t>((i + 1) % piece.count)];
}

/// Side of an edge on which its own piece does not lie; 0 for a segment, which has two free sides.
double outside(const JointHull& piece, int edge, const JointFrame& z) {
  if (piece.count < 3) return 0;
  const Joint a = piece.joints[static_cast<std::size_t>(edge)], b = next(piece, edge),
              c = next(piece, edge + 1);
  return wedge(z[b] - z[a], z[c] - z[a]) > 0 ? -1 : 1;
}

/// The widest separation along the normals of `piece`'s edges.
void separate(const JointHull& piece, const JointHull& other, const JointFrame& z, Features& best) {
  for (int i = 0; i < edge_count(piece); ++i) {
    const Joint a = piece.joints[static_cast<std::size_t>(i)], b = next(piece, i);
    const Complex edge = z[b] - z[a];
    const double length = std::abs(edge), free_side = outside(piece, i, z);
    for (const double side : {1.0, -1.0}) {
      if (free_side * side < 0) continue;
      Features here{.from = a, .to = b, .is_edge = true, .side = side};
      for (int j = 0; j < other.count; ++j) {
        const Joint corner = other.joints[static_cast<std::size_t>(j)];
        const double height = side * wedge(edge, z[corner] - z[a]) / length;
        if (height < here.distance) here.distance = height, here.corner = corner;
      }
      if (here.distance > best.distance) best = here;
    }
  }
}

/// The smallest distance from `other`'s corners to `piece`.
void approach(const JointHull& piece, const JointHull& other, const JointFrame& z, Features& best) {
  for (int j = 0; j < other.count; ++j) {
    const Joint corner = other.joints[static_cast<std::size_t>(j)];
    for (int i = 0; i < piece.count; ++i) {
      const Joint a = piece.joints[static_cast<std::size_t>(i)];
      const double distance = std::abs(z[corner] - z[a]);
      if (distance < best.distance) best = {.distance = distance, .corner = corner, .from = a};
    }
    for (int i = 0; i < edge_count(piece); ++i) {
      const Joint a = piece.joints[static_cast<std::size_t>(i)], b = next(piece, i);
      const Complex edge = z[b] - z[a], to_corner = z[corner] - z[a];
      const double along = dot(edge, to_corner);
      if (along <= 0 || along >= std::norm(edge)) continue;
      const double height = wedge(edge, to_corner) / std::abs(edge);
      if (std::abs(height) >= best.distance) continue;
      best = {std::abs(height), corner, a, b, true, height < 0 ? -1.0 : 1.0};
    }
  }
}

Features nearest_features(const GapTerm& term, const JointFrame& z) {
  Features best{.distance = -infinity};
  separate(term.first.hull, term.second.hull, z, best);
  separate(term.second.hull, term.first.hull, z, best);
  if (best.is_edge && best.distance < 0) return best;
  best = {};
  approach(term.first.hull, term.second.hull, z, best);
  approach(term.second.hull, term.first.hull, z, best);
  return best;
}

/// A vector between joints with its derivatives.
struct VectorJet {
  Complex value;
  std::array<Complex, 3> first;  // u, v, d
  std::array<std::array<Complex, 3>, 3> second;
};

VectorJet difference(const JointFrame& z, Joint to, Joint from) {
  constexpr Complex i{0, 1};
  const Complex p = z.of_p(to) - z.of_p(from), q = z.of_q(to) - z.of_q(from);
  return {p + q, {p, q, i * q}, {{{p, 0, 0}, {0, q, i * q}, {0, i * q, -q}}}};
}

/// |z|
LinkageJet length_of(const VectorJet& z) {
  LinkageJet jet{.value = std::abs(z.value)};
  const Complex unit = jet.value > 0 ? z.value / jet.value : Complex{1, 0};
  for (std::size_t i = 0; i < 3; ++i) jet.gradient[static_cast<int>(i)] = dot(unit, z.first[i]);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const int a = static_cast<int>(i), b = static_cast<int>(j);
      const double across = dot(z.first[i], z.first[j]) - jet.gradient[a] * jet.gradient[b];
      jet.hessian(a, b) = dot(unit, z.second[i][j]) + (jet.value > 0 ? across / jet.value : 0);
    }
  return jet;
}

/// a x b
LinkageJet wedge_of(const VectorJet& a, const VectorJet& b) {
  LinkageJet jet{.value = wedge(a.value, b.value)};
  for (std::size_t i = 0; i < 3; ++i) {
    jet.gradient[static_cast<int>(i)] = wedge(a.first[i], b.value) + wedge(a.value, b.first[i]);
    for (std::size_t j = 0; j < 3; ++j)
      jet.hessian(static_cast<int>(i), static_cast<int>(j)) =
          wedge(a.second[i][j], b.value) + wedge(a.first[i], b.first[j]) + wedge(a.first[j], b.first[i]) +
          wedge(a.value, b.second[i][j]);
  }
  return jet;
}

LinkageJet quotient(const LinkageJet& n, const LinkageJet& l) {
  LinkageJet jet{.value = n.value / l.value};
  jet.gradient = (n.gradient - jet.value * l.gradient) / l.value;
  jet.hessian = (n.hessian - jet.gradient * l.gradient.transpose() - l.gradient * jet.gradient.transpose() -
                 jet.value * l.hessian) /
                l.value;
  return jet;
}

}  // namespace

std::vector<GapTerm> gap_terms(const CopyingLinkage& linkage, const LayerAssignment& layers,
                               const LinkStyle& style) {
  std::vector<GapTerm> terms;
  for (const ContactPair& pair : contact_pairs(linkage, layers))
    for (const JointHull& first : axis_of(pair.first, linkage.shape(), style.plate))
      for (const JointHull& second : axis_of(pair.second, linkage.shape(), style.plate))
        terms.push_back({{first, half_width(pair.first, style)}, {second, half_width(pair.second, style)}});
  return terms;
}

JointFrame::JointFrame(Complex s, const LogLengths& lengths, double opening) {
  const Complex p = std::exp(lengths.u), q = std::polar(std::exp(lengths.v), opening);
  of_p_ = {0, p, 0, p, p, s * p};  // V A B C X Y
  of_q_ = {0, 0, q, q, q / s, q};
  for (std::size_t i = 0; i < 6; ++i) at_[i] = of_p_[i] + of_q_[i];
}

double gap_value(const GapTerm& term, const JointFrame& frame) {
  return nearest_features(term, frame).distance - term.needed();
}

LinkageJet gap_jet(const GapTerm& term, const JointFrame& frame) {
  const Features features = nearest_features(term, frame);
  const VectorJet to_corner = difference(frame, features.corner, features.from);
  LinkageJet jet;
  if (features.is_edge) {
    const VectorJet edge = difference(frame, features.to, features.from);
    jet = quotient(wedge_of(edge, to_corner), length_of(edge));
    jet.value *= features.side, jet.gradient *= features.side, jet.hessian *= features.side;
  } else {
    jet = length_of(to_corner);
  }
  jet.value -= term.needed();
  return jet;
}

}  // namespace kempe
