#include "reports/drawings/spacers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "reports/drawings/joint_distances.hpp"
#include "specs/text/printable.hpp"
#include "workspace/obstacle_names.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// The thinnest wall of a ring, as a share of its bore: that of the thinnest bushes.
constexpr double least_wall_of_bore = 0.1;

/// Three digits, not rounded up.
double three_digits_of(double length) {
  if (!(length > 0)) return 0;
  const double step = std::pow(10.0, std::floor(std::log10(length)) - 2);
  return step * std::floor(length / step * (1 + 1e-12));
}

std::vector<Spacer> full_spacers(const Design& design, const JointStack& stack, double raised) {
  std::vector<Spacer> spacers;
  const auto add = [&](double from, double to) {
    const bool is_lowest = stack.is_post && from == 0;
    spacers.push_back({.name = fmt::format("spacer {}", letter(stack.joint)),
                       .joint = stack.joint,
                       .on = stack.name,
                       .from = is_lowest ? -raised : from,
                       .to = to,
                       .is_lowest = is_lowest,
                       .bore = stack.diameter,
                       .diameter = design.style.width});
  };
  if (stack.is_post && stack.lowest == 1 && raised > 0) add(0, 0);
  for (const StackItem& item : stack.items)
    if (item.kind == StackItem::Kind::spacer) add(item.from, item.to);
  return spacers;
}

/// Turns spacers down until they keep the clearance.
class Room {
 public:
  Room(const Design& design, const std::vector<JointStack>& stacks, double raised)
      : design_(design), stacks_(stacks), raised_(raised), openings_(openings_over_region(design)) {}

  void beside_everything(Spacer& spacer, const JointStack& stack) {
    beside_links(spacer);
    for (const JointStack& other : stacks_)
      if (other.joint != stack.joint) beside_stack(spacer, other);
    beside_obstacles(spacer, stack);
    beside_bodies(spacer, stack);
  }

  /// What two spacers leave each other: the narrower half of it, or each half where both want more.
  void beside_each_other(Spacer& one, Spacer& other) const {
    if (one.joint == other.joint || !overlap(heights(one), heights(other))) return;
    const double room =
        2 * (least_distance(design_, one.joint, other.joint, openings_) - design_.limits.clearance);
    if (one.diameter + other.diameter <= room) return;
    const double narrower = std::min({one.diameter, other.diameter, 0.5 * room});
    const bool one_is_wider = one.diameter >= other.diameter;
    const std::string name = one.name, other_name = other.name;
    turn_down(one, one_is_wider ? room - narrower : narrower, other_name);
    turn_down(other, one_is_wider ? narrower : room - narrower, name);
  }

 private:
  static Heights heights(const Spacer& spacer) { return {spacer.from, spacer.to}; }

  static void turn_down(Spacer& spacer, double room, const std::string& passing) {
    if (room >= spacer.diameter) return;
    spacer.diameter = three_digits_of(room);
    spacer.passing = passing;
  }
  /// `distance`: of what passes from the axis, mm.
  void keep_clear(Spacer& spacer, double distance, const std::string& passing) const {
    turn_down(spacer, 2 * (distance - design_.limits.clearance), passing);
  }

  void beside_links(Spacer& spacer) const {
    for (const Link link : all_links)
      if (!has_joint(link, spacer.joint) &&
          overlap(heights(spacer), heights_of(design_.layers[link], design_.style.thickness)))
        keep_clear(spacer, distance_from_link(design_, spacer.joint, link, openings_),
                   fmt::format("link {}", name(link)));
  }

  void beside_stack(Spacer& spacer, const JointStack& other) const {
    const double apart = least_distance(design_, spacer.joint, other.joint, openings_);
    const Heights gripped{other.is_post ? -raised_ : other.from, other.to};
    if (overlap(heights(spacer), gripped)) keep_clear(spacer, apart - 0.5 * other.diameter, other.name);
    for (const StackItem& item : standing_out(other))
      if (overlap(heights(spacer), {item.from, item.to}))
        keep_clear(spacer, apart - 0.5 * item.diameter, fmt::format("{} of {}", item.name, other.name));
  }

