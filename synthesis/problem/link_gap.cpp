#include "synthesis/problem/link_gap.hpp"

#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "geometry/convex_distance.hpp"

namespace kempe {
namespace {

/// The corners of a piece's axis.
struct HullCorners {
  std::array<Complex, 3> at;
  std::size_t count;
  HullCorners(const JointHull& hull, const JointFrame& frame)
      : at{}, count(static_cast<std::size_t>(hull.count)) {
    for (std::size_t i = 0; i < count; ++i) at[i] = frame[hull.joints[i]];
  }
  ConvexCorners span() const { return {at.data(), count}; }
};

NearestFeatures features_of(const GapTerm& term, const JointFrame& frame) {
  const HullCorners first(term.first.hull, frame), second(term.second.hull, frame);
  return nearest_features(first.span(), second.span());
}

/// A vector between joints with its derivatives.
struct VectorJet {
  Complex value;
  std::array<Complex, 3> first;  // u, v, d
  std::array<std::array<Complex, 3>, 3> second;
};

VectorJet difference(const JointFrame& z, Joint to, Joint from) {
  const Complex p = z.of_p(to) - z.of_p(from), q = z.of_q(to) - z.of_q(from);
  return {p + q, {p, q, i_unit * q}, {{{p, 0, 0}, {0, q, i_unit * q}, {0, i_unit * q, -q}}}};
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
LinkageJet cross_of(const VectorJet& a, const VectorJet& b) {
  LinkageJet jet{.value = cross(a.value, b.value)};
  for (std::size_t i = 0; i < 3; ++i) {
    jet.gradient[static_cast<int>(i)] = cross(a.first[i], b.value) + cross(a.value, b.first[i]);
    for (std::size_t j = 0; j < 3; ++j)
      jet.hessian(static_cast<int>(i), static_cast<int>(j)) =
          cross(a.second[i][j], b.value) + cross(a.first[i], b.first[j]) + cross(a.first[j], b.first[i]) +
          cross(a.value, b.second[i][j]);
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

JointFrame::JointFrame(Complex s, double VA, Complex q) {
  const Complex p = VA;
  of_p_ = {0, p, 0, p, p, s * p};  // V A B C X Y
  of_q_ = {0, 0, q, q, quotient(q, s), q};
  for (std::size_t i = 0; i < 6; ++i) at_[i] = of_p_[i] + of_q_[i];
}

double gap_value(const GapTerm& term, const JointFrame& frame, double enough) {
  const HullCorners first(term.first.hull, frame), second(term.second.hull, frame);
  return convex_distance(first.span(), second.span(), enough + term.needed()) - term.needed();
}

LinkageJet gap_jet(const GapTerm& term, const JointFrame& frame) {
  const NearestFeatures features = features_of(term, frame);
  const JointHull& of_corner = (features.corner_of_first ? term.first : term.second).hull;
  const JointHull& of_edge = (features.corner_of_first ? term.second : term.first).hull;
  const Joint from = of_edge.joints[features.from];
  const VectorJet to_corner = difference(frame, of_corner.joints[features.corner], from);
  LinkageJet jet;
  if (features.is_edge) {
    const VectorJet edge = difference(frame, of_edge.joints[features.to], from);
    jet = quotient(cross_of(edge, to_corner), length_of(edge));
    jet.value *= features.side, jet.gradient *= features.side, jet.hessian *= features.side;
  } else {
    jet = length_of(to_corner);
  }
  jet.value -= term.needed();
  return jet;
}

}  // namespace kempe
