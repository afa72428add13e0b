#include "reports/workshop/tiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kempe::workshop {
namespace {

/// The windows along one direction: how many, how wide, and where the first begins.
struct Cuts {
  int count;
  double first, window;
  double step() const { return window - tile_overlap; }
  double from(int index) const { return first + index * step(); }
  /// The join behind a window.
  double join(int index) const { return from(index) + window - 0.5 * tile_overlap; }
};

Cuts cuts_along(double lower, double upper, double window) {
  constexpr double beside = 4;  // mm around the drawing
  const double length = upper - lower + 2 * beside, step = window - tile_overlap;
  const double wanted = std::ceil((length - tile_overlap) / step);
  const int count = static_cast<int>(std::clamp(wanted, 1.0, most_tiles + 1.0));
  // One sheet has it in its middle, of several the first begins with it.
  return {count, count == 1 ? 0.5 * (lower + upper - window) : lower - beside, window};
}

struct Grid {
  Orientation orientation;
  Cuts across, up;
  int count() const { return across.count * up.count; }
};

Box window_on_paper(const Point& sheet_size) {
  Box window = room_of(sheet_size);
  window.lower.y() += ruler_room;
  return window;
}

Grid grid_for(const Box& box, Paper paper, Orientation orientation) {
  const Box window = window_on_paper(sheet_size(paper, orientation));
  const Point size = window.upper - window.lower;
  return {orientation, cuts_along(box.lower.x(), box.upper.x(), size.x()),
          cuts_along(box.lower.y(), box.upper.y(), size.y())};
}

/// A cross in a ring; its name stands on the side away from the near edge of the paper.
void draw_mark(Sheet& sheet, const Point& at, const std::string& name) {
  sheet.circle(at, 2, Pen::thin);
  sheet.line(at - Point(4, 0), at + Point(4, 0), Pen::hatch);
  sheet.line(at - Point(0, 4), at + Point(0, 4), Pen::hatch);
  const bool is_right = at.x() > 0.5 * sheet.size.x();
  sheet.text(name, at + Point(is_right ? -2.4 : 2.4, 1.2), small_text, is_right ? Align::right : Align::left);
}

std::string tile_name(int column, int row) {
  const std::string letters =
      column < 26 ? std::string(1, static_cast<char>('A' + column)) : fmt::format("X{}.", column);
  return fmt::format("{}{}", letters, row + 1);
}

/// The join behind window `index` of the one direction, within this window of the other; `swapped`: joins run across.
void draw_join(Sheet& sheet, const View& view, double join, double from, double to, bool swapped,
               const std::string& name) {
  const auto place = [&](double along) { return view.at(swapped ? Point(along, join) : Point(join, along)); };
  sheet.line(place(from), place(to), Pen::phantom);
  draw_mark(sheet, place(from + 0.2 * (to - from)), name + "a");
  draw_mark(sheet, place(to - 0.2 * (to - from)), name + "b");
}

Sheet tile_sheet(const Draw& draw, const Grid& grid, int column, int row, Paper paper, SheetTitle title) {
  const std::string name = tile_name(column, row);
  if (grid.count() > 1) title.part += fmt::format(", tile {} of {}", name, grid.count());
  Sheet sheet{sheet_size(paper, grid.orientation), std::move(title)};
  const Box window = window_on_paper(sheet.size);
  const double left = grid.across.from(column), low = grid.up.from(row);
  const View view{1, window.lower - Point(left, low)};
  sheet.marks.emplace_back(ClipBegin{window});
  draw(sheet, view);
  sheet.marks.emplace_back(ClipEnd{});
  // Both tiles of a join name its crosses alike, and no other join has the same two tiles.
  const auto join_up = [&](int before) {
    draw_join(sheet, view, grid.across.join(before), low, low + grid.up.window, false,
              fmt::format("{}-{} ", tile_name(before, row), tile_name(before + 1, row)));
  };
  const auto join_across = [&](int before) {
    draw_join(sheet, view, grid.up.join(before), left, left + grid.across.window, true,
              fmt::format("{}-{} ", tile_name(column, before), tile_name(column, before + 1)));
  };
  if (column > 0) join_up(column - 1);
  if (column + 1 < grid.across.count) join_up(column);
  if (row > 0) join_across(row - 1);
  if (row + 1 < grid.up.count) join_across(row);
  if (grid.count() > 1)
    sheet.text("Tile " + name,  // under a join along the upper edge, with its crosses
               {window.lower.x() + 18, window.upper.y() - tile_overlap - heading_height - 1}, heading_height);
  draw_ruler(sheet);
  return sheet;
}

}  // namespace

std::vector<Sheet> tiled(const Draw& draw, const Box& box, Paper paper, const SheetTitle& title) {
  const Grid lying = grid_for(box, paper, Orientation::landscape);
  const Grid standing = grid_for(box, paper, Orientation::portrait);
  const Grid& grid = standing.count() < lying.count() ? standing : lying;
  std::vector<Sheet> sheets;
  if (grid.count() > most_tiles) return sheets;
  for (int row = 0; row < grid.up.count; ++row)
    for (int column = 0; column < grid.across.count; ++column)
      sheets.push_back(tile_sheet(draw, grid, column, row, paper, title));
  return sheets;
}

}  // namespace kempe::workshop
