#pragma once
// Random groundings and assembly modes of linkages under load, and designs of them, for the tests of the bound.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "specs/materials.hpp"
#include "synthesis/bound/branch.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe::test {

struct LoadedBranch {
  Spec spec;
  bounding::Branch branch;
};

/// With load, steel and a limit.
inline Spec loaded(Spec spec, double limit = 0.1) {
  spec.material = as_material(*material_named("steel"));
  spec.load = Load{10};
  spec.limits.load_error = limit;
  return spec;
}

inline LoadedBranch random_branch(SpecDice& dice) {
  Spec spec = loaded(dice.spec());
  spec.limits.copy_error.reset();
  spec.links.style.thickness = dice.uniform(1, 8);
  if (dice.one_in(4)) spec.copy = Copy::of(dice.log_uniform(0.1, 10), dice.one_in(2) ? 0 : pi);
  const Grounding grounding = all_groundings[static_cast<std::size_t>(dice.uniform(0, 3))];
  const auto modes = assembly_modes(shape_of(spec.copy.k(), grounding));
  const auto number = static_cast<std::size_t>(dice.uniform(0, static_cast<double>(modes.size())));
  auto branch = bounding::make_branch(spec, grounding, modes[number], {});
  return {std::move(spec), std::move(branch)};
}

/// A random design of a branch, and the distances that it covers between two of its openings; no linkage where these are out of order.
struct DesignAtDistances {
  DesignAtDistances(const LoadedBranch& one, SpecDice& dice)
      : t(dice.log_uniform(0.3, 3)), w(dice.log_uniform(1e3, 1e5)) {
    const bounding::ModeFacts& mode = one.branch.mode;
    const double far_psi = dice.uniform(mode.far_end + 0.05, mode.near_end - 0.05),
                 near_psi = dice.uniform(far_psi, mode.near_end - 0.05);
    if (!(far_psi < near_psi)) return;
    linkage =
        bounding::linkage_of(one.spec, one.branch, std::sqrt(w / t / 2), std::sqrt(w * t / 2), Point::Zero())
            .value();
    const double far = one.branch.opening_of(far_psi), near = one.branch.opening_of(near_psi);
    openings = {std::min(far, near), std::max(far, near)};
    const double nearest = linkage->radius_at(near), farthest = linkage->radius_at(far);
    distances = {nearest, farthest, 1, farthest * farthest - nearest * nearest};
  }
  double t, w;
  std::optional<CopyingLinkage> linkage;
  OpeningInterval openings{};
  bounding::PoleDistances distances{};
};

}  // namespace kempe::test
