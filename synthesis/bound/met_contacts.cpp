#include "synthesis/bound/met_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/bound/slack.hpp"

namespace kempe::bounding {
namespace {

bool is_cut(const Branch& branch, const TreeNode& node, const Range& passed, const MetContacts::Cut& cut) {
  if (cut.psi < passed.lower || cut.psi > passed.upper) return false;
  return always_nearer(branch.mode, node.lengths, cut.psi, cut.first, cut.second, cut.needed);
}

/// Drops every layer assignment in which the pair must keep its clearance.
void strike(TreeNode& node, const Branch& branch, const PairKey& pair) {
  for (std::size_t i = 0; i < branch.layers.size(); ++i)
    if (branch.layers[i].has(pair)) node.alive.remove(i);
}

}  // namespace

bool MetContacts::repeat(TreeNode& node, const Branch& branch) const {
  if (std::all_of(node.cut.begin(), node.cut.end(), [](std::uint32_t cut) { return cut == 0; })) return true;
  const Range passed = passed_by_all(branch.mode, node.distances, node.lengths);
  for (std::size_t i = 0; i < kept_cuts; ++i)
    if (node.alive.has(i) && node.cut[i] != 0 && is_cut(branch, node, passed, cuts_[node.cut[i]]))
      node.alive.remove(i);
  return !node.alive.empty();
}

bool MetContacts::rule_out(TreeNode& node, const Branch& branch, std::size_t& boxes) {
  const Range passed = passed_by_all(branch.mode, node.distances, node.lengths);
  if (passed.empty()) return true;
  const double t = std::sqrt(node.lengths.t.lower * node.lengths.t.upper);
  const double w = std::sqrt(node.lengths.w.lower * node.lengths.w.upper);
  const double a = std::sqrt(w / t / 2), b = std::sqrt(w * t / 2);
  const auto linkage = linkage_of(spec_, branch, a, b, node.pole());
  if (!linkage) return true;
  const double one = branch.opening_of(passed.lower), other = branch.opening_of(passed.upper);
  const OpeningInterval openings{std::min(one, other), std::max(one, other)};
  for (std::size_t i = 0; i < branch.layers.size(); ++i) {
    if (!node.alive.has(i)) continue;
    if (stop_()) break;
    ++boxes;
    const Tightest tightest =
        smallest_gap_over(*linkage, spec_.links.style, branch.layers[i].layers, openings);
    if (tightest.gap >= spec_.limits.clearance || !tightest.pair) return true;
    const double psi = std::clamp(branch.psi_of(tightest.opening), passed.lower, passed.upper);
    const auto points =
        nearest_points(*tightest.pair, branch.mode.s, spec_.links.style, a, b, branch.mode.bend * psi);
    const Cut cut{psi, points.first, points.second,
                  (points.needed + spec_.limits.clearance) * slack::surely_less};
    if (!is_cut(branch, node, passed, cut)) {
      if (i < kept_cuts) {
        node.cut[i] = static_cast<std::uint32_t>(cuts_.size());
        cuts_.push_back(cut);
      }
      return true;
    }
    strike(node, branch, key_of(*tightest.pair));
  }
  return !node.alive.empty();
}

}  // namespace kempe::bounding
