#include "synthesis/bound/relaxed_designs.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/bound/slack.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe::bounding {

struct RelaxedDesigns::Candidate {
  CopyingLinkage linkage;
  OpeningInterval openings;
  double value;  ///< as TreeNode::bound
};

struct RelaxedDesigns::Box {
  const TreeNode& node;
  const Branch& branch;
  ObstacleTest* obstacles;
  const LoadFloor* loads;
  DistanceRange range;  ///< of the region from the middle of the pole's places
  std::vector<Candidate> candidates{};
};

RelaxedDesigns::RelaxedDesigns(const Spec& spec, bool by_size, const BoundOptions& options,
                               const Trials* trials, const PolePlaces& places)
    : spec_(spec), options_(options), trials_(trials), places_(places), by_size_(by_size) {
  if (options.incumbent) incumbent_ = best_ = by_size_ ? *options.incumbent : -*options.incumbent;
}

void RelaxedDesigns::try_in(const TreeNode& node, const Branch& branch, ObstacleTest* obstacles,
                            const LoadFloor* loads) {
  if (trials_are_used_up()) return;
  const auto range = places_.distances_from(node.pole());
  if (!range) return;
  const PoleDistances exact{range->nearest, range->farthest, 1,
                            range->farthest * range->farthest - range->nearest * range->nearest};
  Box box{node, branch, obstacles, loads, *range};
  const ModeFacts& a = branch.mode;
  LengthBox lengths = node.lengths;
  if (!contract(a, exact, transmission(), lengths)) return;
  const double middle = std::sqrt(lengths.t.lower * lengths.t.upper);
  for (const double t :
       {lengths.t.lower, lengths.t.upper, std::clamp(1.0, lengths.t.lower, lengths.t.upper), middle}) {
    LengthBox line{{t, t}, lengths.w};
    if (options_.stop()) return;
    if (!contract(a, exact, transmission(), line)) continue;
    if (!by_size_) try_freest(box, exact, line);
    try_design(box, t, std::min(line.w.lower * slack::surely_more, line.w.upper));
    try_design(box, t, std::sqrt(line.w.lower * line.w.upper));
    try_design(box, t, line.w.upper);
  }
  look_at_best(box);
}

/// Of all lengths with one t, those with the largest transmission angle.
void RelaxedDesigns::try_freest(Box& box, const PoleDistances& exact, LengthBox line) {
  const double aim = transmission_at_most(box.branch.mode, exact, line) - slack::relaxed_transmission;
  if (aim <= transmission() || !contract(box.branch.mode, exact, aim, line)) return;
  try_design(box, line.t.lower, std::sqrt(line.w.lower * line.w.upper));
}

void RelaxedDesigns::try_design(Box& box, double t, double w) {
  const TreeNode& node = box.node;
  const auto linkage = linkage_of(spec_, box.branch, std::sqrt(w / t / 2), std::sqrt(w * t / 2), node.pole());
  if (!linkage) return;
  const auto near = linkage->opening_at(box.range.nearest), far = linkage->opening_at(box.range.farthest);
  if (!near || !far) return;
  const double transmission = std::min(linkage->transmission_angle(*near), linkage->transmission_angle(*far));
  if (transmission < spec_.limits.transmission - slack::relaxed_transmission) return;
  const double value = by_size_ ? linkage->size() : -transmission;
  const Candidate candidate{*linkage, {std::min(*near, *far), std::max(*near, *far)}, value};
  if (trials_)
    look_at(box, candidate);
  else
    box.candidates.push_back(candidate);
}

/// The best first: where it keeps all limits the others need not be looked at.
void RelaxedDesigns::look_at_best(Box& box) {
  std::stable_sort(box.candidates.begin(), box.candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.value < b.value; });
  for (const Candidate& candidate : box.candidates) look_at(box, candidate);
}

