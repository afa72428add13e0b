#include "reports/drawings/nesting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "geometry/segment_distance.hpp"

namespace kempe {
namespace {

/// A set of cells of a grid, a row of words for each y.
class Cells {
 public:
  Cells(int columns, int rows)
      : columns_(columns), rows_(rows), words_((static_cast<std::size_t>(columns) + 63) / 64),
        bits_(words_ * static_cast<std::size_t>(rows), 0) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  void set(int x, int y) { word(x, y) |= std::uint64_t{1} << (x % 64); }

  /// True if `part`, moved by (x, y), meets a cell that is set here.
  bool meets(const Cells& part, int x, int y) const {
    for (int row = 0; row < part.rows_; ++row)
      for (std::size_t w = 0; w < part.words_; ++w)
        if ((part.row(row)[w] & window(y + row, x + static_cast<int>(w) * 64)) != 0) return true;
    return false;
  }
  void add(const Cells& part, int x, int y) {
    for (int row = 0; row < part.rows_; ++row)
      for (int column = 0; column < part.columns_; ++column)
        if ((part.row(row)[static_cast<std::size_t>(column) / 64] >> (column % 64) & 1) != 0)
          set(x + column, y + row);
  }

 private:
  const std::uint64_t* row(int y) const { return bits_.data() + static_cast<std::size_t>(y) * words_; }
  std::uint64_t& word(int x, int y) {
    return bits_[static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>(x) / 64];
  }
  /// 64 cells of a row from x on; beyond the row none is set.
  std::uint64_t window(int y, int x) const {
    const auto first = static_cast<std::size_t>(x) / 64;
    const int shift = x % 64;
    std::uint64_t result = first < words_ ? row(y)[first] >> shift : 0;
    if (shift > 0 && first + 1 < words_) result |= row(y)[first + 1] << (64 - shift);
    return result;
  }

  int columns_, rows_;
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

/// A part in one turn: its cells, those included that anything within `reach` of the part touches.
struct Footing {
  double turn;
  Point lower;  ///< of the turned outline's box
  Cells cells;
};

/// Cells whose centres lie within `reach` of an edge.
void add_edge(Cells& cells, const Point& a, const Point& b, double cell, double reach) {
  const Point lower = (a.cwiseMin(b) - Point(reach, reach)) / cell,
              upper = (a.cwiseMax(b) + Point(reach, reach)) / cell;
  const int left = std::max(0, static_cast<int>(lower.x())),
            bottom = std::max(0, static_cast<int>(lower.y()));
  const int right = std::min(cells.columns() - 1, static_cast<int>(upper.x()));
  const int top = std::min(cells.rows() - 1, static_cast<int>(upper.y()));
  for (int y = bottom; y <= top; ++y)
    for (int x = left; x <= right; ++x)
      if (distance(cell * Point(x + 0.5, y + 0.5), a, b) <= reach) cells.set(x, y);
}

/// Cells whose centres the ring surrounds.
void add_inside(Cells& cells, const Ring& ring, double cell) {
  for (int y = 0; y < cells.rows(); ++y) {
    const double height = cell * (y + 0.5);
    std::vector<double> crossings;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y() <= height) != (b.y() <= height))
        crossings.push_back(a.x() + (b.x() - a.x()) * (height - a.y()) / (b.y() - a.y()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      for (int x = std::max(0, static_cast<int>(std::ceil(crossings[i] / cell - 0.5)));
           x < cells.columns() && cell * (x + 0.5) <= crossings[i + 1]; ++x)
        cells.set(x, y);
  }
}

/// A cell belongs to the part if its centre is inside, or nearer to it than the reach and half a cell's
/// diagonal: then no point within the reach of the part lies in a cell that does not belong to it.
Footing footing(const ArcRing& outline, double turn, double cell, double reach) {
  const ArcRing turned = placed(outline, {Point::Zero(), turn});
  const Box box = bounding_box(turned);
  const Point size = box.upper - box.lower + 2 * Point(reach, reach);
  Footing result{turn, box.lower,
                 Cells(static_cast<int>(std::ceil(size.x() / cell)) + 1,
                       static_cast<int>(std::ceil(size.y() / cell)) + 1)};
  Ring ring = flattened(ArcPolygon{turned, {}}, 0.1 * cell, Flatten::grows).outer;
  for (Point& point : ring) point += Point(reach, reach) - box.lower;
  for (std::size_t i = 0; i < ring.size(); ++i)
    add_edge(result.cells, ring[i], ring[(i + 1) % ring.size()], cell, reach + 0.71 * cell);
  add_inside(result.cells, ring, cell);
  return result;
}

struct Spot {
  int x, y, top;
};

std::optional<Spot> lowest_spot(const Cells& sheet, const Cells& part) {
  for (int y = 0; y + part.rows() <= sheet.rows(); ++y)
    for (int x = 0; x + part.columns() <= sheet.columns(); ++x)
      if (!sheet.meets(part, x, y)) return Spot{x, y, y + part.rows()};
  return std::nullopt;
}

/// Sheets that fill up part by part.
class Nester {
 public:
  Nester(const Point& size, double gap)
      : size_(size), gap_(gap), cell_(std::max(size.minCoeff() / 200, size.maxCoeff() / 600)) {
    // Half the gap belongs to each part, the other half is left at the sheet's edge.
    const Point usable = (size - Point(gap, gap)) / cell_;
    columns_ = static_cast<int>(std::floor(std::max(0.0, usable.x())));
    rows_ = static_cast<int>(std::floor(std::max(0.0, usable.y())));
  }

