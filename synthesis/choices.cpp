#include "synthesis/choices.hpp"

#include <algorithm>
#include <tuple>

namespace kempe {
namespace {

/// What has to be kept apart, as sorted keys: two pieces each, or a piece and an obstacle.
using Key = std::tuple<std::vector<int>, double, std::vector<int>, double>;
using Demands = std::vector<Key>;

std::vector<int> corners(const JointHull& hull) {
  std::vector<int> joints;
  for (int i = 0; i < hull.count; ++i)
    joints.push_back(static_cast<int>(hull.joints[static_cast<std::size_t>(i)]));
  return joints;
}

Demands demands_of(const ContactTerms& terms) {
  Demands demands;
  for (const GapTerm& term : terms.gaps)
    demands.emplace_back(corners(term.first.hull), term.first.half_width, corners(term.second.hull),
                         term.second.half_width);
  for (const ObstacleTerm& term : terms.obstacles)
    demands.emplace_back(corners(term.piece.hull), term.piece.half_width,
                         std::vector{-1 - static_cast<int>(term.obstacle)}, 0);
  std::sort(demands.begin(), demands.end());
  demands.erase(std::unique(demands.begin(), demands.end()), demands.end());
  return demands;
}

/// Indices of those that no other asks less than, the first of equals.
std::vector<std::size_t> least_demanding(const std::vector<Demands>& all) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    bool beaten = false;
    for (std::size_t j = 0; j < all.size() && !beaten; ++j)
      beaten = j != i && std::includes(all[i].begin(), all[i].end(), all[j].begin(), all[j].end()) &&
               (all[j].size() < all[i].size() || j < i);
    if (!beaten) kept.push_back(i);
  }
  return kept;
}

}  // namespace

std::vector<ContactChoice> choices_of(const Spec& spec) {
  std::vector<ContactChoice> choices;
  for (const Vertex vertex : spec.objective.groundings) {
    const Complex shape = shape_of(spec.copy.k, vertex);
    const bool mirrored = is_straight(shape) && spec.obstacles.empty();
    const int count = mirrored ? 1 : static_cast<int>(assemblies(shape).size());
    for (int assembly = 0; assembly < count; ++assembly) {
      const auto linkage = CopyingLinkage::make(spec.copy.k, vertex, 1, 1, assembly);
      if (!linkage) continue;
      std::vector<ContactChoice> here;
      std::vector<Demands> demands;
      for (const LayerAssignment& layers : layer_assignments(spec.links.layers)) {
        here.push_back(
            {{vertex, assembly, layers},
             {gap_terms(*linkage, layers, spec.links.style), obstacle_terms(*linkage, layers, spec)}});
        demands.push_back(demands_of(here.back().terms));
      }
      for (const std::size_t i : least_demanding(demands)) choices.push_back(std::move(here[i]));
    }
  }
  return choices;
}

}  // namespace kempe
