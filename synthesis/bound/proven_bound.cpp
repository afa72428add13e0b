// The tree: the most promising box of designs is looked at first, split across its widest coordinate, and
// each half is shrunk by reach and length limits, bounded, and dropped if the gap between original and copy
// (pole_places.hpp), contact (met_contacts.hpp, obstacles.hpp) or, where asked for, the limit on the load
// error (load_floor.hpp, load_trade.hpp) rules it out. Designs met on the way (relaxed_designs.hpp) say how good a box must
// be.

#include "synthesis/bound/proven_bound.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>
#include <set>

#include "kinematics/parallel.hpp"
#include "synthesis/bound/layer_trade.hpp"
#include "synthesis/bound/load_floor.hpp"
#include "synthesis/bound/load_trade.hpp"
#include "synthesis/bound/met_contacts.hpp"
#include "synthesis/bound/relaxed_designs.hpp"
#include "synthesis/problem/local_frame.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

using bounding::Branch;
using bounding::ModeFacts;
using bounding::Range;
using bounding::TreeNode;

/// What trees over the same designs share.
struct Shared {
  Shared(const Spec& spec, const BoundOptions& options)
      : poles(spec, options.self_contact), cuts(spec, options.stop) {}

  bounding::PolePlaces poles;
  bounding::MetContacts cuts;
  std::vector<Branch> branches{};
  std::vector<std::unique_ptr<bounding::ObstacleTest>>
      obstacle_tests{};  ///< one a branch, if there are obstacles
};

class Tree {
 public:
  Tree(const Spec& spec, Objective objective, const BoundOptions& options, const Trials* trials = nullptr)
      : Tree(spec, objective, options, trials, std::make_shared<Shared>(spec, options)) {}

  /// Nothing if it was stopped before every grounding was looked at: then nothing is proven of the others.
  std::optional<ProvenBound> grow() {
    if (!plant()) return std::nullopt;
    const double first = trials_ ? std::max(options_.tolerance, trials_->tolerance) : options_.tolerance;
    grow_until(first);
    if (trials_ && first > options_.tolerance) leap_to_what_is_left();
    ProvenBound proven = proven_so_far(first);
    if (trials_ && proven.tight && designs_.best() < infinity) {
      if (sees_loads()) proven.without_load_limit = grown_without_load_limit();
      if (trials_->tolerance < first) {
        for (const auto& test : shared_->obstacle_tests) test->demand_more(trials_->margin, trials_->places);
        grow_until(trials_->tolerance);
      }
      proven.exhausted = is_closed(trials_->tolerance);
      // What the trials came to meanwhile is a design all the same.
      proven.value =
          by_size_ ? std::min(proven.value, designs_.best()) : std::max(proven.value, -designs_.best());
    }
    return verdict(std::move(proven));
  }

 private:
  Tree(const Spec& spec, Objective objective, const BoundOptions& options, const Trials* trials,
       std::shared_ptr<Shared> shared)
      : spec_(spec), options_(options), trials_(trials), objective_(objective),
        by_size_(objective == Objective::size), shared_(std::move(shared)),
        designs_(spec, by_size_, options, trials, shared_->poles) {}

  /// The bound of designs that need not keep the limit on the load error: another tree goes on with the boxes that only this limit rules
  /// out or makes less promising. Nothing if it was stopped.
  std::optional<double> grown_without_load_limit() {
    BoundOptions options = options_;
    options.incumbent = by_size_ ? designs_.best() : -designs_.best();
    options.share_of_gap = trials_->share_of_load_limit;
    options.boxes = BoundOptions{}.boxes;
    options.load_limit = false;
    options.progress = {};
    Tree tree(spec_, objective_, options, nullptr, shared_);
    tree.value_near_ = trials_->without_load_limit;
    for (auto open = open_; !open.empty(); open.pop()) tree.open_without_loads(open.top());
    for (const TreeNode& node : left_to_loads_) tree.open_without_loads(node);
    tree.grow_until(options.tolerance);
    if (options_.stop()) return std::nullopt;
    return tree.proven_so_far(options.tolerance).value;
  }

  void open_without_loads(TreeNode node) {
    node.bound = node.without_loads;
    if (node.bound < designs_.best()) open_.push(std::move(node));
  }

  const Branch& branch_of(const TreeNode& node) const { return shared_->branches[node.branch]; }
  const ModeFacts& mode_of(const TreeNode& node) const { return branch_of(node).mode; }
  bounding::ObstacleTest* obstacles_of(const TreeNode& node) const {
    return sees_obstacles() ? shared_->obstacle_tests[node.branch].get() : nullptr;
  }

