// The links as pictures with their dimensions, all to one scale.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/drawings/blank.hpp"
#include "reports/drawings/bom.hpp"
#include "reports/drawings/joint_stack.hpp"
#include "reports/drawings/making_notes.hpp"
#include "reports/drawings/tool_words.hpp"
#include "reports/page/html_table.hpp"
#include "reports/page/sections.hpp"
#include "reports/pictures/html_text.hpp"
#include "reports/pictures/picture_labels.hpp"
#include "reports/pictures/svg_element.hpp"
#include "reports/pictures/svg_path.hpp"
#include "reports/workshop/workshop_pdf.hpp"
#include "specs/hardware.hpp"

namespace kempe::report_sections {
namespace {

/// Nominal width of a picture, px.
constexpr double nominal_width = 330;

/// A link lying on its longest side, seen from above.
struct LyingLink {
  Link link;
  std::vector<Joint> joints;
  std::vector<Point> holes;
  ArcPolygon outline;
  Point lower, upper;  ///< of its outline
};

std::pair<std::size_t, std::size_t> longest_side(const std::vector<Point>& corners) {
  std::pair<std::size_t, std::size_t> longest{0, 1};
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j)
      if ((corners[i] - corners[j]).norm() > (corners[longest.first] - corners[longest.second]).norm())
        longest = {i, j};
  return longest;
}

LyingLink lying(Link link, const Design& design, const Pose& pose) {
  LyingLink part{link, {}, {}, link_outline(link, pose, design.style), {}, {}};
  const LinkJoints of_link = joints_of(link);
  part.joints.assign(of_link.joints.begin(), of_link.joints.begin() + of_link.count);
  for (const Joint joint : part.joints) part.holes.push_back(pose[joint]);
  const auto [from, to] = longest_side(part.holes);
  const Point origin = part.holes[from];
  const Complex along = as_complex(part.holes[to] - origin), turn = std::conj(along) / std::abs(along);
  const auto laid = [&](const Point& at) -> Point { return as_point(turn * as_complex(at - origin)); };
  for (Point& hole : part.holes) hole = laid(hole);
  for (ArcVertex& vertex : part.outline.outer) vertex.at = laid(vertex.at);
  for (ArcRing& hole : part.outline.holes)
    for (ArcVertex& vertex : hole) vertex.at = laid(vertex.at);
  part.lower = part.upper = part.holes.front();
  for (const Point& hole : part.holes) {
    part.lower = part.lower.cwiseMin(hole - Point::Constant(design.style.width / 2));
    part.upper = part.upper.cwiseMax(hole + Point::Constant(design.style.width / 2));
  }
  return part;
}

/// Letters at the holes and a dimension on every distance between two of them.
std::string words(const LyingLink& part, const Design& design, const PictureBox& frame, double unit) {
  LabelPlacer placer(frame, unit);
  std::string svg;
  const Point centre = 0.5 * (part.lower + part.upper),
              clear_of_body = Point::Constant(0.5 * design.style.width);
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    placer.avoid(
        {part.holes[i],
         Point::Constant(hole_diameter(design.style, design.hardware, part.joints[i], design.cutting) / 2)});
    for (std::size_t j = i + 1; j < part.holes.size(); ++j) placer.avoid(part.holes[i], part.holes[j], unit);
  }
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    const Point away = part.holes[i] - centre;
    const Point at = placer.place_around(part.holes[i], design.style.width / 2, Point(6, 7) * unit,
                                         away.norm() > 0 ? away : Point(0, 1));
    svg += svg_words("letter", at).saying(std::string(1, letter(part.joints[i]))).line();
  }
  for (std::size_t i = 0; i < part.holes.size(); ++i)
    for (std::size_t j = i + 1; j < part.holes.size(); ++j) {
      const double length = (part.holes[i] - part.holes[j]).norm();
      std::string figure = fmt::format("{:.3f}", length);
      double characters = static_cast<double>(figure.size());
      if (part.holes.size() > 2) {  // between which holes does not go without saying
        figure = fmt::format("{}–{}\u2002{}", letter(part.joints[i]), letter(part.joints[j]), figure);
        characters += 4;
      }
      const Point half = Point(3.8 * characters, 7) * unit;
      const PictureBox side{0.5 * (part.holes[i] + part.holes[j]), clear_of_body};
      svg += svg_words("size", placer.place_beside(side, half)).saying(figure).line();
    }
  return svg;
}

