// The tree: the most promising box of designs is looked at first, split across its widest coordinate, and
// each half is shrunk by reach and length limits, bounded, and dropped if the sheets' gap or contact rules it
// out.

#include "synthesis/bound/proven_bound.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>
#include <set>

#include "geometry/region_reach.hpp"
#include "synthesis/bound/box.hpp"
#include "synthesis/bound/branch.hpp"
#include "synthesis/bound/contact.hpp"
#include "synthesis/bound/obstacles.hpp"
#include "synthesis/bound/sheets.hpp"
#include "synthesis/problem/local_frame.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe {
namespace {

using bounding::AssemblyMode;
using bounding::Branch;
using bounding::LengthBox;
using bounding::PoleDistances;
using bounding::Range;
using bounding::SheetsGap;

/// Two points of a linkage that came too near at an opening in some box: a cheap first test for the boxes
/// within it.
struct Cut {
  double psi = 0;
  bounding::MaterialPoint first, second;
  double needed = 0;
};
constexpr std::size_t kept_cuts = 4;

/// A box of designs of one branch.
struct Node {
  double bound = 0;  // smaller is more promising: size, or minus the transmission angle
  std::size_t number = 0;
  std::size_t branch = 0;
  Range x, y;
  bool sheets_apart = false;  // wherever the pole stands in the box
  PoleDistances distances;
  LengthBox lengths;
  bounding::LayerSet alive{};  // layer assignments not yet ruled out, by their place in the branch
  bounding::Sight sight;       // of the obstacles
  std::array<std::uint32_t, kept_cuts>
      cut{};  // of the first layer assignments: number in Tree::cuts_, 0 for none

  Point pole() const { return {0.5 * (x.lower + x.upper), 0.5 * (y.lower + y.upper)}; }
  bool pole_is_known() const { return x.lower == x.upper && y.lower == y.upper; }
};

struct LessPromising {
  bool operator()(const Node& one, const Node& other) const {
    return one.bound != other.bound ? one.bound > other.bound : one.number > other.number;
  }
};

/// Places are computed from coordinates to within this share of the largest: some 4500 units in the last place, for
/// formulas of a few dozen operations.
constexpr double rounding_share = 1e-12;

/// The largest distance of a corner from the frame's origin, mm.
double extent(const RegionReach& region) { return region.farthest(Point::Zero()).distance; }

class Tree {
 public:
  Tree(const Spec& spec, Objective objective, const BoundOptions& options, const Trials* trials = nullptr)
      : spec_(spec), options_(options), trials_(trials), by_size_(objective == Objective::size),
        region_(spec.region), sheets_(spec, region_) {
    if (const Region* area = std::get_if<Region>(&spec.pole.place)) area_.emplace(*area);
    place_rounding_ = rounding_share * std::max(extent(region_), area_ ? extent(*area_) : 0);
    constexpr std::size_t most_corners = 256;
    const std::size_t stride = 1 + (region_.hull().size() - 1) / most_corners;
    for (std::size_t i = 0; i < region_.hull().size(); i += stride) corners_.push_back(region_.hull()[i]);
    if (options.incumbent) best_ = by_size_ ? *options.incumbent : -*options.incumbent;
    // The posts stand on the table: pole, tracer and pen keep their distance from each other.
    const double between_posts = spec.links.style.pin_diameter + spec.limits.clearance;
    const double k = std::abs(spec.copy.k()), third = std::abs(1.0 - spec.copy.k());
    least_radius_ = options.self_contact ? between_posts / std::min({1.0, k, third}) * (1 - 1e-12) : 0;
  }

  /// Nothing if it was stopped before every grounding was looked at: then nothing is proven of the others.
  std::optional<ProvenBound> grow() {
    if (!plant()) return std::nullopt;
    grow_until(options_.tolerance);
    ProvenBound proven = proven_so_far();
    if (trials_ && proven.tight && best_ < infinity) {
      for (const auto& test : obstacle_tests_) test->demand_more(trials_->margin, trials_->places);
      grow_until(trials_->tolerance);
      proven.exhausted = is_closed(trials_->tolerance);
      // What the trials came to meanwhile is a design all the same.
      proven.value = by_size_ ? std::min(proven.value, best_) : std::max(proven.value, -best_);
    }
    return verdict(std::move(proven));
  }

 private:
  const AssemblyMode& assembly_mode(const Node& node) const { return branches_[node.branch].assembly_mode; }

