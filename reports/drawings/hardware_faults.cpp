#include "reports/drawings/hardware_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reports/drawings/joint_distances.hpp"
#include "reports/drawings/joint_stack.hpp"
#include "specs/text/printable.hpp"
#include "workspace/obstacle_names.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// "comes within 0.30 mm of link VA", "hits link VA, by up to 0.30 mm", or where the overlap is not known (0) "hits link VA"; `gap` in mm.
std::string nearness_words(double gap, const std::string& what) {
  if (gap > 0) return fmt::format("comes within {:.2f} mm of {}", gap, what);
  return "hits " + what + (gap < 0 ? fmt::format(", by up to {:.2f} mm", -gap) : "");
}

/// How far a stack's head, washers or nut reach from its axis in heights that an item of another shares, and that item.
std::optional<std::string> meeting(const Design& design, const JointStack& one, const JointStack& other) {
  const double apart = least_distance(design, one.joint, other.joint, openings_to_show(design));
  const auto sentence = [&](const StackItem& item, const std::string& what, double needed) {
    return fmt::format("{} and {} come within {:.2f} mm of each other: {} of {:.9g} mm and {} need {:.2f} mm",
                       one.name, other.name, apart, item.name, item.diameter, what, needed);
  };
  const auto others = standing_out(other);
  for (const StackItem& item : standing_out(one)) {
    if (other.is_post && item.from < other.to) {
      const double needed = 0.5 * (item.diameter + other.diameter);
      if (apart < needed) return sentence(item, "the post", needed);
    }
    for (const StackItem& beside : others) {
      const double needed = 0.5 * (item.diameter + beside.diameter);
      if (item.from < beside.to && beside.from < item.to && apart < needed)
        return sentence(item, beside.name, needed);
    }
  }
  return std::nullopt;
}

void tell_links_beside(const Design& design, const JointStack& stack, std::vector<std::string>& faults) {
  for (const StackItem& item : standing_out(stack))
    for (const Link link : all_links) {
      const int layer = design.layers[link];
      if (!overlap({item.from, item.to}, heights_of(layer, design.style.thickness))) continue;
      const auto gap_over = [&](const OpeningInterval& openings) {
        return distance_from_link(design, stack.joint, link, openings) - 0.5 * item.diameter;
      };
      const double in_region = gap_over(openings_over_region(design)),
                   anywhere = gap_over(openings_to_show(design));
      const bool outside_alone = in_region >= design.limits.clearance;
      const double gap = outside_alone ? anywhere : in_region;
      if (gap < design.limits.clearance)
        faults.push_back(fmt::format(
            "{}: {} of {:.9g} mm stands in layer {} and {}{}; clearance is {:.9g} mm", stack.name, item.name,
            item.diameter, layer, nearness_words(gap, fmt::format("link {}", name(link))),
            outside_alone ? ", with the tracer outside the region" : "", design.limits.clearance));
    }
}

/// Bodies are taken for discs as large as they reach: what is told may still be clear, what is not told is.
void tell_bodies_beside(const Design& design, const JointStack& stack, std::vector<std::string>& faults) {
  for (std::size_t i = 0; i < design.bodies.size(); ++i) {
    const Body& body = design.bodies[i];
    const Joint carrier = joint_of(body.at, design.linkage);
    const double apart = least_distance(design, stack.joint, carrier, openings_to_show(design)),
                 reach = farthest(body);
    for (const StackItem& item : standing_out(stack))
      if (overlap({item.from, item.to},
                  heights_of(body.lowest_layer, body.highest_layer, design.style.thickness)) &&
          apart < reach + 0.5 * item.diameter + design.limits.clearance)
        faults.push_back(
            fmt::format("{}: {} of {:.9g} mm may come too near to {}, which reaches {:.2f} mm from {}; "
                        "the two joints come within {:.2f} mm of each other",
                        stack.name, item.name, item.diameter, printable(body_name(design.bodies, i)), reach,
                        letter(carrier), apart));
  }
}

/// True if the certified contact of one of its own links with the obstacle answers for an item: it lies within that link's outline.
bool link_answers(const Design& design, const JointStack& stack, const StackItem& item,
                  const Obstacle& obstacle) {
  return item.diameter <= design.style.width &&
         std::any_of(stack.links.begin(), stack.links.end(), [&](Link link) {
           const int layer = design.layers[link];
           return obstacle.lowest_layer <= layer && layer <= obstacle.highest_layer;
         });
}

/// Obstacles stand on the table, the linkage `raised` above it.
void tell_obstacles_beside(const Design& design, const JointStack& stack, double raised,
                           std::vector<std::string>& faults) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < design.obstacles.size(); ++i) {
    const Obstacle& obstacle = design.obstacles[i];
    const Heights heights = heights_of(obstacle.lowest_layer, obstacle.highest_layer, design.style.thickness);
    for (const StackItem& item : standing_out(stack)) {
      if (!overlap({item.from + raised, item.to + raised}, heights) ||
          link_answers(design, stack, item, obstacle))
        continue;
      if (poses.empty()) poses = poses_over_region(design);
      double gap = std::numeric_limits<double>::infinity();
      for (const Pose& pose : poses)
        gap = std::min(gap, distance(Region{{obstacle.shape}}, pose[stack.joint]) - 0.5 * item.diameter);
      if (gap < design.limits.clearance)
        faults.push_back(fmt::format(
            "{}: {} of {:.9g} mm {}; clearance is {:.9g} mm", stack.name, item.name, item.diameter,
            nearness_words(std::max(gap, 0.0), printable(obstacle_name(design.obstacles, i))),
            design.limits.clearance));
    }
  }
}

/// Contact with obstacles is certified for a linkage that lies on the table.
void tell_raised(const Design& design, double raised, std::vector<std::string>& faults) {
  for (std::size_t i = 0; raised > 0 && i < design.obstacles.size(); ++i)
    if (design.obstacles[i].lowest_layer > 1)
      faults.push_back(fmt::format("{}: {} must stand so much higher too, since it begins in layer {}",
                                   lowest_layer_words(raised), printable(obstacle_name(design.obstacles, i)),
                                   design.obstacles[i].lowest_layer));
}

}  // namespace

std::vector<std::string> hardware_faults(const Design& design) {
  std::vector<std::string> faults;
  if (design.hardware.none()) return faults;
  const auto stacks = joint_stacks(design);
  const double raised = raised_by(stacks);
  tell_raised(design, raised, faults);
  for (std::size_t i = 0; i < stacks.size(); ++i) {
    if (stacks[i].is_post) continue;
    const std::string& hardware = design.hardware[stacks[i].joint];
    if (!stacks[i].fastener && !hardware.empty())
      faults.push_back(fmt::format("{}: no \"{}\" is made that grips {:.9g} mm", stacks[i].name, hardware,
                                   stacks[i].grip()));
    tell_links_beside(design, stacks[i], faults);
    tell_bodies_beside(design, stacks[i], faults);
    tell_obstacles_beside(design, stacks[i], raised, faults);
    for (std::size_t j = i + 1; j < stacks.size(); ++j)
      if (auto fault = meeting(design, stacks[i], stacks[j])) faults.push_back(std::move(*fault));
  }
  return faults;
}

}  // namespace kempe
