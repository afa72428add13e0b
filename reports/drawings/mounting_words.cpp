#include "reports/drawings/mounting_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/drawings/joint_distances.hpp"
#include "specs/text/printable.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// "; link ACX, in layer 3, comes within 0.20 mm of a post there": of one as thick as the stack's pin.
std::string links_in_the_way(const Design& design, const Body& body, const JointStack& stack) {
  std::string text;
  for (const Link link : all_links) {
    const int layer = design.layers[link];
    if (layer <= stack.highest || layer >= body.lowest_layer) continue;
    const double gap =
        distance_from_link(design, stack.joint, link, openings_over_region(design)) - 0.5 * stack.diameter;
    if (gap >= design.limits.clearance) continue;
    text += fmt::format(
        "; link {}, in layer {}, {}", name(link), layer,
        gap > 0 ? fmt::format("comes within {:.2f} mm of a post there", gap) : "passes through a post there");
  }
  return text;
}

}  // namespace

double height_above(const Design& design, const Body& body, const JointStack& stack) {
  if (joint_of(body.at, design.linkage) != stack.joint) return 0;
  return std::max(0, body.lowest_layer - 1 - stack.highest) * design.style.thickness;
}

std::vector<std::string> mounting_words(const Design& design) {
  std::vector<std::string> words;
  for (const JointStack& stack : joint_stacks(design))
    for (std::size_t i = 0; stack.is_post && i < design.bodies.size(); ++i) {
      const Body& body = design.bodies[i];
      const double height = height_above(design, body, stack);
      if (height == 0) continue;
      words.push_back(fmt::format(
          "what carries {} is not in the proof of contact: it begins {:.6g} mm above the links at {}{}",
          printable(body_name(design.bodies, i)), height, stack.name, links_in_the_way(design, body, stack)));
    }
  return words;
}

}  // namespace kempe