  /// Bounds at least this good end the search.
  double enough(double tolerance) const {
    return best_ < infinity ? best_ - tolerance * std::abs(best_) : infinity;
  }
  bool is_closed(double tolerance) const { return open_.empty() || open_.top().bound >= enough(tolerance); }

  void grow_until(double tolerance) {
    while (!is_closed(tolerance) && boxes_ < options_.boxes && !options_.stop()) {
      Node node = open_.top();
      open_.pop();
      if (options_.self_contact && !rule_out_layers(node)) continue;
      if (!rule_out_by_obstacles(node, false)) continue;
      if (++opened_ <= 100 || opened_ % 8 == 0)
        try_designs(node);  // often at first, when the boxes are still many
      split(node);
    }
  }

  /// The transmission angle that designs of interest have at least.
  double transmission() const {
    return by_size_ ? spec_.limits.transmission : std::max(spec_.limits.transmission, -best_);
  }

  /// The roots of all groundings and assembly modes; false if it was stopped on the way.
  bool plant() {
    Range x, y;
    if (area_) {
      x = {area_->box().lower.x(), area_->box().upper.x()};
      y = {area_->box().lower.y(), area_->box().upper.y()};
    } else {
      const Point& at = std::get<Point>(spec_.pole.place);
      x = {at.x(), at.x()};
      y = {at.y(), at.y()};
    }
    for (const Grounding grounding : all_groundings) {
      const auto& permitted = spec_.objective.groundings;
      if (std::find(permitted.begin(), permitted.end(), grounding) == permitted.end()) continue;
      const auto layers = bounding::layer_choices(
          spec_.copy.k(), grounding, spec_.links.layers,
          sees_obstacles() ? spec_.obstacles : std::vector<Obstacle>{}, trials_ != nullptr);
      const std::size_t count = assembly_modes(shape_of(spec_.copy.k(), grounding)).size();
      for (std::size_t number = 0; number < count; ++number) {
        if (options_.stop()) return false;
        branches_.push_back(
            bounding::make_branch(spec_, grounding, static_cast<int>(number), layers, options_.shortest));
        if (sees_obstacles()) add_obstacle_test(branches_.back());
        const AssemblyMode& a = branches_.back().assembly_mode;
        if (a.a.empty() || a.b.empty() || a.allowed.empty()) continue;
        Node root;
        root.branch = branches_.size() - 1;
        root.x = x;
        root.y = y;
        root.lengths = {{a.b.lower / a.a.upper * 0.999, a.b.upper / a.a.lower * 1.001},
                        {2 * a.a.lower * a.b.lower * 0.999, 2 * a.a.upper * a.b.upper * 1.001}};
        root.alive = bounding::LayerSet::all(layers.size());
        if (measure_pole(root)) grow_from(root);
      }
    }
    return true;
  }

  /// Distances over the pole's places; false if the pole cannot stand in the box.
  bool measure_pole(Node& node) const {
    if (!measure_distances(node)) return false;
    if (node.sheets_apart) return true;
    const bounding::PoleDisc poles = bounding::disc_around(node.x, node.y);
    const SheetsGap::Verdict sheets = sheets_.verdict(poles.centre, poles.radius);
    node.sheets_apart = sheets == SheetsGap::Verdict::far_enough;
    return sheets != SheetsGap::Verdict::too_near;
  }

  /// The corner of the region that is farthest from the nearest point of the box to it.
  const Point& farthest_corner(const Range& x, const Range& y) const {
    const Point lower(x.lower, y.lower), upper(x.upper, y.upper);
    const auto apart = [&](const Point& corner) {
      return (corner - corner.cwiseMax(lower).cwiseMin(upper)).squaredNorm();
    };
    return *std::max_element(corners_.begin(), corners_.end(),
                             [&](const Point& less, const Point& more) { return apart(less) < apart(more); });
  }

