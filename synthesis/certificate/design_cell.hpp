#pragma once
// A box of designs of one grounding and assembly mode, as a proof log cuts it.

#include <array>

#include "synthesis/bound/box.hpp"
#include "synthesis/certificate/proof_log.hpp"

namespace kempe::certificate {

/// Ranges of a = VA, b = VB/|s| and the pole's place, mm, and the cosines of the least and the largest |psi| that are left.
struct DesignCell {
  std::array<bounding::Range, 4> box;
  double far_cosine = 1, near_cosine = -1;

  const bounding::Range& operator[](Variable variable) const {
    return box[static_cast<std::size_t>(variable)];
  }
  bounding::Range& operator[](Variable variable) { return box[static_cast<std::size_t>(variable)]; }
  double middle(Variable variable) const { return 0.5 * ((*this)[variable].lower + (*this)[variable].upper); }
  double half(Variable variable) const { return 0.5 * ((*this)[variable].upper - (*this)[variable].lower); }
  Point pole() const { return {middle(Variable::x), middle(Variable::y)}; }
};
inline constexpr std::array<Variable, 4> all_variables{Variable::a, Variable::b, Variable::x, Variable::y};

/// What a grounding and an assembly mode fix: w = g z turns the tracer's way from the pole z into X - V.
struct Root {
  bounding::ModeFacts mode;
  Complex g;
};

}  // namespace kempe::certificate