/// "holes of 8.1 mm for pins of 8 mm", or of holes that differ "holes: V 22 mm for a 608 bearing, A 8.1 mm for a pin of 8 mm".
std::string holes_of(const LyingLink& part, const Design& design) {
  const auto hole_at = [&](Joint joint) {
    return hole_diameter(design.style, design.hardware, joint, design.cutting);
  };
  const auto pin = [&](Joint joint) { return pin_at(design.style, design.hardware, joint); };
  const auto seat = [&](Joint joint) {
    const Hardware* of = hardware_named(design.hardware[joint]);
    return of != nullptr && of->seat > 0 ? seat_name(*of) : std::string();
  };
  const Joint first = part.joints.front();
  if (std::all_of(part.joints.begin(), part.joints.end(), [&](Joint joint) {
        return hole_at(joint) == hole_at(first) && pin(joint) == pin(first) && seat(joint) == seat(first);
      })) {
    const std::string holes = "holes of " + length_text(hole_at(first), 3);
    if (!seat(first).empty()) return holes + ", each for a " + seat(first);
    return hole_at(first) == pin(first) ? holes : holes + " for pins of " + length_text(pin(first));
  }
  std::string each;
  for (const Joint joint : part.joints)
    each += fmt::format("{} {} {} for a {}", each.empty() ? "holes:" : ",", letter(joint),
                        length_text(hole_at(joint), 3),
                        seat(joint).empty() ? "pin of " + length_text(pin(joint)) : seat(joint));
  return each;
}

std::string picture(const LyingLink& part, const Design& design, double unit) {
  const Point room = Point(0.5 * nominal_width, 0.5 * (part.upper.y() - part.lower.y()) / unit + 42) * unit;
  const PictureBox frame{0.5 * (part.lower + part.upper), room};
  std::string inside = svg_shape("body", svg_path(part.outline, 0)).line();
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    for (std::size_t j = i + 1; j < part.holes.size(); ++j)
      inside += svg_shape("line", svg_line({part.holes[i], part.holes[j]})).line();
    inside += svg_disc("hole", part.holes[i],
                       hole_diameter(design.style, design.hardware, part.joints[i], design.cutting) / 2)
                  .line();
  }
  const SvgElement svg =
      SvgElement("svg")
          .with("role", "img")
          .with("aria-label", fmt::format("Link {} with its dimensions", name(part.link)))
          .with("viewBox", view_box(frame.lower().x(), -frame.upper().y(), 2 * room.x(), 2 * room.y()))
          .with("font-size", 13 * unit, 5)
          .holding("\n" + inside + words(part, design, frame, unit));
  return fmt::format("<figure>{}<figcaption><b>{}</b>, layer {}, {} thick, {}</figcaption></figure>\n",
                     svg.line(), name(part.link), design.layers[part.link],
                     length_text(design.style.thickness), holes_of(part, design));
}

std::string dimensioned_links(const Design& design) {
  const Pose pose = design.linkage.pose_at(openings_to_show(design).middle(), 0);
  std::vector<LyingLink> links;
  double widest = 0;
  for (const Link link : all_links) {
    links.push_back(lying(link, design, pose));
    widest = std::max(widest, links.back().upper.x() - links.back().lower.x());
  }
  const double unit = widest / (nominal_width - 50);
  std::string html;
  for (const LyingLink& part : links) html += picture(part, design, unit);
  return "<p class=\"note\">To one scale, seen from above, lengths between the centres of the holes in "
         "millimetres.</p>\n<div class=\"dimensioned\">\n" +
         html + "</div>\n";
}

