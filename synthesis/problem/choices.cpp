#include "synthesis/problem/choices.hpp"

#include "workspace/contact/layer_demands.hpp"

namespace kempe {

std::vector<ContactChoice> choices_of(const Spec& spec) {
  std::vector<ContactChoice> choices;
  const std::vector<Obstruction> obstructions = obstructions_of(spec.obstacles, spec.bodies, spec.table);
  for (const Grounding grounding : spec.objective.groundings) {
    const Complex shape = shape_of(spec.copy.k(), grounding);
    const bool mirrored = is_straight(shape) && obstructions.empty();
    // Those of one assembly mode are those of all.
    std::vector<LayerAssignment> assignments;
    std::vector<ContactTerms> terms;
    for (const AssemblyMode& mode : assembly_modes(shape)) {
      const auto linkage = CopyingLinkage::make(spec.copy.k(), grounding, 1, 1, mode.number);
      if (!linkage) continue;
      if (assignments.empty()) {
        assignments = assignments_worth_trying(*linkage, spec.links.layers, spec.obstacles, spec.bodies,
                                               sag_counts(spec.limits));
        for (const LayerAssignment& layers : assignments)
          terms.push_back({gap_terms(*linkage, layers, spec.links.style),
                           obstacle_terms(*linkage, layers, spec.links.style, obstructions, spec.bodies)});
      }
      for (std::size_t i = 0; i < assignments.size(); ++i)
        choices.push_back({{grounding, mode.number, assignments[i]}, terms[i], mirrored && mode.number > 0});
    }
  }
  return choices;
}

}  // namespace kempe
