#include "reports/drawings/bom.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/drawings/blank.hpp"
#include "reports/drawings/joint_stack.hpp"
#include "reports/drawings/mounting_words.hpp"
#include "reports/drawings/spacers.hpp"
#include "reports/drawings/tool_words.hpp"
#include "specs/text/printable.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

std::string links_of(const JointStack& stack) {
  std::string text;
  for (const Link link : all_links)
    if (has_joint(link, stack.joint)) text += (text.empty() ? "" : " and ") + std::string(name(link));
  return text;
}

double length_between(const LinkLengths& lengths, Link link) {
  switch (link) {
    case Link::VA: return lengths.VA;
    case Link::VB: return lengths.VB;
    case Link::ACX: return std::max({lengths.AC, lengths.AX, lengths.CX});
    case Link::BCY: break;
  }
  return std::max({lengths.BC, lengths.BY, lengths.CY});
}

/// To a hundredth of a millimetre; three digits of what is shorter than a tenth.
std::string sawn(double length) {
  return length < 0.1 ? fmt::format("{:.3g}", length) : fmt::format("{:.2f}", length);
}

/// "draws the copy with a cutter of 6 mm, carries router".
std::string use_of(const Design& design, const JointStack& stack) {
  const Joint joint = stack.joint;
  if (joint == design.linkage.pole_joint()) return "fixed in the table";
  const bool is_tracer = joint == design.linkage.tracer_joint();
  std::string text = is_tracer ? "follows the original" : "draws the copy";
  const std::optional<double> radius = !design.tool ? std::nullopt
                                       : is_tracer  ? design.tool->follower_radius
                                                    : design.tool->cutter_radius;
  if (radius && *radius > 0)
    text += fmt::format(" with a {} of {:.6g} mm", is_tracer ? "follower" : "cutter", 2 * *radius);
  for (std::size_t i = 0; i < design.bodies.size(); ++i)
    if (joint_of(design.bodies[i].at, design.linkage) == joint) {
      text += ", carries " + printable(body_name(design.bodies, i));
      if (const double above = height_above(design, design.bodies[i], stack); above > 0)
        text += fmt::format(" {:.6g} mm above its end", above);
    }
  if (const std::string offset = template_words(design.tool); is_tracer && !offset.empty())
    text += "; " + offset;
  return text;
}

class Bill {
 public:
  explicit Bill(const Design& design) : design_(design), style_(design.style) {}

  std::vector<BomItem> make() {
    const auto stacks = joint_stacks(design_);
    raised_ = raised_by(stacks);
    for (const Link link : all_links) add_link(link);
    add_strip();
    const auto spacers = spacers_of(design_, stacks);
    for (std::size_t i = 0; i < stacks.size(); ++i) add_stack(stacks[i], spacers[i]);
    add_plain_washers(stacks);
    add_hardware(stacks);
    return std::move(items_);
  }

 private:
  void add_link(Link link) {
    const Blank blank = blank_of(design_, link);
    items_.push_back({.item = "link",
                      .name = std::string(name(link)),
                      .length = length_between(design_.linkage.lengths(), link) + style_.width,
                      .width = style_.width,
                      .thickness = style_.thickness,
                      .blank_length = blank.length,
                      .blank_width = blank.width,
                      .remark = fmt::format("{}, layer {}{}", form_of(design_, link), design_.layers[link],
                                            design_.material ? ", " + design_.material->name : "")});
  }

  void add_strip() {
    const Strip strip = strip_of(design_);
    std::string cuts;
    for (const Strip::Piece& piece : strip.pieces)
      cuts += fmt::format("{}{} {}", cuts.empty() ? "" : ", ", name(piece.link), sawn(piece.length));
    items_.push_back(
        {.item = "strip",
         .name = fmt::format("strip {:.9g} x {:.9g}", strip.width, strip.thickness),
         .length = strip.length,
         .width = strip.width,
         .thickness = strip.thickness,
         .remark = "sawn into " + cuts + (design_.cutting.kerf > 0 ? "; kerf counted" : "; kerf on top")});
  }

  void add_stack(const JointStack& stack, const std::vector<Spacer>& spacers) {
    items_.push_back({.item = stack.is_post ? "post" : "pin",
                      .name = stack.name,
                      .diameter = stack.diameter,
                      .length = stack.grip() + (stack.is_post ? raised_ : 0),
                      .remark = stack.is_post ? fmt::format("through {} down to the table, {}",
                                                            links_of(stack), use_of(design_, stack))
                                              : "joins " + links_of(stack) + made_of(stack)});
    for (const Spacer& spacer : spacers) add_spacer(spacer);
  }

  /// A pin's fastener, or what else holds it.
  std::string made_of(const JointStack& stack) const {
    if (!stack.fastener) {
      if (!design_.hardware[stack.joint].empty() || stack.lowest > 1) return "";
      return raised_ > 0 ? fmt::format("; head at most {} mm high, the room under layer 1", sawn(raised_))
                         : "; countersunk head, as layer 1 slides on the table";
    }
    std::string text = "; " + stack.fastener->name;
    if (stack.fastener->play > 0)
      text += fmt::format(", {} mm play along the shoulder", sawn(stack.fastener->play));
    return text;
  }

