#include "reports/drawings/joint_stack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kempe {
namespace {

std::vector<Link> links_from_below(Joint joint, const LayerAssignment& layers) {
  std::vector<Link> links;
  for (const Link link : all_links)
    if (has_joint(link, joint)) links.push_back(link);
  std::sort(links.begin(), links.end(), [&](Link a, Link b) { return layers[a] < layers[b]; });
  return links;
}

std::string name_of(const CopyingLinkage& linkage, Joint joint) {
  Part part{.kind = Part::Kind::pin, .joint = joint};
  if (joint == linkage.pole_joint()) part.kind = Part::Kind::pole_post;
  if (joint == linkage.tracer_joint()) part.kind = Part::Kind::tracer_post;
  if (joint == linkage.pen_joint()) part.kind = Part::Kind::pen_post;
  return name(part);
}

JointStack stack_at(const Design& design, Joint joint, bool is_post) {
  const double thickness = design.style.thickness;
  JointStack stack{.joint = joint,
                   .is_post = is_post,
                   .name = name_of(design.linkage, joint),
                   .links = links_from_below(joint, design.layers),
                   .diameter = pin_at(design.style, design.hardware, joint)};
  stack.lowest = design.layers[stack.links.front()];
  stack.highest = design.layers[stack.links.back()];
  stack.from = is_post ? 0 : (stack.lowest - 1) * thickness;
  double height = stack.from;
  for (const Link link : stack.links) {
    const double under = (design.layers[link] - 1) * thickness;
    if (under > height)
      stack.items.push_back({StackItem::Kind::spacer, fmt::format("spacer {}", letter(joint)), height, under,
                             design.style.width});
    height = design.layers[link] * thickness;
    stack.items.push_back(
        {StackItem::Kind::link, std::string(name(link)), under, height, design.style.width});
  }
  stack.to = height;
  return stack;
}

/// Puts screws, washers and nuts on the pins.
class Fastening {
 public:
  Fastening(const Hardware& hardware, JointStack& stack) : hardware_(hardware), stack_(stack) {}

  void fasten() {
    switch (hardware_.kind) {
      case HardwareKind::bolt:
      case HardwareKind::bearing: return by_bolt(*thread_of(hardware_));
      case HardwareKind::shoulder_screw: return by_shoulder(*thread_of(hardware_));
      case HardwareKind::dowel:
      case HardwareKind::bush: return by_pin();
    }
  }

 private:
  /// Head and washer below, washer and nut above; a turn of the thread or more stands out of the nut.
  void by_bolt(const ThreadSizes& thread) {
    const double washer = thread.washer_height, under = stack_.from - washer;
    below(StackItem::Kind::head, "head", under - thread.screw_head_height, under, thread.screw_head);
    add_washer(thread, under, StackItem::Kind::washer);
    add_washer(thread, stack_.to, StackItem::Kind::washer);
    add_nut(thread, stack_.to + washer);
    const double needed = stack_.grip() + 2 * washer + thread.nut_height + thread.pitch;
    if (const auto length = screw_length(thread, needed))
      stack_.fastener = Fastener{fmt::format("screw ISO 4762 {} x {}", thread.name, *length), *length, under,
                                 under + *length};
  }

  /// The head lies against the lowest link; the nut is drawn against the shoulder's end.
  void by_shoulder(const ThreadSizes& thread) {
    below(StackItem::Kind::head, "head", stack_.from - hardware_.head_height, stack_.from, hardware_.head);
    const auto length = shoulder_or_pin_length(hardware_, stack_.grip());
    if (!length) return;
    const double end = stack_.from + *length;
    double play = end - stack_.to;
    for (const ThreadSizes* ring = ring_on_shoulder(); ring != nullptr && play >= ring->washer_height;
         play -= ring->washer_height)
      add_washer(*ring, end - play, StackItem::Kind::shim);
    add_washer(thread, end, StackItem::Kind::washer);
    add_nut(thread, end + thread.washer_height);
    stack_.fastener =
        Fastener{fmt::format("shoulder screw ISO 7379 {} x {} {}", hardware_.pin, *length, thread.name),
                 *length,
                 stack_.from,
                 end,
                 play,
                 thread.diameter,
                 hardware_.thread_length};
  }