/// What to saw: the blank of each link, and the strip for those that are straight.
std::string cutting_list(const Design& design) {
  std::vector<std::vector<std::string>> rows;
  const auto size = [](double length) { return figure_text(length, 2); };
  for (const Link link : all_links) {
    const Blank blank = blank_of(design, link);
    rows.push_back(
        {std::string(name(link)), std::string(form_of(design, link)), size(blank.length), size(blank.width)});
  }
  const Strip strip = strip_of(design);
  std::string of;
  for (const Strip::Piece& piece : strip.pieces)
    of += (of.empty() ? "" : ", ") + std::string(name(piece.link));
  rows.push_back({"Strip", "for " + of, size(strip.length), size(strip.width)});
  return fmt::format(
             "<h3>Blanks, {} thick</h3>\n<p class=\"note\">The smallest rectangle round each link; the "
             "straight ones "
             "together off one strip{}.</p>\n",
             length_text(design.style.thickness),
             design.cutting.kerf > 0 ? ", a kerf for each counted" : ", the saw's kerf on top") +
         html_table("blanks", {{"Blank"}, {"Form"}, {"Length, mm", true}, {"Width, mm", true}}, rows);
}

/// Pins, posts, spacers and washers: what bom.csv lists beside what is sawn.
std::string hardware(const Design& design) {
  std::vector<std::vector<std::string>> rows;
  for (const BomItem& item : bill_of_materials(design)) {
    if (item.item == "link" || item.item == "strip") continue;
    const std::string across = item.diameter > 0 ? figure_text(item.diameter, 3) : "–";
    rows.push_back({html_escaped(item.name), std::to_string(item.quantity),
                    item.item == "spacer" ? figure_text(item.width, 3) + ", bore " + across : across,
                    item.length > 0 ? figure_text(item.length, 3) : "–", html_escaped(item.remark)});
  }
  return "<h3>Pins, posts, spacers</h3>\n" +
         html_table(
             "hardware",
             {{"Item"}, {"Number", true}, {"Diameter, mm", true}, {"Length needed, mm", true}, {"Use"}},
             rows);
}

std::string notes(const Design& design) {
  std::string html;
  for (const std::string& words : tool_words(design.tool)) html += "<li>" + html_escaped(words) + "</li>";
  for (const std::string& note : part_notes(design)) html += "<li>" + html_escaped(note) + "</li>";
  return html.empty() ? html : "<ul class=\"note\">" + html + "</ul>\n";
}

std::string given_pictures(const std::vector<PartPicture>& pictures) {
  std::string html;
  for (const PartPicture& part : pictures)
    // As an image an SVG runs no script and loads nothing, whatever it holds.
    html += fmt::format(
        "<figure class=\"part\"><img alt=\"Drawing of {0}\" "
        "src=\"data:image/svg+xml;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
        html_escaped(part.name), base64(part.svg));
  return html.empty() ? html : "<div class=\"parts\">\n" + html + "</div>\n";
}

std::string files_note(const ReportExtras& extras) {
  if (extras.pareto) return "";  // a front's folder holds no drawings
  if (!extras.why_no_parts.empty())
    return fmt::format(
        "<p class=\"note\"><b>The links cannot be cut as they are</b>: {}. "
        "<code>drawing.dxf</code> and <a href=\"workshop.pdf\">workshop.pdf</a> show them, not to work "
        "from; there are no files of the parts.</p>\n",
        html_escaped(extras.why_no_parts));
  return "<p class=\"note\">To work from: <a href=\"workshop.pdf\">workshop.pdf</a>, every link with its "
         "dimensions at 1:1, the stack, the assembly, the bench plan, the parts list and what to know before "
         "making, to print.</p>\n"
         "<p class=\"note\">To cut: <code>drawing.dxf</code> (all links, 1:1), or link by link "
         "<code>parts/VA.dxf</code>, <code>.svg</code> and <code>.stl</code> and so on.</p>\n";
}

}  // namespace

std::string parts(const Design& design, const ReportExtras& extras) {
  return html_section("parts", "Parts",
                      dimensioned_links(design) + given_pictures(extras.parts) + files_note(extras) +
                          notes(design) + cutting_list(design) + hardware(design));
}

}  // namespace kempe::report_sections
