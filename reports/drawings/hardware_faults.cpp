#include "reports/drawings/hardware_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reports/drawings/joint_stack.hpp"
#include "specs/text/printable.hpp"
#include "synthesis/verification/stations.hpp"
#include "workspace/contact/gap.hpp"
#include "workspace/obstacle_names.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// Heads, washers and nuts, and the end of a screw or pin above them.
std::vector<StackItem> standing_out(const JointStack& stack) {
  std::vector<StackItem> items;
  double top = stack.to;
  for (const StackItem& item : stack.items) {
    top = std::max(top, item.to);
    if (item.kind != StackItem::Kind::link && item.kind != StackItem::Kind::spacer) items.push_back(item);
  }
  if (stack.fastener && stack.fastener->end() > top)
    items.push_back({StackItem::Kind::nut, "its end", top, stack.fastener->end(), stack.diameter});
  return items;
}

/// How far a stack's head, washers or nut reach from its axis in heights that an item of another shares, and that item.
std::optional<std::string> meeting(const Design& design, const JointStack& one, const JointStack& other) {
  const double apart = least_distance(design, one.joint, other.joint);
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

/// Heights above the lower side of layer 1, mm.
struct Heights {
  double from, to;
};
bool overlap(const Heights& one, const Heights& other) { return one.from < other.to && other.from < one.to; }

Heights heights_of(int layer, double thickness) { return {(layer - 1) * thickness, layer * thickness}; }

/// What begins in layer 1 goes down to the table, also where the linkage is raised; what ends in the highest layer goes up without end.
Heights heights_of(int lowest, int highest, double thickness) {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {lowest == 1 ? -far : (lowest - 1) * thickness, highest == most_layers ? far : highest * thickness};
}

/// How near a round thing on a joint comes to a link that lacks the joint, over the openings shown; mm, negative: it meets it.
double gap_from_link(const Design& design, Joint joint, double diameter, Link link) {
  LinkStyle style = design.style;
  style.pin_diameter = diameter;
  const ContactPair pair{Part{.kind = Part::Kind::pin, .joint = joint}, Part{.link = link}};
  return smallest_gap_over(design.linkage, style, std::vector{pair}, openings_to_show(design)).gap;
}

void tell_links_beside(const Design& design, const JointStack& stack, std::vector<std::string>& faults) {
  for (const StackItem& item : standing_out(stack))
    for (const Link link : all_links) {
      const int layer = design.layers[link];
      if (!overlap({item.from, item.to}, heights_of(layer, design.style.thickness))) continue;
      const double gap = gap_from_link(design, stack.joint, item.diameter, link);
      if (gap < design.limits.clearance)
        faults.push_back(
            fmt::format("{}: {} of {:.9g} mm stands in layer {} and comes within {:.2f} mm of link {}; "
                        "clearance is {:.9g} mm",
                        stack.name, item.name, item.diameter, layer, std::max(gap, 0.0), name(link),
                        design.limits.clearance));
    }
}

/// Bodies are taken for discs as large as they reach: what is told may still be clear, what is not told is.
void tell_bodies_beside(const Design& design, const JointStack& stack, std::vector<std::string>& faults) {
  for (std::size_t i = 0; i < design.bodies.size(); ++i) {
    const Body& body = design.bodies[i];
    const Joint carrier = joint_of(body.at, design.linkage);
    const double apart = least_distance(design, stack.joint, carrier), reach = farthest(body);
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

/// The places of a joint with the tracer at those of the region that the verification drives to.
std::vector<Point> places_of(const Design& design, Joint joint) {
  std::vector<Point> places;
  if (design.region.empty()) return places;
  for (const Point& tracer : stations_over(design.region, design.linkage.pole(), {}))
    if (const auto opening = design.linkage.opening_at(tracer.norm()))
      places.push_back(design.linkage.pose_at(*opening, std::atan2(tracer.y(), tracer.x()))[joint]);
  return places;
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
  std::vector<Point> places;
  for (std::size_t i = 0; i < design.obstacles.size(); ++i) {
    const Obstacle& obstacle = design.obstacles[i];
    const Heights heights = heights_of(obstacle.lowest_layer, obstacle.highest_layer, design.style.thickness);
    for (const StackItem& item : standing_out(stack)) {
      if (!overlap({item.from + raised, item.to + raised}, heights) ||
          link_answers(design, stack, item, obstacle))
        continue;
      if (places.empty()) places = places_of(design, stack.joint);
      double gap = std::numeric_limits<double>::infinity();
      for (const Point& place : places)
        gap = std::min(gap, distance(Region{{obstacle.shape}}, place) - 0.5 * item.diameter);
      if (gap < design.limits.clearance)
        faults.push_back(
            fmt::format("{}: {} of {:.9g} mm comes within {:.2f} mm of {}; clearance is {:.9g} mm",
                        stack.name, item.name, item.diameter, std::max(gap, 0.0),
                        printable(obstacle_name(design.obstacles, i)), design.limits.clearance));
    }
  }
}

/// Contact with obstacles is certified for a linkage that lies on the table.
void tell_raised(const Design& design, double raised, std::vector<std::string>& faults) {
  for (std::size_t i = 0; raised > 0 && i < design.obstacles.size(); ++i)
    if (design.obstacles[i].lowest_layer > 1)
      faults.push_back(fmt::format(
          "layer 1 stands {:.9g} mm above the table, for the heads under it: {} must stand so much "
          "higher too, since it begins in layer {}",
          raised, printable(obstacle_name(design.obstacles, i)), design.obstacles[i].lowest_layer));
}

}  // namespace

double least_distance(const Design& design, Joint one, Joint other) {
  const Complex s = design.linkage.shape();
  const auto from = linkage_point(one, s), to = linkage_point(other, s);
  const Complex along_p = design.linkage.VA() * (to.of_p - from.of_p),
                along_q = design.linkage.VB() * (to.of_q - from.of_q);
  const OpeningInterval openings = openings_to_show(design);
  const auto at = [&](double opening) { return std::abs(along_p + along_q * std::polar(1.0, opening)); };
  // |u + v e^id| falls until v e^id points against u and grows from there.
  const double opposite = std::arg(-along_p * std::conj(along_q));
  double least = std::min(at(openings.lower), at(openings.upper));
  for (const double turn : {opposite - 2 * pi, opposite, opposite + 2 * pi})
    if (openings.lower < turn && turn < openings.upper) least = std::min(least, at(turn));
  return least;
}

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
