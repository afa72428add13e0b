#pragma once
// Mass of the links.

#include <array>

#include "workspace/parts.hpp"

namespace kempe {

/// mm^2: the outlines of VA, VB, ACX and BCY as they are cut, holes taken out.
std::array<double, 4> link_areas(const CopyingLinkage& linkage, const Spec& spec);
/// kg, of the four links, without pins, tools and bodies. Of a spec with a material.
double mass_of_links(const CopyingLinkage& linkage, const Spec& spec);

/// The mass as a smooth function: of_VA(VA) + of_VB(VB), each c0 + c1 L + c2 L^2. Of bent plates whose arms are shorter than the piece that
/// they share it says less than mass_of_links(); else the same.
struct MassPolynomial {
  std::array<double, 3> of_VA{}, of_VB{};  ///< kg, kg/mm, kg/mm^2
};
MassPolynomial mass_polynomial(const Spec& spec, Complex k, Grounding grounding);

}  // namespace kempe