  const bounding::LoadFloor* loads_of(const TreeNode& node) const {
    return load_floors_.empty() ? nullptr : &load_floors_[node.branch];
  }

  bool is_closed(double tolerance) const {
    return open_.empty() || open_.top().bound >= designs_.enough(tolerance);
  }

  /// By how far a box may be better than the best design known, as a share of it.
  double gap() const {
    const double best = designs_.best();
    return best < infinity && !open_.empty() ? std::abs((best - open_.top().bound) / best) : infinity;
  }

  /// The gap closes by halves, so its logarithm tells how far the tree has come; where no design is known, the boxes do.
  void tell_progress(double tolerance) {
    if (!options_.progress) return;
    const double here = gap(), of_boxes = static_cast<double>(boxes_) / static_cast<double>(options_.boxes);
    if (here < infinity) widest_gap_ = std::max(widest_gap_, here);
    const double of_gap = here < infinity && widest_gap_ > tolerance && here > 0
                              ? std::log(widest_gap_ / here) / std::log(widest_gap_ / tolerance)
                              : 0;
    told_ = std::clamp(std::max(of_boxes, of_gap), told_, 1.0);
    options_.progress(told_);
  }

  void grow_until(double tolerance) {
    tolerance_ = tolerance;
    while (!is_closed(tolerance) && boxes_ < options_.boxes && !designs_.in_vain() && !options_.stop()) {
      if (opened_ % told_every == 0) tell_progress(tolerance);
      TreeNode node = open_.top();
      open_.pop();
      if (options_.self_contact && !shared_->cuts.rule_out(node, branch_of(node), boxes_)) continue;
      if (!rule_out_by_obstacles(node, false)) continue;
      raise_by_touches(node);
      if (node.bound >= designs_.enough(tolerance)) {
        open_.push(std::move(node));
        continue;
      }
      if (are_tried(++opened_)) designs_.try_in(node, branch_of(node), obstacles_of(node), loads_of(node));
      if (opened_ == next_leap_) leap_to(node), next_leap_ *= 2;
      if (sees_obstacles() && opened_ % looked_further_every == 0)
        obstacles_of(node)->look_further(design_box(node), node.alive);
      split(node);
    }
  }

  /// Whether designs of a box are tried: often at first, when the boxes are still many; but seldom where the search has a design already
  /// and asks what the load limit costs: most of them are too soft then, and without the limit designs near boxes' middles tell more.
  bool are_tried(std::size_t opened) const {
    const bool is_seldom = trials_ == nullptr && options_.incumbent && (sees_loads() || value_near_);
    return opened % 8 == 0 || (opened <= 100 && !is_seldom);
  }

  /// Tries the middle of a box out, whatever limits it breaks: under a limit on the load error the best designs lie where limits meet, and
  /// designs that keep all of them are met there late. So are those of the tree that goes on without that limit.
  void leap_to(const TreeNode& node) {
    if (!value_near_ && !(trials_ && sees_loads())) return;
    const auto middle = middle_of(node);
    if (!middle) return;
    if (value_near_)
      designs_.learn_of(node, branch_of(node), *middle, value_near_);
    else
      designs_.leap_to(node, branch_of(node), *middle, obstacles_of(node));
  }

  /// The same of each branch's most promising box, where the tree ends before it leaves nothing better.
  void leap_to_what_is_left() {
    std::set<std::size_t> seen;
    for (auto open = open_; !open.empty() && open.top().bound < designs_.enough(options_.tolerance);
         open.pop())
      if (seen.insert(open.top().branch).second) leap_to(open.top());
  }

  static bounding::DesignBox design_box(const TreeNode& node) {
    const bounding::PoleDisc poles = bounding::disc_around(node.x, node.y);
    const Point half(std::max(node.x.upper - poles.centre.x(), poles.centre.x() - node.x.lower),
                     std::max(node.y.upper - poles.centre.y(), poles.centre.y() - node.y.lower));
    return {node.lengths, poles.centre, poles.radius, half};
  }

