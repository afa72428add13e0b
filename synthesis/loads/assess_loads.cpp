#include "synthesis/loads/assess_loads.hpp"

#include "specs/hardware.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/plane_weight.hpp"
#include "synthesis/loads/strength.hpp"
#include "synthesis/loads/top_over.hpp"

namespace kempe {
namespace {

/// The same with the links' own weight along a tilted table, over all turns of the linkage: each pin and link bears both at one opening.
void add_weight(const Spec& spec, const CopyingLinkage& linkage, const OpeningInterval& openings,
                LoadFigures& figures) {
  const Complex k = linkage.k();
  const Grounding grounding = linkage.grounding();
  const LinkStyle& style = spec.links.style;
  const BarLengths lengths{linkage.VA(), linkage.VB()};
  const PlaneWeight weight(k, grounding, style, *spec.material, spec.load->tilt);
  if (!weight.weighs()) return;
  const double force = most_force_at_pen(*spec.load),
               hole = widest_hole(style, spec.links.hardware, spec.cutting);
  const auto pin_force = [&](double opening) {
    return (force * pin_forces(k, grounding, opening) + weight.pin_forces(lengths, opening)).largest();
  };
  const auto stress = [&](double opening) {
    const LinkStresses by_force = link_stresses(k, grounding, style, hole, lengths, opening);
    return (force * by_force + weight.stresses(lengths, opening, hole)).largest();
  };
  figures.pin_force_max = pin_force(top_over(openings, pin_force));
  figures.stress_max = stress(top_over(openings, stress));
  figures.weight_error_max = weight.most_over(lengths, openings);
}

}  // namespace

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
  LoadFigures figures{.error_max = error.worst,
                      .error_min = error.least,
                      .pin_force_max = force * pin_force(top_over(openings, pin_force)),
                      .hand_force_max = spec.load->pen_force * hand_force(k),
                      .stress_max = force * stress(top_over(openings, stress))};
  add_weight(spec, linkage, openings, figures);
  return figures;
}

}  // namespace kempe
