// check_mechanisms() of laws.hpp.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/every_layers.hpp"
#include "tests/metamorphic/laws.hpp"
#include "workspace/map/workspace_map.hpp"

namespace kempe::metamorphic {
namespace {

constexpr int drawn = 80, mapped_below_the_bound = 8, mapped_above = 1, layers_tried = 3;

std::optional<Point> draw_pole_about(const Spec& spec, Dice& dice) {
  if (spec.pole.is_fixed()) return std::get<Point>(spec.pole.place);
  const Region& area = std::get<Region>(spec.pole.place);
  const Box box = bounding_box(area);
  for (int i = 0; i < 20; ++i) {
    const double x = dice.uniform(box.lower.x(), box.upper.x());
    const double y = dice.uniform(box.lower.y(), box.upper.y());
    if (contains(area, {x, y})) return Point(x, y);
  }
  return std::nullopt;
}

/// A linkage that reaches the region with the transmission asked for: the ratio of its lengths drawn, then their size.
std::optional<CopyingLinkage> draw_linkage(const Spec& spec, Dice& dice) {
  const auto pole = draw_pole_about(spec, dice);
  if (!pole) return std::nullopt;
  const auto& groundings = spec.objective.groundings;
  const Grounding grounding =
      groundings[static_cast<std::size_t>(dice.below(static_cast<int>(groundings.size())))];
  const int assembly_mode =
      dice.below(static_cast<int>(assembly_modes(shape_of(spec.copy.k(), grounding)).size()));
  const double VB = dice.log_uniform(0.2, 5) * std::abs(shape_of(spec.copy.k(), grounding));
  const auto unit = CopyingLinkage::make(spec.copy.k(), grounding, 1, VB, assembly_mode, *pole);
  if (!unit) return std::nullopt;
  const OpeningInterval openings = unit->openings_with_transmission(spec.limits.transmission);
  if (openings.empty()) return std::nullopt;
  const auto radii = unit->radii_over(openings);
  const DistanceRange needed = distance_range(spec.region, *pole);
  const double least = needed.farthest / radii.upper, most = needed.nearest / radii.lower;
  if (!(least < most)) return std::nullopt;
  const double share = dice.percent(50) ? 1e-6 : dice.uniform(0, 1);
  const double VA = least * std::pow(std::min(most / least, 10.0), share);
  const auto linkage = CopyingLinkage::make(spec.copy.k(), grounding, VA, VA * VB, assembly_mode, *pole);
  if (!linkage) return std::nullopt;
  for (const double length : linkage->lengths().values())
    if (length < spec.links.shortest || length > spec.links.longest) return std::nullopt;
  return *linkage;
}

bool is_free_at_corners(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers) {
  const MapTask task{.linkage = linkage,
                     .style = spec.links.style,
                     .layers = layers,
                     .limits = spec.limits,
                     .obstacles = spec.obstacles,
                     .region = spec.region};
  const Ring& ring = spec.region.polygons[0].outer;
  for (std::size_t i = 0; i < ring.size(); i += 1 + ring.size() / 6)
    if (!verdict_at(task, ring[i]).free) return false;
  return true;
}

class MechanismTrial {
 public:
  MechanismTrial(const Task& task, const Answer& answer, Counts& counts)
      : task_(task), answer_(answer), counts_(counts) {}

  void map(const CopyingLinkage& linkage, const LayerAssignment& layers) {
    ++counts_["mechanisms tried"];
    if (!is_free_at_corners(answer_.spec, linkage, layers)) return;
    ++counts_["mechanisms mapped"];
    if (!limit_missed(answer_.spec, linkage, layers, -1e-9).empty()) return;
    ++counts_["mechanisms certified"];
    if (answer_.proven_none)
      return report(linkage, layers, "a mechanism is certified where it is proven that none exists");
    if (answer_.least_size && linkage.size() < *answer_.least_size)
      report(linkage, layers,
             fmt::format("certified at size {}, the bound is {}", linkage.size(), *answer_.least_size));
    else if (answer_.least_size)
      ++counts_["mechanisms certified above a bound"];
  }

  std::vector<Finding> findings() const { return findings_; }

 private:
  void report(const CopyingLinkage& linkage, const LayerAssignment& layers, std::string sentence) {
    Task task = task_;
    task.pole = linkage.pole();
    task.pole_area.clear();
    const MechanismSpec mechanism{linkage.grounding(), linkage.VA(), linkage.VB(),
                                  linkage.assembly_mode().number, layers.of};
    findings_.push_back({true, "mechanisms", std::move(sentence), {task, task_}, mechanism});
  }

  const Task& task_;
  const Answer& answer_;
  Counts& counts_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> check_mechanisms(const Task& task, const Answer& answer, Dice& dice, Counts& counts) {
  const Spec& spec = answer.spec;
  const std::vector<LayerAssignment> layers = test::every_layers(spec.links.layers);
  MechanismTrial trial(task, answer, counts);
  int below = 0, above = 0;
  for (int i = 0; i < drawn && below < mapped_below_the_bound; ++i) {
    const auto linkage = draw_linkage(spec, dice);
    if (!linkage) continue;
    const bool is_below = answer.proven_none || (answer.least_size && linkage->size() < *answer.least_size);
    if (!is_below && above >= mapped_above) continue;
    ++(is_below ? below : above);
    for (int j = 0; j < layers_tried; ++j)
      trial.map(*linkage, layers[static_cast<std::size_t>(dice.below(static_cast<int>(layers.size())))]);
  }
  return trial.findings();
}

}  // namespace kempe::metamorphic
