#include "synthesis/bound/obstacles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "geometry/complex_vectors.hpp"
#include "synthesis/bound/pole_places.hpp"
#include "synthesis/bound/slack.hpp"
#include "workspace/obstructions.hpp"

namespace kempe::bounding {
namespace {

/// Places of the tracer that are looked at: at first, at most, and for single designs.
constexpr int first_places = 60;
constexpr std::size_t most_places = 240;
constexpr int many_places = 2000;
/// Factor: at no place do joints move farther than this times what they do at others, more or less.
constexpr double moves_of_others = 3;

/// Share of what joints move at most: an overlap that is less deep is none that all designs have, to first order either.
constexpr double share_of_moves = 0.2;

/// Share of what joints move at most: where no overlap is deeper, none is likely to be one that all designs have before the box has been split
/// so many times more.
constexpr double hopeless_share = 0.05;
constexpr int splits_at_rest = 3;

JointSpread between(const JointSpread& from, const JointSpread& to, double share) {
  JointSpread point{
      (1 - share) * from.middle + share * to.middle, {}, (1 - share) * from.rest + share * to.rest};
  for (std::size_t i = 0; i < point.by.size(); ++i) point.by[i] = (1 - share) * from.by[i] + share * to.by[i];
  return point;
}

/// Equal for terms that ask the same.
using TermKey = std::tuple<std::size_t, double, std::vector<Joint>>;
TermKey key_of(const ObstacleTerm& term) {
  const JointHull& hull = term.piece.hull;
  return {term.obstacle, term.piece.half_width, {hull.joints.begin(), hull.joints.begin() + hull.count}};
}

/// Around all places where the pole may stand.
PoleDisc disc_of_poles(const PoleSpec& pole) {
  const Box box = box_of_places(pole);
  return disc_around({box.lower.x(), box.upper.x()}, {box.lower.y(), box.upper.y()});
}

/// What a term's joints move, as seen from the joint that carries its obstruction: 0 for the table's frame.
std::size_t frame_of(const ObstacleTerm& term) {
  return term.seen_from ? 1 + static_cast<std::size_t>(*term.seen_from) : 0;
}

/// What the corners of a term's piece move at most, mm.
double moved_of(const ObstacleTerm& term, const JointMoves& moves) {
  double most = 0;
  for (int i = 0; i < term.piece.hull.count; ++i)
    most =
        std::max(most, moves[static_cast<std::size_t>(term.piece.hull.joints[static_cast<std::size_t>(i)])]);
  return most;
}

}  // namespace

std::vector<Obstruction> obstructions_of(const Spec& spec) {
  return kempe::obstructions_of(spec.obstacles, that_keep_direction(spec.bodies), spec.table);
}

std::shared_ptr<const ObstacleScene> obstacle_scene(const Spec& spec, const StopFlag& stop) {
  ObstacleScene scene{obstacle_shapes(obstructions_of(spec), stop),
                      tracer_places(spec.region, first_places),
                      tracer_places(spec.region, many_places),
                      {}};
  scene.groups = groups_of(scene.many_places);
  return std::make_shared<const ObstacleScene>(std::move(scene));
}

ObstacleTest::ObstacleTest(const Spec& spec, const ModeFacts& mode,
                           const std::vector<LayerAssignment>& layers, const StopFlag& stop)
    : ObstacleTest(spec, mode, layers, obstacle_scene(spec, stop), stop) {}

ObstacleTest::ObstacleTest(const Spec& spec, const ModeFacts& mode,
                           const std::vector<LayerAssignment>& layers,
                           std::shared_ptr<const ObstacleScene> scene, StopFlag stop)
    : mode_(mode), moving_(mode), k_(spec.copy.k()), reach_(k_, mode.grounding, mode.assembly_mode.number),
      roles_(roles_of(mode.grounding)), clearance_(spec.limits.clearance),
      usable_(mode.usable(spec.limits.transmission)), scene_(std::move(scene)), stop_(std::move(stop)) {
  for (const Point& place : scene_->places) places_.push_back({place});
  const auto any = CopyingLinkage::make(spec.copy.k(), mode.grounding, 100, 100, mode.assembly_mode.number);
  const std::vector<Obstruction> obstructions = obstructions_of(spec);
  std::map<TermKey, std::size_t> known;
  for (std::size_t i = 0; any && i < layers.size() && !stop_(); ++i)
    for (const ObstacleTerm& what : obstacle_terms(*any, layers[i], spec.links.style, obstructions)) {
      const auto at = known.emplace(key_of(what), terms_.size()).first;
      if (at->second == terms_.size()) add_term({what, {}, obstructions[what.obstacle].met.has_value()});
      terms_[at->second].layers.add(i);
    }
  if (any) look_at_the_copy(spec, *any, obstructions, layers);
}

void ObstacleTest::add_term(Term term) {
  convex_pairs_ += scene_->shapes[term.what.obstacle].groups.empty() ? 1 : 2;
  all_terms_.push_back(static_cast<std::uint32_t>(terms_.size()));
  terms_.push_back(std::move(term));
}

/// The links' ends at tracer and pen: the copy says where they are for any lengths, up to the pole's place. An obstacle in the original
/// is told from this in no time, where boxes of designs need to be small; in a box it takes a small area of poles alone.
void ObstacleTest::look_at_the_copy(const Spec& spec, const CopyingLinkage& any,
                                    const std::vector<Obstruction>& obstructions,
                                    const std::vector<LayerAssignment>& layers) {
  for (std::size_t i = 0; i < obstructions.size(); ++i) {
    const Obstruction& obstruction = obstructions[i];
    if (obstruction.frame || obstruction.met) continue;
    for (const Joint joint : {roles_.tracer, roles_.pen}) {
      const ObstacleTerm end{{{{joint, joint, joint}, 1}, 0.5 * spec.links.style.width + obstruction.grown},
                             i};
      const bool is_hit = is_hit_by_the_copy(spec.pole, end);
      if (!is_hit && spec.pole.is_fixed()) continue;
      LayerSet with_end;
      for (std::size_t one = 0; one < layers.size(); ++one)
        for (const Part& part : parts_of(any, layers[one]))
          if (part.kind == Part::Kind::link && has_joint(part.link, joint) &&
              may_meet(part, obstruction, any))
            (is_hit ? hit_by_the_copy_ : with_end).add(one);
      if (!with_end.empty()) add_term({end, std::move(with_end), true});
    }
  }
}

/// With the tracer at one of the places at least, wherever the pole stands; `end`: a disc at tracer or pen. Groups of places are left out
/// where the disc keeps away with the pole in the middle of its places.
bool ObstacleTest::is_hit_by_the_copy(const PoleSpec& pole, const ObstacleTerm& end) const {
  if (scene_->groups.groups.empty()) return false;
  const PoleDisc poles = disc_of_poles(pole);
  const DesignBox any{{{1, 1}, {1, 1}}, poles.centre, poles.radius};
  const Joint joint = end.piece.hull.joints.front();
  const double per_tracer = joint == roles_.tracer ? 1 : std::abs(k_);
  const auto joints_at = [&](const Point& place) {
    return PlacedJoints(reach_, roles_, {}, poles.centre, place);
  };
  const auto gap_at = [&](const PlacedJoints& joints, double enough) {
    return obstacle_gap(end, scene_->shapes[end.obstacle], joints, enough, Beyond::anything);
  };
  const auto is_hit_at = [&](const Point& place) {
    if (place == poles.centre) return false;
    const PlacedJoints joints = joints_at(place);
    const double gap = gap_at(joints, clearance_);
    if (gap >= clearance_) return false;
    const JointMoves moves = copying_joints_move_at_most(mode_, k_, any, place, joints.all());
    return gap + moves[static_cast<std::size_t>(joint)] + gap_rounding(end, joints) < clearance_;
  };
  bool is_hit = false;
  const auto may_be_hit = [&](const PlaceGroup& group, bool) {
    if (group.centre == poles.centre) return true;
    const PlacedJoints joints = joints_at(group.centre);
    const double enough = clearance_ + per_tracer * group.radius + 2 * gap_rounding(end, joints);
    return !(gap_at(joints, enough) >= enough);
  };
  descend(scene_->groups, 0, true, may_be_hit, [&](std::size_t place, bool) {
    is_hit = !stop_() && is_hit_at(scene_->many_places[place]);
    return !is_hit && !stop_();
  });
  return is_hit;
}

LogLengths ObstacleTest::middle_of(const DesignBox& box) const {
  const double t = box.t(), w = box.w();
  return {std::log(std::sqrt(w / t / 2)), std::log(std::sqrt(w * t / 2) * std::abs(mode_.s))};
}

/// How far a gap may be off by rounding, mm.
double ObstacleTest::gap_rounding(const ObstacleTerm& term, const PlacedJoints& joints) const {
  double largest = 0;
  for (const Joint joint : all_joints) largest = std::max(largest, std::abs(joints[joint]));
  const ObstacleShape& obstacle = scene_->shapes[term.obstacle];
  return slack::obstacle_gap_rounding *
         (largest + std::abs(obstacle.centre) + obstacle.radius + term.piece.half_width + clearance_);
}

/// A point of the piece is a mean of its corners' places, so it moves by the same mean of their moves. A convex part that it is
/// within reach of at the ends of all moves it is within reach of all over the box.
bool ObstacleTest::is_hit_all_over(const Term& term, const JointSpreads& spreads, double rounding) const {
  const JointHull& hull = term.what.piece.hull;
  const double needed = term.what.piece.half_width + clearance_ - rounding;
  const auto corner = [&](int i) -> const JointSpread& {
    return spreads[static_cast<std::size_t>(hull.joints[static_cast<std::size_t>(i)])];
  };
  const auto reaches = [&](const JointSpread& point, const FixedConvex& part) {
    const double left = needed - point.rest;
    const auto is_within = [&](Complex at) { return distance_from(at, part.corners()) < left; };
    if (!is_within(point.middle)) return false;
    for (int ends = 0; ends < 16; ++ends) {
      Complex at = point.middle;
      for (int i = 0; i < 4; ++i)
        at += (ends >> i & 1) != 0 ? point.by[static_cast<std::size_t>(i)]
                                   : -point.by[static_cast<std::size_t>(i)];
      if (!is_within(at)) return false;
    }
    return true;
  };
  for (const EncircledPart& part : scene_->shapes[term.what.obstacle].parts) {
    const auto may_reach = [&](const JointSpread& point) {
      return std::abs(point.middle - part.centre) < part.radius + needed - point.rest;
    };
    if (hull.count == 1) {
      if (may_reach(corner(0)) && reaches(corner(0), part.outline)) return true;
      continue;
    }
    for (int i = 0; i < (hull.count == 3 ? 3 : 1); ++i) {
      const JointSpread &from = corner(i), &to = corner((i + 1) % hull.count);
      const double nearest = nearest_share(part.centre, from.middle, to.middle);
      for (const double share : {nearest, 0.5 * nearest, 0.5 * (1 + nearest)}) {
        const JointSpread point = between(from, to, share);
        if (may_reach(point) && reaches(point, part.outline)) return true;
      }
    }
    if (hull.count == 3)
      for (const double share : {0.25, 0.5, 0.75}) {
        const JointSpread side = between(corner(0), corner(1), share);
        const double nearest = nearest_share(part.centre, side.middle, corner(2).middle);
        const JointSpread point = between(side, corner(2), nearest);
        if (may_reach(point) && reaches(point, part.outline)) return true;
      }
  }
  return false;
}

LayerSet ObstacleTest::layers_of(const Hit& hit) const {
  const auto& of_one = places_[hit.place].layers;
  if (!of_one) return terms_[hit.term].layers;
  LayerSet one;
  if (terms_[hit.term].layers.has(*of_one)) one.add(*of_one);
  return one;
}

std::optional<ObstacleTouch> ObstacleTest::touch_of(const DesignBox& box, const Hit& hit) const {
  const ObstacleTerm& term = terms_[hit.term].what;
  const Point& place = places_[hit.place].at;
  const PlacedJoints joints(reach_, roles_, middle_of(box), box.pole, place);
  const Complex origin = term.seen_from ? joints[*term.seen_from] : 0;
  const JointHull& hull = term.piece.hull;
  std::vector<Complex> corners;
  for (int i = 0; i < hull.count; ++i)
    corners.push_back(joints[hull.joints[static_cast<std::size_t>(i)]] - origin);
  NearestFeatures nearest{.distance = infinity};
  const FixedConvex* part = nullptr;
  for (const EncircledPart& each : scene_->shapes[term.obstacle].parts) {
    const NearestFeatures here = nearest_features(corners, each.outline.corners());
    if (here.distance < nearest.distance) nearest = here, part = &each.outline;
  }
  if (part == nullptr) return std::nullopt;
  const auto ends = [&](const auto& of, bool has_corner) {
    return has_corner ? std::array{of[nearest.corner], of[nearest.corner]}
                      : std::array{of[nearest.from], of[nearest.is_edge ? nearest.to : nearest.from]};
  };
  return ObstacleTouch{place,
                       term.seen_from,
                       nearest.corner_of_first,
                       nearest.is_edge,
                       ends(hull.joints, nearest.corner_of_first),
                       ends(part->corners(), !nearest.corner_of_first),
                       nearest.side,
                       term.piece.half_width + clearance_ - gap_rounding(term, joints)};
}

/// One box, place by place.
struct ObstacleTest::Look {
  const ObstacleTest& test;
  const DesignBox& box;
  LayerSet& alive;
  LogLengths middle{};
  SideLengths sides{};
  double nearest = infinity;  ///< mm, of a gap with what the joints move added
  std::optional<Hit> hit{};
  double deepest = 0;  ///< overlap that was found, as a share of what its joints move
  double moved = 0;    ///< mm, the most that joints were found to move; infinite where that could not be said
  PlacesWithTerms seen{};  ///< what was looked at
  std::vector<double>
      gaps{};  ///< mm beyond the clearance, of each term that was; where there is more, a lower bound

