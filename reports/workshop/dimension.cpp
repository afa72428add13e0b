#include "reports/workshop/dimension.hpp"

#include <fmt/format.h>

#include <cmath>

namespace kempe::workshop {
namespace {

constexpr double arrow_length = 2.5, arrow_half_width = 0.42;  ///< mm: an angle of 19 degrees
constexpr double gap_at_part = 1, beyond_line = 1.5;           ///< mm, of extension lines
constexpr double above_line = 0.8;                             ///< mm, from a line to the figure's foot
constexpr double tail = 6;                                     ///< mm, of lines whose arrows stand outside

/// A dimension in a frame of its own: `u` along what is measured, `v` towards the head of its figure.
struct Axes {
  Point u, v;
};

void extension(Sheet& sheet, const Point& part, const Point& line) {
  const Point way = line - part;
  const double length = way.norm();
  if (length <= gap_at_part) return;
  const Point along = way / length;
  sheet.line(part + gap_at_part * along, line + beyond_line * along, Pen::thin);
}

void dimension(Sheet& sheet, const Point& part_from, const Point& part_to, const Point& from, const Point& to,
               const Axes& axes, const std::string& figure, const Lettering& lettering, bool behind) {
  extension(sheet, part_from, from);
  extension(sheet, part_to, to);
  const double length = (to - from).dot(axes.u), width = lettering(figure, text_height);
  const double turn = std::atan2(axes.u.y(), axes.u.x());
  const Point up = above_line * axes.v;
  if (length >= width + 2 * arrow_length) {
    sheet.line(from, to, Pen::thin);
    draw_arrow(sheet, from, -axes.u);
    draw_arrow(sheet, to, axes.u);
    sheet.text(figure, 0.5 * (from + to) + up, text_height, Align::middle, turn);
    return;
  }
  const double shelf = tail + width;
  sheet.line(from - (behind ? tail : shelf) * axes.u, to + (behind ? shelf : tail) * axes.u, Pen::thin);
  draw_arrow(sheet, from, axes.u);
  draw_arrow(sheet, to, -axes.u);
  if (behind)
    sheet.text(figure, to + (tail - 1) * axes.u + up, text_height, Align::left, turn);
  else
    sheet.text(figure, from - (tail - 1) * axes.u + up, text_height, Align::right, turn);
}

}  // namespace

void draw_arrow(Sheet& sheet, const Point& tip, const Point& along) {
  const Point aside = arrow_half_width * Point(-along.y(), along.x()), back = tip - arrow_length * along;
  sheet.marks.emplace_back(
      SheetPath{{{tip}, {back + aside}, {back - aside}}, true, Pen::thin, Fill::ink, false});
}

void dimension_along_x(Sheet& sheet, const Point& from, const Point& to, double y, const std::string& figure,
                       const Lettering& lettering, bool behind) {
  const bool ordered = from.x() <= to.x();
  const Point &left = ordered ? from : to, &right = ordered ? to : from;
  dimension(sheet, left, right, {left.x(), y}, {right.x(), y}, {Point(1, 0), Point(0, 1)}, figure, lettering,
            behind);
}

void dimension_along_y(Sheet& sheet, const Point& from, const Point& to, double x, const std::string& figure,
                       const Lettering& lettering, bool behind) {
  const bool ordered = from.y() <= to.y();
  const Point &low = ordered ? from : to, &high = ordered ? to : from;
  dimension(sheet, low, high, {x, low.y()}, {x, high.y()}, {Point(0, 1), Point(-1, 0)}, figure, lettering,
            behind);
}

void draw_hole_axes(Sheet& sheet, const Point& centre, double radius) {
  const double reach = radius + hole_axis_beyond;
  sheet.line(centre - Point(reach, 0), centre + Point(reach, 0), Pen::centre);
  sheet.line(centre - Point(0, reach), centre + Point(0, reach), Pen::centre);
}

void draw_leader(Sheet& sheet, const std::string& text, const Point& at, const Point& target,
                 const Lettering& lettering, bool to_left) {
  const double width = lettering(text, text_height) + 1;
  const Point end = at + Point(to_left ? -width : width, 0);
  sheet.line(at, end, Pen::thin);
  sheet.line(at, target, Pen::thin);
  draw_arrow(sheet, target, (target - at).normalized());
  sheet.text(text, Point(std::min(at.x(), end.x()) + 0.5, at.y() + above_line), text_height);
}

void draw_balloon(Sheet& sheet, int item, const Point& at, const Point& target) {
  const Point way = target - at;
  if (way.norm() > balloon_radius) {
    sheet.line(at + balloon_radius * way.normalized(), target, Pen::thin);
    sheet.circle(target, 0.5, Pen::thin, Fill::ink);
  }
  sheet.circle(at, balloon_radius, Pen::thin, Fill::paper);
  sheet.text(fmt::format("{}", item), at - Point(0, 0.5 * text_height), text_height, Align::middle);
}

}  // namespace kempe::workshop
