#pragma once
// One grounding and assembly mode of a spec, as the proven bound sees it.

#include <optional>
#include <vector>

#include "specs/spec.hpp"
#include "synthesis/bound/box.hpp"
#include "synthesis/bound/contact.hpp"

namespace kempe::bounding {

/// An assembly mode with what is needed to turn |psi| into openings.
struct Branch {
  ModeFacts mode;
  double middle = 0, middle_psi = 0;  // the interval's middle: opening and |psi|, rad
  std::vector<LayerCandidate> layers;

  double psi_of(double opening) const { return middle_psi + mode.bend * (opening - middle); }
  double opening_of(double psi) const { return middle + mode.bend * (psi - middle_psi); }
};

/// From the spec: the limits of lengths with locks, the openings that the copy error leaves, the layer
/// assignments worth a look. `least_distance` of two joints of a link, mm; absent: the spec's.
Branch make_branch(const Spec& spec, Grounding grounding, const AssemblyMode& assembly_mode,
                   std::vector<LayerCandidate> layers, std::optional<double> least_distance = std::nullopt);

/// The linkage of the branch with a = VA and b = VB/|s|, mm; the error where there is none.
tl::expected<CopyingLinkage, LinkageFault> linkage_of(const Spec& spec, const Branch& branch, double a,
                                                      double b, const Point& pole);

}  // namespace kempe::bounding
