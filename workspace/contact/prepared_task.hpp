#pragma once
// What every question about a task's contacts begins with, made once: the scene, the region's edges, the gaps that need no search.

#include <vector>

#include "workspace/contact/contact_scene.hpp"
#include "workspace/contact/gap.hpp"

namespace kempe {

struct PreparedTask {
  /// For the smallest gap over the region, for contact, and for gaps up to `within`, mm.
  explicit PreparedTask(const MapTask& task, double within = 0);

  const MapTask& task;  ///< must outlive the object
  OpeningInterval
      openings;  ///< at which the tracer is over the region; empty without a region, or if it is out of reach
  Tightest own;  ///< of the linkage's parts against each other over them; infinite if there are none
  std::vector<PoleGap> at_pole;  ///< of what stands beside the pole post
  ContactScene scene;
  EdgeTree region;  ///< the pole at the origin
};

}  // namespace kempe
