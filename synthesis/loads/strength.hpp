#pragma once
// What the load does to the links' material: stress in the arms and bars, and how far the bars are from buckling.

#include <array>

#include "synthesis/loads/load_error.hpp"

namespace kempe {

/// What a section of a flat bar sets against forces.
struct SectionModuli {
  double area;          ///< mm^2
  double in_plane;      ///< mm^3, against bending in the plane of the linkage
  double out_of_plane;  ///< mm^3, against bending out of it
  double twist;         ///< mm^3, against torsion: torque over the largest shear stress
};
/// Of a section across a hole (mm, less than the width; 0: none) in the middle of the width; against torsion that of a bar as wide as what
/// the hole leaves. No peaks at the hole's edge.
SectionModuli section_moduli(const LinkStyle& style, double hole);

/// Torque over the largest shear stress of a rectangle, mm^3, whatever the order of its sides: W. C. Young, R. G. Budynas, Roark's Formulas
/// for Stress and Strain, 7th edition, table 10.1; to 0.3 % of the exact series.
double torsion_modulus(double width, double thickness);

/// What a straight piece of a link between two of its joints bears.
struct PieceForces {
  double pull = 0;                   ///< N, where it begins
  double pull_growth = 0;            ///< N, by so much more at its end
  std::array<double, 2> in_plane{};  ///< N mm, bending at both ends, a straight line between them, but for
  double own_weight_in_plane = 0;    ///< N mm: times x (1 - x) more at x of the length
  std::array<double, 2> out_of_plane{};  ///< N mm, the same out of the plane, with
  double own_weight = 0;                 ///< N mm
  double twist = 0;                      ///< N mm
};
/// MPa, the largest equivalent stress (von Mises) in a piece: at its ends over the section with the hole, between them over the whole one.
/// sigma = |pull| / A + |M| / W in the plane + |M| / W out of it is that of the corner where all add up, tau the largest shear stress of
/// torsion: no point of a section exceeds sqrt(sigma^2 + 3 tau^2). Shear by transverse forces is not in it.
double largest_stress(const PieceForces& forces, const SectionModuli& at_ends, const SectionModuli& between);

/// MPa by link. Infinite where the hole leaves nothing.
struct LinkStresses {
  double VA = 0, VB = 0, ACX = 0, BCY = 0;
  double largest() const;
};
LinkStresses operator+(const LinkStresses& one, const LinkStresses& other);
LinkStresses operator*(double times, const LinkStresses& stresses);
/// For each newton at the pen, worst over the directions, in the plane alone: in a bar the pull over the net section at its holes; in a plate
/// bending and pull together at the joint in its middle, where the section has lost the hole (no peaks at its edge). With the bending out of
/// the plane: LayeredErrorProfile. `hole`: mm, the diameter that every joint takes of its link.
LinkStresses link_stresses(Complex k, Grounding grounding, const LinkStyle& style, double hole,
                           const BarLengths& lengths, double opening);

/// N: the push at which a two-force bar buckles in its weaker direction (Euler's load, pinned ends).
double buckling_load(const LinkStyle& style, const Material& material, double length);

}  // namespace kempe
