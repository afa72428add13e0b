#include "synthesis/problem/choices.hpp"

#include "workspace/contact/layer_demands.hpp"

namespace kempe {

std::vector<ContactChoice> choices_of(const Spec& spec) {
  std::vector<ContactChoice> choices;
  for (const Grounding grounding : spec.objective.groundings) {
    const Complex shape = shape_of(spec.copy.k(), grounding);
    const bool mirrored = is_straight(shape) && spec.obstacles.empty();
    std::vector<LayerAssignment> assignments;  // those of one assembly mode are those of all
    for (int assembly_mode = 0; assembly_mode < static_cast<int>(assembly_modes(shape).size());
         ++assembly_mode) {
      const auto linkage = CopyingLinkage::make(spec.copy.k(), grounding, 1, 1, assembly_mode);
      if (!linkage) continue;
      if (assignments.empty())
        assignments = assignments_worth_trying(*linkage, spec.links.layers, spec.obstacles);
      for (const LayerAssignment& layers : assignments)
        choices.push_back(
            {{grounding, assembly_mode, layers},
             {gap_terms(*linkage, layers, spec.links.style), obstacle_terms(*linkage, layers, spec)},
             mirrored && assembly_mode > 0});
    }
  }
  return choices;
}

}  // namespace kempe
