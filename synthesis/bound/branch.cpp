#include "synthesis/bound/branch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "synthesis/tolerance/copy_error.hpp"

namespace kempe::bounding {
namespace {

constexpr double lock_slack = 1e-9;  // relative
/// An end of an opening in |psi| is a sum of at most six doubles below 7, each off by two units in its last place, and the
/// argument of s by as much again: 7e-15 rad is more than all of these.
constexpr double opening_slack = 32 * std::numeric_limits<double>::epsilon();

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }

/// Lengths per VA (VA, BC, BY, CY) and per b = VB/|s| (VB, AC, AX, CX), with the sources' places in
/// LinkLengths.
struct Factor {
  std::size_t length;
  double per;
};

Range allowed(const Spec& spec, double shortest, const std::array<Factor, 4>& factors) {
  Range range{0, infinity};
  const auto& locked = spec.links.workshop.locked;
  for (const Factor& factor : factors) {
    range.lower = std::max(range.lower, shortest * (1 - lock_slack) / factor.per);
    range.upper = std::min(range.upper, spec.links.longest * (1 + lock_slack) / factor.per);
    if (!locked[factor.length]) continue;
    range.lower = std::max(range.lower, *locked[factor.length] * (1 - lock_slack) / factor.per);
    range.upper = std::min(range.upper, *locked[factor.length] * (1 + lock_slack) / factor.per);
  }
  return range;
}

}  // namespace

Branch make_branch(const Spec& spec, Grounding grounding, int number, std::vector<LayerChoice> layers,
                   std::optional<double> least_distance) {
  const double shortest = least_distance.value_or(least_joint_distance(spec));
  Branch branch;
  branch.layers = std::move(layers);
  AssemblyMode& assembly_mode = branch.assembly_mode;
  assembly_mode.grounding = grounding;
  assembly_mode.number = number;
  assembly_mode.s = shape_of(spec.copy.k(), grounding);
  assembly_mode.chain = chain_length_per_tracer(spec.copy.k(), grounding);
  const OpeningInterval interval = assembly_modes(assembly_mode.s)[static_cast<std::size_t>(number)];
  const double psi = wrapped(interval.middle() - std::arg(assembly_mode.s));
  assembly_mode.bend = psi < 0 ? -1 : 1;
  branch.middle = interval.middle();
  branch.middle_psi = std::abs(psi);
  assembly_mode.far_end = std::max(0.0, branch.middle_psi - interval.width() / 2 - opening_slack);
  assembly_mode.near_end = std::min(pi, branch.middle_psi + interval.width() / 2 + opening_slack);
  assembly_mode.allowed = {0, pi};
  const double plate = std::abs(assembly_mode.s), side = std::abs(1.0 - assembly_mode.s);
  assembly_mode.size_per_a = 1 + (1 + plate + side) / 2;
  assembly_mode.size_per_b = plate + (plate + 1 + side) / 2;
  assembly_mode.a = allowed(spec, shortest, {{{0, 1}, {3, 1}, {6, plate}, {7, side}}});
  assembly_mode.b = allowed(spec, shortest, {{{1, plate}, {2, plate}, {4, 1}, {5, side}}});
  if (spec.limits.copy_error && spec.tolerance) {
    const CopyErrorProfile profile(spec.copy.k(), grounding, CopyTolerance::uniform(*spec.tolerance));
    const OpeningInterval kept = profile.openings_not_ruled_out(*spec.limits.copy_error, interval);
    const double one = branch.psi_of(kept.lower), other = branch.psi_of(kept.upper);
    if (kept.empty())
      assembly_mode.allowed = {};
    else
      assembly_mode.allowed = {std::min(one, other) - opening_slack, std::max(one, other) + opening_slack};
  }
  return branch;
}

}  // namespace kempe::bounding