  /// The roots of all groundings and assembly modes; false if it was stopped on the way.
  bool plant() {
    for (const Grounding grounding : all_groundings) {
      const auto& permitted = spec_.objective.groundings;
      if (std::find(permitted.begin(), permitted.end(), grounding) == permitted.end()) continue;
      // A bound leaves turning bodies out; designs that are tried keep clear of them, in layers that know them.
      const auto bodies = trials_ != nullptr ? spec_.bodies : that_keep_direction(spec_.bodies);
      const auto layers = bounding::layer_candidates(
          spec_.copy.k(), grounding, spec_.links.layers,
          sees_obstacles() ? spec_.obstacles : std::vector<Obstacle>{},
          sees_obstacles() ? bodies : std::vector<Body>{},
          trials_ != nullptr ? std::optional(sag_counts(spec_.limits)) : std::nullopt);
      const Complex shape = shape_of(spec_.copy.k(), grounding);
      // The search, whose choices the trials are of, leaves mirror images out (problem/choices.hpp).
      const bool has_mirror_images = trials_ != nullptr && is_straight(shape) && !sees_obstacles();
      for (const AssemblyMode& mode : assembly_modes(shape)) {
        if (options_.stop()) return false;
        if (has_mirror_images && mode.number > 0) continue;
        shared_->branches.push_back(bounding::make_branch(spec_, grounding, mode, layers, options_.shortest));
        if (sees_loads()) {
          load_floors_.emplace_back(spec_, shared_->branches.back().mode);
          load_trades_.emplace_back();
        }
      }
    }
    if (sees_obstacles()) set_up_obstacle_tests();
    for (std::size_t branch = 0; branch < shared_->branches.size(); ++branch) {
      if (options_.stop()) return false;
      plant(branch);
    }
    return true;
  }

  void plant(std::size_t branch) {
    const ModeFacts& a = shared_->branches[branch].mode;
    if (a.a.empty() || a.b.empty() || a.allowed.empty()) return;
    TreeNode root;
    root.branch = branch;
    shared_->poles.plant(root);
    root.lengths = {{a.b.lower / a.a.upper * 0.999, a.b.upper / a.a.lower * 1.001},
                    {2 * a.a.lower * a.b.lower * 0.999, 2 * a.a.upper * a.b.upper * 1.001}};
    root.alive = bounding::LayerSet::all(shared_->branches[branch].layers.size());
    if (sees_obstacles()) root.alive.remove(shared_->obstacle_tests[branch]->hit_by_the_copy());
    if (!root.alive.empty() && shared_->poles.measure(root)) grow_from(root);
  }

  /// Shrinks, bounds and keeps a box, or drops it.
  void grow_from(TreeNode node) {
    ++boxes_;
    const ModeFacts& a = mode_of(node);
    if (!bounding::contract(a, node.distances, designs_.transmission(), node.lengths)) return;
    if (by_size_ && !bounding::contract_by_size(a, designs_.best(), node.lengths))
      return drop(node, designs_.best());
    node.bound = bound_of(node);
    if (!by_size_ && -node.bound < spec_.limits.transmission) return;
    if (node.bound >= designs_.best()) return drop(node, designs_.best());
    node.without_loads = node.bound;
    node.number = boxes_;
    if (sees_loads() &&
        loads_of(node)->exceeded_by_all(node.distances, designs_.transmission(), node.lengths)) {
      if (trials_) left_to_loads_.push_back(std::move(node));
      return;
    }
    if (sees_loads()) raise_by_loads(node);
    if (!shared_->cuts.repeat(node, branch_of(node)) ||
        (node.sight.hit && !rule_out_by_obstacles(node, true)))
      return;
    open_.push(std::move(node));
  }

  /// The bound of a box without a design that keeps the limit on the load error and is better than what the tree asks for.
  void raise_by_loads(TreeNode& node) {
    const double enough = designs_.enough(tolerance_);
    if (!(enough < infinity) || node.bound >= enough) return;
    const bounding::DesignRange designs{node.lengths, node.x, node.y};
    if (trade_of(node, designs, enough).none_better()) node.bound = enough;
  }

  /// What designs have to do to be better than `enough`, as TreeNode::bound.
  bounding::BetterDesign better_than(double enough) const {
    if (by_size_) return {designs_.transmission(), enough};
    return {std::max(spec_.limits.transmission, -enough), std::nullopt};
  }

  bounding::BoxTrade trade_of(const TreeNode& node, const bounding::DesignRange& designs, double enough) {
    std::optional<bounding::LoadTrade>& trade = load_trades_[node.branch];
    if (!trade) trade.emplace(spec_, mode_of(node));
    return {*trade, shared_->poles.ends_from(node.pole()), designs, better_than(enough)};
  }

