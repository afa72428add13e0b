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
/// Room for rounding, in shares of the figures it is added to: many times what they can be off.
constexpr double slack = 1e-11;

double mean(double t) { return 0.5 * (t + 1 / t); }

/// Equal for terms that ask the same.
using TermKey = std::tuple<std::size_t, double, std::vector<Joint>>;
TermKey key_of(const ObstacleTerm& term) {
  const JointHull& hull = term.piece.hull;
  return {term.obstacle, term.piece.half_width, {hull.joints.begin(), hull.joints.begin() + hull.count}};
}

}  // namespace

/// The design in the middle of a box.
struct ObstacleTest::Middle {
  double t, w;
  LogLengths lengths;
};

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

/// How far any joint of any design of the box may stand from the middle design's, with the tracer at the place, mm; nothing
/// if the middle does not reach the place, or the box is too large for a statement.
std::optional<double> ObstacleTest::joints_move(const DesignBox& box, const Point& place,
                                                const Middle& middle) const {
  const double chain = assembly_mode_.chain, distance = (place - box.pole).norm();
  const LengthBox& l = box.lengths;
  const auto cosine = [&](double r, double w, double h) { return chain * chain * r * r / w - h; };
  const double at_middle = cosine(distance, middle.w, mean(middle.t));
  if (!(std::abs(at_middle) < 1)) return std::nullopt;
  const double h_least = l.t.lower > 1 ? mean(l.t.lower) : l.t.upper < 1 ? mean(l.t.upper) : 1;
  const double h_most = std::max(mean(l.t.lower), mean(l.t.upper));
  const double r_least = std::max(0.0, distance - box.radius), r_most = distance + box.radius;
  const auto angle = [](double c) { return std::acos(std::clamp(c, -1.0, 1.0)); };
  const double room = slack * (1 + h_most);
  const double psi = angle(at_middle);
  const double psi_away = std::max(angle(cosine(r_least, l.w.upper, h_most) - room) - psi,
                                   psi - angle(cosine(r_most, l.w.lower, h_least) + room)) +
                          slack;
  // rho is known to within this share of the middle's |rho|.
  const double share =
      std::max(l.t.upper / middle.t - 1, 1 - l.t.lower / middle.t) + l.t.upper / middle.t * psi_away + slack;

  const JointFrame frame(reach_.shape(), middle.lengths, reach_.opening_at(middle.lengths, distance));
  const auto of_p = [&](Joint joint) { return frame.of_p(joint) - frame.of_p(roles_.pole); };
  const auto of_q = [&](Joint joint) { return frame.of_q(joint) - frame.of_q(roles_.pole); };
  const Complex arm_p = of_p(roles_.tracer), arm_q = of_q(roles_.tracer);
  const double arm = std::abs(arm_p + arm_q), least_arm = arm - std::abs(arm_q) * share;
  if (!(least_arm > 0.05 * arm)) return std::nullopt;
  double most = 0;
  for (const Joint joint : all_joints) {
    const Complex p = of_p(joint), q = of_q(joint);
    const double of_map = std::abs(q * arm_p - p * arm_q) * share / (arm * least_arm);
    const double beside = std::abs(1.0 - (p + q) / (arm_p + arm_q)) + of_map;
    most = std::max(most, box.radius * beside + distance * of_map);
  }
  return most * (1 + slack) + slack * (distance + middle.w / arm);
}

LayerSet ObstacleTest::not_hit(const DesignBox& box, LayerSet alive, std::optional<Hit>& hint,
                               bool only_hint) const {
  const double t = std::sqrt(box.lengths.t.lower * box.lengths.t.upper);
  const double w = std::sqrt(box.lengths.w.lower * box.lengths.w.upper);
  const double VB = std::sqrt(w * t / 2) * std::abs(assembly_mode_.s);
  const Middle middle{t, w, {std::log(std::sqrt(w / t / 2)), std::log(VB)}};
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<Hit> next;
  const auto look_at = [&](std::size_t place, std::size_t first, std::size_t last) {
    const auto moved = joints_move(box, places_[place], middle);
    if (!moved) return;
    const PlacedJoints joints(reach_, roles_, middle.lengths, box.pole, places_[place]);
    for (std::size_t i = first; i < last; ++i) {
      if (!terms_[i].layers.meets(alive)) continue;
      const ObstacleTerm& term = terms_[i].what;
      const double gap = obstacle_gap(term, shapes_[term.obstacle], joints, clearance_);  // exact below it
      if (gap + *moved < clearance_ * (1 - slack) - slack * box.pole.norm()) {
        alive.remove(terms_[i].layers);
        next = Hit{place, i};
        if (alive.empty()) return;
      } else if (gap < clearance_ && gap + *moved < nearest) {
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