  Look(const ObstacleTest& of, const DesignBox& all, LayerSet& left) : test(of), box(all), alive(left) {
    middle = test.middle_of(box);
    sides = test.reach_.sides(middle);
  }

  PlacedJoints joints_at(std::size_t place) const {
    return {test.reach_, test.roles_, middle, sides, box.pole, test.places_[place].at};
  }

  std::optional<JointMoves> moved_at(std::size_t place, const PlacedJoints& joints,
                                     std::optional<Joint> seen_from) {
    const auto moves = test.moving_.at_most(box, test.places_[place].at, joints.all(), seen_from);
    moved = moves ? std::max(moved, *std::max_element(moves->begin(), moves->end())) : infinity;
    return moves;
  }

  /// To first order; `spreads`: at this place, once they are known.
  bool is_hit_all_over(std::size_t place, const Term& term, double rounding,
                       std::optional<std::optional<JointSpreads>>& spreads) const {
    if (!spreads)
      spreads = test.moving_.spread(box, test.places_[place].at, test.usable_, term.what.seen_from);
    return *spreads && test.is_hit_all_over(term, **spreads, rounding);
  }

  /// True if the box is so large that at a place nothing can be said of other terms than those of the copy.
  bool is_too_large_at(std::size_t place) const {
    return !test.moving_.at_most(box, test.places_[place].at, joints_at(place).all());
  }

