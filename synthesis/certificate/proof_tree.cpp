// A node is refuted by a sum of requirements, by the pole's place or the gap between original and copy if that is possible; else an
// obstacle or a contact of the linkage with itself is sought that rules out part of it; else its widest variable is cut.

#include "synthesis/certificate/proof_tree.hpp"

#include <algorithm>
#include <cmath>
#include <tl/expected.hpp>

#include "geometry/convex_distance.hpp"
#include "geometry/regions/convex_parts.hpp"
#include "synthesis/bound/branch.hpp"
#include "synthesis/certificate/obstacle_points.hpp"
#include "synthesis/certificate/part_points.hpp"
#include "synthesis/certificate/requirement_sum.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/obstacles.hpp"

namespace kempe::certificate {
namespace {

/// What a guess in doubles keeps in hand, so that the checker's own rounding does not decide otherwise.
constexpr double in_hand = 1e-9;

/// A set of layer assignments by their numbers.
using Assignments = std::vector<std::uint32_t>;

/// A point of the linkage in an obstacle: tried first in the cells within one where it was found.
struct ObstacleGuess {
  ObstacleLeaf leaf;
  Point place = Point::Zero();
};

struct Node {
  DesignCell cell;
  Assignments assignments;
  std::optional<ObstacleGuess> guess;
};

/// A line and what is left to refute after it.
struct Step {
  Line line;
  std::vector<Node> children;
};

/// One grounding and assembly mode.
class RootProof {
 public:
  RootProof(const Spec& spec, const RegionPlaces& places, Grounding grounding, int number,
            const std::optional<double>& size_bound, double transmission)
      : spec_(spec), places_(places), number_(number),
        branch_(bounding::make_branch(spec, grounding, number, {})) {
    root_.mode = branch_.assembly_mode;
    root_.mode.allowed = {0, 4};  // rad, all: the limit on the copy error has no rule
    const Complex k = spec.copy.k();
    root_.g = grounding == Grounding::pole ? Complex(1) : grounding == Grounding::tracer ? Complex(-1) : -k;
    const double between = spec.links.style.pin_diameter + spec.limits.clearance;
    const Complex s = root_.mode.s;
    const double smallest = std::abs(root_.g) * std::min({1.0, std::abs(s), std::abs(1.0 - s)});
    sums_ = {&root_, &places, size_bound, between / smallest};
    whole_.cell[Variable::a] = root_.mode.a;
    whole_.cell[Variable::b] = root_.mode.b;
    put_poles();
    const bounding::Range window = root_.mode.usable(transmission);
    empty_ = root_.mode.a.empty() || root_.mode.b.empty();
    whole_.cell.far_cosine = std::cos(window.lower);
    whole_.cell.near_cosine = std::cos(window.upper);
    add_assignments(grounding);
    for (std::size_t i = 0; i < spec.obstacles.size(); ++i) {
      targets_.push_back(targets(i));
      const Box box = bounding_box(Region{{spec.obstacles[i].shape}});
      circles_.emplace_back(0.5 * (box.lower + box.upper), 0.5 * (box.upper - box.lower).norm());
    }
  }

  Node whole() const { return whole_; }

  /// Nothing if the cell is too narrow to cut.
  std::optional<Step> step(const Node& node) const {
    if (empty_) return Step{LengthsLeaf{}, {}};
    if (node.assignments.empty()) return Step{LayersLeaf{}, {}};
    const BestSum sum = best_sum(sums_, node.cell);
    if (sum.refutes) return Step{sum.leaf, {}};
    if (outside_pole(node.cell)) return Step{PoleLeaf{}, {}};
    if (const auto sheets = sheets_too_near(node.cell)) return Step{*sheets, {}};
    if (auto hit = by_obstacle(node)) return hit;
    if (auto cut = by_contact(node)) return cut;
    return split(node, sum);
  }