  void by_pin() {
    if (const auto length = shoulder_or_pin_length(hardware_, stack_.grip()))
      stack_.fastener = Fastener{fmt::format("parallel pin ISO 8734 {} x {}", hardware_.pin, *length),
                                 *length, stack_.from, stack_.from + *length};
  }

  /// The washer whose hole takes the shoulder: that of the thread of its diameter.
  const ThreadSizes* ring_on_shoulder() const {
    Hardware as_bolt = hardware_;
    const std::string thread = fmt::format("M{}", hardware_.pin);
    as_bolt.thread = thread;
    return thread_of(as_bolt);
  }

  void below(StackItem::Kind kind, const char* name, double from, double to, double diameter) {
    stack_.items.insert(stack_.items.begin(), {kind, name, from, to, diameter});
  }
  void add_washer(const ThreadSizes& thread, double at, StackItem::Kind kind) {
    const StackItem washer{kind, fmt::format("washer ISO 7089 {}", thread.diameter), at,
                           at + thread.washer_height, thread.washer_diameter};
    const auto after = std::find_if(stack_.items.begin(), stack_.items.end(),
                                    [&](const StackItem& item) { return item.from >= at; });
    stack_.items.insert(after, washer);
  }
  void add_nut(const ThreadSizes& thread, double at) {
    stack_.items.push_back({StackItem::Kind::nut, fmt::format("nut ISO 4032 {}", thread.name), at,
                            at + thread.nut_height, thread.nut_corners});
  }

  const Hardware& hardware_;
  JointStack& stack_;
};

}  // namespace

std::vector<JointStack> joint_stacks(const Design& design) {
  std::vector<JointStack> stacks;
  for (const Joint joint : {Joint::A, Joint::B, Joint::C}) stacks.push_back(stack_at(design, joint, false));
  for (JointStack& stack : stacks)
    if (const Hardware* hardware = hardware_named(design.hardware[stack.joint]))
      Fastening(*hardware, stack).fasten();
  const CopyingLinkage& linkage = design.linkage;
  for (const Joint joint : {linkage.pole_joint(), linkage.tracer_joint(), linkage.pen_joint()})
    stacks.push_back(stack_at(design, joint, true));
  return stacks;
}

std::string seat_name(const Hardware& hardware) {
  if (hardware.kind == HardwareKind::bearing)
    return fmt::format("bearing {} {} x {} x {}", hardware.name.substr(0, hardware.name.find(' ')),
                       hardware.pin, hardware.seat, hardware.seat_width);
  if (hardware.kind == HardwareKind::bush)
    return fmt::format("bush ISO 3547 {} x {}", hardware.pin, hardware.seat);
  return "";
}

std::optional<ShimRing> shim_ring(const Hardware& hardware, double thickness) {
  const double height = 0.5 * (thickness - hardware.seat_width);
  if (hardware.kind != HardwareKind::bearing || !(height > 1e-9 * thickness)) return std::nullopt;
  return ShimRing{fmt::format("shim ring {} x {:.6g}", hardware.pin, height), height};
}

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

double raised_by(const std::vector<JointStack>& stacks) {
  double lowest = 0;
  for (const JointStack& stack : stacks)
    for (const StackItem& item : stack.items) lowest = std::min(lowest, item.from);
  return -lowest;
}

std::string lowest_layer_words(double raised) {
  return raised > 0 ? fmt::format("layer 1 stands {:.9g} mm above the table, for the heads under it", raised)
                    : "layer 1 lies next to the table";
}

}  // namespace kempe