  bool measure_distances(Node& node) const {
    const auto [centre, radius] = bounding::disc_around(node.x, node.y);
    if (area_ && area_->nearest(centre).distance > radius + place_rounding_) return false;
    const RegionReach::Nearest nearest = region_.nearest(centre);
    if (-nearest.distance > radius + place_rounding_)
      return false;  // inside the region wherever it stands: it would touch the tracer
    node.distances.nearest_at_most =
        bounding::distance_from_box(nearest.place, place_rounding_, node.x, node.y).upper;
    node.distances.farthest_at_least =
        bounding::distance_from_box(farthest_corner(node.x, node.y), place_rounding_, node.x, node.y).lower;
    if (node.distances.nearest_at_most < least_radius_) return false;
    const Point& farthest = farthest_corner({centre.x(), centre.x()}, {centre.y(), centre.y()});
    const bounding::Spread spread =
        bounding::spread_over(farthest, nearest.place, place_rounding_, node.x, node.y);
    node.distances.ratio_at_least = spread.ratio;
    node.distances.squares_at_least = spread.squares;
    return true;
  }

  /// Shrinks, bounds and keeps a box, or drops it.
  void grow_from(Node node) {
    ++boxes_;
    const AssemblyMode& a = assembly_mode(node);
    if (!bounding::contract(a, node.distances, transmission(), node.lengths)) return;
    if (by_size_ && !bounding::contract_by_size(a, best_, node.lengths)) return drop(node, best_);
    node.bound = bound_of(node);
    if (!by_size_ && -node.bound < spec_.limits.transmission) return;
    if (node.bound >= best_) return drop(node, best_);
    if (!repeat_cuts(node) || (node.sight.hit && !rule_out_by_obstacles(node, true))) return;
    node.number = boxes_;
    open_.push(node);
  }

  bool sees_obstacles() const { return options_.self_contact && !spec_.obstacles.empty(); }

  void add_obstacle_test(const Branch& branch) {
    std::vector<LayerAssignment> layers;
    for (const bounding::LayerChoice& choice : branch.layers) layers.push_back(choice.layers);
    obstacle_tests_.push_back(
        std::make_unique<bounding::ObstacleTest>(spec_, branch.assembly_mode, layers, options_.stop));
  }

  /// Drops layer assignments in which every design of the box has a part in an obstacle; false if none is left.
  bool rule_out_by_obstacles(Node& node, bool only_where_last) {
    if (!sees_obstacles()) return true;
    if (!only_where_last) boxes_ += obstacle_tests_[node.branch]->cost(node.sight);
    const bounding::PoleDisc poles = bounding::disc_around(node.x, node.y);
    node.alive = obstacle_tests_[node.branch]->not_hit({node.lengths, poles.centre, poles.radius}, node.alive,
                                                       node.sight, only_where_last);
    return !node.alive.empty();
  }

  double bound_of(const Node& node) const {
    return by_size_
               ? bounding::size_at_least(assembly_mode(node), node.distances, transmission(), node.lengths)
               : -bounding::transmission_at_most(assembly_mode(node), node.distances, node.lengths);
  }

  /// A box whose designs are no better than the best known: its grounding is not impossible.
  void drop(const Node& node, double bound) { note(assembly_mode(node).grounding, bound); }

  void note(Grounding grounding, double bound) {
    auto& noted = by_grounding_[static_cast<std::size_t>(grounding)];
    noted = noted ? std::min(*noted, bound) : bound;
  }

  bool is_cut(const Node& node, const Range& passed, const Cut& cut) const {
    if (cut.psi < passed.lower || cut.psi > passed.upper) return false;
    return bounding::always_nearer(assembly_mode(node), node.lengths, cut.psi, cut.first, cut.second,
                                   cut.needed);
  }

  /// Tests the contacts that the box was split from; false if no layer assignment is left.
  bool repeat_cuts(Node& node) const {
    if (std::all_of(node.cut.begin(), node.cut.end(), [](std::uint32_t cut) { return cut == 0; }))
      return true;
    const Range passed = bounding::passed_by_all(assembly_mode(node), node.distances, node.lengths);
    for (std::size_t i = 0; i < kept_cuts; ++i)
      if (node.alive.has(i) && node.cut[i] != 0 && is_cut(node, passed, cuts_[node.cut[i]]))
        node.alive.remove(i);
    return !node.alive.empty();
  }

  /// Drops every layer assignment in which the pair must keep its clearance.
  static void strike(Node& node, const Branch& branch, const bounding::PairKey& pair) {
    for (std::size_t i = 0; i < branch.layers.size(); ++i)
      if (branch.layers[i].has(pair)) node.alive.remove(i);
  }

