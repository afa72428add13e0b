// What a maker needs: lengths to cut, joints, layers.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "reports/drawings/blank.hpp"
#include "reports/drawings/joint_stack.hpp"
#include "reports/page/html_table.hpp"
#include "reports/page/sections.hpp"
#include "reports/pictures/html_text.hpp"
#include "reports/pictures/mechanism_picture.hpp"
#include "specs/hardware.hpp"
#include "synthesis/design/rounding.hpp"

namespace kempe::report_sections {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// The corner of a plate: the angle at A between AC and AX, at B between BC and BY. Both are |arg s|.
std::string corner_text(Link link, const Design& design) {
  if (link == Link::VA || link == Link::VB) return "–";
  return fmt::format("{} at {}", angle_text(std::abs(std::arg(design.linkage.shape())), 3),
                     link == Link::ACX ? 'A' : 'B');
}

/// Indices into LinkLengths of a link's lengths.
std::vector<std::size_t> lengths_of(Link link) {
  switch (link) {
    case Link::VA: return {0};
    case Link::VB: return {1};
    case Link::ACX: return {2, 4, 5};
    case Link::BCY: break;
  }
  return {3, 6, 7};
}

std::string turn_of(Side side) { return side == Side::left ? "to the left" : "to the right"; }

std::string assembly_sentence(const Design& design) {
  const LoopSides sides = design.linkage.assembly_mode().sides;
  std::string text = fmt::format(
      "<p class=\"note\">Put together so that, seen from above, going from V to A the bar VB lies {}",
      turn_of(sides.parallelogram));
  if (sides.plate_ACX != Side::on_line)
    text += fmt::format(", going from A to C the tip X {}, and going from B to C the tip Y {}",
                        turn_of(sides.plate_ACX), turn_of(sides.plate_BCY));
  return text + ". The opposite sides of the parallelogram are equal: VA = BC and VB = AC.</p>\n";
}

std::string links_at(Joint joint) {
  std::string names;
  for (const Link link : all_links) {
    const LinkJoints joints = joints_of(link);
    for (int i = 0; i < joints.count; ++i)
      if (joints.joints[static_cast<std::size_t>(i)] == joint)
        names += (names.empty() ? "" : " + ") + std::string(name(link));
  }
  return names;
}

std::string_view task_of(const CopyingLinkage& linkage, Joint joint) {
  const std::string_view what = role(linkage, joint);
  if (what == "pole") return "pole: fixed to the table";
  if (what == "tracer") return "tracer: follows the original";
  if (what == "pen") return "pen: draws the copy";
  return "pin";
}

/// One body of the table a link, its lengths one below the other.
std::string link_rows(Link link, const Design& design, const RoundedLengths& rounded) {
  const auto which = lengths_of(link);
  const auto values = rounded.lengths.values();
  std::string html = fmt::format(R"(<tbody><tr><th scope="rowgroup" rowspan="{0}">{1}<small>{2}</small></th>)"
                                 R"(<td rowspan="{0}">{3}</td><td rowspan="{0}">{4}</td>)",
                                 which.size(), name(link), form_of(design, link), design.layers[link],
                                 corner_text(link, design));
  for (std::size_t i = 0; i < which.size(); ++i) {
    const std::string_view letters = LinkLengths::names[which[i]];
    html +=
        fmt::format(R"({}<td class="letters">{} – {}</td><td class="number">{:.{}f}</td></tr>)",
                    i == 0 ? "" : "\n<tr>", letters[0], letters[1], values[which[i]], decimals_of(rounded));
  }
  return html + "</tbody>\n";
}

/// What the rounding of the lengths costs.
std::string rounding_sentence(const RoundedLengths& rounded, bool first_order_will_do) {
  std::string cost;
  if (rounded.copy_error)
    cost = fmt::format(", which moves the copy by {} at most", length_text(*rounded.copy_error, 4));
  if (rounded.with_tolerance)
    cost += fmt::format("; made to them within the tolerances the copy is off by {} {}",
                        length_text(*rounded.with_tolerance, 4),
                        first_order_will_do ? "at most" : "to the first order, which is too small here");
  return fmt::format(
      "<p class=\"note\">Rounded to {}{}. The drawings and <code>design.json</code> have the exact "
      "lengths.</p>\n",
      length_text(rounded.step, decimals_of(rounded)), cost);
}

std::string length_table(const Design& design) {
  std::string html =
      R"(<div class="scroll"><table class="lengths">
<thead><tr><th scope="col">Link</th><th scope="col">Layer</th><th scope="col">Corner</th>)"
      R"(<th scope="col">From – to</th><th scope="col" class="number">Length, mm</th></tr></thead>
)";
  const RoundedLengths rounded = rounded_lengths(design);
  for (const Link link : all_links) html += link_rows(link, design, rounded);
  return html + "</table></div>\n" + rounding_sentence(rounded, !design.quality.copy_error_at_corner) +
         assembly_sentence(design);
}

std::string joint_table(const Design& design) {
  Rows rows;
  for (const Joint joint : all_joints)
    rows.push_back(
        {std::string(1, letter(joint)), std::string(task_of(design.linkage, joint)), links_at(joint)});
  return html_table("joints", {{"Joint"}, {"Task"}, {"Joins"}}, rows);
}

/// Pins and posts alone: "empty; pole post V, tracer X pass".
std::string empty_layer(const Design& design, int layer) {
  std::string passing;
  for (const Part& part : parts_of(design.linkage, design.layers))
    if (part.lowest_layer <= layer && layer <= part.highest_layer)
      passing += (passing.empty() ? "" : ", ") + name(part);
  return passing.empty() ? "empty" : "empty; " + passing + " pass";
}

std::string layer_table(const Design& design) {
  Rows rows;
  for (int layer = design.layers.highest(); layer >= 1; --layer) {
    std::string names;
    for (const Link link : all_links)
      if (design.layers[link] == layer) names += (names.empty() ? "" : ", ") + std::string(name(link));
    if (names.empty()) names = empty_layer(design, layer);
    const double under = (layer - 1) * design.style.thickness;
    rows.push_back({std::to_string(layer), names,
                    number_text(under, 3) + " – " + number_text(under + design.style.thickness, 3)});
  }
  return html_table("layers", {{"Layer"}, {"Links"}, {"Height over the first, mm"}}, rows);
}

/// "6 mm", or "4 mm at A B C, 8 mm at V X Y" as by_joint() says it.
std::string pins_text(const Design& design) {
  const auto pins = pin_diameters(design.style, design.hardware);
  return design.hardware.differs() ? by_joint(pins, [](double pin) { return length_text(pin); })
                                   : length_text(design.style.pin_diameter);
}

}  // namespace

std::string making(const Design& design) {
  const LinkStyle& style = design.style;
  const std::string note =
      fmt::format("<p class=\"note\">Links {} wide and {} thick, pins {} across. L{}.</p>\n",
                  length_text(style.width), length_text(style.thickness), pins_text(design),
                  lowest_layer_words(raised_by(joint_stacks(design))).substr(1));
  return html_section("lengths", "Lengths to cut",
                      "<div class=\"columns\"><div>" + length_table(design) +
                          "</div><div class=\"beside\"><h3>Joints</h3>\n" + joint_table(design) +
                          "<h3>Layers, from the top</h3>\n" + layer_table(design) + note + "</div></div>\n");
}

}  // namespace kempe::report_sections