  /// True if the certified contact of one of the joint's own links, within whose outline a spacer lies, answers for what stands in
  /// these layers.
  template <class MayMeet>
  bool is_answered(const JointStack& stack, int lowest, int highest, const MayMeet& may_meet) const {
    return std::any_of(stack.links.begin(), stack.links.end(), [&](Link link) {
      return lowest <= design_.layers[link] && design_.layers[link] <= highest && may_meet(link);
    });
  }

  /// Obstacles stand on the table.
  void beside_obstacles(Spacer& spacer, const JointStack& stack) {
    for (std::size_t i = 0; i < design_.obstacles.size(); ++i) {
      const Obstacle& obstacle = design_.obstacles[i];
      if (!overlap({spacer.from + raised_, spacer.to + raised_},
                   heights_of(obstacle.lowest_layer, obstacle.highest_layer, design_.style.thickness)) ||
          is_answered(stack, obstacle.lowest_layer, obstacle.highest_layer, [](Link) { return true; }))
        continue;
      double least = std::numeric_limits<double>::infinity();
      for (const Pose& pose : poses())
        least = std::min(least, distance(Region{{obstacle.shape}}, pose[stack.joint]));
      keep_clear(spacer, least, printable(obstacle_name(design_.obstacles, i)));
    }
  }

  /// A body that the joint itself carries sits on its post.
  void beside_bodies(Spacer& spacer, const JointStack& stack) {
    for (std::size_t i = 0; i < design_.bodies.size(); ++i) {
      const Body& body = design_.bodies[i];
      const Joint carrier = joint_of(body.at, design_.linkage);
      if (carrier == stack.joint ||
          !overlap(heights(spacer),
                   heights_of(body.lowest_layer, body.highest_layer, design_.style.thickness)) ||
          is_answered(stack, body.lowest_layer, body.highest_layer,
                      [&](Link link) { return !has_joint(link, carrier); }))
        continue;
      double least = std::numeric_limits<double>::infinity();
      for (const Pose& pose : poses()) least = std::min(least, distance_to(body, pose, stack.joint));
      keep_clear(spacer, least, printable(body_name(design_.bodies, i)));
    }
  }

  double distance_to(const Body& body, const Pose& pose, Joint joint) const {
    const std::variant<Disc, Polygon> shape = placed(body, design_.linkage, pose);
    if (const auto* disc = std::get_if<Disc>(&shape))
      return (pose[joint] - disc->centre).norm() - disc->radius;
    return distance(Region{{std::get<Polygon>(shape)}}, pose[joint]);
  }

  const std::vector<Pose>& poses() {
    if (poses_.empty()) poses_ = poses_over_region(design_);
    return poses_;
  }

  const Design& design_;
  const std::vector<JointStack>& stacks_;
  double raised_;
  OpeningInterval openings_;
  std::vector<Pose> poses_{};
};

}  // namespace

bool Spacer::has_room() const { return passing.empty() || diameter >= (1 + 2 * least_wall_of_bore) * bore; }

std::string words_on(const Spacer& spacer) {
  if (spacer.passing.empty()) return "";
  if (spacer.has_room())
    return fmt::format("turn it down to {:.9g} mm, {} passes", spacer.diameter, spacer.passing);
  const std::string none = fmt::format("no room for a ring, {} passes too near: ", spacer.passing);
  if (spacer.diameter > spacer.bore)
    return none + fmt::format("make {} of one piece with a collar of {:.9g} mm", spacer.on, spacer.diameter);
  return none + fmt::format("fix the links at their heights on {}", spacer.on);
}

std::vector<std::vector<Spacer>> spacers_of(const Design& design, const std::vector<JointStack>& stacks) {
  const double raised = raised_by(stacks);
  Room room(design, stacks, raised);
  std::vector<std::vector<Spacer>> spacers;
  std::vector<Spacer*> all;
  for (const JointStack& stack : stacks) spacers.push_back(full_spacers(design, stack, raised));
  for (std::size_t i = 0; i < stacks.size(); ++i)
    for (Spacer& spacer : spacers[i]) {
      room.beside_everything(spacer, stacks[i]);
      all.push_back(&spacer);
    }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) room.beside_each_other(*all[j], *all[i]);
  return spacers;
}

}  // namespace kempe