  /// Drops layer assignments in which the linkage touches itself at an opening that every design of the box
  /// passes, and remembers where it does in others; false if none is left.
  bool rule_out_layers(Node& node) {
    const Branch& branch = branches_[node.branch];
    const Range passed = bounding::passed_by_all(branch.assembly_mode, node.distances, node.lengths);
    if (passed.empty()) return true;
    const double t = std::sqrt(node.lengths.t.lower * node.lengths.t.upper);
    const double w = std::sqrt(node.lengths.w.lower * node.lengths.w.upper);
    const double a = std::sqrt(w / t / 2), b = std::sqrt(w * t / 2);
    const auto linkage = linkage_of(branch, a, b, node.pole());
    if (!linkage) return true;
    const double one = branch.opening_of(passed.lower), other = branch.opening_of(passed.upper);
    const OpeningInterval openings{std::min(one, other), std::max(one, other)};
    std::vector<bool> looked_at(branch.layers.size(), false);
    for (std::size_t i = 0; i < branch.layers.size(); ++i) {
      if (!node.alive.has(i) || looked_at[branch.layers[i].like]) continue;
      if (options_.stop()) break;
      looked_at[branch.layers[i].like] = true;
      ++boxes_;
      const Tightest tightest =
          smallest_gap_over(*linkage, spec_.links.style, branch.layers[i].layers, openings);
      if (tightest.gap >= spec_.limits.clearance || !tightest.pair) continue;
      const double psi = std::clamp(branch.psi_of(tightest.opening), passed.lower, passed.upper);
      const auto points = bounding::nearest_points(*tightest.pair, branch.assembly_mode.s, spec_.links.style,
                                                   a, b, branch.assembly_mode.bend * psi);
      const Cut cut{psi, points.first, points.second, (points.needed + spec_.limits.clearance) * (1 - 1e-12)};
      if (is_cut(node, passed, cut)) {
        strike(node, branch, bounding::key_of(*tightest.pair));
      } else if (i < kept_cuts) {
        node.cut[i] = static_cast<std::uint32_t>(cuts_.size());
        cuts_.push_back(cut);
      }
    }
    return !node.alive.empty();
  }

  tl::expected<CopyingLinkage, LinkageFault> linkage_of(const Branch& branch, double a, double b,
                                                        const Point& pole) const {
    return CopyingLinkage::make(spec_.copy.k(), branch.assembly_mode.grounding, a,
                                b * std::abs(branch.assembly_mode.s), branch.assembly_mode.number, pole);
  }

  /// Designs of the relaxation in the box: its smallest by reach, and its middle.
  void try_designs(const Node& node) {
    if (area_ && !area_->contains(node.pole())) return;
    const DistanceRange range = region_.range(node.pole());
    const PoleDistances exact{range.nearest, range.farthest, 1,
                              range.farthest * range.farthest - range.nearest * range.nearest};
    const AssemblyMode& a = assembly_mode(node);
    LengthBox lengths = node.lengths;
    if (!(range.nearest > 0) || sheets_.verdict(node.pole(), 0) == SheetsGap::Verdict::too_near) return;
    if (!bounding::contract(a, exact, transmission(), lengths)) return;
    const double middle = std::sqrt(lengths.t.lower * lengths.t.upper);
    for (const double t :
         {lengths.t.lower, lengths.t.upper, std::clamp(1.0, lengths.t.lower, lengths.t.upper), middle}) {
      LengthBox line{{t, t}, lengths.w};
      if (options_.stop()) return;
      if (!bounding::contract(a, exact, transmission(), line)) continue;
      if (!by_size_) try_freest(node, exact, line, range);
      try_design(node, t, std::min(line.w.lower * (1 + 1e-12), line.w.upper), range);
      try_design(node, t, std::sqrt(line.w.lower * line.w.upper), range);
      try_design(node, t, line.w.upper, range);
    }
  }

  /// Of all lengths with one t, those with the largest transmission angle.
  void try_freest(const Node& node, const PoleDistances& exact, LengthBox line, const DistanceRange& range) {
    const double aim = bounding::transmission_at_most(assembly_mode(node), exact, line) - 1e-9;
    if (aim <= transmission() || !bounding::contract(assembly_mode(node), exact, aim, line)) return;
    try_design(node, line.t.lower, std::sqrt(line.w.lower * line.w.upper), range);
  }