/// Kept, or tried out, if it keeps all limits and is better than the best known.
void RelaxedDesigns::look_at(const Box& box, const Candidate& candidate) {
  const TreeNode& node = box.node;
  const Branch& branch = box.branch;
  const CopyingLinkage& linkage = candidate.linkage;
  const OpeningInterval& openings = candidate.openings;
  if (candidate.value >= (trials_ ? enough(trials_->tolerance) : best_)) return;
  const BarLengths lengths{linkage.VA(), linkage.VB()};
  bool is_soft = box.loads != nullptr && !box.loads->keeps_at_ends(lengths, openings);
  // A trial may make of a design that is too soft one that is not. While none is known each branch has one such trial.
  const bool may_be_soft =
      trials_ != nullptr && !(best_ < infinity) && !soft_tried_out_.contains(node.branch);
  if (is_soft && !may_be_soft) return;
  if (spec_.limits.copy_error && spec_.tolerance) {
    const CopyErrorProfile profile = copy_error_profile(linkage, CopyTolerance::uniform(*spec_.tolerance));
    if (profile.largest(openings).worst.worst > *spec_.limits.copy_error) return;
  }
  if (was_in_vain(node.branch, linkage)) return;
  std::vector<std::optional<bool>> keep(branch.layers.size());  // where known; of those alike the first's
  const auto keeps_clearance = [&](const LayerCandidate& choice) {
    const std::optional<bool>& known = keep[choice.like];
    if (known) return *known;
    const auto nearer =
        pair_nearer_than(spec_.limits.clearance, linkage, spec_.links.style, choice.parts, openings);
    keep[choice.like] = !nearer;
    if (!nearer) return true;
    const PairKey pair = key_of(choice.parts[*nearer]);
    for (const LayerCandidate& other : branch.layers)
      if (other.has(pair)) keep[other.like] = false;
    return false;
  };
  LayerSet left = node.alive;  // of which none is known not to be clear
  const auto free = [&](const LayerCandidate& choice) {
    if (!options_.self_contact) return true;
    const auto index = static_cast<std::size_t>(&choice - branch.layers.data());
    return left.has(index) && keeps_clearance(choice) &&
           (box.obstacles == nullptr ||
            box.obstacles->is_clear(linkage.VA(), linkage.VB(), node.pole(), index, node.sight.hit, left));
  };
  const auto layers = std::find_if(branch.layers.begin(), branch.layers.end(), free);
  if (layers == branch.layers.end()) return;
  is_soft = is_soft || (box.loads != nullptr && !box.loads->keeps(lengths, openings));
  if (is_soft && !may_be_soft) return;
  const RelaxedDesign design{linkage.grounding(), linkage.assembly_mode().number,
                             linkage.VA(),        linkage.VB(),
                             node.pole(),         layers->layers};
  if (is_soft) soft_tried_out_.insert(node.branch);
  if (trials_)
    return try_out(box.obstacles, node.branch, static_cast<std::size_t>(layers - branch.layers.begin()),
                   design);
  design_ = design;
  best_ = candidate.value;
}

void RelaxedDesigns::learn_of(const TreeNode& node, const Branch& branch, RelaxedDesign design,
                              const ValueNear& value_near) {
  if (node.alive.empty()) return;
  design.layers = branch.layers[node.alive.first()].layers;
  if (const auto value = value_near(design)) best_ = std::min(best_, by_size_ ? *value : -*value);
}

void RelaxedDesigns::leap_to(const TreeNode& node, const Branch& branch, RelaxedDesign design,
                             ObstacleTest* obstacles) {
  if (trials_are_used_up() || node.alive.empty()) return;
  const std::size_t layers = node.alive.first();
  design.layers = branch.layers[layers].layers;
  try_out(obstacles, node.branch, layers, design);
}

/// Tries a design out in the search: what it leads to is known, and where it fails is looked at from now on.
void RelaxedDesigns::try_out(ObstacleTest* obstacles, std::size_t branch, std::size_t layers,
                             const RelaxedDesign& design) {
  ++tried_out_;
  const Trial trial = trials_->run(design);
  if (trial.best) best_ = std::min(best_, by_size_ ? *trial.best : -*trial.best);
  if (obstacles != nullptr)
    for (const Point& place : trial.in_the_way) obstacles->add_place(place, layers);
  std::vector<RelaxedDesign>& known = in_vain_[branch];
  if (trial.in_vain)
    known.push_back(design);
  else
    known.clear();
}

/// Boxes that share a corner have it as a design, apart in its last digits.
bool RelaxedDesigns::was_in_vain(std::size_t branch, const CopyingLinkage& linkage) const {
  const auto known = in_vain_.find(branch);
  if (known == in_vain_.end()) return false;
  const double apart = slack::same_design * linkage.size();
  return std::any_of(known->second.begin(), known->second.end(), [&](const RelaxedDesign& one) {
    return std::abs(one.VA - linkage.VA()) <= apart && std::abs(one.VB - linkage.VB()) <= apart &&
           (one.pole - linkage.pole()).norm() <= apart;
  });
}

}  // namespace kempe::bounding