  /// The same of a box that is about to be split: of its designs that keep clear of what the one in the middle touches in each layer
  /// assignment left.
  void raise_by_touches(TreeNode& node) {
    const double enough = designs_.enough(tolerance_);
    if (!(enough < infinity) || node.bound >= enough || !layers_are_asked()) return;
    const auto distances = shared_->poles.distances_from(node.pole());
    if (!distances) return;
    if (node.worse_than < enough) node.worse = {};
    node.worse_than = enough;
    const bounding::DesignRange designs{node.lengths, node.x, node.y};
    const bounding::BoxTrade trade = trade_of(node, designs, enough);
    ++layers_asked_;
    if (bounding::leaves_a_layer({spec_, branch_of(node), obstacles_of(node), design_box(node), *distances,
                                  better_than(enough).transmission, trade},
                                 node))
      return;
    ++layers_ruled_out_;
    node.bound = enough;
  }

  /// To ask takes as long as a few boxes do: where it is of use less than once in `worth_asking` times it is asked as seldom, and not at all
  /// in small trees.
  bool layers_are_asked() const {
    constexpr std::size_t small_tree = 64, worth_asking = 8, asked_at_first = 16;
    return sees_loads() && options_.self_contact && opened_ >= small_tree &&
           (layers_asked_ < asked_at_first || worth_asking * layers_ruled_out_ >= layers_asked_ ||
            opened_ % worth_asking == 0);
  }

  bool sees_obstacles() const {
    return options_.self_contact && (!spec_.obstacles.empty() || !spec_.bodies.empty() || spec_.table);
  }

  bool sees_loads() const {
    return options_.load_limit && spec_.limits.load_error && spec_.load && spec_.material;
  }

  /// One for each branch.
  void set_up_obstacle_tests() {
    const auto scene = bounding::obstacle_scene(spec_, options_.stop);
    shared_->obstacle_tests.resize(shared_->branches.size());
    run_parallel(shared_->branches.size(), options_.threads, [&](std::size_t branch) {
      std::vector<LayerAssignment> layers;
      for (const bounding::LayerCandidate& choice : shared_->branches[branch].layers)
        layers.push_back(choice.layers);
      shared_->obstacle_tests[branch] = std::make_unique<bounding::ObstacleTest>(
          spec_, shared_->branches[branch].mode, layers, scene, options_.stop);
    });
  }

  /// Drops layer assignments in which every design of the box has a part in an obstacle, body or the table's edge; false if none is left.
  bool rule_out_by_obstacles(TreeNode& node, bool only_where_last) {
    if (!sees_obstacles()) return true;
    if (!only_where_last) boxes_ += shared_->obstacle_tests[node.branch]->cost(node.sight);
    node.alive = shared_->obstacle_tests[node.branch]->not_hit(design_box(node), node.alive, node.sight,
                                                               only_where_last);
    return !node.alive.empty();
  }

  double bound_of(const TreeNode& node) const {
    return by_size_
               ? bounding::size_at_least(mode_of(node), node.distances, designs_.transmission(), node.lengths)
               : -bounding::transmission_at_most(mode_of(node), node.distances, node.lengths);
  }

  /// A box whose designs are no better than the best known: its grounding is not impossible.
  void drop(const TreeNode& node, double bound) { note(mode_of(node).grounding, bound); }

  void note(Grounding grounding, double bound) {
    auto& noted = by_grounding_[static_cast<std::size_t>(grounding)];
    noted = noted ? std::min(*noted, bound) : bound;
  }

  /// A box whose bound would not rise if the pole were known is split across its lengths first.
  double pole_weight(const TreeNode& node) const {
    constexpr double idle = 0.1;
    TreeNode fixed = node;
    fixed.x.lower = fixed.x.upper = node.pole().x();
    fixed.y.lower = fixed.y.upper = node.pole().y();
    if (node.pole_is_known() || !shared_->poles.measure_distances(fixed)) return 1;
    if (!bounding::contract(mode_of(node), fixed.distances, designs_.transmission(), fixed.lengths)) return 1;
    if (bound_of(fixed) > node.bound) return 1;
    // Where all designs of a box have no opening in common, nothing is said of their contact.
    const bool is_seen = !options_.self_contact ||
                         !bounding::passed_by_all(mode_of(node), node.distances, node.lengths).empty();
    return is_seen ? idle : 1;
  }