  void try_design(const Node& node, double t, double w, const DistanceRange& range) {
    const Branch& branch = branches_[node.branch];
    const auto linkage = linkage_of(branch, std::sqrt(w / t / 2), std::sqrt(w * t / 2), node.pole());
    if (!linkage) return;
    const auto near = linkage->opening_at(range.nearest), far = linkage->opening_at(range.farthest);
    if (!near || !far) return;
    const double transmission =
        std::min(linkage->transmission_angle(*near), linkage->transmission_angle(*far));
    if (transmission < spec_.limits.transmission - 1e-9) return;
    const double value = by_size_ ? linkage->size() : -transmission;
    if (value >= (trials_ ? enough(trials_->tolerance) : best_)) return;
    const OpeningInterval openings{std::min(*near, *far), std::max(*near, *far)};
    if (spec_.limits.copy_error && spec_.tolerance) {
      const CopyErrorProfile profile = copy_error_profile(*linkage, CopyTolerance::uniform(*spec_.tolerance));
      if (profile.largest(openings).worst.worst > *spec_.limits.copy_error) return;
    }
    const auto free = [&](const bounding::LayerChoice& choice) {
      return !options_.self_contact ||
             (smallest_gap_over(*linkage, spec_.links.style, choice.layers, openings).gap >=
                  spec_.limits.clearance &&
              (!sees_obstacles() ||
               obstacle_tests_[node.branch]->is_clear(
                   linkage->VA(), linkage->VB(), node.pole(),
                   static_cast<std::size_t>(&choice - branch.layers.data()), node.sight.hit)));
    };
    const auto layers = std::find_if(branch.layers.begin(), branch.layers.end(), free);
    if (layers == branch.layers.end()) return;
    const RelaxedDesign design{linkage->grounding(), linkage->assembly_mode(),
                               linkage->VA(),        linkage->VB(),
                               node.pole(),          layers->layers};
    if (trials_)
      return try_out(node.branch, static_cast<std::size_t>(layers - branch.layers.begin()), design);
    design_ = design;
    best_ = value;
  }

  /// Tries a design out in the search: what it leads to is known, and where it fails is looked at from now on.
  void try_out(std::size_t branch, std::size_t layers, const RelaxedDesign& design) {
    if (tried_out_ >= trials_->most) return;
    ++tried_out_;
    const Trial trial = trials_->run(design);
    if (trial.best) best_ = std::min(best_, by_size_ ? *trial.best : -*trial.best);
    if (sees_obstacles())
      for (const Point& place : trial.in_the_way) obstacle_tests_[branch]->add_place(place, layers);
  }

  /// A box whose bound would not rise if the pole were known is split across its lengths first.
  double pole_weight(const Node& node) const {
    constexpr double idle = 0.1;
    Node fixed = node;
    fixed.x.lower = fixed.x.upper = node.pole().x();
    fixed.y.lower = fixed.y.upper = node.pole().y();
    if (node.pole_is_known() || !measure_distances(fixed)) return 1;
    if (!bounding::contract(assembly_mode(node), fixed.distances, transmission(), fixed.lengths)) return 1;
    return bound_of(fixed) > node.bound ? 1 : idle;
  }

  void split(const Node& node) {
    const double t_width = 0.5 * std::log(node.lengths.t.upper / node.lengths.t.lower);
    const double w_width = 0.5 * std::log(node.lengths.w.upper / node.lengths.w.lower);
    const double per_mm = (0.5 / std::max(node.distances.farthest_at_least, 1e-300) +
                           0.5 / std::max(node.distances.nearest_at_most, 1e-300)) *
                          pole_weight(node);
    const double x_width = (node.x.upper - node.x.lower) * per_mm,
                 y_width = (node.y.upper - node.y.lower) * per_mm;
    const double widest = std::max({t_width, w_width, x_width, y_width});
    const auto halve = [&](auto part, double middle) {
      Node lower = node, upper = node;
      part(lower).upper = middle;
      part(upper).lower = middle;
      for (Node* half : {&lower, &upper})
        if (widest == t_width || widest == w_width || measure_pole(*half)) grow_from(*half);
    };
    if (widest == t_width)
      return halve([](Node& n) -> Range& { return n.lengths.t; },
                   std::sqrt(node.lengths.t.lower * node.lengths.t.upper));
    if (widest == w_width)
      return halve([](Node& n) -> Range& { return n.lengths.w; },
                   std::sqrt(node.lengths.w.lower * node.lengths.w.upper));
    if (widest == x_width)
      return halve([](Node& n) -> Range& { return n.x; }, 0.5 * (node.x.lower + node.x.upper));
    halve([](Node& n) -> Range& { return n.y; }, 0.5 * (node.y.lower + node.y.upper));
  }

