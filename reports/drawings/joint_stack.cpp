#include "reports/drawings/joint_stack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "specs/text/printable.hpp"
#include "workspace/contact/gap.hpp"
#include "workspace/obstructions.hpp"

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
    return fmt::format("{} and {} come within {:.2f} mm of each other: {} of {} mm and {} need {:.2f} mm",
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

/// A body in layer 1 goes down to the table, also where the linkage is raised; one in the highest layer goes up without end.
Heights heights_of(const Body& body, double thickness) {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {body.lowest_layer == 1 ? -far : (body.lowest_layer - 1) * thickness,
          body.highest_layer == most_layers ? far : body.highest_layer * thickness};
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
            fmt::format("{}: {} of {} mm stands in layer {} and comes within {:.2f} mm of link {}; "
                        "clearance is {} mm",
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
      if (overlap({item.from, item.to}, heights_of(body, design.style.thickness)) &&
          apart < reach + 0.5 * item.diameter + design.limits.clearance)
        faults.push_back(
            fmt::format("{}: {} of {} mm may come too near to {}, which reaches {:.2f} mm from {}; "
                        "the two joints come within {:.2f} mm of each other",
                        stack.name, item.name, item.diameter, printable(body_name(design.bodies, i)), reach,
                        letter(carrier), apart));
  }
}

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

double raised_by(const std::vector<JointStack>& stacks) {
  double lowest = 0;
  for (const JointStack& stack : stacks)
    for (const StackItem& item : stack.items) lowest = std::min(lowest, item.from);
  return -lowest;
}

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
  for (std::size_t i = 0; i < stacks.size(); ++i) {
    if (stacks[i].is_post) continue;
    const std::string& hardware = design.hardware[stacks[i].joint];
    if (!stacks[i].fastener && !hardware.empty())
      faults.push_back(
          fmt::format("{}: no \"{}\" is made that grips {} mm", stacks[i].name, hardware, stacks[i].grip()));
    tell_links_beside(design, stacks[i], faults);
    tell_bodies_beside(design, stacks[i], faults);
    for (std::size_t j = i + 1; j < stacks.size(); ++j)
      if (auto fault = meeting(design, stacks[i], stacks[j])) faults.push_back(std::move(*fault));
  }
  return faults;
}

}  // namespace kempe
