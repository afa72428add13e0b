// A node is refuted by a sum of requirements, by the pole's place or the gap between original and copy if that is possible; else an
// obstacle (obstacle_leaf.hpp) or a contact of the linkage with itself (contact_cut.hpp) is sought that rules out part of it; else
// its widest variable is cut.

#include "synthesis/certificate/proof_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "synthesis/certificate/contact_cut.hpp"
#include "synthesis/certificate/obstacle_leaf.hpp"
#include "workspace/obstructions.hpp"

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

/// One grounding and assembly mode.
class RootProof {
 public:
  RootProof(const Spec& spec, const RegionPlaces& places, Grounding grounding, const AssemblyMode& mode,
            const std::optional<double>& size_bound, double transmission)
      : task_(root_task(spec, places, grounding, mode)), obstacles_(task_), contact_(task_) {
    const double between = spec.links.style.pin_diameter + spec.limits.clearance;
    const Complex s = task_.root.mode.s;
    const double smallest = std::abs(task_.root.g) * std::min({1.0, std::abs(s), std::abs(1.0 - s)});
    task_.sums = {&task_.root, &places, size_bound, between / smallest};
    put_whole(transmission);
  }
  RootProof(const RootProof&) = delete;  // its members keep references to the task
  RootProof& operator=(const RootProof&) = delete;

  Node whole() const { return whole_; }
  bool bounds_size() const { return task_.sums.size_bound.has_value(); }
  void bound_size(const std::optional<double>& bound) { task_.sums.size_bound = bound; }
  bool refuted_by_sum(const DesignCell& cell) const { return best_sum(task_.sums, cell).refutes; }

  /// Nothing if the cell is too narrow to cut.
  std::optional<Step> step(const Node& node) const {
    if (task_.root.mode.a.empty() || task_.root.mode.b.empty()) return Step{LengthsLeaf{}, {}};
    if (node.assignments.empty()) return Step{LayersLeaf{}, {}};
    const BestSum sum = best_sum(task_.sums, node.cell);
    if (sum.refutes) return Step{sum.leaf, {}};
    if (auto cut = copy_error_step(node)) return cut;
    if (outside_pole(node.cell)) return Step{PoleLeaf{}, {}};
    if (const auto sheets = copy_too_near(node.cell)) return Step{*sheets, {}};
    if (auto hit = obstacles_.step(node)) return hit;
    if (auto cut = contact_.step(node)) return cut;
    return split(node, sum);
  }

 private:
  void put_whole(double transmission) {
    bounding::ModeFacts& mode = task_.root.mode;
    kept_ = mode.allowed;
    mode.allowed = {0, 4};  // rad, all: what the copy error leaves is a step of the log
    const bounding::Range window = mode.usable(transmission);
    Box poles;
    if (const auto* within = std::get_if<Region>(&task_.spec.pole.place))
      poles = bounding_box(*within);
    else
      poles = {std::get<Point>(task_.spec.pole.place), std::get<Point>(task_.spec.pole.place)};
    whole_.cell[Variable::a] = task_.root.mode.a;
    whole_.cell[Variable::b] = task_.root.mode.b;
    whole_.cell[Variable::x] = {poles.lower.x(), poles.upper.x()};
    whole_.cell[Variable::y] = {poles.lower.y(), poles.upper.y()};
    whole_.cell.far_cosine = std::cos(window.lower);
    whole_.cell.near_cosine = std::cos(window.upper);
    for (std::size_t i = 0; i < task_.layers.size(); ++i)
      whole_.assignments.push_back(static_cast<std::uint32_t>(i));
  }