 private:
  void put_poles() {
    Box box;
    if (const auto* within = std::get_if<Region>(&spec_.pole.place))
      box = bounding_box(*within);
    else
      box = {std::get<Point>(spec_.pole.place), std::get<Point>(spec_.pole.place)};
    whole_.cell[Variable::x] = {box.lower.x(), box.upper.x()};
    whole_.cell[Variable::y] = {box.lower.y(), box.upper.y()};
  }

  void add_assignments(Grounding grounding) {
    const auto any = CopyingLinkage::make(spec_.copy.k(), grounding, 100, 100, number_);
    if (!any) return;
    for (const LayerAssignment& layers : layer_assignments(spec_.links.layers)) {
      whole_.assignments.push_back(static_cast<std::uint32_t>(layers_.size()));
      layers_.push_back(layers);
      filled_.emplace_back(*any, layers);
    }
  }

  bool outside_pole(const DesignCell& cell) const {
    const auto* within = std::get_if<Region>(&spec_.pole.place);
    if (within == nullptr || (cell.half(Variable::x) == 0 && cell.half(Variable::y) == 0)) return false;
    const double radius = std::hypot(cell.half(Variable::x), cell.half(Variable::y));
    return distance(*within, cell.pole()) > radius * (1 + in_hand) + in_hand;
  }

  /// The two places of the region that the copy brings nearest to each other, if that is too near all over the cell.
  std::optional<SheetsLeaf> sheets_too_near(const DesignCell& cell) const {
    if (!spec_.limits.sheets_gap) return std::nullopt;
    const Complex k = spec_.copy.k(), pole = as_complex(cell.pole());
    const double away = std::abs(1.0 - k) * std::hypot(cell.half(Variable::x), cell.half(Variable::y));
    const double room = *spec_.limits.sheets_gap * (1 - in_hand) - away - in_hand;
    if (!(room > 0)) return std::nullopt;
    for (const KnownPlace& place : places_.spread()) {
      const Complex from_pole = as_complex(place.at) - pole;
      const Point image = as_point(pole + k * from_pole), source = as_point(pole + from_pole / k);
      const KnownPlace near_image = places_.nearest(image), near_source = places_.nearest(source);
      if ((near_image.at - image).norm() < room) return SheetsLeaf{place.place, near_image.place};
      if (std::abs(k) * (near_source.at - source).norm() < room)
        return SheetsLeaf{near_source.place, place.place};
    }
    return std::nullopt;
  }

  // Obstacles

  /// How deep a place lies within reach `needed` of an obstacle's edge or, without one, of all of it; mm.
  double depth(const Point& at, std::size_t obstacle, const std::optional<std::size_t>& edge,
               double needed) const {
    const Ring& outline = spec_.obstacles[obstacle].shape.outer;
    const Complex point = as_complex(at);
    std::vector<Complex> corners;
    if (edge)
      corners = {as_complex(outline[*edge]), as_complex(outline[(*edge + 1) % outline.size()])};
    else
      for (const Point& corner : outline) corners.push_back(as_complex(corner));
    return needed - nearest_features({&point, 1}, corners).distance;
  }

  double needed(PartName part) const {
    return half_width(part_of(part), spec_.links.style) + spec_.limits.clearance;
  }

  bool hits(const ObstacleGuess& guess, const DesignCell& cell) const {
    const PartPoint& point = guess.leaf.point;
    const bounding::MaterialPoint at = material_point(point, root_.mode.s),
                                  pole = bounding::material_point(roles_of(root_.mode.grounding).pole,
                                                                  root_.mode.s);
    const auto range = point_over(root_, cell, guess.place, {at.of_a - pole.of_a, at.of_b - pole.of_b});
    if (!range) return false;
    constexpr double of_the_way =
        2;  // another order of the same operations may find the way this much longer
    return depth(range->middle, guess.leaf.obstacle, guess.leaf.edge, needed(point.part)) >
           of_the_way * range->away + in_hand;
  }

