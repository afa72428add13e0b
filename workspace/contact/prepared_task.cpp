#include "workspace/contact/prepared_task.hpp"

#include <algorithm>

#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

OpeningInterval openings_over_region(const MapTask& task) {
  return task.region.empty() ? OpeningInterval{} : openings_met(task.linkage, task.region);
}

/// mm, which gaps the scene must know: those up to the clearance are contact, and none above the smallest that is known without
/// moving anything is the smallest of all.
double asked_for(const PreparedTask& prepared) {
  if (prepared.openings.empty()) return prepared.task.limits.clearance;
  double smallest = prepared.own.gap;
  for (const PoleGap& at : prepared.at_pole) smallest = std::min(smallest, at.gap);
  return std::max(prepared.task.limits.clearance, smallest);
}

}  // namespace

PreparedTask::PreparedTask(const MapTask& prepared, double within)
    : task(prepared), openings(openings_over_region(task)),
      own(smallest_gap_over(task.linkage, task.style, task.layers, openings)), at_pole(gaps_at_pole(task)),
      scene(task, std::max(within, asked_for(*this))), region(task.region, task.linkage.pole()) {}

}  // namespace kempe
