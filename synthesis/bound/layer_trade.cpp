#include "synthesis/bound/layer_trade.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/bound/slack.hpp"

namespace kempe::bounding {
namespace {

/// Share of the way from one end of psi to the other: a touch so near to an end is asked about there.
constexpr double at_end = 0.01;

/// The design in the middle of a box, on its way from the farthest place to the nearest as far as better designs go it.
class MiddleDesign {
 public:
  explicit MiddleDesign(const LayerQuestion& asked)
      : asked_(asked), a_(std::sqrt(asked.box.w() / asked.box.t() / 2)),
        b_(std::sqrt(asked.box.w() * asked.box.t() / 2)),
        linkage_(linkage_of(asked.spec, asked.branch, a_, b_, asked.box.pole)) {
    const Range usable = asked.branch.mode.usable(asked.transmission);
    if (!usable.empty())
      psi_ = {psi_at(asked.distances.farthest, usable), psi_at(asked.distances.nearest, usable)};
  }

  /// Where it touches itself most in an assignment, or nearly.
  struct Touch {
    ContactPair pair;
    ContactTouch points;
  };
  /// `by_all`: the psi that all designs of the box pass. Nothing where there is no such place, or other designs need not come by it.
  std::optional<Touch> touch_in(const LayerCandidate& layers, const Range& by_all) const {
    if (!linkage_ || !(psi_.lower < psi_.upper)) return std::nullopt;
    const double far = asked_.branch.opening_of(psi_.lower), near = asked_.branch.opening_of(psi_.upper);
    const LinkStyle& style = asked_.spec.links.style;
    const Tightest tightest =
        smallest_gap_over(*linkage_, style, layers.parts, {std::min(far, near), std::max(far, near)});
    if (!tightest.pair) return std::nullopt;
    const double psi = std::clamp(asked_.branch.psi_of(tightest.opening), psi_.lower, psi_.upper);
    const auto at = place_of(psi);
    if (at == ContactTouch::At::psi && !(by_all.lower <= psi && psi <= by_all.upper)) return std::nullopt;
    const ModeFacts& mode = asked_.branch.mode;
    const auto points = nearest_points(*tightest.pair, mode.s, style, a_, b_, mode.bend * psi);
    return Touch{*tightest.pair,
                 {at, psi, points.first, points.second,
                  (points.needed + asked_.spec.limits.clearance) * slack::surely_less}};
  }

 private:
  /// With the tracer at a distance, or the nearest that better designs may have.
  double psi_at(double distance, const Range& usable) const {
    const double along = asked_.branch.mode.chain * distance, t = asked_.box.t();
    const double cosine = along * along / asked_.box.w() - 0.5 * (t + 1 / t);
    return std::clamp(std::acos(std::clamp(cosine, -1.0, 1.0)), usable.lower, usable.upper);
  }

  ContactTouch::At place_of(double psi) const {
    const double share = (psi - psi_.lower) / (psi_.upper - psi_.lower);
    if (share < at_end) return ContactTouch::At::far;
    return share > 1 - at_end ? ContactTouch::At::near : ContactTouch::At::psi;
  }

  const LayerQuestion& asked_;
  double a_, b_;
  tl::expected<CopyingLinkage, LinkageFault> linkage_;
  Range psi_;
};

void strike_what_is_hit(const LayerQuestion& asked, TreeNode& node) {
  if (asked.obstacles == nullptr || !node.sight.hit) return;
  const auto touch = asked.obstacles->touch_of(asked.box, *node.sight.hit);
  if (touch && asked.trade.none_better_without(*touch))
    node.worse.add(asked.obstacles->layers_of(*node.sight.hit));
}

}  // namespace

bool leaves_a_layer(const LayerQuestion& asked, TreeNode& node) {
  strike_what_is_hit(asked, node);
  const MiddleDesign middle(asked);
  const Range by_all = passed_by_all(asked.branch.mode, node.distances, node.lengths);
  const std::vector<LayerCandidate>& layers = asked.branch.layers;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!node.alive.has(i) || node.worse.has(i)) continue;
    const auto touch = middle.touch_in(layers[i], by_all);
    if (!touch || !asked.trade.none_better_without(touch->points)) return true;
    const PairKey pair = key_of(touch->pair);
    for (std::size_t j = 0; j < layers.size(); ++j)
      if (layers[j].has(pair)) node.worse.add(j);
  }
  return false;
}

}  // namespace kempe::bounding