  /// Rules out what is hit at a place. `only_the_copy`: the box is too large there.
  void at(std::size_t place, std::span<const std::uint32_t> terms, bool only_the_copy = false) {
    const auto& of_one = test.places_[place].layers;
    if (of_one && !alive.has(*of_one)) return;
    const PlacedJoints joints = joints_at(place);
    std::array<std::optional<JointMoves>, 1 + all_joints.size()>
        moves;  // as seen from the table and from each joint
    std::array<std::optional<std::optional<JointSpreads>>, 1 + all_joints.size()> spreads;
    bool is_reached = !only_the_copy;
    seen.places.push_back({place, seen.terms.size(), 0});
    for (const std::uint32_t i : terms) {
      const Term& term = test.terms_[i];
      if (of_one ? !term.layers.has(*of_one) : !term.layers.meets(alive)) continue;
      if (!is_reached && !term.is_of_the_copy) {
        note(i, -infinity);
        continue;
      }
      const double clearance = test.clearance_;
      const double gap = obstacle_gap(term.what, test.scene_->shapes[term.what.obstacle], joints,
                                      clearance);  // exact below it
      note(i, gap - clearance);
      if (gap >= clearance) continue;
      double here = 0;
      if (term.is_of_the_copy) {
        here =
            moved_of(term.what, copying_joints_move_at_most(test.mode_, test.k_, box, test.places_[place].at,
                                                            joints.all(), term.what.seen_from));
      } else {
        auto& seen_moves = moves[frame_of(term.what)];
        if (!seen_moves) is_reached = (seen_moves = moved_at(place, joints, term.what.seen_from)).has_value();
        if (!is_reached) continue;
        here = moved_of(term.what, *seen_moves);
      }
      deepest = std::max(deepest, (clearance - gap) / here);
      const double rounding = test.gap_rounding(term.what, joints);
      if (gap + here + rounding < clearance ||
          (!term.is_of_the_copy && gap + share_of_moves * here < clearance &&
           is_hit_all_over(place, term, rounding, spreads[frame_of(term.what)]))) {
        hit = Hit{place, i};
        nearest = -infinity;
        of_one ? alive.remove(*of_one) : alive.remove(term.layers);
        if (of_one || alive.empty()) return;
      } else if (gap + here < nearest) {
        nearest = gap + here;
        hit = Hit{place, i};
      }
    }
  }