  /// Obstacles that are convex can be taken as a whole, others by their edges.
  std::vector<std::optional<std::size_t>> targets(std::size_t obstacle) const {
    const Ring& outline = spec_.obstacles[obstacle].shape.outer;
    if (convex_parts(spec_.obstacles[obstacle].shape).size() == 1) return {std::nullopt};
    std::vector<std::optional<std::size_t>> edges;
    for (std::size_t i = 0; i < outline.size(); ++i) edges.emplace_back(i);
    return edges;
  }

  Assignments sharing(const Assignments& all, PartName part, std::size_t obstacle) const {
    Assignments some;
    for (const std::uint32_t i : all)
      if (filled_[i].share(part, spec_.obstacles[obstacle])) some.push_back(i);
    return some;
  }

  /// A leaf for the assignments in which the part meets the obstacle; the others are left.
  std::optional<Step> leaf_for(const Node& node, const ObstacleGuess& guess) const {
    const PartName part = guess.leaf.point.part;
    const Assignments some = sharing(node.assignments, part, guess.leaf.obstacle);
    if (some.empty() || !hits(guess, node.cell)) return std::nullopt;
    if (some.size() == node.assignments.size()) return Step{guess.leaf, {}};
    return share_step(node, {part, guess.leaf.obstacle}, some, guess);
  }

  static Step share_step(const Node& node, const Share& line, const Assignments& some,
                         const std::optional<ObstacleGuess>& guess) {
    Node first{node.cell, some, guess}, second{node.cell, {}, std::nullopt};
    std::set_difference(node.assignments.begin(), node.assignments.end(), some.begin(), some.end(),
                        std::back_inserter(second.assignments));
    return {line, {std::move(first), std::move(second)}};
  }

  /// Joints of the middle design with the tracer at a place; nothing if it does not reach it.
  std::optional<std::array<Complex, 6>> joints_at(const DesignCell& cell, const Point& place) const {
    const double a = cell.middle(Variable::a), b = cell.middle(Variable::b);
    const Complex w = root_.g * (as_complex(place) - as_complex(cell.pole()));
    const double r = std::norm(w), rest = r - a * a - b * b, h2 = 4 * a * a * b * b - rest * rest;
    if (!(h2 > 0) || !(r > 0)) return std::nullopt;
    const Complex p = w * (r + a * a - b * b - Complex(0, root_.mode.bend * std::sqrt(h2))) / (2 * r);
    std::array<Complex, 6> at;
    const bounding::MaterialPoint pole =
        bounding::material_point(roles_of(root_.mode.grounding).pole, root_.mode.s);
    for (const Joint joint : all_joints) {
      const bounding::MaterialPoint m = bounding::material_point(joint, root_.mode.s);
      at[static_cast<std::size_t>(joint)] =
          as_complex(cell.pole()) + p * (m.of_a - pole.of_a) + (w - p) * (m.of_b - pole.of_b);
    }
    return at;
  }

  std::optional<Step> by_obstacle(const Node& node) const {
    if (spec_.obstacles.empty()) return std::nullopt;
    if (node.guess)
      if (auto step = leaf_for(node, *node.guess)) return step;
    if (!small_enough(node.cell)) return std::nullopt;
    std::optional<Step> best;
    for (const KnownPlace& place : places_.spread()) {
      const auto joints = joints_at(node.cell, place.at);
      if (!joints) continue;
      for (std::size_t obstacle = 0; obstacle < spec_.obstacles.size(); ++obstacle)
        for (std::uint8_t part = 0; part < part_count; ++part) {
          const auto guess = deepest(node, {part}, obstacle, place, *joints);
          if (!guess) continue;
          auto step = leaf_for(node, *guess);
          if (step && step->children.empty()) return step;
          if (step && !best) best = std::move(step);
        }
    }
    return best;
  }

