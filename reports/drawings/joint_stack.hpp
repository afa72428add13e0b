#pragma once
// What stands on each joint, layer by layer: the one home of "which layers does this pin pass, what fills them, and which
// screw is long enough".

#include <optional>
#include <string>
#include <vector>

#include "specs/hardware.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// One thing on a pin or post. Heights in mm above the lower side of layer 1 (layer n lies between n - 1 and n thicknesses);
/// negative below it.
struct StackItem {
  enum class Kind {
    link,
    spacer,  ///< fills empty layers
    head,    ///< of a screw
    washer,  ///< under head or nut
    shim,    ///< fills what a shoulder is longer than the links are thick
    nut
  } kind;
  std::string name;  ///< "VA", "spacer V", "washer ISO 7089 6"
  double from, to;   ///< mm, from < to
  double diameter;   ///< mm, outer; of a link its width, of a nut over its corners
};

/// A screw, shoulder screw or parallel pin of a commercial length.
struct Fastener {
  std::string name;  ///< "screw ISO 4762 M6 x 25"
  double length;     ///< mm: under the head; of a shoulder screw its shoulder; of a parallel pin all
  double from, to;   ///< mm, heights of that length
  double play = 0;   ///< mm, along the axis: what shims leave of a shoulder
  double thread = 0,
         thread_length =
             0;  ///< mm, diameter and length of what goes on above `to`: the thread of a shoulder screw
  double end() const { return to + thread_length; }
};

/// A pin (A, B, C: it joins two links) or a post (pole, tracer, pen: it also reaches down to the table).
struct JointStack {
  Joint joint;
  bool is_post;
  std::string name;             ///< "pin A", "pole post V", "tracer X", "pen Y"
  std::vector<Link> links{};    ///< from below, one or two
  int lowest = 0, highest = 0;  ///< layers of the lowest and the highest of them
  double diameter;              ///< mm, of the pin or post
  double from = 0,
         to = 0;  ///< mm, heights that it grips: of a post from the table (if the linkage is not raised)
  /// From below; links and spacers fill `from` to `to` without gap, head, washers, shims and nut stand outside.
  std::vector<StackItem> items{};
  std::optional<Fastener> fastener{};  ///< of a pin, where the design names its hardware and a length is made
  double grip() const { return to - from; }
};

/// Those of A, B and C, then pole, tracer and pen. Spacers fill the empty layers: under the lowest link of a post, and
/// between two links. Where the design names a pin's hardware, it has its screws, washers and nuts: heads below, nuts above.
std::vector<JointStack> joint_stacks(const Design& design);

/// What is pressed into every link at a joint made so: "bearing 608 8 x 22 x 7", "bush ISO 3547 8 x 10"; empty: nothing.
std::string seat_name(const Hardware& hardware);

/// What keeps a bearing in the middle of a thicker link: a ring on each side of its inner ring.
struct ShimRing {
  std::string name;  ///< "shim ring 8 x 0.5"
  double height;     ///< mm
};
/// Those of a bearing in a link of that thickness, mm; nothing where there is no bearing or no room beside it.
std::optional<ShimRing> shim_ring(const Hardware& hardware, double thickness);

/// Of a stack its head, washers, shims and nut, and the end of a screw or pin above them.
std::vector<StackItem> standing_out(const JointStack& stack);

/// How far layer 1 must stand above the table, mm, so that the heads under it have room: the posts are longer and have spacers
/// of so much under their lowest link. 0 where nothing hangs under layer 1.
double raised_by(const std::vector<JointStack>& stacks);

/// "layer 1 lies next to the table"; of a linkage `raised` (mm) "layer 1 stands 6 mm above the table, for the heads under it".
std::string lowest_layer_words(double raised);

}  // namespace kempe
