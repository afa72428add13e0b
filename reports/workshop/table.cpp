#include "reports/workshop/table.hpp"

#include <algorithm>

namespace kempe::workshop {
namespace {

constexpr double cell_margin = 1.2;                           ///< mm, beside a cell's text
constexpr double row_pitch = line_pitch * text_height;        ///< mm, of a line in a cell
constexpr double heading_room = line_pitch * heading_height;  ///< mm
constexpr double foot = 0.15 * row_pitch;                     ///< mm, below a row's last line

using Lines = std::vector<std::string>;

std::vector<Lines> cell_lines(const Table& table, const std::vector<std::string>& row,
                              const Lettering& lettering) {
  std::vector<Lines> cells;
  for (std::size_t i = 0; i < row.size(); ++i)
    cells.push_back(wrapped(row[i], text_height, table.columns[i].width - 2 * cell_margin, lettering));
  return cells;
}

double row_height(const std::vector<Lines>& cells) {
  std::size_t lines = 1;
  for (const Lines& cell : cells) lines = std::max(lines, cell.size());
  return row_pitch * static_cast<double>(lines) + 0.2 * row_pitch;
}

std::vector<std::string> heads(const Table& table) {
  std::vector<std::string> row;
  for (const Column& column : table.columns) row.push_back(column.head);
  return row;
}

double text_place(const Column& column, double left) {
  switch (column.align) {
    case Align::left: return left + cell_margin;
    case Align::middle: return left + 0.5 * column.width;
    case Align::right: break;
  }
  return left + column.width - cell_margin;
}

/// Draws a row below `top`; gives its height.
double draw_row(Sheet& sheet, const Table& table, const std::vector<std::string>& row, const Point& top_left,
                const Lettering& lettering) {
  const auto cells = cell_lines(table, row, lettering);
  double left = top_left.x();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double base = top_left.y() - row_pitch + foot;
    for (const std::string& line : cells[i]) {
      sheet.text(line, {text_place(table.columns[i], left), base}, text_height, table.columns[i].align);
      base -= row_pitch;
    }
    left += table.columns[i].width;
  }
  return row_height(cells);
}

}  // namespace

double Table::width() const {
  double sum = 0;
  for (const Column& column : columns) sum += column.width;
  return sum;
}

double Table::height(const Lettering& lettering) const {
  double sum = heading_room + row_height(cell_lines(*this, heads(*this), lettering));
  for (const auto& row : rows) sum += row_height(cell_lines(*this, row, lettering));
  return sum;
}

std::size_t Table::fitting_rows(std::size_t first, double room, const Lettering& lettering) const {
  double left = room - heading_room - row_height(cell_lines(*this, heads(*this), lettering));
  std::size_t last = first;
  while (last < rows.size()) {
    left -= row_height(cell_lines(*this, rows[last], lettering));
    if (left < 0) break;
    ++last;
  }
  return std::max(last, std::min(first + 1, rows.size()));
}

void Table::draw(Sheet& sheet, const Point& top_left, const Lettering& lettering, std::size_t first,
                 std::size_t last) const {
  sheet.text(heading, top_left - Point(0, heading_height + 0.6), heading_height);
  const double right = top_left.x() + width();
  double y = top_left.y() - heading_room;
  const double top = y;
  const auto rule = [&](Pen pen) { sheet.line({top_left.x(), y}, {right, y}, pen); };
  rule(Pen::outline);
  y -= draw_row(sheet, *this, heads(*this), {top_left.x(), y}, lettering);
  rule(Pen::outline);
  for (std::size_t i = first; i < last; ++i) {
    y -= draw_row(sheet, *this, rows[i], {top_left.x(), y}, lettering);
    if (i + 1 < last) rule(Pen::hatch);
  }
  rule(Pen::outline);
  double x = top_left.x();
  for (std::size_t i = 0; i <= columns.size(); ++i) {
    const bool edge = i == 0 || i == columns.size();
    sheet.line({x, top}, {x, y}, edge ? Pen::outline : Pen::hatch);
    if (!edge || i == 0) x += columns[i].width;
  }
}

}  // namespace kempe::workshop
