#include "synthesis/certificate/contact_cut.hpp"

#include <algorithm>
#include <cmath>

#include "workspace/contact/self_contact.hpp"

namespace kempe::certificate {

std::optional<Step> ContactCuts::step(const Node& node) const {
  if (!small_enough(node.cell)) return std::nullopt;
  const bounding::Range range = passed(node.cell);
  if (range.empty()) return std::nullopt;
  const auto linkage =
      CopyingLinkage::make(task_.spec.copy.k(), task_.root.mode.grounding, node.cell.middle(Variable::a),
                           node.cell.middle(Variable::b) * std::abs(task_.root.mode.s),
                           task_.root.mode.assembly_mode.number, node.cell.pole());
  if (!linkage) return std::nullopt;
  const double one = task_.branch.opening_of(range.lower), other = task_.branch.opening_of(range.upper);
  const OpeningInterval openings{std::min(one, other), std::max(one, other)};
  int looked_at = 0;
  constexpr int most_looked_at = 6;
  for (const std::uint32_t i : node.assignments) {
    if (looked_at == most_looked_at) break;
    const Tightest tightest = smallest_gap_over(*linkage, task_.spec.links.style, task_.layers[i], openings);
    ++looked_at;
    if (!tightest.pair || tightest.gap >= task_.spec.limits.clearance) continue;
    const PartName first = name_of(tightest.pair->first), second = name_of(tightest.pair->second);
    if (!task_.filled[i].share(first, second)) continue;  // two posts: a sum's business
    const double psi = std::clamp(task_.branch.psi_of(tightest.opening), range.lower, range.upper);
    const auto cut = best_cut(*tightest.pair, node.cell, psi, range);
    if (!cut) continue;
    Assignments some;
    for (const std::uint32_t j : node.assignments)
      if (task_.filled[j].share(first, second)) some.push_back(j);
    if (some.size() < node.assignments.size()) return share_step(node, {first, second}, some, std::nullopt);
    return Step{
        cut->cut,
        {{cut->sides[0], node.assignments, node.guess}, {cut->sides[1], node.assignments, node.guess}}};
  }
  return std::nullopt;
}

/// |psi| of the middle design at the farthest and the nearest place, within the window.
bounding::Range ContactCuts::passed(const DesignCell& cell) const {
  const double a = cell.middle(Variable::a), b = cell.middle(Variable::b);
  const auto psi = [&](const Point& place) {
    const double r = std::norm(task_.root.g) * (place - cell.pole()).squaredNorm();
    return std::acos(std::clamp((r - a * a - b * b) / (2 * a * b), -1.0, 1.0));
  };
  return {std::max(psi(task_.places.farthest(cell.pole()).at), std::acos(cell.far_cosine)),
          std::min(psi(task_.places.nearest(cell.pole()).at), std::acos(cell.near_cosine))};
}

/// The cut at |psi|, if its two nearest points are too near each other at all corners of the lengths.
std::optional<ContactCut> ContactCuts::cut_at(const ContactPair& pair, const DesignCell& cell,
                                              double psi) const {
  const double a = cell.middle(Variable::a), b = cell.middle(Variable::b);
  const LinkStyle& style = task_.spec.links.style;
  const auto nearest =
      bounding::nearest_points(pair, task_.root.mode.s, style, a, b, task_.root.mode.bend * psi);
  ContactCut cut{part_point(name_of(pair.first), nearest.first, task_.root.mode.s, style.plate),
                 part_point(name_of(pair.second), nearest.second, task_.root.mode.s, style.plate),
                 std::tan(psi / 2)};
  const auto one = material_point(cut.one, task_.root.mode.s),
             other = material_point(cut.other, task_.root.mode.s);
  const Complex turn = std::polar(1.0, task_.root.mode.bend * 2 * std::atan(cut.u));
  const double allowed = (nearest.needed + task_.spec.limits.clearance) * (1 - slack::in_hand);
  for (const double corner_a : {cell[Variable::a].lower, cell[Variable::a].upper})
    for (const double corner_b : {cell[Variable::b].lower, cell[Variable::b].upper})
      if (!(std::abs((one.of_a - other.of_a) * corner_a + (one.of_b - other.of_b) * corner_b * turn) <
            allowed))
        return std::nullopt;
  return cut;
}

std::optional<ContactCuts::SeenCut> ContactCuts::seen_cut(const ContactPair& pair, const DesignCell& cell,
                                                          double psi) const {
  const auto cut = cut_at(pair, cell, psi);
  if (!cut) return std::nullopt;
  SeenCut seen{*cut, {cell, cell}};
  const double cosine = (1 - cut->u * cut->u) / (1 + cut->u * cut->u);
  seen.sides[0].near_cosine = seen.sides[1].far_cosine = cosine;
  for (const DesignCell& side : seen.sides) seen.refuted += best_sum(task_.sums, side).refutes;
  return seen;
}

/// The last cut on the way from `from` to `to` that holds all over the cell, as all before it do: looked for in strides, then by
/// halving.
std::optional<ContactCuts::SeenCut> ContactCuts::farthest_cut(const ContactPair& pair, const DesignCell& cell,
                                                              double from, double to) const {
  constexpr int strides = 16, halvings = 20;
  std::optional<double> held;
  double fails = to;
  for (int stride = 1; stride <= strides; ++stride) {
    const double psi = from + (to - from) * stride / strides;
    fails = psi;
    if (!cut_at(pair, cell, psi)) break;
    held = psi;
  }
  double holds = held.value_or(from);
  for (int i = 0; i < halvings && holds != fails; ++i) {
    const double middle = 0.5 * (holds + fails);
    if (cut_at(pair, cell, middle))
      held = holds = middle;
    else
      fails = middle;
  }
  return held ? seen_cut(pair, cell, *held) : std::nullopt;
}

/// Both sides are narrower than the openings passed before, by a share that falls with the cell's: else the same cut would
/// be found again and again where a smaller cell has a better one. So it would, too, halving what is passed without end, where
/// that is narrow beside what the cell's width makes of it.
bool ContactCuts::narrows(const SeenCut& cut, const DesignCell& cell, const bounding::Range& range) {
  const double width = std::max(cell.half(Variable::a) / cell.middle(Variable::a),
                                cell.half(Variable::b) / cell.middle(Variable::b));
  const double psi = 2 * std::atan(cut.cut.u);
  const double passed = range.upper - range.lower,
               least = std::min(slack::least_side_of_cut, 0.1 * width) * passed;
  return passed > slack::narrowest_passed * width && psi > range.lower + least && psi < range.upper - least;
}

std::optional<ContactCuts::SeenCut> ContactCuts::best_cut(const ContactPair& pair, const DesignCell& cell,
                                                          double deepest,
                                                          const bounding::Range& range) const {
  const auto first = seen_cut(pair, cell, deepest);
  if (!first || first->refuted == 2) return first;
  const auto middle = seen_cut(pair, cell, 0.5 * (range.lower + range.upper));
  if (middle && middle->refuted == 2) return middle;
  std::optional<SeenCut> best;
  for (const auto& cut : {farthest_cut(pair, cell, deepest, range.upper),
                          farthest_cut(pair, cell, deepest, range.lower), middle, first})
    if (cut && narrows(*cut, cell, range) && cut->refuted > (best ? best->refuted : 0)) best = cut;
  return best;
}

}  // namespace kempe::certificate