  std::optional<ObstacleGuess> deepest(const Node& node, PartName part, std::size_t obstacle,
                                       const KnownPlace& place, const std::array<Complex, 6>& joints) const {
    const double need = needed(part);
    if (std::none_of(node.assignments.begin(), node.assignments.end(),
                     [&](std::uint32_t i) { return filled_[i].share(part, spec_.obstacles[obstacle]); }))
      return std::nullopt;
    ObstacleGuess best;
    double most = 0;
    const Complex V = joints[0], p = joints[1] - V, q = joints[4] - V - p;  // V, A, X: q/s = X - A
    for (const PartPoint& point : points_along(part, spec_.links.style.plate)) {
      const bounding::MaterialPoint m = material_point(point, root_.mode.s);
      const Point at = as_point(V + m.of_a * p + m.of_b * q);
      if (!(circle_depth(at, obstacle, need) > most)) continue;
      for (const auto& edge : targets_[obstacle])
        if (const double here = depth(at, obstacle, edge, need); here > most) {
          most = here;
          best = {{obstacle, edge, place.place, point}, place.at};
        }
    }
    if (most > 0) return best;
    return std::nullopt;
  }

  /// At least the depth: from a circle around the obstacle.
  double circle_depth(const Point& at, std::size_t obstacle, double need) const {
    return need + 2 * circles_[obstacle].second - (at - circles_[obstacle].first).norm();
  }

  // Contact of the linkage with itself

  bool small_enough(const DesignCell& cell) const {
    constexpr double share = 0.3;
    return cell.half(Variable::a) < share * cell.middle(Variable::a) &&
           cell.half(Variable::b) < share * cell.middle(Variable::b);
  }

  /// |psi| of the middle design at the farthest and the nearest place, within the window.
  bounding::Range passed(const DesignCell& cell) const {
    const double a = cell.middle(Variable::a), b = cell.middle(Variable::b);
    const auto psi = [&](const Point& place) {
      const double r = std::norm(root_.g) * (place - cell.pole()).squaredNorm();
      return std::acos(std::clamp((r - a * a - b * b) / (2 * a * b), -1.0, 1.0));
    };
    return {std::max(psi(places_.farthest(cell.pole()).at), std::acos(cell.far_cosine)),
            std::min(psi(places_.nearest(cell.pole()).at), std::acos(cell.near_cosine))};
  }

  /// The cut at |psi|, if its two nearest points are too near each other at all corners of the lengths.
  std::optional<ContactCut> cut_at(const ContactPair& pair, const DesignCell& cell, double psi) const {
    const double a = cell.middle(Variable::a), b = cell.middle(Variable::b);
    const LinkStyle& style = spec_.links.style;
    const auto nearest = bounding::nearest_points(pair, root_.mode.s, style, a, b, root_.mode.bend * psi);
    ContactCut cut{part_point(name_of(pair.first), nearest.first, root_.mode.s, style.plate),
                   part_point(name_of(pair.second), nearest.second, root_.mode.s, style.plate),
                   std::tan(psi / 2)};
    const auto one = material_point(cut.one, root_.mode.s), other = material_point(cut.other, root_.mode.s);
    const Complex turn = std::polar(1.0, root_.mode.bend * 2 * std::atan(cut.u));
    const double allowed = (nearest.needed + spec_.limits.clearance) * (1 - in_hand);
    for (const double corner_a : {cell[Variable::a].lower, cell[Variable::a].upper})
      for (const double corner_b : {cell[Variable::b].lower, cell[Variable::b].upper})
        if (!(std::abs((one.of_a - other.of_a) * corner_a + (one.of_b - other.of_b) * corner_b * turn) <
              allowed))
          return std::nullopt;
    return cut;
  }