  /// What each coordinate adds to how uncertain a box is: the part of it with the largest share is split.
  struct Widths {
    double t, w, x, y;
  };

  Widths widths_of(const TreeNode& node) const {
    const double per_mm = (0.5 / std::max(node.distances.farthest_at_least, 1e-300) +
                           0.5 / std::max(node.distances.nearest_at_most, 1e-300)) *
                          pole_weight(node);
    return {0.5 * std::log(node.lengths.t.upper / node.lengths.t.lower),
            0.5 * std::log(node.lengths.w.upper / node.lengths.w.lower),
            (node.x.upper - node.x.lower) * per_mm, (node.y.upper - node.y.lower) * per_mm};
  }

  void split(const TreeNode& node) {
    const Widths width = widths_of(node);
    const double widest = std::max({width.t, width.w, width.x, width.y});
    const auto halve = [&](auto part, double middle) {
      TreeNode lower = node, upper = node;
      part(lower).upper = middle;
      part(upper).lower = middle;
      for (TreeNode* half : {&lower, &upper})
        if (widest == width.t || widest == width.w || shared_->poles.measure(*half)) grow_from(*half);
    };
    if (widest == width.t)
      return halve([](TreeNode& n) -> Range& { return n.lengths.t; },
                   std::sqrt(node.lengths.t.lower * node.lengths.t.upper));
    if (widest == width.w)
      return halve([](TreeNode& n) -> Range& { return n.lengths.w; },
                   std::sqrt(node.lengths.w.lower * node.lengths.w.upper));
    if (widest == width.x)
      return halve([](TreeNode& n) -> Range& { return n.x; }, 0.5 * (node.x.lower + node.x.upper));
    halve([](TreeNode& n) -> Range& { return n.y; }, 0.5 * (node.y.lower + node.y.upper));
  }

  std::optional<RelaxedDesign> middle_of(const TreeNode& node) const {
    const Branch& branch = branch_of(node);
    const double t = std::sqrt(node.lengths.t.lower * node.lengths.t.upper);
    const double w = std::sqrt(node.lengths.w.lower * node.lengths.w.upper);
    const auto linkage =
        bounding::linkage_of(spec_, branch, std::sqrt(w / t / 2), std::sqrt(w * t / 2), node.pole());
    if (!linkage) return std::nullopt;
    return RelaxedDesign{
        linkage->grounding(), linkage->assembly_mode().number, linkage->VA(), linkage->VB(), node.pole(), {}};
  }

  /// `tolerance`: with which it counts as tight.
  ProvenBound proven_so_far(double tolerance) const {
    ProvenBound result;
    const double bound = open_.empty() ? designs_.best() : std::min(designs_.best(), open_.top().bound);
    result.no_design = open_.empty() && !(designs_.best() < infinity);
    result.tight = is_closed(tolerance);
    if (!result.no_design) result.value = by_size_ ? bound : -bound;
    return result;
  }

  ProvenBound verdict(ProvenBound result) {
    result.boxes = boxes_;
    if (designs_.best() < infinity) result.relaxation = by_size_ ? designs_.best() : -designs_.best();
    result.design = designs_.design();
    std::set<std::size_t> promising;
    for (; !open_.empty(); open_.pop()) {
      const TreeNode& node = open_.top();
      note(mode_of(node).grounding, node.bound);
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
  Objective objective_;
  bool by_size_;
  std::shared_ptr<Shared> shared_;
  std::vector<bounding::LoadFloor> load_floors_;                 // one a branch, if loads are to be seen
  std::vector<std::optional<bounding::LoadTrade>> load_trades_;  // the same, once one is asked
  std::vector<TreeNode> left_to_loads_;  // of a search: boxes that only the load limit rules out
  bounding::RelaxedDesigns designs_;
  std::priority_queue<TreeNode, std::vector<TreeNode>, bounding::LessPromising> open_;
  std::array<std::optional<double>, 3> by_grounding_;
  std::size_t boxes_ = 0, opened_ = 0;
  std::size_t layers_asked_ = 0, layers_ruled_out_ = 0;    // boxes, by what they touch
  std::size_t next_leap_ = 32;                             // boxes opened
  ValueNear value_near_{};                                 // of a tree that goes on without the load limit
  static constexpr std::size_t told_every = 64;            // boxes
  static constexpr std::size_t looked_further_every = 64;  // boxes
  double tolerance_ = options_.tolerance;                  // that the tree grows to now
  double widest_gap_ = 0, told_ = 0;                       // of the progress told
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
