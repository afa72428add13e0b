#pragma once
// What pins give in the plane, because the links that they join lie in different layers.

#include "synthesis/loads/load_error.hpp"
#include "workspace/parts.hpp"

namespace kempe {

/// Round steel pins (E 200 GPa, G 77 GPa) that bend and shear between the middles of the two layers; the links keep their ends from tilting:
/// h^3 / 12EI + 10 h / 9GA over a height h. The pole's post is clamped in the table and free above: h^3 / 3EI + 10 h / 9GA up to the middle of
/// its highest link. What holes give is not in it. mm for each newton.
PinCompliance pin_compliance(Grounding grounding, const LayerAssignment& layers, const LinkStyle& style,
                             const JointHardware& hardware);

/// One pin whose ends do not tilt, mm for each newton; diameter and height in mm.
double upright_pin(double diameter, double height);

}  // namespace kempe
