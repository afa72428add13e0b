// What a stored design's figures mean: its linkage in closed form, what its map is made of, and the task of checking it.

#include <fmt/format.h>

#include <cmath>

#include "reports/data/design_json.hpp"

namespace kempe {
namespace {

/// The assembly mode whose interval holds the stored opening and whose orientation is the stored one.
std::optional<CopyingLinkage> fitting_assembly_mode(const StoredDesign& design) {
  const DrawnMechanism& drawn = design.mechanism;
  constexpr double slack = 1e-9;
  for (const AssemblyMode& mode : assembly_modes(shape_of(design.k, design.grounding))) {
    const OpeningInterval widened{mode.openings.lower - slack, mode.openings.upper + slack};
    if (!widened.contains(drawn.opening) || mode.sides != drawn.sides ||
        mode.number != design.assembly_mode.value_or(mode.number))
      continue;
    const auto linkage = CopyingLinkage::make(design.k, design.grounding, drawn.lengths.VA, drawn.lengths.VB,
                                              mode.number, drawn.pole_position);
    if (linkage) return *linkage;
  }
  return std::nullopt;
}

}  // namespace

tl::expected<CopyingLinkage, InputError> linkage_of(const StoredDesign& design, const std::string& file) {
  const auto refused = [&](const std::string& key, const std::string& found, const std::string& allowed) {
    return tl::unexpected(InputError{file, 0, "mechanism." + key, found, allowed});
  };
  const Complex shape = shape_of(design.k, design.grounding);
  if (std::abs(shape - design.shape) > 1e-9 * (1 + std::abs(shape)))
    return refused("shape", fmt::format("[{}, {}]", design.shape.real(), design.shape.imag()),
                   fmt::format("[{}, {}] for this copy ratio and vertex", shape.real(), shape.imag()));
  const auto linkage = fitting_assembly_mode(design);
  if (!linkage)
    return refused("opening_deg", "an opening or an orientation of no assembly mode",
                   "those of one assembly mode of this shape");
  const auto stored = design.mechanism.lengths.values(), exact = linkage->lengths().values();
  for (std::size_t i = 0; i < stored.size(); ++i)
    if (std::abs(stored[i] - exact[i]) > 1e-9 * linkage->size())
      return refused(fmt::format("lengths_mm.{}", LinkLengths::names[i]), fmt::format("{}", stored[i]),
                     fmt::format("{} to close and copy with VA, VB and the shape", exact[i]));
  return *linkage;
}

MapTask map_task(const StoredDesign& design, const CopyingLinkage& linkage) {
  return {.linkage = linkage,
          .style = design.style,
          .layers = design.layers,
          .limits = design.limits.value_or(Limits{}),
          .obstacles = design.obstacles,
          .bodies = design.bodies,
          .table = design.table};
}

namespace {

/// Where there is no region to drive over the file does not say where the linkage is free: it is mapped anew.
void drive_over_workspace(const StoredDesign& design, VerificationTask& task) {
  const auto linkage = linkage_of(design, "");
  if (!linkage) return;  // whatever contradicts itself there, the drive over the region sees it too
  MapTask mapped = map_task(design, *linkage);
  WorkspaceMap map = map_workspace(mapped, {.largest_sheets = false});
  // Of several free intervals the file states one, which need not be the widest.
  if (!task.mechanism.opening.empty()) map.certified_opening = task.mechanism.opening;
  task.workspace = part_to_drive_over(mapped, map);
  if (!task.mechanism.opening.empty()) return;
  task.mechanism.opening = linkage->openings_with_transmission(mapped.limits.transmission);
  task.region_covered = false;
}

}  // namespace

VerificationTask verification_task(const StoredDesign& design) {
  VerificationTask task;
  task.mechanism = design.mechanism;
  task.mechanism.shape = design.shape;
  task.k = design.k;
  task.region = design.region;
  task.region_covered = design.region_covered;
  task.style = design.style;
  task.layers = design.layers;
  if (task.region.empty() || !task.region_covered) drive_over_workspace(design, task);
  if (design.limits && task.region_covered) {
    task.limits = *design.limits;
    task.obstacles = design.obstacles;
    task.bodies = design.bodies;
    task.table = design.table;
  }
  return task;
}

}  // namespace kempe
