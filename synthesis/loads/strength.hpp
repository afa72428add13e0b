#pragma once
// What the load does to the links' material: stress in the arms and bars, and how far the bars are from buckling.

#include "synthesis/loads/load_error.hpp"

namespace kempe {

/// MPa for each newton at the pen, worst over the directions, by link: in a bar the pull over the net section at its holes; in a plate
/// bending and pull together at the joint in its middle, where the section has lost the hole (no peaks at its edge). Infinite where the
/// hole leaves nothing.
struct LinkStresses {
  double VA = 0, VB = 0, ACX = 0, BCY = 0;
  double largest() const;
};
/// `hole`: mm, the diameter that every joint takes of its link.
LinkStresses link_stresses(Complex k, Grounding grounding, const LinkStyle& style, double hole,
                           const BarLengths& lengths, double opening);

/// N: the push at which a two-force bar buckles in its weaker direction (Euler's load, pinned ends).
double buckling_load(const LinkStyle& style, const Material& material, double length);

}  // namespace kempe
