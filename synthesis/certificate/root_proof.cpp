#include "synthesis/certificate/root_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/bound/pole_places.hpp"
#include "synthesis/certificate/slack.hpp"

namespace kempe::certificate {
namespace {

RootTask root_task(const Spec& spec, const RegionPlaces& places, Grounding grounding,
                   const AssemblyMode& mode) {
  RootTask task{spec, places, bounding::make_branch(spec, grounding, mode, {})};
  task.root.mode = task.branch.mode;
  const Complex k = spec.copy.k();
  task.root.g = chain_per_tracer(k, grounding);
  const auto any = CopyingLinkage::make(k, grounding, 100, 100, mode.number);
  if (!any) return task;
  for (const LayerAssignment& layers : layer_assignments(spec.links.layers)) {
    task.layers.push_back(layers);
    task.filled.emplace_back(*any, layers);
  }
  return task;
}

std::size_t largest(const std::array<double, 4>& values) {
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

/// The middle of a range, of one that spans a factor of two the geometric one, in no more digits than it needs: a log has tens of
/// thousands of them.
double short_middle(const bounding::Range& range) {
  const bool by_ratio = range.lower > 0 && range.upper > 2 * range.lower;
  const double middle = by_ratio ? std::sqrt(range.lower * range.upper) : 0.5 * (range.lower + range.upper);
  const double digits = -std::floor(std::log10(slack::short_cut * (range.upper - range.lower)));
  if (!(std::abs(digits) < 16)) return middle;  // narrower than any decimal is worth
  const double power = std::pow(10.0, std::abs(digits));
  const double rounded = digits > 0 ? std::round(middle * power) / power : std::round(middle / power) * power;
  return rounded > range.lower && rounded < range.upper ? rounded : middle;
}

Step cut_at_middle(const Node& node, Variable variable) {
  const double at = short_middle(node.cell[variable]);
  Node lower = node, upper = node;
  lower.cell[variable].upper = at;
  upper.cell[variable].lower = at;
  return Step{Split{variable, at}, {std::move(lower), std::move(upper)}};
}

}  // namespace

RootProof::RootProof(const Spec& spec, const RegionPlaces& places, Grounding grounding,
                     const AssemblyMode& mode, const std::optional<double>& size_bound, double transmission,
                     CutOrder order)
    : task_(root_task(spec, places, grounding, mode)), obstacles_(task_), contact_(task_), order_(order) {
  const double between = spec.links.style.pin_diameter + spec.limits.clearance;
  const Complex s = task_.root.mode.s;
  const double smallest = std::abs(task_.root.g) * std::min({1.0, std::abs(s), std::abs(1.0 - s)});
  task_.sums = {&task_.root, &places, size_bound, between / smallest};
  put_whole(transmission);
}

std::optional<Step> RootProof::step(Node& node) const {
  if (task_.root.mode.a.empty() || task_.root.mode.b.empty()) return Step{LengthsLeaf{}, {}};
  if (node.assignments.empty()) return Step{LayersLeaf{}, {}};
  const BestSum sum = best_sum(task_.sums, node.cell);
  if (sum.refutes) return Step{sum.leaf, {}};
  if (auto cut = copy_error_step(node)) return cut;
  if (outside_pole(node.cell)) return Step{PoleLeaf{}, {}};
  if (const auto sheets = copy_too_near(node.cell)) return Step{*sheets, {}};
  if (has_all_lengths(node.cell)) {
    ObstacleLeaves::ByTheCopy copy = obstacles_.by_the_copy(node);
    if (copy.step) return std::move(copy.step);
    if (copy.guess)
      if (auto cut = cut_poles(node, *copy.guess)) return cut;
  }
  if (auto hit = obstacles_.step(node)) return hit;
  if (auto cut = contact_.step(node)) return cut;
  return split(node, sum);
}

void RootProof::put_whole(double transmission) {
  bounding::ModeFacts& mode = task_.root.mode;
  kept_ = mode.allowed;
  mode.allowed = {0, 4};  // rad, all: what the copy error leaves is a step of the log
  const bounding::Range window = mode.usable(transmission);
  const Box poles = bounding::box_of_places(task_.spec.pole);
  whole_.cell[Variable::a] = task_.root.mode.a;
  whole_.cell[Variable::b] = task_.root.mode.b;
  whole_.cell[Variable::x] = {poles.lower.x(), poles.upper.x()};
  whole_.cell[Variable::y] = {poles.lower.y(), poles.upper.y()};
  whole_.cell.far_cosine = std::cos(window.lower);
  whole_.cell.near_cosine = std::cos(window.upper);
  for (std::size_t i = 0; i < task_.layers.size(); ++i)
    whole_.assignments.push_back(static_cast<std::uint32_t>(i));
}

/// True where at most the pole was cut.
bool RootProof::has_all_lengths(const DesignCell& cell) const {
  const auto is_whole = [&](Variable variable) {
    return cell[variable].lower == whole_.cell[variable].lower &&
           cell[variable].upper == whole_.cell[variable].upper;
  };
  return is_whole(Variable::a) && is_whole(Variable::b);
}

/// The window without the openings that exceed the limit on the copy error, if there are such.
std::optional<Step> RootProof::copy_error_step(const Node& node) const {
  if (!task_.spec.limits.copy_error || !task_.spec.tolerance) return std::nullopt;
  const double far = std::min(node.cell.far_cosine,
                              std::cos(std::max(0.0, kept_.lower - slack::beyond_copy_error))),
               near = std::max(node.cell.near_cosine,
                               std::cos(std::min(pi, kept_.upper + slack::beyond_copy_error)));
  if (kept_.empty() || !(far > near)) {
    const double middle = 0.5 * (node.cell.far_cosine + node.cell.near_cosine);
    return Step{CopyErrorCut{middle, middle}, {}};
  }
  const bool cut_far = far < node.cell.far_cosine;
  const bool cut_near = near > node.cell.near_cosine;
  if (!cut_far && !cut_near) return std::nullopt;
  Node left = node;
  left.cell.far_cosine = far;
  left.cell.near_cosine = near;
  // The checker rounds the window's own ends otherwise: one that is not cut is named by what is beyond any.
  return Step{CopyErrorCut{cut_far ? far : 1, cut_near ? near : -1}, {std::move(left)}};
}

bool RootProof::outside_pole(const DesignCell& cell) const {
  const auto* within = std::get_if<Region>(&task_.spec.pole.place);
  if (within == nullptr || (cell.half(Variable::x) == 0 && cell.half(Variable::y) == 0)) return false;
  const double radius = std::hypot(cell.half(Variable::x), cell.half(Variable::y));
  return distance(*within, cell.pole()) > radius * (1 + slack::in_hand) + slack::in_hand;
}

/// The two places of the region that the copy brings nearest to each other, if that is too near all over the cell.
std::optional<CopyGapLeaf> RootProof::copy_too_near(const DesignCell& cell) const {
  if (!task_.spec.limits.copy_gap) return std::nullopt;
  const Complex k = task_.spec.copy.k(), pole = as_complex(cell.pole());
  const double away = std::abs(1.0 - k) * std::hypot(cell.half(Variable::x), cell.half(Variable::y));
  const double room = *task_.spec.limits.copy_gap * (1 - slack::in_hand) - away - slack::in_hand;
  if (!(room > 0)) return std::nullopt;
  for (const KnownPlace& place : task_.places.spread()) {
    const Complex from_pole = as_complex(place.at) - pole;
    const Point image = as_point(pole + k * from_pole), source = as_point(pole + from_pole / k);
    const KnownPlace near_image = task_.places.nearest(image), near_source = task_.places.nearest(source);
    if ((near_image.at - image).norm() < room) return CopyGapLeaf{place.place, near_image.place};
    if (std::abs(k) * (near_source.at - source).norm() < room)
      return CopyGapLeaf{near_source.place, place.place};
  }
  return std::nullopt;
}

/// The pole in the cell's middle brings the copy too near to the original: half of the cell or more can be refuted by that alone,
/// whatever the lengths.
bool RootProof::half_too_near(DesignCell cell) const {
  for (const Variable v : {Variable::x, Variable::y}) cell[v] = {cell.middle(v), cell.middle(v)};
  return copy_too_near(cell).has_value();
}

/// The variable that adds most to what the sum lacks, unless another is left much wider: obstacles and contacts, of which the
/// sum knows nothing, rule out no cell that is wide in any variable. Nothing if the cell is too narrow in all of them.
std::optional<Variable> RootProof::variable_to_cut(const DesignCell& cell, const BestSum& sum) const {
  std::array<double, 4> width{}, wanted{};
  const double near =
      std::max(slack::nearest_weighed, (task_.places.nearest(cell.pole()).at - cell.pole()).norm());
  const double far = (task_.places.farthest(cell.pole()).at - cell.pole()).norm();
  for (const Variable variable : all_variables) {
    const auto i = static_cast<std::size_t>(variable);
    const bool is_length = variable == Variable::a || variable == Variable::b;
    const double relative = is_length ? 0.5 * std::log(cell[variable].upper / cell[variable].lower)
                                      : cell.half(variable) * (0.5 / near + 0.5 / far);
    if (relative < slack::narrowest_cut) continue;
    width[i] = relative;
    wanted[i] = sum.refutes_soon ? sum.share[i] + slack::width_weight * relative : relative;
  }
  const std::size_t widest = largest(width);
  if (order_ == CutOrder::poles_first) {
    const Variable side = width[3] > width[2] ? Variable::y : Variable::x;
    const double its_width = width[static_cast<std::size_t>(side)];
    if (its_width * slack::most_uneven_of_poles > width[widest] && half_too_near(cell)) return side;
  }
  std::size_t chosen = largest(wanted);
  if (width[widest] > slack::most_uneven * width[chosen]) chosen = widest;
  if (width[chosen] == 0) return std::nullopt;
  return static_cast<Variable>(chosen);
}

std::optional<Step> RootProof::split(const Node& node, const BestSum& sum) const {
  const std::optional<Variable> cut = variable_to_cut(node.cell, sum);
  if (!cut) return std::nullopt;
  return cut_at_middle(node, *cut);
}

/// Where the pole in the cell's middle brings tracer or pen into an obstruction half of the cell or more can be refuted by that alone.
/// Nothing if the pole is nearly known.
std::optional<Step> RootProof::cut_poles(const Node& node, const ObstacleGuess& guess) const {
  const DesignCell& cell = node.cell;
  const Variable side = cell.half(Variable::y) > cell.half(Variable::x) ? Variable::y : Variable::x;
  if (!(cell.half(side) > slack::narrowest_poles * whole_.cell.half(side))) return std::nullopt;
  Node guessed = node;
  guessed.guess = guess;
  return cut_at_middle(guessed, side);
}

}  // namespace kempe::certificate
