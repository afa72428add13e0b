#include "workspace/grid_outline.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/workspace/random_linkage.hpp"
#include "workspace/cell_polygons.hpp"

namespace kempe {
namespace {

using test::Dice;

constexpr std::uint32_t columns = 16, rows = 8;
constexpr std::uint32_t width = AngleGrid::turn / columns, height = AngleGrid::rise / rows;

std::vector<GridCell> random_cells(Dice& dice, int share) {
  std::vector<GridCell> cells;
  for (std::uint32_t x = 0; x < columns; ++x)
    for (std::uint32_t y = 0; y < rows; ++y)
      if (dice.below(100) < share) cells.push_back({x * width, y * height, width, height});
  return cells;
}

AngleGrid some_grid(int assembly_mode) {
  const CopyingLinkage linkage =
      *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, assembly_mode, Point(3, 4));
  return {linkage, shrink(linkage.assembly_mode().openings, 0.2)};
}

TEST(GridOutline, EnclosesTheAreaOfItsCells) {
  Dice dice(51);
  for (int i = 0; i < 200; ++i) {
    const AngleGrid grid = some_grid(2 + i % 2);  // the distance falls, and rises, with the opening
    const auto cells = random_cells(dice, 10 + 8 * (i % 11));
    double sum = 0;
    for (const GridCell& cell : cells) sum += grid.area(cell);
    EXPECT_NEAR(area(polygons_of(grid, cells, Corners::part)), sum,
                1e-5 * grid.area({0, 0, AngleGrid::turn, AngleGrid::rise}));
    EXPECT_NEAR(area(polygons_of(grid, cells, Corners::join)), sum,
                1e-5 * grid.area({0, 0, AngleGrid::turn, AngleGrid::rise}));
  }
}

TEST(GridOutline, NoRingTouchesItselfOrAnother) {
  Dice dice(52);
  for (int i = 0; i < 200; ++i)
    for (const Corners corners : {Corners::part, Corners::join}) {
      std::set<std::pair<std::int64_t, std::int64_t>> seen;
      for (const GridRing& ring : outline_of(random_cells(dice, 50), corners).rings) {
        const std::size_t count = ring.corners.size();
        if (count == 1) continue;
        for (const GridPoint& corner : ring.corners)
          EXPECT_TRUE(seen.insert({corner.x & (AngleGrid::turn - 1), corner.y}).second)
              << "a corner is met twice";
      }
    }
}

/// Components by flood fill: neighbours through sides, or through corners as well.
std::size_t flooded(const std::vector<GridCell>& cells, bool through_corners) {
  std::set<std::pair<int, int>> left;
  for (const GridCell& cell : cells)
    left.insert({static_cast<int>(cell.x / width), static_cast<int>(cell.y / height)});
  std::size_t count = 0;
  while (!left.empty()) {
    ++count;
    std::vector<std::pair<int, int>> open{*left.begin()};
    left.erase(left.begin());
    while (!open.empty()) {
      const auto [x, y] = open.back();
      open.pop_back();
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy) {
          if (dx != 0 && dy != 0 && !through_corners) continue;
          const std::pair next{(x + dx + static_cast<int>(columns)) % static_cast<int>(columns), y + dy};
          if (left.erase(next)) open.push_back(next);
        }
    }
  }
  return count;
}

TEST(GridOutline, ComponentsAreThoseOfAFloodFillAndEachIsOnePolygon) {
  Dice dice(53);
  for (int i = 0; i < 200; ++i) {
    const auto cells = random_cells(dice, 10 + 8 * (i % 11));
    for (const Corners corners : {Corners::part, Corners::join}) {
      const GridOutline outline = outline_of(cells, corners);
      const std::set<std::size_t> components(outline.component_of.begin(), outline.component_of.end());
      EXPECT_EQ(components.size(), flooded(cells, corners == Corners::join));
      EXPECT_EQ(polygons_of(some_grid(2), outline).size(), components.size());
    }
  }
}

TEST(GridOutline, CellsOfDifferentSizesCancelWhereTheyMeet) {
  const std::vector<GridCell> cells{{0, 0, width, height},
                                    {width, 0, width / 2, height / 2},
                                    {width, height / 2, width / 2, height / 2},
                                    {width + width / 2, 0, width / 2, height}};
  const GridOutline outline = outline_of(cells, Corners::part);
  ASSERT_EQ(outline.rings.size(), 1u);
  EXPECT_EQ(outline.rings[0].corners.size(), 4u);
}

TEST(GridOutline, AFullTurnIsAnAnnulusWithTwoCircles) {
  std::vector<GridCell> cells;
  for (std::uint32_t x = 0; x < columns; ++x) cells.push_back({x * width, 0, width, AngleGrid::rise});
  const AngleGrid grid = some_grid(2);
  const ArcRegion region = polygons_of(grid, cells, Corners::part);
  ASSERT_EQ(region.size(), 1u);
  ASSERT_EQ(region[0].holes.size(), 1u);
  const double a = grid.radius(0), b = grid.radius(AngleGrid::rise);
  EXPECT_NEAR(area(region), pi * std::abs(a * a - b * b), 1e-9);
  EXPECT_EQ(region[0].outer.size(), 2u) << "two half arcs";
}

}  // namespace
}  // namespace kempe
