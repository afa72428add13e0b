#include "synthesis/bound/layer_trade.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/bound/slack.hpp"

namespace kempe::bounding {
namespace {

/// Of the way from one end of psi to the other: so near to an end a touch is asked about there.
constexpr double at_end = 0.01;

/// The |psi| of the middle design with the tracer at a distance, or the nearest that better designs may have.
double psi_at(const ModeFacts& mode, const DesignBox& box, double distance, const Range& usable) {
  const double t = box.t(), along = mode.chain * distance;
  const double cosine = along * along / box.w() - 0.5 * (t + 1 / t);
  return std::clamp(std::acos(std::clamp(cosine, -1.0, 1.0)), usable.lower, usable.upper);
}

}  // namespace

bool LayerTrade::leaves_one(TreeNode& node) const {
  for (std::size_t i = 0; i < branch.layers.size(); ++i)
    if (node.alive.has(i) && !node.worse.has(i) && !is_worse_by_obstacle(node, i) &&
        !is_worse_by_contact(node, i))
      return true;
  return false;
}

bool LayerTrade::is_worse_by_obstacle(TreeNode& node, std::size_t layers) const {
  if (obstacles == nullptr) return false;
  if (node.sight.layers != layers) {
    LayerSet one;
    one.add(layers);
    if (obstacles->not_hit(box, one, node.sight, false).empty()) {
      node.alive.remove(layers);
      return true;
    }
  }
  if (!node.sight.hit || !obstacles->layers_of(*node.sight.hit).has(layers)) return false;
  const auto touch = obstacles->touch_of(box, *node.sight.hit);
  if (!touch || !trade.none_better_without(*touch)) return false;
  node.worse.add(obstacles->layers_of(*node.sight.hit));
  return true;
}

bool LayerTrade::is_worse_by_contact(TreeNode& node, std::size_t layers) const {
  const ModeFacts& mode = branch.mode;
  const Range usable = mode.usable(transmission);
  if (usable.empty()) return false;
  const Range passed{psi_at(mode, box, distances.farthest, usable), psi_at(mode, box, distances.nearest, usable)};
  const double t = box.t(), w = box.w();
  const auto linkage = linkage_of(spec, branch, std::sqrt(w / t / 2), std::sqrt(w * t / 2), node.pole());
  if (!linkage || !(passed.lower < passed.upper)) return false;
  const double far = branch.opening_of(passed.lower), near = branch.opening_of(passed.upper);
  const Tightest tightest = smallest_gap_over(*linkage, spec.links.style, branch.layers[layers].parts,
                                              {std::min(far, near), std::max(far, near)});
  if (!tightest.pair) return false;
  const double psi = std::clamp(branch.psi_of(tightest.opening), passed.lower, passed.upper);
  const auto touch = contact_of(node, *tightest.pair, psi, passed);
  if (!touch || !trade.none_better_without(*touch)) return false;
  const PairKey pair = key_of(*tightest.pair);
  for (std::size_t i = 0; i < branch.layers.size(); ++i)
    if (branch.layers[i].has(pair)) node.worse.add(i);
  return true;
}

std::optional<ContactTouch> LayerTrade::contact_of(const TreeNode& node, const ContactPair& pair, double psi,
                                                   const Range& passed) const {
  using At = ContactTouch::At;
  const double share = (psi - passed.lower) / (passed.upper - passed.lower);
  const Range by_all = passed_by_all(branch.mode, node.distances, node.lengths);
  const bool is_common = by_all.lower <= psi && psi <= by_all.upper;
  const At at = share < at_end ? At::far : share > 1 - at_end ? At::near : At::psi;
  if (at == At::psi && !is_common) return std::nullopt;
  const double t = box.t(), w = box.w();
  const auto points = nearest_points(pair, branch.mode.s, spec.links.style, std::sqrt(w / t / 2),
                                     std::sqrt(w * t / 2), branch.mode.bend * psi);
  return ContactTouch{at, psi, points.first, points.second,
                      (points.needed + spec.limits.clearance) * slack::surely_less};
}

}  // namespace kempe::bounding
