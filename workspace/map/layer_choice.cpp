#include "workspace/map/layer_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/fixed_text.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/contact/layer_demands.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// The openings by which assignments are compared, and whether they are those that the region needs.
struct Compared {
  OpeningInterval openings;
  bool of_region;
};

Compared compared_openings(const MapTask& task) {
  const OpeningInterval usable = task.linkage.openings_with_transmission(task.limits.transmission);
  if (const auto needed = openings_over(task.linkage, task.region)) return {*needed, true};
  return {usable.empty() ? task.linkage.assembly_mode().openings : usable, false};
}

double widest_free(const MapTask& task) {
  double width = 0;
  for (const FreeOpenings& one :
       contact_free_openings(task.linkage, task.style, task.layers, task.limits.clearance,
                             task.linkage.openings_with_transmission(task.limits.transmission)))
    width = std::max(width, one.interval.width());
  return width;
}

/// Gaps and openings nearer to each other than this are equal, mm and rad.
constexpr double same_gap = 1e-9;

/// The largest gaps met so far, mm, of assignments alike: to so many layers, leaving none of them empty, or leaving one. Of each kind the
/// best is told of alone.
class BestGaps {
 public:
  double alike(const LayerAssignment& layers) const {
    const auto found = by_kind_.find(kind_of(layers));
    return found == by_kind_.end() ? -infinity : found->second;
  }
  void add(const LayerFinding& finding) {
    double& best = by_kind_.try_emplace(kind_of(finding.layers), -infinity).first->second;
    best = std::max(best, finding.gap);
  }

 private:
  using Kind = std::pair<int, bool>;
  static Kind kind_of(const LayerAssignment& layers) { return {layers.highest(), layers.is_stacked()}; }

  std::map<Kind, double> by_kind_;
};

LayerFinding finding_of(MapTask task, const LayerAssignment& layers, const Compared& by, const BestGaps& best,
                        const StopFlag& stop) {
  task.layers = layers;
  const Tightest own = smallest_gap_over(task.linkage, task.style, layers, by.openings);
  LayerFinding finding{
      layers, own.gap, name(*own.pair), task.linkage.tracer_at(own.opening, 0), false, widest_free(task),
      true};
  const double clearly_worse = best.alike(layers) - 2 * same_gap;
  if (by.of_region && own.gap < clearly_worse && has_obstructions(task)) {
    finding.compared = false;
  } else if (const auto figure =
                 by.of_region ? smallest_clearance(task, stop, clearly_worse) : std::nullopt) {
    finding.compared = figure->gap >= clearly_worse;
    finding.gap = figure->gap;
    finding.parts = figure->parts;
    finding.at = figure->at;
  }
  finding.keeps_clearance = finding.gap >= task.limits.clearance;
  return finding;
}

/// Larger is better; the last digits do not count.
double rank_of(double figure) { return -std::round(figure / same_gap); }

/// `layers` begins the sentence: "2 layers".
std::string why_not(const std::string& layers, const LayerFinding& finding, const LayerFinding& best,
                    double clearance) {
  if (finding.keeps_clearance)
    return fmt::format("{} would do with {:.2f} mm of clearance ({}); {} layers keep {:.2f} mm.", layers,
                       finding.gap, finding.parts, best.layers.highest(), best.gap);
  return fmt::format(
      "{} are not enough: with the tracer at ({}, {}) {} {} ({:.2f} mm of clearance required).", layers,
      fixed_text(finding.at.x(), 1), fixed_text(finding.at.y(), 1), finding.parts,
      finding.gap > 0 ? fmt::format("come within {:.2f} mm", finding.gap) : "overlap", clearance);
}

/// All that leave no layer empty, for a person asks about each number of layers; of the others those that may be better.
std::vector<LayerAssignment> compared_assignments(const MapTask& task, int layers) {
  std::vector<LayerAssignment> all = layer_assignments(layers);
  const auto worth_trying = assignments_worth_trying(task.linkage, layers, task.obstacles, task.bodies);
  std::erase_if(all, [&](const LayerAssignment& one) {
    return !one.is_stacked() &&
           std::find(worth_trying.begin(), worth_trying.end(), one) == worth_trying.end();
  });
  return all;
}

}  // namespace

LayerChoice choose_layers(const MapTask& task, int layers, const StopFlag& stop) {
  LayerChoice choice;
  const Compared by = compared_openings(task);
  const std::vector<LayerAssignment> assignments = compared_assignments(task, layers);
  BestGaps best_gaps;
  std::optional<LayerFinding> of_task;
  if (std::find(assignments.begin(), assignments.end(), task.layers) != assignments.end()) {
    of_task = finding_of(task, task.layers, by, best_gaps, stop);
    best_gaps.add(*of_task);
  }
  for (const LayerAssignment& assignment : assignments) {
    if (stop() && !choice.findings.empty()) break;
    choice.findings.push_back(
        of_task && assignment == task.layers ? *of_task : finding_of(task, assignment, by, best_gaps, stop));
    if (choice.findings.back().compared) best_gaps.add(choice.findings.back());
  }
  const auto order = [&](const LayerFinding& one) {
    return std::tuple(!one.compared, by.of_region ? rank_of(one.gap) : 0, rank_of(one.free_opening),
                      one.layers.highest());
  };
  std::stable_sort(choice.findings.begin(), choice.findings.end(),
                   [&](const LayerFinding& a, const LayerFinding& b) { return order(a) < order(b); });
  const LayerFinding& best = choice.findings.front();
  choice.best = best.layers;
  for (int fewer = 2; fewer < best.layers.highest(); ++fewer)
    for (const LayerFinding& finding : choice.findings)
      if (finding.layers.highest() == fewer) {
        choice.why_not_fewer.push_back(
            why_not(fmt::format("{} layers", fewer), finding, best, task.limits.clearance));
        break;
      }
  if (!best.layers.is_stacked())
    if (const auto stacked = std::find_if(choice.findings.begin(), choice.findings.end(),
                                          [&](const LayerFinding& finding) {
                                            return finding.layers.is_stacked() &&
                                                   finding.layers.highest() == best.layers.highest();
                                          });
        stacked != choice.findings.end())
      choice.why_not_fewer.push_back(
          why_not(fmt::format("{} layers, none of them empty,", best.layers.highest()), *stacked, best,
                  task.limits.clearance));
  return choice;
}

}  // namespace kempe
