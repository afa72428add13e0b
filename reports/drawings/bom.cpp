#include "reports/drawings/bom.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace kempe {
namespace {

/// The layers of the links at a joint.
struct Span {
  int lowest = 1000, highest = 0;
  int links = 0;
};

Span span_at(Joint joint, const LayerAssignment& layers) {
  Span span;
  for (const Link link : all_links) {
    if (!has_joint(link, joint)) continue;
    span.lowest = std::min(span.lowest, layers[link]);
    span.highest = std::max(span.highest, layers[link]);
    ++span.links;
  }
  return span;
}

std::string links_at(Joint joint) {
  std::string text;
  for (const Link link : all_links)
    if (has_joint(link, joint)) text += (text.empty() ? "" : " and ") + std::string(name(link));
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

class Bill {
 public:
  explicit Bill(const Design& design) : design_(design), style_(design.style) {}

  std::vector<BomItem> make() {
    for (const Link link : all_links) add_link(link);
    const CopyingLinkage& linkage = design_.linkage;
    for (const Joint joint : {Joint::A, Joint::B, Joint::C}) add_pin(joint);
    add_post("pole post", linkage.pole_joint(), "fixed in the table");
    add_post("tracer", linkage.tracer_joint(), "follows the original");
    add_post("pen", linkage.pen_joint(), "draws the copy");
    items_.push_back({"washer", "washer", 2 * pins_, style_.pin_diameter, 0, 0, 0, "two for each pin"});
    return std::move(items_);
  }

 private:
  void add_link(Link link) {
    const double between = length_between(design_.linkage.lengths(), link);
    items_.push_back({"link", std::string(name(link)), 1, 0, between + style_.width, style_.width,
                      style_.thickness, fmt::format("layer {}, see its drawing", design_.layers[link])});
  }

  void add_pin(Joint joint) {
    const Span span = span_at(joint, design_.layers);
    const std::string head = span.lowest == 1 ? "; countersunk head, as layer 1 slides on the table" : "";
    items_.push_back({"pin", fmt::format("pin {}", letter(joint)), 1, style_.pin_diameter,
                      style_.thickness * (span.highest - span.lowest + 1), 0, 0,
                      "joins " + links_at(joint) + head});
    add_spacer(joint, span.highest - span.lowest + 1 - span.links, "between the links");
    ++pins_;
  }

  void add_post(const std::string& role, Joint joint, const std::string& use) {
    const Span span = span_at(joint, design_.layers);
    items_.push_back({"post", fmt::format("{} {}", role, letter(joint)), 1, style_.pin_diameter,
                      style_.thickness * span.highest, 0, 0,
                      fmt::format("through {} down to the table, {}", links_at(joint), use)});
    add_spacer(joint, span.lowest - 1, "under the lowest link");
    add_spacer(joint, span.highest - span.lowest + 1 - span.links, "between the links");
  }

  void add_spacer(Joint joint, int empty_layers, const std::string& where) {
    if (empty_layers <= 0) return;
    items_.push_back({"spacer", fmt::format("spacer {}", letter(joint)), 1, style_.pin_diameter,
                      style_.thickness * empty_layers, style_.width, 0, where + narrower()});
  }

  /// What a spacer as wide as a link must heed: contact is certified for pins and posts alone.
  std::string narrower() const {
    if (style_.width <= style_.pin_diameter + 2 * design_.quality.clearance_min) return "";
    return fmt::format(
        "; clearance is certified for {} mm diameter: turn the spacer down where something passes",
        style_.pin_diameter);
  }

  const Design& design_;
  const LinkStyle& style_;
  std::vector<BomItem> items_;
  int pins_ = 0;
};

std::string cell(double value) { return value == 0 ? "" : fmt::format("{}", value); }

}  // namespace

std::vector<BomItem> bill_of_materials(const Design& design) { return Bill(design).make(); }

std::string bom_csv(const Design& design) {
  std::string text = "item,name,quantity,diameter_mm,length_mm,width_mm,thickness_mm,remark\n";
  for (const BomItem& item : bill_of_materials(design))
    text +=
        fmt::format("{},{},{},{},{},{},{},\"{}\"\n", item.item, item.name, item.quantity, cell(item.diameter),
                    cell(item.length), cell(item.width), cell(item.thickness), item.remark);
  return text;
}

}  // namespace kempe
