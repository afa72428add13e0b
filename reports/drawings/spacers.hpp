#pragma once
// The rings that fill empty layers, and how wide each may be: contact is certified for the pins and posts in them alone.

#include <string>
#include <vector>

#include "reports/drawings/joint_stack.hpp"

namespace kempe {

/// A ring on a pin or post, as wide as a link, or as narrow as what passes beside it asks for.
struct Spacer {
  std::string name;  ///< "spacer V"
  Joint joint;
  std::string on;  ///< "pole post V"
  double from,
      to;  ///< mm above the lower side of layer 1; of one on the table negative where the linkage is raised
  bool is_lowest = false;  ///< stands on the table, under the lowest link of a post
  double bore;             ///< mm, of the pin or post
  double diameter;         ///< mm, outer: that of the links, or less where something passes
  std::string passing{};   ///< what a ring as wide as the links would meet: "link VB"; empty: nothing
  double height() const { return to - from; }
  /// False where what passes leaves no room for a wall around the bore; `diameter` is then what there is room for.
  bool has_room() const;
};

/// What a spacer must heed where something passes: "turn it down to 28.3 mm, link VB passes", or that there is no room for a ring, and what
/// to do instead; empty where nothing passes.
std::string words_on(const Spacer& spacer);

/// The spacers of every stack of joint_stacks(), from below; where the linkage is raised those under the lowest links too. Each keeps
/// `limits.clearance` from links, pins, posts, heads, nuts and other spacers, exactly over the openings that the region needs; from obstacles and bodies
/// that no certified contact answers for at the places of the region that the verification drives to.
std::vector<std::vector<Spacer>> spacers_of(const Design& design, const std::vector<JointStack>& stacks);

}  // namespace kempe
