// A node is refuted by a sum of requirements, by the pole's place or the gap between original and copy if that is possible; else an
// obstacle (obstacle_leaf.hpp) or a contact of the linkage with itself (contact_cut.hpp) is sought that rules out part of it; else
// its widest variable is cut.

#include "synthesis/certificate/proof_tree.hpp"

#include <algorithm>
#include <cmath>
#include <tl/expected.hpp>

#include "synthesis/certificate/contact_cut.hpp"
#include "synthesis/certificate/obstacle_leaf.hpp"

namespace kempe::certificate {
namespace {

RootTask root_task(const Spec& spec, const RegionPlaces& places, Grounding grounding, int number) {
  RootTask task{spec, places, number, bounding::make_branch(spec, grounding, number, {})};
  task.root.mode = task.branch.assembly_mode;
  task.root.mode.allowed = {0, 4};  // rad, all: the limit on the copy error has no rule
  const Complex k = spec.copy.k();
  task.root.g = grounding == Grounding::pole ? Complex(1) : grounding == Grounding::tracer ? Complex(-1) : -k;
  const auto any = CopyingLinkage::make(k, grounding, 100, 100, number);
  if (!any) return task;
  for (const LayerAssignment& layers : layer_assignments(spec.links.layers)) {
    task.layers.push_back(layers);
    task.filled.emplace_back(*any, layers);
  }
  return task;
}

/// One grounding and assembly mode.
class RootProof {
 public:
  RootProof(const Spec& spec, const RegionPlaces& places, Grounding grounding, int number,
            const std::optional<double>& size_bound, double transmission)
      : task_(root_task(spec, places, grounding, number)), obstacles_(task_), contact_(task_) {
    const double between = spec.links.style.pin_diameter + spec.limits.clearance;
    const Complex s = task_.root.mode.s;
    const double smallest = std::abs(task_.root.g) * std::min({1.0, std::abs(s), std::abs(1.0 - s)});
    task_.sums = {&task_.root, &places, size_bound, between / smallest};
    put_whole(task_.root.mode.usable(transmission));
  }
  RootProof(const RootProof&) = delete;  // its members keep references to the task
  RootProof& operator=(const RootProof&) = delete;

  Node whole() const { return whole_; }

  /// Nothing if the cell is too narrow to cut.
  std::optional<Step> step(const Node& node) const {
    if (task_.root.mode.a.empty() || task_.root.mode.b.empty()) return Step{LengthsLeaf{}, {}};
    if (node.assignments.empty()) return Step{LayersLeaf{}, {}};
    const BestSum sum = best_sum(task_.sums, node.cell);
    if (sum.refutes) return Step{sum.leaf, {}};
    if (outside_pole(node.cell)) return Step{PoleLeaf{}, {}};
    if (const auto sheets = sheets_too_near(node.cell)) return Step{*sheets, {}};
    if (auto hit = obstacles_.step(node)) return hit;
    if (auto cut = contact_.step(node)) return cut;
    return split(node, sum);
  }

 private:
  void put_whole(const bounding::Range& window) {
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

  bool outside_pole(const DesignCell& cell) const {
    const auto* within = std::get_if<Region>(&task_.spec.pole.place);
    if (within == nullptr || (cell.half(Variable::x) == 0 && cell.half(Variable::y) == 0)) return false;
    const double radius = std::hypot(cell.half(Variable::x), cell.half(Variable::y));
    return distance(*within, cell.pole()) > radius * (1 + in_hand) + in_hand;
  }

  /// The two places of the region that the copy brings nearest to each other, if that is too near all over the cell.
  std::optional<SheetsLeaf> sheets_too_near(const DesignCell& cell) const {
    if (!task_.spec.limits.sheets_gap) return std::nullopt;
    const Complex k = task_.spec.copy.k(), pole = as_complex(cell.pole());
    const double away = std::abs(1.0 - k) * std::hypot(cell.half(Variable::x), cell.half(Variable::y));
    const double room = *task_.spec.limits.sheets_gap * (1 - in_hand) - away - in_hand;
    if (!(room > 0)) return std::nullopt;
    for (const KnownPlace& place : task_.places.spread()) {
      const Complex from_pole = as_complex(place.at) - pole;
      const Point image = as_point(pole + k * from_pole), source = as_point(pole + from_pole / k);
      const KnownPlace near_image = task_.places.nearest(image), near_source = task_.places.nearest(source);
      if ((near_image.at - image).norm() < room) return SheetsLeaf{place.place, near_image.place};
      if (std::abs(k) * (near_source.at - source).norm() < room)
        return SheetsLeaf{near_source.place, place.place};
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
    const double near = std::max(1e-3, (task_.places.nearest(cell.pole()).at - cell.pole()).norm());
    const double far = (task_.places.farthest(cell.pole()).at - cell.pole()).norm();
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

  RootTask task_;
  ObstacleLeaves obstacles_;
  ContactCuts contact_;
  Node whole_;
};

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