  /// The window without the openings that exceed the limit on the copy error, if there are such.
  std::optional<Step> copy_error_step(const Node& node) const {
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

  bool outside_pole(const DesignCell& cell) const {
    const auto* within = std::get_if<Region>(&task_.spec.pole.place);
    if (within == nullptr || (cell.half(Variable::x) == 0 && cell.half(Variable::y) == 0)) return false;
    const double radius = std::hypot(cell.half(Variable::x), cell.half(Variable::y));
    return distance(*within, cell.pole()) > radius * (1 + slack::in_hand) + slack::in_hand;
  }

  /// The two places of the region that the copy brings nearest to each other, if that is too near all over the cell.
  std::optional<CopyGapLeaf> copy_too_near(const DesignCell& cell) const {
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

  // Cuts

  /// The variable that adds most to what the sum lacks, unless another is left much wider: obstacles and contacts, of which the
  /// sum knows nothing, rule out no cell that is wide in any variable. Nothing if the cell is too narrow in all of them.
  std::optional<Variable> variable_to_cut(const DesignCell& cell, const BestSum& sum) const {
    std::array<double, 4> width{}, wanted{};
    const double near = std::max(1e-3, (task_.places.nearest(cell.pole()).at - cell.pole()).norm());
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
    std::size_t chosen = largest(wanted);
    if (width[widest] > slack::most_uneven * width[chosen]) chosen = widest;
    if (width[chosen] == 0) return std::nullopt;
    return static_cast<Variable>(chosen);
  }

  std::optional<Step> split(const Node& node, const BestSum& sum) const {
    const std::optional<Variable> cut = variable_to_cut(node.cell, sum);
    if (!cut) return std::nullopt;
    const Variable variable = *cut;
    const bounding::Range& range = node.cell[variable];
    const bool by_ratio = range.lower > 0 && range.upper > 2 * range.lower;
    const double at = by_ratio ? std::sqrt(range.lower * range.upper) : 0.5 * (range.lower + range.upper);
    Node lower = node, upper = node;
    lower.cell[variable].upper = at;
    upper.cell[variable].lower = at;
    return Step{Split{variable, at}, {std::move(lower), std::move(upper)}};
  }

  RootTask task_;
  bounding::Range kept_;  ///< |psi| that the limit on the copy error leaves, rad
  ObstacleLeaves obstacles_;
  ContactCuts contact_;
  Node whole_;
};

/// The bound that a tree is grown for. Where no box of doubles is small enough for it, it is made looser.
class Loosening {
 public:
  Loosening(Objective objective, const std::optional<double>& bound)
      : given_(bound), direction_(is_maximized(objective) ? 1 : -1) {}

  std::optional<double> bound() const {
    return given_ ? std::optional(*given_ * (1 + direction_ * slack::given_way[step_])) : std::nullopt;
  }
  double given_way() const { return slack::given_way[step_]; }
  bool loosen() {
    if (!given_ || step_ + 1 == std::size(slack::given_way)) return false;
    ++step_;
    return true;
  }

 private:
  std::optional<double> given_;
  double direction_;
  std::size_t step_ = 0;
};

/// One root's tree, depth first. A bound of size stands in sums only, and what refutes a node with one refutes it with a looser one,
/// too: where no box is small enough, the tree goes on with the looser one from the largest box that this refutes.
class Growth {
 public:
  Growth(RootProof& proof, Loosening& bound, std::vector<Line>& lines)
      : proof_(proof), bound_(bound), lines_(lines) {
    open_.push_back({proof.whole(), 0});
  }

  tl::expected<void, NoLog> run(std::size_t most_lines, const StopFlag& stop) {
    while (!open_.empty()) {
      if (stop()) return tl::unexpected(NoLog::stopped);
      if (lines_.size() >= most_lines) return tl::unexpected(NoLog::too_long);
      const std::size_t depth = open_.back().depth;
      Node node = std::move(open_.back().node);
      open_.pop_back();
      path_.resize(depth);
      auto step = proof_.step(node);
      path_.push_back({std::move(node), lines_.size(), open_.size()});
      if (!step) {
        if (!go_back()) return tl::unexpected(NoLog::too_tight);
        continue;
      }
      lines_.push_back(std::move(step->line));
      for (auto child = step->children.rbegin(); child != step->children.rend(); ++child)
        open_.push_back({std::move(*child), depth + 1});
    }
    return {};
  }

 private:
  struct Waiting {
    Node node;
    std::size_t depth = 0;
  };
  /// A node on the way down, and what there was when it was come to.
  struct Visit {
    Node node;
    std::size_t lines = 0, open = 0;
  };

  /// Loosens the bound until it refutes a node on the way down; false if none does.
  bool go_back() {
    while (proof_.bounds_size() && bound_.loosen()) {
      proof_.bound_size(bound_.bound());
      const auto refuted = std::find_if(path_.begin(), path_.end(), [&](const Visit& visit) {
        return proof_.refuted_by_sum(visit.node.cell);
      });
      if (refuted == path_.end()) continue;
      lines_.resize(refuted->lines);
      open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(refuted->open), open_.end());
      open_.push_back({refuted->node, static_cast<std::size_t>(refuted - path_.begin())});
      return true;
    }
    return false;
  }

  RootProof& proof_;
  Loosening& bound_;
  std::vector<Line>& lines_;
  std::vector<Waiting> open_;
  std::vector<Visit> path_;
};

bool bodies_may_meet_things(const Spec& spec) {
  const std::vector<Obstruction> all = obstructions_of(spec.obstacles, spec.bodies, spec.table);
  return std::any_of(all.begin(), all.end(), [](const Obstruction& one) { return one.met.has_value(); });
}

tl::expected<ProofLog, NoLog> log_of(const Spec& spec, Objective objective, Loosening& bound,
                                     const ProofOptions& options) {
  const bool by_size = objective == Objective::size;
  const double transmission =
      by_size ? spec.limits.transmission : std::max(spec.limits.transmission, bound.bound().value_or(0));
  const RegionPlaces places(spec.region);
  ProofLog log{objective, std::nullopt, {}};
  for (const Grounding grounding : all_groundings) {
    const auto& permitted = spec.objective.groundings;
    if (std::find(permitted.begin(), permitted.end(), grounding) == permitted.end()) continue;
    for (const AssemblyMode& mode : assembly_modes(shape_of(spec.copy.k(), grounding))) {
      RootProof proof(spec, places, grounding, mode, by_size ? bound.bound() : std::nullopt, transmission);
      if (const auto grown = Growth(proof, bound, log.lines).run(options.lines, options.stop); !grown)
        return tl::unexpected(grown.error());
    }
  }
  log.bound = bound.bound();
  return log;
}

}  // namespace