  /// A cut with what is left on its two sides, and how many of them a sum refutes.
  struct SeenCut {
    ContactCut cut;
    std::array<DesignCell, 2> sides;
    int refuted = 0;
  };
  std::optional<SeenCut> seen_cut(const ContactPair& pair, const DesignCell& cell, double psi) const {
    const auto cut = cut_at(pair, cell, psi);
    if (!cut) return std::nullopt;
    SeenCut seen{*cut, {cell, cell}};
    const double cosine = (1 - cut->u * cut->u) / (1 + cut->u * cut->u);
    seen.sides[0].near_cosine = seen.sides[1].far_cosine = cosine;
    for (const DesignCell& side : seen.sides) seen.refuted += best_sum(sums_, side).refutes;
    return seen;
  }

  /// The last cut on the way from `from` to `to` that holds all over the cell, as all before it do: looked for in strides, then by
  /// halving.
  std::optional<SeenCut> farthest_cut(const ContactPair& pair, const DesignCell& cell, double from,
                                      double to) const {
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
  /// be found again and again where a smaller cell has a better one.
  static bool narrows(const SeenCut& cut, const DesignCell& cell, const bounding::Range& range) {
    const double width = std::max(cell.half(Variable::a) / cell.middle(Variable::a),
                                  cell.half(Variable::b) / cell.middle(Variable::b));
    const double psi = 2 * std::atan(cut.cut.u);
    const double least = std::min(1e-3, 0.1 * width) * (range.upper - range.lower);
    return psi > range.lower + least && psi < range.upper - least;
  }

  std::optional<SeenCut> best_cut(const ContactPair& pair, const DesignCell& cell, double deepest,
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

  std::optional<Step> by_contact(const Node& node) const {
    if (!small_enough(node.cell)) return std::nullopt;
    const bounding::Range range = passed(node.cell);
    if (range.empty()) return std::nullopt;
    const auto linkage = CopyingLinkage::make(
        spec_.copy.k(), root_.mode.grounding, node.cell.middle(Variable::a),
        node.cell.middle(Variable::b) * std::abs(root_.mode.s), number_, node.cell.pole());
    if (!linkage) return std::nullopt;
    const double one = branch_.opening_of(range.lower), other = branch_.opening_of(range.upper);
    const OpeningInterval openings{std::min(one, other), std::max(one, other)};
    int looked_at = 0;
    constexpr int most_looked_at = 6;
    for (const std::uint32_t i : node.assignments) {
      if (looked_at == most_looked_at) break;
      const Tightest tightest = smallest_gap_over(*linkage, spec_.links.style, layers_[i], openings);
      ++looked_at;
      if (!tightest.pair || tightest.gap >= spec_.limits.clearance) continue;
      const PartName first = name_of(tightest.pair->first), second = name_of(tightest.pair->second);
      if (!filled_[i].share(first, second)) continue;  // two posts: a sum's business
      const double psi = std::clamp(branch_.psi_of(tightest.opening), range.lower, range.upper);
      const auto cut = best_cut(*tightest.pair, node.cell, psi, range);
      if (!cut) continue;
      Assignments some;
      for (const std::uint32_t j : node.assignments)
        if (filled_[j].share(first, second)) some.push_back(j);
      if (some.size() < node.assignments.size()) return share_step(node, {first, second}, some, std::nullopt);
      return Step{
          cut->cut,
          {{cut->sides[0], node.assignments, node.guess}, {cut->sides[1], node.assignments, node.guess}}};
    }
    return std::nullopt;
  }

  // Cuts

  /// Share of a variable's size, or of the distances, below which nothing is cut: what is not refuted there is the design that the
  /// bound belongs to.
  static constexpr double narrowest = 1e-9;

  std::optional<Step> split(const Node& node, const BestSum& sum) const {
    std::array<double, 4> width{};
    const DesignCell& cell = node.cell;
    const double near = std::max(1e-3, (places_.nearest(cell.pole()).at - cell.pole()).norm());
    const double far = (places_.farthest(cell.pole()).at - cell.pole()).norm();
    for (const Variable variable : all_variables) {
      const auto i = static_cast<std::size_t>(variable);
      const bool is_length = variable == Variable::a || variable == Variable::b;
      const double relative = is_length ? 0.5 * std::log(cell[variable].upper / cell[variable].lower)
                                        : cell.half(variable) * (0.5 / near + 0.5 / far);
      if (relative < narrowest) continue;
      width[i] = sum.refutes_soon ? sum.share[i] + 1e-9 * relative : relative;
    }
    const auto widest =
        static_cast<std::size_t>(std::max_element(width.begin(), width.end()) - width.begin());
    if (width[widest] == 0) return std::nullopt;
    const auto variable = static_cast<Variable>(widest);
    const bounding::Range& range = cell[variable];
    const bool by_ratio = range.lower > 0 && range.upper > 2 * range.lower;
    const double at = by_ratio ? std::sqrt(range.lower * range.upper) : 0.5 * (range.lower + range.upper);
    Node lower = node, upper = node;
    lower.cell[variable].upper = at;
    upper.cell[variable].lower = at;
    return Step{Split{variable, at}, {std::move(lower), std::move(upper)}};
  }

  const Spec& spec_;
  const RegionPlaces& places_;
  int number_;
  bounding::Branch branch_;
  Root root_;
  SumTask sums_;
  Node whole_;
  bool empty_ = false;
  std::vector<LayerAssignment> layers_;
  std::vector<FilledLayers> filled_;
  std::vector<std::vector<std::optional<std::size_t>>> targets_;
  std::vector<std::pair<Point, double>> circles_;  // around the obstacles: centre and radius
};

}  // namespace

namespace {

/// Why a tree did not close.
enum class Open { too_tight, too_large };

tl::expected<void, Open> grow(const RootProof& proof, std::size_t most_lines, const StopFlag& stop,
                              std::vector<Line>& lines) {
  std::vector<Node> open{proof.whole()};
  while (!open.empty()) {
    if (lines.size() >= most_lines || stop()) return tl::unexpected(Open::too_large);
    const Node node = std::move(open.back());
    open.pop_back();
    auto step = proof.step(node);
    if (!step) return tl::unexpected(Open::too_tight);
    lines.push_back(std::move(step->line));
    std::move(step->children.rbegin(), step->children.rend(), std::back_inserter(open));
  }
  return {};
}

tl::expected<ProofLog, Open> log_of(const Spec& spec, Objective objective, const std::optional<double>& bound,
                                    const ProofOptions& options) {
  const bool by_size = objective == Objective::size;
  const double transmission =
      !by_size && bound ? std::max(spec.limits.transmission, *bound) : spec.limits.transmission;
  const RegionPlaces places(spec.region);
  ProofLog log{objective, bound, {}};
  for (const Grounding grounding : all_groundings) {
    const auto& permitted = spec.objective.groundings;
    if (std::find(permitted.begin(), permitted.end(), grounding) == permitted.end()) continue;
    const auto modes = static_cast<int>(assembly_modes(shape_of(spec.copy.k(), grounding)).size());
    for (int number = 0; number < modes; ++number) {
      const RootProof proof(spec, places, grounding, number, by_size ? bound : std::nullopt, transmission);
      if (const auto grown = grow(proof, options.lines, options.stop, log.lines); !grown)
        return tl::unexpected(grown.error());
    }
  }
  return log;
}

}  // namespace

std::optional<ProofLog> prove(const Spec& spec, Objective objective, const std::optional<double>& bound,
                              const ProofOptions& options) {
  if (objective != Objective::size && objective != Objective::transmission) return std::nullopt;
  if (spec.region.empty()) return std::nullopt;
  const double looser = is_maximized(objective) ? 1 : -1;
  for (const double share : {0.0, 1e-6, 1e-5, 1e-4}) {
    auto log = log_of(spec, objective, bound ? std::optional(*bound * (1 + looser * share)) : bound, options);
    if (log) return *std::move(log);
    if (!bound || log.error() == Open::too_large) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace kempe::certificate
