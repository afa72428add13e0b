#include "synthesis/bound/branch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "synthesis/bound/slack.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe::bounding {
namespace {

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }

/// Lengths per VA (VA, BC, BY, CY) and per b = VB/|s| (VB, AC, AX, CX), with the sources' places in
/// LinkLengths.
struct Factor {
  std::size_t length;
  double per;
};

Range allowed(const Spec& spec, double shortest, const std::array<Factor, 4>& factors) {
  Range range{0, infinity};
  const auto& locked = spec.links.stock_lengths.locked;
  const double most = std::max(0.0, largest_joint_distance(spec)) * (1 + slack::locked_length);
  for (const Factor& factor : factors) {
    range.lower = std::max(range.lower, shortest * (1 - slack::locked_length) / factor.per);
    range.upper = std::min(range.upper, most / factor.per);
    if (!locked[factor.length]) continue;
    range.lower = std::max(range.lower, *locked[factor.length] * (1 - slack::locked_length) / factor.per);
    range.upper = std::min(range.upper, *locked[factor.length] * (1 + slack::locked_length) / factor.per);
  }
  return range;
}

}  // namespace

Branch make_branch(const Spec& spec, Grounding grounding, const AssemblyMode& assembly_mode,
                   std::vector<LayerCandidate> layers, std::optional<double> least_distance) {
  const double shortest = least_distance.value_or(least_joint_distance(spec));
  Branch branch;
  branch.layers = std::move(layers);
  ModeFacts& mode = branch.mode;
  mode.grounding = grounding;
  mode.s = shape_of(spec.copy.k(), grounding);
  mode.chain = chain_length_per_tracer(spec.copy.k(), grounding);
  mode.assembly_mode = assembly_mode;
  const OpeningInterval& interval = assembly_mode.openings;
  const double psi = wrapped(interval.middle() - std::arg(mode.s));
  mode.bend = psi < 0 ? -1 : 1;
  branch.middle = interval.middle();
  branch.middle_psi = std::abs(psi);
  mode.far_end = std::max(0.0, branch.middle_psi - interval.width() / 2 - slack::end_of_opening);
  mode.near_end = std::min(pi, branch.middle_psi + interval.width() / 2 + slack::end_of_opening);
  mode.allowed = {0, pi};
  const double plate = std::abs(mode.s), side = std::abs(1.0 - mode.s);
  mode.size_per_a = 1 + (1 + plate + side) / 2;
  mode.size_per_b = plate + (plate + 1 + side) / 2;
  mode.a = allowed(spec, shortest, {{{0, 1}, {3, 1}, {6, plate}, {7, side}}});
  mode.b = allowed(spec, shortest, {{{1, plate}, {2, plate}, {4, 1}, {5, side}}});
  if (spec.limits.copy_error && spec.tolerance) {
    const CopyErrorProfile profile(spec.copy.k(), grounding, CopyTolerance::uniform(*spec.tolerance));
    const OpeningInterval kept = profile.openings_not_ruled_out(*spec.limits.copy_error, interval);
    const double one = branch.psi_of(kept.lower), other = branch.psi_of(kept.upper);
    if (kept.empty())
      mode.allowed = {};
    else
      mode.allowed = {std::min(one, other) - slack::end_of_opening,
                      std::max(one, other) + slack::end_of_opening};
  }
  return branch;
}

tl::expected<CopyingLinkage, LinkageFault> linkage_of(const Spec& spec, const Branch& branch, double a,
                                                      double b, const Point& pole) {
  return CopyingLinkage::make(spec.copy.k(), branch.mode.grounding, a, b * std::abs(branch.mode.s),
                              branch.mode.assembly_mode.number, pole);
}

}  // namespace kempe::bounding