std::string reason(NoLog why, const ProofOptions& options) {
  switch (why) {
    case NoLog::too_long: return fmt::format("its proof takes more than {} lines", options.lines);
    case NoLog::stopped: return "its proof did not close before the time was over";
    case NoLog::too_tight:
      return "some linkages are so near to what is forbidden that no box of doubles parts them from it";
    case NoLog::bodies:
      return "its rules do not say where a body meets an obstacle, the table's edge or another body";
    case NoLog::no_rules: break;
  }
  return "only size and transmission have rules";
}

tl::expected<ProofLog, NoLog> prove(const Spec& spec, Objective objective, const std::optional<double>& bound,
                                    const ProofOptions& options) {
  if ((objective != Objective::size && objective != Objective::transmission) || spec.region.empty())
    return tl::unexpected(NoLog::no_rules);
  Loosening loosening(objective, bound);
  while (true) {
    auto log = log_of(spec, objective, loosening, options);
    if (log) return log;
    const NoLog why = log.error();
    if (why == NoLog::stopped || !loosening.loosen())
      return tl::unexpected(why != NoLog::stopped && bodies_may_meet_things(spec) ? NoLog::bodies : why);
    while (why == NoLog::too_long && loosening.given_way() < slack::much_shorter) loosening.loosen();
  }
}

}  // namespace kempe::certificate
