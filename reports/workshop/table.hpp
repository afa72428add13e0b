#pragma once
// Tables on a sheet.

#include <string>
#include <vector>

#include "reports/workshop/sheet.hpp"

namespace kempe::workshop {

struct Column {
  std::string head;
  double width;  ///< mm
  Align align = Align::left;
};

/// A table with its heading; cells too wide for their column go on in the next line.
struct Table {
  std::string heading;
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows{};

  double width() const;
  /// mm, its heading included.
  double height(const Lettering& lettering) const;
  /// Rows from `first` on that fit into `room` (mm), at least one.
  std::size_t fitting_rows(std::size_t first, double room, const Lettering& lettering) const;
  /// Draws the rows [first, last) below `top_left`.
  void draw(Sheet& sheet, const Point& top_left, const Lettering& lettering, std::size_t first,
            std::size_t last) const;
  void draw(Sheet& sheet, const Point& top_left, const Lettering& lettering) const {
    draw(sheet, top_left, lettering, 0, rows.size());
  }
};

}  // namespace kempe::workshop
