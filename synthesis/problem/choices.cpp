#include "synthesis/problem/choices.hpp"

#include "workspace/contact/layer_demands.hpp"

namespace kempe {

std::vector<ContactChoice> choices_of(const Spec& spec) {
  std::vector<ContactChoice> choices;
  for (const Vertex vertex : spec.objective.groundings) {
    const Complex shape = shape_of(spec.copy.k, vertex);
    const bool mirrored = is_straight(shape) && spec.obstacles.empty();
    std::vector<LayerAssignment> assignments;  // those of one assembly are those of all
    for (int assembly = 0; assembly < static_cast<int>(assemblies(shape).size()); ++assembly) {
      const auto linkage = CopyingLinkage::make(spec.copy.k, vertex, 1, 1, assembly);
      if (!linkage) continue;
      if (assignments.empty())
        assignments = assignments_worth_trying(*linkage, spec.links.layers, spec.obstacles);
      for (const LayerAssignment& layers : assignments)
        choices.push_back(
            {{vertex, assembly, layers},
             {gap_terms(*linkage, layers, spec.links.style), obstacle_terms(*linkage, layers, spec)},
             mirrored && assembly > 0});
    }
  }
  return choices;
}

}  // namespace kempe
