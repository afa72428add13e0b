#include "workspace/layer_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "workspace/clearance.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// The openings that the region needs, or all that keep the transmission limit.
OpeningInterval openings_of(const MapTask& task) {
  const OpeningInterval usable = task.linkage.openings_with_transmission(task.transmission);
  const auto needed = openings_over(task.linkage, task.region);
  return needed ? *needed : usable.empty() ? task.linkage.assembly_interval() : usable;
}

LayerFinding finding_of(MapTask task, const LayerAssignment& layers, double best_gap) {
  task.layers = layers;
  const Tightest own = smallest_gap_over(task.linkage, task.style, layers, openings_of(task));
  LayerFinding finding{layers, own.gap, name(*own.pair), task.linkage.tracer_at(own.opening, 0), false, true};
  if (own.gap < best_gap && !task.obstacles.empty()) {
    finding.compared = false;
  } else if (const auto figure = smallest_clearance(task)) {
    finding.gap = figure->gap;
    finding.parts = figure->parts;
    finding.at = figure->at;
  }
  finding.keeps_clearance = finding.gap >= task.clearance;
  return finding;
}

/// Gaps nearer to each other than this are equal, mm.
constexpr double same_gap = 1e-9;

double rank_of(double gap) { return -std::round(gap / same_gap); }

std::string why_not(const LayerFinding& finding, const LayerFinding& best, double clearance) {
  const int count = finding.layers.highest();
  if (finding.keeps_clearance)
    return fmt::format("{} layers would do with {:.2f} mm ({}); {} layers keep {:.2f} mm.", count,
                       finding.gap, finding.parts, best.layers.highest(), best.gap);
  return fmt::format(
      "{} layers fail: {} {} with the tracer at ({:.1f}, {:.1f}); {:.2f} mm are required.", count,
      finding.parts,
      finding.gap > 0 ? fmt::format("come within {:.2f} mm", finding.gap) : std::string("overlap"),
      finding.at.x(), finding.at.y(), clearance);
}

}  // namespace

LayerChoice choose_layers(const MapTask& task, int layers) {
  LayerChoice choice;
  double best_gap = -std::numeric_limits<double>::infinity();
  for (const LayerAssignment& assignment : layer_assignments(layers)) {
    choice.findings.push_back(finding_of(task, assignment, best_gap));
    best_gap = std::max(best_gap, choice.findings.back().compared ? choice.findings.back().gap : best_gap);
  }
  std::stable_sort(choice.findings.begin(), choice.findings.end(),
                   [](const LayerFinding& a, const LayerFinding& b) {
                     return std::tuple(!a.compared, rank_of(a.gap), a.layers.highest()) <
                            std::tuple(!b.compared, rank_of(b.gap), b.layers.highest());
                   });
  const LayerFinding& best = choice.findings.front();
  choice.best = best.layers;
  for (int fewer = 2; fewer < best.layers.highest(); ++fewer)
    for (const LayerFinding& finding : choice.findings)
      if (finding.layers.highest() == fewer) {
        choice.why_not_fewer.push_back(why_not(finding, best, task.clearance));
        break;
      }
  return choice;
}

}  // namespace kempe
