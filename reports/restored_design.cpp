#include "reports/restored_design.hpp"

#include <algorithm>

#include "specs/spec_check.hpp"
#include "synthesis/design/allowed.hpp"
#include "synthesis/design/assemble.hpp"

namespace kempe {
namespace {

/// Without limits of its own a file of the minimal form asks for nothing.
Limits no_limits() {
  Limits limits;
  limits.clearance = 0;
  limits.transmission = 0;
  return limits;
}

MechanismSpec mechanism_of(const StoredDesign& stored, const CopyingLinkage& linkage) {
  return {.grounding = linkage.grounding(),
          .VA = linkage.VA(),
          .VB = linkage.VB(),
          .assembly_mode = linkage.assembly_mode().number,
          .layers = stored.layers.of};
}

/// The spec that the file states, its mechanism given.
Spec task_of(const StoredDesign& stored, const CopyingLinkage& linkage) {
  Spec spec;
  spec.title = stored.title;
  spec.copy = stored.wanted ? Copy::of(stored.wanted->scale, stored.wanted->rotation)
                            : Copy::of(stored.scale, stored.rotation);
  spec.region = stored.region;
  spec.pole.place = stored.mechanism.pole_position;
  spec.links.style = stored.style;
  spec.links.hardware = stored.hardware;
  spec.links.layers = std::max(spec.links.layers, stored.layers.highest());
  spec.limits = stored.limits.value_or(no_limits());
  spec.tolerance = stored.tolerance;
  if (stored.tool) spec.tool = {stored.tool->follower_radius, stored.tool->cutter_radius};
  spec.obstacles = stored.obstacles;
  spec.bodies = stored.bodies;
  spec.table = stored.table;
  spec.objective.objective = stored.objective.value_or(spec.objective.objective);
  spec.mechanism = mechanism_of(stored, linkage);
  spec.cutting = stored.cutting.value_or(CuttingSpec{});
  spec.material = stored.material;
  spec.load = stored.load;
  if (stored.allowed) allow(spec, *stored.allowed);
  spec.links.sections.clear();  // the choice is made
  return spec;
}

/// The way back from in_file_unit() (objective_unit.hpp).
std::optional<double> in_library_unit(Objective objective, const std::optional<double>& figure) {
  return figure && objective == Objective::transmission ? std::optional(radians(*figure)) : figure;
}

FoundDesign found_design(const StoredDesign& stored, const CopyingLinkage& linkage) {
  const Objective objective = *stored.objective;
  FoundDesign found{.linkage = linkage,
                    .layers = stored.layers,
                    .goal = goal_of(objective),
                    .value = in_library_unit(objective, stored.value).value_or(0),
                    .solvers = stored.search.solvers,
                    .evaluations = stored.search.evaluations,
                    .seed = stored.search.seed,
                    .complete = stored.search.complete,
                    .proven_bound = in_library_unit(objective, stored.quality.proven_bound)};
  if (stored.quality.robust)
    found.nominal_value = in_library_unit(objective, stored.quality.robust->nominal_value);
  return found;
}

}  // namespace

tl::expected<Design, InputError> restored_design(const StoredDesign& stored, const std::string& file,
                                                 const StopFlag& stop) {
  const auto linkage = linkage_of(stored, file);
  if (!linkage) return tl::unexpected(linkage.error());
  auto task = check_spec(task_of(stored, *linkage));
  if (!task) {
    InputError faults = task.error();
    faults.file = file;
    for (InputError& other : faults.others) other.file = file;
    return tl::unexpected(std::move(faults));
  }
  const MapOptions options{.map_tolerance = stored.map.map_tolerance.value_or(MapOptions{}.map_tolerance),
                           .stop = stop};
  if (!stored.allowed || !stored.objective) return assemble_given(*task, *linkage, options);
  task->mechanism.reset();
  task->links.sections = stored.allowed->sections;
  return assemble_design(*task, found_design(stored, *linkage), options);
}

}  // namespace kempe
