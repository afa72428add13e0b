#include "workspace/contact/layer_demands.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "workspace/contact/self_contact.hpp"

namespace kempe {
namespace {

constexpr std::size_t first_joint = all_links.size();

std::size_t member_of(const Part& part) {
  return part.kind == Part::Kind::link ? static_cast<std::size_t>(part.link)
                                       : first_joint + static_cast<std::size_t>(part.joint);
}

/// Of each member those that its outline holds: itself and, of a link, the pins and posts at its joints.
std::array<LayerMembers, layer_members> held_members() {
  std::array<LayerMembers, layer_members> held;
  for (std::size_t member = 0; member < layer_members; ++member) held[member].set(member);
  for (const Link link : all_links) {
    const LinkJoints joints = joints_of(link);
    for (std::size_t i = 0; i < static_cast<std::size_t>(joints.count); ++i)
      held[static_cast<std::size_t>(link)].set(first_joint + static_cast<std::size_t>(joints.joints[i]));
  }
  return held;
}

const std::array<LayerMembers, layer_members> held_by = held_members();

/// Of each member those that are never kept apart from it: links hold their joints and share joints with their neighbours.
std::array<LayerMembers, layer_members> joined_members() {
  std::array<LayerMembers, layer_members> joined;
  for (std::size_t one = 0; one < layer_members; ++one)
    for (std::size_t other = 0; other < layer_members; ++other)
      joined[one].set(other, (held_by[one] & held_by[other]).any());
  return joined;
}

const std::array<LayerMembers, layer_members> joined_with = joined_members();

/// How long its pins at A, B, C and V and the pole's post are, in thicknesses.
std::array<int, 5> pin_lengths(const LayerAssignment& layers, Joint pole) {
  const auto apart = [&](Link one, Link other) { return std::abs(layers[one] - layers[other]); };
  std::array<int, 5> lengths{apart(Link::VA, Link::ACX), apart(Link::VB, Link::BCY),
                             apart(Link::ACX, Link::BCY)};
  if (pole == Joint::V)  // both bars turn on the post
    lengths[3] = layers[Link::VA], lengths[4] = layers[Link::VB];
  else
    lengths[3] = apart(Link::VA, Link::VB), lengths[4] = layers[Link::ACX];
  return lengths;
}

struct Candidate {
  LayerAssignment layers;
  LayerDemands implied;
};

std::vector<Candidate> candidates(const CopyingLinkage& linkage, int layers,
                                  const std::vector<Obstacle>& obstacles, const std::vector<Body>& bodies) {
  const ObstacleLayers of_obstacles(obstacles, bodies, layers);
  std::vector<Candidate> result;
  // Without obstacles and bodies links above an empty layer may move down: what shared no layer before shares none then,
  // and pins get shorter.
  const bool are_alike = of_obstacles.ranges.empty();
  for (const LayerAssignment& each : layer_assignments(are_alike ? std::min(layers, 4) : layers)) {
    if (are_alike && !each.is_stacked()) continue;
    result.push_back({each, LayerDemands(linkage, each, of_obstacles).implied()});
  }
  return result;
}

/// The layers of candidates that no other one beats; `beats` must be transitive, and of two that beat each other the
/// first stays.
template <typename Beats>
std::vector<LayerAssignment> unbeaten(const std::vector<Candidate>& all, const Beats& beats) {
  std::vector<const Candidate*> kept;
  for (const Candidate& one : all) {
    const auto beats_it = [&](const Candidate* other) { return beats(*other, one); };
    if (std::any_of(kept.begin(), kept.end(), beats_it)) continue;
    std::erase_if(kept, [&](const Candidate* other) { return beats(one, *other); });
    kept.push_back(&one);
  }
  std::vector<LayerAssignment> result;
  for (const Candidate* one : kept) result.push_back(one->layers);
  return result;
}

}  // namespace

ObstacleLayers::ObstacleLayers(const std::vector<Obstacle>& obstacles, const std::vector<Body>& bodies,
                               int layers) {
  const auto add = [&](int lowest, int highest, std::optional<Carrier> carrier = {},
                       std::optional<Link> turns_with = {}) {
    const LayerRange range{lowest, std::min(highest, layers), carrier, turns_with};
    if (range.lowest <= range.highest && std::find(ranges.begin(), ranges.end(), range) == ranges.end())
      ranges.push_back(range);
  };
  for (const Obstacle& obstacle : obstacles) add(obstacle.lowest_layer, obstacle.highest_layer);
  for (const Body& body : bodies) add(body.lowest_layer, body.highest_layer, body.at, body.turns_with);
}

LayerDemands::LayerDemands(const CopyingLinkage& linkage, const LayerAssignment& layers,
                           const ObstacleLayers& obstacles) {
  for (const ContactPair& pair : contact_pairs(linkage, layers)) {
    const std::size_t first = member_of(pair.first), second = member_of(pair.second);
    pairs_[first].set(second);
    pairs_[second].set(first);
  }
  for (const Part& part : parts_of(linkage, layers))
    for (std::size_t i = 0; i < obstacles.ranges.size(); ++i) {
      const auto& [lowest, highest, carrier, turns_with] = obstacles.ranges[i];
      const Obstruction any{
          .frame = carrier, .turns_with = turns_with, .lowest_layer = lowest, .highest_layer = highest};
      if (may_meet(part, any, linkage)) obstacles_[member_of(part)].set(i);
    }
}

LayerDemands LayerDemands::implied() const {
  LayerDemands all;
  for (std::size_t one = 0; one < layer_members; ++one) {
    LayerMembers apart;  // from this one, with what these hold
    for (std::size_t other = 0; other < layer_members; ++other)
      if (pairs_[one][other]) apart |= held_by[other];
    for (std::size_t held = 0; held < layer_members; ++held) {
      if (!held_by[one][held]) continue;
      all.obstacles_[held] |= obstacles_[one];
      all.pairs_[held] |= apart & ~joined_with[held];
    }
  }
  return all;
}

bool LayerDemands::within(const LayerDemands& other) const {
  for (std::size_t i = 0; i < layer_members; ++i)
    if ((pairs_[i] & ~other.pairs_[i]).any() || (obstacles_[i] & ~other.obstacles_[i]).any()) return false;
  return true;
}

std::vector<LayerAssignment> least_demanding_assignments(const CopyingLinkage& linkage, int layers,
                                                         const std::vector<Obstacle>& obstacles,
                                                         const std::vector<Body>& bodies) {
  return unbeaten(
      candidates(linkage, layers, obstacles, bodies),
      [](const Candidate& less, const Candidate& more) { return less.implied.within(more.implied); });
}

std::vector<LayerAssignment> assignments_worth_trying(const CopyingLinkage& linkage, int layers,
                                                      const std::vector<Obstacle>& obstacles,
                                                      const std::vector<Body>& bodies, SagCounts sag) {
  const auto is_nowhere_longer = [&](const LayerAssignment& one, const LayerAssignment& other) {
    const auto of_one = pin_lengths(one, linkage.pole_joint()),
               of_other = pin_lengths(other, linkage.pole_joint());
    return std::equal(of_one.begin(), of_one.end(), of_other.begin(), std::less_equal<int>());
  };
  return unbeaten(
      candidates(linkage, layers, obstacles, bodies), [&](const Candidate& less, const Candidate& more) {
        return less.layers.highest() <= more.layers.highest() && less.implied.within(more.implied) &&
               (sag == SagCounts::no || is_nowhere_longer(less.layers, more.layers));
      });
}

}  // namespace kempe