  void add_plain_washers(const std::vector<JointStack>& stacks) {
    const auto plain = std::count_if(stacks.begin(), stacks.end(), [&](const JointStack& stack) {
      return !stack.is_post && design_.hardware[stack.joint].empty();
    });
    if (plain > 0)
      items_.push_back({.item = "washer",
                        .name = "washer",
                        .quantity = 2 * static_cast<int>(plain),
                        .diameter = style_.pin_diameter,
                        .remark = plain == 3 ? "two for each pin" : "two for each plain pin"});
  }

  /// What to buy, each thing once with its number; what is first bought of a kind says by which standards, and what to heed.
  void add_hardware(const std::vector<JointStack>& stacks) {
    const auto first = static_cast<std::ptrdiff_t>(items_.size());
    const auto buy = [&](const char* item, const std::string& name, int count, double diameter,
                         double length) {
      const auto same = std::find_if(items_.begin() + first, items_.end(),
                                     [&](const BomItem& each) { return each.name == name; });
      if (same != items_.end()) return static_cast<void>(same->quantity += count);
      items_.push_back(
          {.item = item, .name = name, .quantity = count, .diameter = diameter, .length = length});
    };
    std::vector<const Hardware*> told;
    for (const JointStack& stack : stacks) {
      const Hardware* of = hardware_named(design_.hardware[stack.joint]);
      if (of == nullptr) continue;
      const Hardware& hardware = *of;
      const std::size_t before = items_.size();
      if (stack.fastener)
        buy(hardware.thread.empty() ? "dowel" : "screw", stack.fastener->name, 1, stack.diameter,
            stack.fastener->length);
      for (const StackItem& item : stack.items)
        if (item.kind == StackItem::Kind::washer || item.kind == StackItem::Kind::shim)
          buy("washer", item.name, 1, 0, item.to - item.from);
        else if (item.kind == StackItem::Kind::nut)
          buy("nut", item.name, 1, 0, item.to - item.from);
      add_seats(hardware, static_cast<int>(stack.links.size()), buy);
      if (items_.size() == before || std::find(told.begin(), told.end(), of) != told.end()) continue;
      told.push_back(of);
      items_[before].remark = remark_on(hardware);
    }
  }

  /// The bearings with their shim rings, or the bushes, of the links at a joint.
  template <class Buy>
  void add_seats(const Hardware& hardware, int links, const Buy& buy) const {
    if (hardware.kind == HardwareKind::bearing)
      buy("bearing", seat_name(hardware), links, hardware.seat, hardware.seat_width);
    if (const auto ring = shim_ring(hardware, style_.thickness))
      buy("shim ring", ring->name, 2 * links, hardware.pin, ring->height);
    if (hardware.kind == HardwareKind::bush)
      buy("bush", seat_name(hardware), links, hardware.seat, style_.thickness);
  }

  std::string remark_on(const Hardware& hardware) const {
    std::string text(standards_of(hardware.kind));
    if (raised_ > 0) text += "; " + lowest_layer_words(raised_);
    switch (hardware.kind) {
      case HardwareKind::bolt: return text + "; self-locking nuts or thread lock: the joints turn";
      case HardwareKind::bearing:
        return text + (shim_ring(hardware, style_.thickness)
                           ? "; a shim ring on each side of each bearing, no wider than its inner ring"
                           : "");
      case HardwareKind::shoulder_screw: return text;
      case HardwareKind::dowel:
      case HardwareKind::bush: break;
    }
    return text + "; secure both ends";
  }

  /// One without room is no piece to buy: what is to be done instead stands beside the pin or post.
  void add_spacer(const Spacer& spacer) {
    const std::string words = words_on(spacer);
    if (!spacer.has_room()) {
      const auto on = std::find_if(items_.begin(), items_.end(),
                                   [&](const BomItem& item) { return item.name == spacer.on; });
      if (on != items_.end()) on->remark += "; " + words;
      return;
    }
    items_.push_back({.item = "spacer",
                      .name = spacer.name,
                      .diameter = spacer.bore,
                      .length = spacer.height(),
                      .width = spacer.diameter,
                      .remark = (spacer.is_lowest ? "under the lowest link" : "between the links") +
                                (words.empty() ? "" : "; " + words)});
  }

  const Design& design_;
  const LinkStyle& style_;
  std::vector<BomItem> items_;
  double raised_ = 0;  ///< mm
};

/// Always in quotation marks. A remark begins with words of this program; names from outside may be in it.
std::string quoted(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

/// To a thousandth, or six digits of what is smaller than that tells: parts are bought and sawn by it, and made by their drawings.
std::string cell(double value) {
  if (value == 0) return "";
  return value < 1 ? fmt::format("{:.6g}", value) : fmt::format("{}", std::round(value * 1e3) / 1e3);
}

}  // namespace

std::vector<BomItem> bill_of_materials(const Design& design) { return Bill(design).make(); }

std::string bom_csv(const Design& design) {
  std::string text =
      "item,name,quantity,diameter_mm,length_mm,width_mm,thickness_mm,blank_length_mm,blank_width_mm,"
      "remark\n";
  for (const BomItem& item : bill_of_materials(design))
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", item.item, item.name, item.quantity,
                        cell(item.diameter), cell(item.length), cell(item.width), cell(item.thickness),
                        cell(item.blank_length), cell(item.blank_width), quoted(item.remark));
  return text;
}

}  // namespace kempe
