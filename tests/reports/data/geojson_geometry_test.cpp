#include "reports/data/geojson_geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/workspace/random_linkage.hpp"

namespace kempe {
namespace {

Ring random_ring(test::Dice& dice) {
  Ring ring;
  for (int i = dice.below(6); i > 0; --i) {
    const double x = dice.between(-1e3, 1e3), tiny = dice.between(-1e-5, 1e-5);
    const int whole = dice.below(9);
    ring.emplace_back(x, i % 3 == 0 ? whole : tiny);
  }
  return ring;
}

TEST(GeojsonGeometry, TextIsThatOfTheValues) {
  test::Dice dice(12);
  for (int i = 0; i < 300; ++i) {
    Region region;
    for (int polygons = dice.below(4); polygons > 0; --polygons) {
      Polygon& polygon = region.polygons.emplace_back();
      polygon.outer = random_ring(dice);
      for (int holes = dice.below(3); holes > 0; --holes) polygon.holes.push_back(random_ring(dice));
    }
    for (const int indent : {-1, 0, 1, 2}) {
      std::string alone, inside;
      append_multi_polygon(alone, region, indent, 0);
      append_multi_polygon(inside, region, indent, 1);
      EXPECT_EQ(alone, multi_polygon(region).dump(indent));
      const std::string line = indent < 0 ? "" : "\n",
                        space(static_cast<std::size_t>(std::max(indent, 0)), ' ');
      EXPECT_EQ("[" + line + space + inside + line + "]",
                nlohmann::ordered_json::array({multi_polygon(region)}).dump(indent));
    }
  }
}

}  // namespace
}  // namespace kempe