  void note(std::uint32_t term, double gap) {
    seen.terms.push_back(term);
    gaps.push_back(gap);
    ++seen.places.back().terms;
  }

  /// What was looked at and is nearer than `reach` (mm), beyond the clearance.
  PlacesWithTerms nearer_than(double reach) const {
    PlacesWithTerms near;
    for (const PlacesWithTerms::Place& place : seen.places) {
      const std::size_t first = near.terms.size();
      for (std::size_t i = place.first; i < place.first + place.terms; ++i)
        if (gaps[i] < reach) near.terms.push_back(seen.terms[i]);
      if (near.terms.size() > first) near.places.push_back({place.number, first, near.terms.size() - first});
    }
    return near;
  }
};

LayerSet ObstacleTest::not_hit(const DesignBox& box, LayerSet alive, Sight& sight, bool only_hit) const {
  if (sight.hit) {
    Look look(*this, box, alive);
    look.at(sight.hit->place, std::span(all_terms_).subspan(sight.hit->term, 1));
    if (look.hit) sight.hit = look.hit;
  }
  if (!only_hit && sight.rests > 0 && alive.has(sight.layers)) {
    --sight.rests;
    return alive;
  }
  while (!only_hit && !alive.empty() && !stop_()) {
    const std::size_t one = alive.first();
    if (sight.layers != one) sight = {sight.hit, {}, 0, one};
    if (look_all_over(box, one, sight)) break;
    if (places_[sight.hit->place].layers)
      alive.remove(one);
    else
      alive.remove(terms_[sight.hit->term].layers);
  }
  return alive;
}

bool ObstacleTest::look_all_over(const DesignBox& box, std::size_t one, Sight& sight) const {
  LayerSet alive;
  alive.add(one);
  Look look(*this, box, alive);
  std::optional<bool> may_be_too_large;
  const auto look_at = [&](std::size_t place, std::span<const std::uint32_t> terms) {
    if (alive.empty() || stop_()) return;
    if (!may_be_too_large) may_be_too_large = look.is_too_large_at(place);
    look.at(place, terms, *may_be_too_large && look.is_too_large_at(place));
  };
  if (sight.near)
    for (const PlacesWithTerms::Place& place : sight.near->places)
      look_at(place.number, sight.near->at(place));
  for (std::size_t place = sight.judged; place < places_.size(); ++place) look_at(place, all_terms_);
  if (look.hit) sight.hit = look.hit;
  if (!alive.empty()) judge(look, sight);
  sight.rests = look.deepest < hopeless_share ? splits_at_rest : 0;
  return !alive.empty();
}

/// Keeps the places where an obstruction can be hit in a part of the box, and the terms. That joints move alike at all places is not certain,
/// but what is left out can only make the bound looser.
void ObstacleTest::judge(Look& look, Sight& sight) const {
  if (look.seen.places.empty() || stop_()) return;
  if (const std::size_t first = look.seen.places.front().number; look.moved == 0)
    look.moved_at(first, look.joints_at(first), std::nullopt);
  if (!(look.moved < infinity)) return;
  sight.near = std::make_shared<const PlacesWithTerms>(look.nearer_than(moves_of_others * look.moved));
  sight.judged = places_.size();
}

void ObstacleTest::demand_more(double margin, const std::vector<Point>& places) {
  clearance_ += margin;
  for (const Point& place : places) places_.push_back({place});
}

/// One design, wherever its tracer is.
struct ObstacleTest::Design {
  LogLengths lengths;
  SideLengths sides;
  Point pole;
};

/// One of the many places, and the terms that may be hit there.
struct ObstacleTest::Doubt {
  std::size_t place;
  std::shared_ptr<const TermNumbers> terms;
};

/// Of the terms those that are not surely `gap` (mm) apart from every place of the group; null if there are none.
std::shared_ptr<const ObstacleTest::TermNumbers> ObstacleTest::may_be_nearer(const Design& design,
                                                                             const PlaceGroup& group,
                                                                             const TermNumbers& terms,
                                                                             double gap) const {
  const PlacedJoints joints(reach_, roles_, design.lengths, design.sides, design.pole, group.centre);
  std::array<std::optional<JointMoves>, all_joints.size()> moves;  // as seen from each joint
  const auto may_be = [&](std::uint32_t i) {
    const ObstacleTerm& term = terms_[i].what;
    const Joint seen_from = term.seen_from.value_or(roles_.pole);
    auto& seen = moves[static_cast<std::size_t>(seen_from)];
    if (!seen) seen = moving_.beside(std::exp(design.lengths.u), joints.all(), group.radius, seen_from);
    const double enough = gap + moved_of(term, *seen) + 2 * gap_rounding(term, joints);
    return !(obstacle_gap(term, scene_->shapes[term.obstacle], joints, enough, Beyond::anything) >= enough);
  };
  auto left = std::make_shared<TermNumbers>();
  std::copy_if(terms.begin(), terms.end(), std::back_inserter(*left), may_be);
  return left->empty() ? nullptr : std::move(left);
}

/// The many places in their order, without those at which surely nothing is hit.
std::vector<ObstacleTest::Doubt> ObstacleTest::where_it_may_be_hit(const Design& design,
                                                                   std::size_t layers) const {
  std::vector<Doubt> doubts;
  if (scene_->groups.groups.empty()) return doubts;
  using Terms = std::shared_ptr<const TermNumbers>;
  auto all = std::make_shared<TermNumbers>();
  std::copy_if(all_terms_.begin(), all_terms_.end(), std::back_inserter(*all),
               [&](std::uint32_t i) { return terms_[i].layers.has(layers); });
  const auto left_of = [&](const PlaceGroup& group, const Terms& terms) -> Terms {
    return stop_() ? nullptr : may_be_nearer(design, group, *terms, clearance_);
  };
  descend(scene_->groups, 0, Terms(std::move(all)), left_of, [&](std::size_t place, const Terms& terms) {
    doubts.push_back({place, terms});
    return true;
  });
  std::sort(doubts.begin(), doubts.end(),
            [](const Doubt& one, const Doubt& other) { return one.place < other.place; });
  return doubts;
}

bool ObstacleTest::is_clear(double VA, double VB, const Point& pole, std::size_t layers,
                            const std::optional<Hit>& first, LayerSet& left) {
  const LogLengths lengths{std::log(VA), std::log(VB)};
  const Design design{lengths, reach_.sides(lengths), pole};
  const auto is_hit = [&](const Term& term, const PlacedJoints& joints) {
    return obstacle_gap(term.what, scene_->shapes[term.what.obstacle], joints, clearance_, Beyond::anything) <
           clearance_;
  };
  const auto joints_at = [&](const Point& place) {
    return PlacedJoints(reach_, roles_, lengths, design.sides, pole, place);
  };
  const auto is_kept = [&](const Place& place) {
    if (place.layers && *place.layers != layers) return true;
    if (stop_()) return false;
    const PlacedJoints joints = joints_at(place.at);
    const auto hit = std::find_if(terms_.begin(), terms_.end(), [&](const Term& term) {
      return term.layers.has(layers) && is_hit(term, joints);
    });
    if (hit != terms_.end() && !place.layers) left.remove(hit->layers);
    return hit == terms_.end();
  };
  if (first && !is_kept(places_[first->place])) return false;
  if (last_hit_ < places_.size() && !is_kept(places_[last_hit_])) return false;
  const auto lost = std::find_if_not(places_.begin(), places_.end(), is_kept);
  if (lost != places_.end()) {
    last_hit_ = static_cast<std::size_t>(lost - places_.begin());
    return false;
  }
  for (const Doubt& doubt : where_it_may_be_hit(design, layers)) {
    if (stop_()) return false;
    const Point& place = scene_->many_places[doubt.place];
    const PlacedJoints joints = joints_at(place);
    const auto hit = std::find_if(doubt.terms->begin(), doubt.terms->end(),
                                  [&](std::size_t i) { return is_hit(terms_[i], joints); });
    if (hit == doubt.terms->end()) continue;
    left.remove(terms_[*hit].layers);
    if (places_.size() < most_places) places_.push_back({place});
    return false;
  }
  return !stop_();
}

void ObstacleTest::look_further(const DesignBox& box, const LayerSet& alive) {
  if (places_.size() >= most_places || scene_->groups.groups.empty() || stop_()) return;
  const LogLengths lengths = middle_of(box);
  const Design middle{lengths, reach_.sides(lengths), box.pole};
  using Terms = std::shared_ptr<const TermNumbers>;
  const auto depth_at = [&](const Point& place, const TermNumbers& terms) {
    const PlacedJoints joints(reach_, roles_, lengths, middle.sides, box.pole, place);
    double deepest = 0;
    for (const std::uint32_t i : terms) {
      const ObstacleTerm& term = terms_[i].what;
      deepest = std::max(deepest, clearance_ - obstacle_gap(term, scene_->shapes[term.obstacle], joints,
                                                            clearance_, Beyond::anything));
    }
    return deepest;
  };
  auto counting = std::make_shared<TermNumbers>();
  std::copy_if(all_terms_.begin(), all_terms_.end(), std::back_inserter(*counting),
               [&](std::uint32_t i) { return terms_[i].layers.meets(alive); });
  double deepest = 0;
  for (const Place& place : places_) deepest = std::max(deepest, 2 * depth_at(place.at, *counting));
  std::optional<std::size_t> found;  // of equally deep ones the first
  const auto may_be_deeper = [&](const PlaceGroup& group, const Terms& terms) -> Terms {
    return may_be_nearer(middle, group, *terms, clearance_ - deepest);
  };
  descend(scene_->groups, 0, Terms(std::move(counting)), may_be_deeper,
          [&](std::size_t place, const Terms& terms) {
            const double depth = depth_at(scene_->many_places[place], *terms);
            if (depth > deepest || (found && depth == deepest && place < *found))
              deepest = depth, found = place;
            return true;
          });
  if (found) places_.push_back({scene_->many_places[*found]});
}

void ObstacleTest::add_place(const Point& place, std::size_t layers) { places_.push_back({place, layers}); }

}  // namespace kempe::bounding
