#include "synthesis/bound/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace kempe::bounding {
namespace {

/// Places of the tracer that are looked at: at first, at most, and for single designs.
constexpr int first_places = 60;
constexpr std::size_t most_places = 240;
constexpr int many_places = 2000;
/// A gap is a difference of coordinates, off by less than this share of the largest of them: some 450 units in the last place,
/// for a formula of a few dozen operations.
constexpr double rounding_share = 1e-13;

/// Equal for terms that ask the same.
using TermKey = std::tuple<std::size_t, double, std::vector<Joint>>;
TermKey key_of(const ObstacleTerm& term) {
  const JointHull& hull = term.piece.hull;
  return {term.obstacle, term.piece.half_width, {hull.joints.begin(), hull.joints.begin() + hull.count}};
}

}  // namespace

ObstacleTest::ObstacleTest(const Spec& spec, const AssemblyMode& assembly_mode,
                           const std::vector<LayerAssignment>& layers, StopFlag stop)
    : assembly_mode_(assembly_mode), reach_(spec.copy.k(), assembly_mode.grounding, assembly_mode.number),
      roles_(roles_of(assembly_mode.grounding)), clearance_(spec.limits.clearance),
      shapes_(obstacle_shapes(spec.obstacles)), places_(tracer_places(spec.region, first_places)),
      many_places_(tracer_places(spec.region, many_places)), stop_(std::move(stop)) {
  const auto any =
      CopyingLinkage::make(spec.copy.k(), assembly_mode.grounding, 100, 100, assembly_mode.number);
  std::map<TermKey, std::size_t> known;
  for (std::size_t i = 0; any && i < layers.size() && !stop_(); ++i)
    for (const ObstacleTerm& what : obstacle_terms(*any, layers[i], spec)) {
      const auto at = known.emplace(key_of(what), terms_.size()).first;
      if (at->second == terms_.size()) terms_.push_back(Term{what});
      terms_[at->second].layers.add(i);
    }
}

/// How far a gap may be off by rounding, mm.
double ObstacleTest::gap_rounding(const Term& term, const PlacedJoints& joints) const {
  double largest = 0;
  for (const Joint joint : all_joints) largest = std::max(largest, std::abs(joints[joint]));
  const ObstacleShape& obstacle = shapes_[term.what.obstacle];
  return rounding_share *
         (largest + std::abs(obstacle.centre) + obstacle.radius + term.what.piece.half_width + clearance_);
}

LayerSet ObstacleTest::not_hit(const DesignBox& box, LayerSet alive, std::optional<Hit>& hint,
                               bool only_hint) const {
  const double t = box.t(), w = box.w();
  const LogLengths middle{std::log(std::sqrt(w / t / 2)),
                          std::log(std::sqrt(w * t / 2) * std::abs(assembly_mode_.s))};
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<Hit> next;
  const auto look_at = [&](std::size_t place, std::size_t first, std::size_t last) {
    const PlacedJoints joints(reach_, roles_, middle, box.pole, places_[place]);
    std::optional<double> moved;
    for (std::size_t i = first; i < last; ++i) {
      if (!terms_[i].layers.meets(alive)) continue;
      const ObstacleTerm& term = terms_[i].what;
      const double gap = obstacle_gap(term, shapes_[term.obstacle], joints, clearance_);  // exact below it
      if (gap >= clearance_) continue;
      if (!moved) moved = joints_move_at_most(assembly_mode_, box, places_[place], joints.all());
      if (!moved) return;
      if (gap + *moved + gap_rounding(terms_[i], joints) < clearance_) {
        alive.remove(terms_[i].layers);
        next = Hit{place, i};
        if (alive.empty()) return;
      } else if (gap + *moved < nearest) {
        nearest = gap + *moved;
        if (!next) next = Hit{place, i};
      }
    }
  };
  if (hint) look_at(hint->place, hint->term, hint->term + 1);
  for (std::size_t place = 0; !only_hint && place < places_.size() && !alive.empty() && !stop_(); ++place)
    look_at(place, 0, terms_.size());
  if (next) hint = next;
  return alive;
}

bool ObstacleTest::is_clear(double VA, double VB, const Point& pole, std::size_t layers) {
  const LogLengths lengths{std::log(VA), std::log(VB)};
  const auto is_clear_at = [&](const Point& place) {
    if (stop_()) return false;
    const PlacedJoints joints(reach_, roles_, lengths, pole, place);
    return std::none_of(terms_.begin(), terms_.end(), [&](const Term& term) {
      return term.layers.has(layers) &&
             obstacle_gap(term.what, shapes_[term.what.obstacle], joints, clearance_) < clearance_;
    });
  };
  if (!std::all_of(places_.begin(), places_.end(), is_clear_at)) return false;
  const auto hit = std::find_if_not(many_places_.begin(), many_places_.end(), is_clear_at);
  if (hit == many_places_.end()) return true;
  if (!stop_() && places_.size() < most_places) places_.push_back(*hit);
  return false;
}

}  // namespace kempe::bounding
