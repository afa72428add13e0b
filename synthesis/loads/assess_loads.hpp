#pragma once
// Every figure of the load over the openings that a region uses.

#include <optional>

#include "kinematics/copying_linkage.hpp"
#include "specs/spec.hpp"
#include "synthesis/loads/load_figures.hpp"

namespace kempe {

/// Of a spec with load and material; the section is that of links.style.
LoadFigures load_figures_over(const Spec& spec, const CopyingLinkage& linkage,
                              const OpeningInterval& openings);

}  // namespace kempe