  std::optional<RelaxedDesign> middle_of(const Node& node) const {
    const Branch& branch = branches_[node.branch];
    const double t = std::sqrt(node.lengths.t.lower * node.lengths.t.upper);
    const double w = std::sqrt(node.lengths.w.lower * node.lengths.w.upper);
    const auto linkage = linkage_of(branch, std::sqrt(w / t / 2), std::sqrt(w * t / 2), node.pole());
    if (!linkage) return std::nullopt;
    return RelaxedDesign{
        linkage->grounding(), linkage->assembly_mode(), linkage->VA(), linkage->VB(), node.pole(), {}};
  }

  ProvenBound proven_so_far() const {
    ProvenBound result;
    const double bound = open_.empty() ? best_ : std::min(best_, open_.top().bound);
    result.no_design = open_.empty() && !(best_ < infinity);
    result.tight = is_closed(options_.tolerance);
    if (!result.no_design) result.value = by_size_ ? bound : -bound;
    return result;
  }

  ProvenBound verdict(ProvenBound result) {
    result.boxes = boxes_;
    if (best_ < infinity) result.relaxation = by_size_ ? best_ : -best_;
    result.design = design_;
    std::set<std::size_t> promising;
    for (; !open_.empty(); open_.pop()) {
      const Node& node = open_.top();
      note(assembly_mode(node).grounding, node.bound);
      if (result.tight || !promising.insert(node.branch).second) continue;
      if (const auto middle = middle_of(node)) result.promising.push_back(*middle);
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (by_grounding_[i]) result.by_grounding[i] = by_size_ ? *by_grounding_[i] : -*by_grounding_[i];
    return result;
  }

  const Spec& spec_;
  const BoundOptions& options_;
  const Trials* trials_;  // absent: designs of the relaxation are as good as any
  int tried_out_ = 0;
  bool by_size_;
  RegionReach region_;
  std::optional<RegionReach> area_;
  std::vector<Point> corners_;  // of the region's hull, so many as are worth looking at
  SheetsGap sheets_;
  std::vector<Branch> branches_;
  std::vector<std::unique_ptr<bounding::ObstacleTest>>
      obstacle_tests_;            // one a branch, if there are obstacles
  std::vector<Cut> cuts_{Cut{}};  // number 0 stands for none
  std::priority_queue<Node, std::vector<Node>, LessPromising> open_;
  double best_ = infinity;  // of the relaxation's designs met, or the incumbent; as in Node::bound
  std::optional<RelaxedDesign> design_;
  double least_radius_ = 0;
  double place_rounding_ = 0;  // mm: how far places of region and pole may be off
  std::array<std::optional<double>, 3> by_grounding_;
  std::size_t boxes_ = 0, opened_ = 0;
};

std::optional<ProvenBound> back_to_the_table(std::optional<ProvenBound> bound, const Point& origin) {
  if (!bound) return bound;
  if (bound->design) bound->design->pole += origin;
  for (RelaxedDesign& place : bound->promising) place.pole += origin;
  return bound;
}

}  // namespace

std::optional<ProvenBound> proven_bound(const Spec& spec, Objective objective, const BoundOptions& options) {
  if (objective != Objective::size && objective != Objective::transmission) return std::nullopt;
  if (spec.region.empty()) return std::nullopt;
  const Point origin = local_origin(spec);
  if (origin.isZero(0)) return Tree(spec, objective, options).grow();
  const Spec here = shifted(spec, -origin);
  return back_to_the_table(Tree(here, objective, options).grow(), origin);
}

std::optional<ProvenBound> searched_by_tree(const Spec& spec, Objective objective,
                                            const BoundOptions& options, const Trials& trials) {
  if (objective != Objective::size && objective != Objective::transmission) return std::nullopt;
  if (spec.region.empty()) return std::nullopt;
  return Tree(spec, objective, options, &trials).grow();
}

std::vector<RelaxedDesign> starts_of(const ProvenBound& bound) {
  std::vector<RelaxedDesign> starts = bound.promising;
  if (bound.design) starts.insert(starts.begin(), *bound.design);
  return starts;
}

std::optional<ProvenBound> proven_bound(const Spec& spec, const BoundOptions& options) {
  return proven_bound(spec, spec.objective.objective, options);
}

}  // namespace kempe
