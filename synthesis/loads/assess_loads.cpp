#include "synthesis/loads/assess_loads.hpp"

#include "specs/hardware.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/strength.hpp"
#include "synthesis/loads/top_over.hpp"

namespace kempe {

LoadFigures load_figures_over(const Spec& spec, const CopyingLinkage& linkage,
                              const OpeningInterval& openings) {
  const Complex k = linkage.k();
  const Grounding grounding = linkage.grounding();
  const BarLengths lengths{linkage.VA(), linkage.VB()};
  const double force = most_force_at_pen(*spec.load);
  const double hole = widest_hole(spec.links.style, spec.links.hardware, spec.cutting);
  const LoadErrorProfile::Range error = load_error_profile(spec, k, grounding).over(lengths, openings);
  const auto pin_force = [&](double opening) { return pin_forces(k, grounding, opening).largest(); };
  const auto stress = [&](double opening) {
    return link_stresses(k, grounding, spec.links.style, hole, lengths, opening).largest();
  };
  return {.error_max = error.worst,
          .error_min = error.least,
          .pin_force_max = force * pin_force(top_over(openings, pin_force)),
          .hand_force_max = spec.load->pen_force * hand_force(k),
          .stress_max = force * stress(top_over(openings, stress))};
}

}  // namespace kempe