  std::optional<NestedPart> put(const ArcRing& outline) {
    if (auto found = put_turned(outline, pi / 2, 4, 0)) return found;
    return put_turned(outline, pi / 36, 36, sheets_.size());
  }

 private:
  /// Tries the turns on every sheet from `first` on and on a new one.
  std::optional<NestedPart> put_turned(const ArcRing& outline, double step, int steps, std::size_t first) {
    std::vector<Footing> turns;
    for (int i = 0; i < steps; ++i) {
      Footing one = footing(outline, step * i, cell_, 0.5 * gap_);
      if (one.cells.columns() <= columns_ && one.cells.rows() <= rows_) turns.push_back(std::move(one));
    }
    if (turns.empty()) return std::nullopt;
    for (std::size_t sheet = first;; ++sheet) {
      if (sheet == sheets_.size()) sheets_.emplace_back(columns_, rows_);
      if (auto found = put_on(sheet, turns)) return found;
    }
  }

  std::optional<NestedPart> put_on(std::size_t sheet, const std::vector<Footing>& turns) {
    std::optional<Spot> best;
    const Footing* chosen = nullptr;
    for (const Footing& turn : turns) {
      const auto spot = lowest_spot(sheets_[sheet], turn.cells);
      if (!spot || (best && spot->top >= best->top)) continue;
      best = spot;
      chosen = &turn;
    }
    if (!best) return std::nullopt;
    sheets_[sheet].add(chosen->cells, best->x, best->y);
    const Point corner = Point(0.5 * gap_, 0.5 * gap_) + cell_ * Point(best->x, best->y);
    return NestedPart{sheet, {corner + Point(0.5 * gap_, 0.5 * gap_) - chosen->lower, chosen->turn}};
  }

  Point size_;
  double gap_, cell_;
  int columns_ = 0, rows_ = 0;
  std::vector<Cells> sheets_;
};

}  // namespace

tl::expected<std::vector<NestedPart>, std::string> nest(const std::vector<CutPart>& parts, const Point& size,
                                                        double gap) {
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return signed_area(parts[a].outline) > signed_area(parts[b].outline);
  });
  Nester nester(size, gap);
  std::vector<NestedPart> result(parts.size());
  for (const std::size_t i : order) {
    const auto nested = nester.put(parts[i].outline);
    if (!nested) {
      const Box box = bounding_box(parts[i].outline);
      return tl::unexpected(
          fmt::format("link {} ({:.1f} x {:.1f} mm) does not fit on a sheet of {:.9g} x {:.9g} mm with a gap "
                      "of {:.9g} mm",
                      parts[i].name, box.upper.x() - box.lower.x(), box.upper.y() - box.lower.y(), size.x(),
                      size.y(), gap));
    }
    result[i] = *nested;
  }
  return result;
}

Drawing nested_drawing(const std::vector<CutPart>& parts, const std::vector<NestedPart>& nested,
                       const Point& size) {
  Drawing drawing;
  const double step = size.x() + 20;
  std::size_t sheets = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Placement placement = nested[i].placement;
    placement.move.x() += step * static_cast<double>(nested[i].sheet);
    append(drawing, part_drawing(parts[i]), placement);
    sheets = std::max(sheets, nested[i].sheet + 1);
  }
  drawing.layers.push_back({"SHEET", 8, "#999", false});
  for (std::size_t i = 0; i < sheets; ++i) {
    const Point at(step * static_cast<double>(i), 0);
    drawing.shapes.push_back(OutlineShape{
        "SHEET", {{at}, {at + Point(size.x(), 0)}, {at + size}, {at + Point(0, size.y())}}, true});
  }
  return drawing;
}

}  // namespace kempe
