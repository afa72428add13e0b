// Each link with its dimensions and holes; tiles at 1:1 where the paper is smaller than the link.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "reports/workshop/dimension.hpp"
#include "reports/workshop/sheets.hpp"
#include "reports/workshop/table.hpp"
#include "reports/workshop/tiles.hpp"

namespace kempe::workshop {
namespace {

/// What the drawing of a link takes on each side of the link, on paper, mm.
struct Surround {
  double left, right, below, above;
};

/// A link as it is drawn: finished, without kerf, the first hole of its table at the origin.
struct DrawnLink {
  CutPart part;
  Box box;  ///< of the outline
};

/// The hole farthest left, the lowest of those: all others are measured from it.
std::size_t datum_of(const CutPart& part) {
  constexpr double same = 1e-6;  // mm: equal but for rounding
  std::size_t datum = 0;
  for (std::size_t i = 1; i < part.holes.size(); ++i) {
    const Point &one = part.holes[i].centre, &best = part.holes[datum].centre;
    const bool level = std::abs(one.x() - best.x()) <= same;
    if (level ? one.y() < best.y() : one.x() < best.x()) datum = i;
  }
  return datum;
}

DrawnLink drawn_link(const Task& task, Link link) {
  CutPart part = cut_part(task.design, link, finished(task.design.cutting));
  std::swap(part.holes[0], part.holes[datum_of(part)]);
  std::sort(part.holes.begin() + 1, part.holes.end(),
            [](const CutPart::Hole& a, const CutPart::Hole& b) { return a.centre.x() < b.centre.x(); });
  const Point datum = part.holes[0].centre;
  for (CutPart::Hole& hole : part.holes) hole.centre -= datum;
  for (ArcVertex& vertex : part.outline) vertex.at -= datum;
  for (TextShape& label : part.labels) label.at -= datum;
  const Box box = bounding_box(part.outline);
  return {std::move(part), box};
}

/// True if a coordinate is not that of the datum: nothing is dimensioned as 0.
bool is_off(double coordinate) { return figure(std::abs(coordinate)) != "0"; }

constexpr double shelf_above = 10,
                 overall_above = 16;  ///< mm, over the part: the note on its holes, its length

Surround surround_of(const CutPart& part) {
  constexpr double figure_outside = 20;  // mm: a figure beside its arrows
  double along = 0, up = 0;
  for (const CutPart::Hole& hole : part.holes) {
    along += is_off(hole.centre.x()) ? 1 : 0;
    up += is_off(hole.centre.y()) ? 1 : 0;
  }
  return {std::max(figure_outside, 6 + dimension_step * up), 30,
          std::max(figure_outside, 4 + dimension_step * along), overall_above + 6};
}

Table hole_table(const CutPart& part) {
  Table table{"Holes, from " + std::string(1, letter(part.holes[0].joint)),
              {{"Hole", 13, Align::middle},
               {"x", 24, Align::right},
               {"y", 24, Align::right},
               {"\u00d8", 17, Align::right}}};
  for (const CutPart::Hole& hole : part.holes)
    table.rows.push_back({std::string(1, letter(hole.joint)), figure(hole.centre.x()),
                          figure(hole.centre.y()), figure(hole.diameter)});
  return table;
}

Table distance_table(const CutPart& part) {
  Table table{"Between holes", {{"Holes", 18, Align::middle}, {"mm", 24, Align::right}}};
  for (std::size_t i = 0; i < part.holes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      table.rows.push_back({{letter(part.holes[j].joint), letter(part.holes[i].joint)},
                            figure((part.holes[i].centre - part.holes[j].centre).norm())});
  return table;
}

void draw_holes(Sheet& sheet, const CutPart& part, const View& view) {
  for (const CutPart::Hole& hole : part.holes) {
    const double radius = 0.5 * hole.diameter * view.scale;
    if (radius > 0) sheet.circle(view.at(hole.centre), radius, Pen::outline);
    draw_hole_axes(sheet, view.at(hole.centre), radius);
  }
}

/// Where a hole's letter stands: towards `middle`, clear of the hole's axes.
Point beside_hole(const CutPart& part, const View& view, char name, const Point& middle, double height) {
  for (const CutPart::Hole& hole : part.holes) {
    if (letter(hole.joint) != name) continue;
    const Point centre = view.at(hole.centre), way = middle - centre;
    const double clear = 0.5 * hole.diameter * view.scale + hole_axis_beyond + 0.3 + 0.6 * height;
    return centre + std::max(clear, way.norm()) * way.normalized();
  }
  return middle;
}

/// Letters of the holes where they are engraved, neither larger nor smaller than is read well, and the name where they leave it room; the
/// title block says it anyway. Those that are far too small are left out.
void draw_labels(Sheet& sheet, const CutPart& part, const View& view, const Lettering& lettering) {
  std::vector<SheetText> letters;
  std::optional<SheetText> name;
  for (const TextShape& label : part.labels) {
    const double engraved = label.height * view.scale,
                 height = std::clamp(engraved, small_text, title_height);
    if (engraved < 0.5 * small_text) continue;
    // The middle of the letters stays where it is.
    const Point up = as_point(std::polar(1.0, label.turn + pi / 2));
    const Point middle = view.at(label.at + 0.5 * label.height * up);
    const bool is_letter = label.text.size() == 1;
    const Point at = is_letter ? beside_hole(part, view, label.text.front(), middle, height) : middle;
    const SheetText text{label.text, at - 0.5 * height * up, height, Align::middle, label.turn};
    if (is_letter)
      letters.push_back(text);
    else
      name = text;
  }
  for (const SheetText& text : letters) sheet.marks.emplace_back(text);
  const bool has_room =
      name && std::all_of(letters.begin(), letters.end(), [&](const SheetText& text) {
        return (text.at - name->at).norm() > 0.5 * lettering(name->text, name->height) + 1.5 * text.height;
      });
  if (has_room) sheet.marks.emplace_back(*name);
}

/// Every hole from the datum, the nearest first, then the link's length and width over all.
void draw_dimensions(Sheet& sheet, const DrawnLink& link, const View& view, const Lettering& lettering) {
  const CutPart& part = link.part;
  const Point lower = view.at(link.box.lower), upper = view.at(link.box.upper), datum = view.at(Point(0, 0));
  std::vector<CutPart::Hole> by_height = part.holes;
  std::stable_sort(by_height.begin(), by_height.end(), [](const CutPart::Hole& a, const CutPart::Hole& b) {
    return std::abs(a.centre.y()) < std::abs(b.centre.y());
  });
  double y = lower.y(), x = lower.x();
  std::string last;  // holes at one distance are dimensioned once
  for (const CutPart::Hole& hole : part.holes) {
    const std::string along = figure(hole.centre.x());
    if (!is_off(hole.centre.x()) || along == last) continue;
    dimension_along_x(sheet, datum, view.at(hole.centre), y -= dimension_step, along, lettering);
    last = along;
  }
  last.clear();
  for (const CutPart::Hole& hole : by_height) {
    const std::string up = figure(std::abs(hole.centre.y()));
    if (!is_off(hole.centre.y()) || up == last) continue;
    dimension_along_y(sheet, datum, view.at(hole.centre), x -= dimension_step, up, lettering, true);
    last = up;
  }
  const Point size = link.box.upper - link.box.lower;
  dimension_along_x(sheet, {lower.x(), upper.y()}, upper, upper.y() + overall_above, figure(size.x()),
                    lettering);
  dimension_along_y(sheet, {upper.x(), lower.y()}, upper, upper.x() + dimension_step, figure(size.y()),
                    lettering);
}

/// Of holes that differ that which the leader points at: the table has them all.
std::string note_of(const CutPart& part) {
  const double diameter = part.holes.back().diameter;
  const bool alike = std::all_of(part.holes.begin(), part.holes.end(),
                                 [&](const auto& hole) { return hole.diameter == diameter; });
  return alike ? holes_text(part) : "\u00d8" + figure(diameter);
}

/// Number and diameter of the holes, on a shelf to the upper right of the part.
void note_holes(Sheet& sheet, const DrawnLink& link, const View& view, const Lettering& lettering) {
  const CutPart& part = link.part;
  const CutPart::Hole& last = part.holes.back();
  if (last.diameter <= 0) return;
  const Point upper = view.at(link.box.upper), centre = view.at(last.centre);
  const Point at(upper.x() + 3, upper.y() + shelf_above);
  draw_leader(sheet, note_of(part), at,
              centre + 0.5 * last.diameter * view.scale * (at - centre).normalized(), lettering);
}

/// What the drawing and its tables do not say: the walls beside the holes, and of a bent link where its first hole lies in the blank.
std::vector<std::string> notes_on(const Design& design, const DrawnLink& link) {
  const double half = 0.5 * design.style.width;
  double widest = 0;
  for (const CutPart::Hole& hole : link.part.holes) widest = std::max(widest, hole.diameter);
  std::vector<std::string> notes{fmt::format("Ends, corners R{}", figure(half)),
                                 fmt::format("Thickness {}", figure(link.part.thickness))};
  if (widest > 0)
    notes.push_back(widest < 2 * half ? fmt::format("Hole to edge {}", figure(half - 0.5 * widest))
                                      : "Hole to edge: no wall");
  if (is_off(-link.box.lower.y() - half)) {
    const char datum = letter(link.part.holes.front().joint);
    notes.push_back(fmt::format("{} from left {}", datum, figure(-link.box.lower.x())));
    notes.push_back(fmt::format("{} from front {}", datum, figure(-link.box.lower.y())));
  }
  notes.insert(notes.end(), {"Seen from above:", "not to be mirrored"});
  return notes;
}

constexpr double notes_head = heading_height + 0.6;  ///< mm, above the first line

void write_notes(Sheet& sheet, const std::vector<std::string>& notes, const Point& top_left) {
  double y = top_left.y() - notes_head;
  sheet.text("Notes", {top_left.x(), y}, heading_height);
  for (const std::string& line : notes)
    sheet.text(line, {top_left.x(), y -= line_pitch * text_height}, text_height);
}

std::string link_title(const Task& task, const CutPart& part) {
  return fmt::format("Link {}, item {}, layer {}", part.name, item_number(task.bill, part.name), part.layer);
}

struct Tables {
  Table holes, distances;
  std::vector<std::string> notes;
  std::string why_not_cut;  ///< empty: the link can be cut
  double height(const Lettering& lettering) const {
    const double lines = line_pitch * text_height * static_cast<double>(notes.size());
    return std::max({holes.height(lettering), distances.height(lettering), notes_head + lines});
  }
};

/// Where the tables stand: side by side at the foot, above the ruler.
constexpr double between_tables = 5, above_tables = 4;

/// Why the link cannot be cut, in lines across a field of the sheet.
std::vector<std::string> lines_of(const std::string& why_not_cut, const Box& field,
                                  const Lettering& lettering) {
  if (why_not_cut.empty()) return {};
  return wrapped("Do not cut: " + why_not_cut, heading_height, field.upper.x() - field.lower.x(), lettering);
}

/// The sheet of this link on paper lying or standing, at the largest scale that fits.
struct Layout {
  Point size;
  Box field;  ///< room of the view
  double scale;
};

Layout layout_of(const Task& task, const DrawnLink& link, const Tables& tables, Orientation orientation) {
  const Point size = sheet_size(task.paper, orientation);
  Box field = room_of(size);
  field.lower.y() += ruler_room + tables.height(task.lettering) + above_tables;
  field.upper.y() -= line_pitch * heading_height *
                     static_cast<double>(lines_of(tables.why_not_cut, field, task.lettering).size());
  const Surround around = surround_of(link.part);
  const Point rest =
      field.upper - field.lower - Point(around.left + around.right, around.below + around.above);
  const Point extent = link.box.upper - link.box.lower;
  constexpr double small = 40, enlarged = 10;  // links shorter than 40 mm are drawn larger too
  return {size, field, fitting_scale(extent, rest, extent.maxCoeff() < small ? enlarged : 1)};
}

Sheet dimensioned(const Task& task, const DrawnLink& link, const Tables& tables, const Layout& layout) {
  Sheet sheet{layout.size, {link_title(task, link.part), stock_text(task.design), scale_text(layout.scale)}};
  const Surround around = surround_of(link.part);
  const Point paper = layout.scale * (link.box.upper - link.box.lower);
  const Point needed = paper + Point(around.left + around.right, around.below + around.above);
  const Point corner = layout.field.lower + 0.5 * (layout.field.upper - layout.field.lower - needed) +
                       Point(around.left, around.below);
  const View view{layout.scale, corner - layout.scale * link.box.lower};
  double y = room_of(layout.size).upper.y() - heading_height;
  for (const std::string& line : lines_of(tables.why_not_cut, layout.field, task.lettering)) {
    sheet.text(line, {layout.field.lower.x(), y}, heading_height);
    y -= line_pitch * heading_height;
  }
  sheet.outline(view.at(link.part.outline), Pen::outline);
  draw_holes(sheet, link.part, view);
  draw_labels(sheet, link.part, view, task.lettering);
  draw_dimensions(sheet, link, view, task.lettering);
  note_holes(sheet, link, view, task.lettering);
  const Point top_left(layout.field.lower.x(), layout.field.lower.y() - above_tables);
  tables.holes.draw(sheet, top_left, task.lettering);
  const Point second = top_left + Point(tables.holes.width() + between_tables, 0);
  tables.distances.draw(sheet, second, task.lettering);
  write_notes(sheet, tables.notes, second + Point(tables.distances.width() + between_tables, 0));
  if (layout.scale == 1) draw_ruler(sheet);
  return sheet;
}

}  // namespace

std::vector<Sheet> link_sheets(const Task& task, Link link) {
  const DrawnLink drawn = drawn_link(task, link);
  const Tables tables{hole_table(drawn.part), distance_table(drawn.part), notes_on(task.design, drawn),
                      why_not_cut(task.design)};
  const Layout standing = layout_of(task, drawn, tables, Orientation::portrait);
  const Layout lying = layout_of(task, drawn, tables, Orientation::landscape);
  const Layout& layout = lying.scale > standing.scale ? lying : standing;
  std::vector<Sheet> sheets{dimensioned(task, drawn, tables, layout)};
  if (layout.scale == 1 || !tables.why_not_cut.empty()) return sheets;
  const auto draw = [&](Sheet& sheet, const View& view) {
    sheet.outline(view.at(drawn.part.outline), Pen::outline);
    draw_holes(sheet, drawn.part, view);
  };
  const SheetTitle title{link_title(task, drawn.part), stock_text(task.design), "1:1"};
  for (Sheet& tile : tiled(draw, drawn.box, task.paper, title)) sheets.push_back(std::move(tile));
  return sheets;
}

}  // namespace kempe::workshop
