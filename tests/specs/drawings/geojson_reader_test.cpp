#include "specs/drawings/geojson_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kempe {
namespace {

tl::expected<Region, InputError> read(const std::string& text, double margin = 0) {
  return read_geojson_region(text, "r.geojson", {Cover::hull, margin});
}

const std::string square = R"([[[0,0],[10,0],[10,10],[0,10],[0,0]]])";

TEST(GeoJson, ReadsAPolygonWithAHoleOfEitherDirection) {
  for (const char* hole : {"[[2,2],[4,2],[4,4],[2,4],[2,2]]", "[[2,2],[2,4],[4,4],[4,2],[2,2]]"}) {
    const auto region =
        read(std::string(R"({"type":"Polygon","coordinates":[[[0,0],[0,10],[10,10],[10,0],[0,0]],)") + hole +
             "]}");
    ASSERT_TRUE(region) << region.error().message();
    EXPECT_DOUBLE_EQ(area(*region), 96);
    EXPECT_GT(signed_area(region->polygons[0].outer), 0);
    EXPECT_LT(signed_area(region->polygons[0].holes.at(0)), 0);
  }
}

TEST(GeoJson, ReadsEveryKindOfContainer) {
  const std::string polygon = R"({"type":"Polygon","coordinates":)" + square + "}";
  const std::string feature = R"({"type":"Feature","properties":null,"geometry":)" + polygon + "}";
  const std::string nothing = R"({"type":"Feature","properties":{},"geometry":null})";
  for (const std::string& text :
       {polygon, feature, R"({"type":"FeatureCollection","features":[)" + nothing + "," + feature + "]}",
        R"({"type":"GeometryCollection","geometries":[)" + polygon + "]}",
        R"({"type":"MultiPolygon","coordinates":[)" + square + "]}"}) {
    const auto region = read(text);
    ASSERT_TRUE(region) << region.error().message();
    EXPECT_DOUBLE_EQ(area(*region), 100);
  }
}

TEST(GeoJson, UnitesPolygonsThatOverlapOrAdjoin) {
  const auto overlapping = read(R"({"type":"MultiPolygon","coordinates":[)" + square +
                                R"(,[[[5,5],[15,5],[15,15],[5,15],[5,5]]]]})");
  ASSERT_TRUE(overlapping) << overlapping.error().message();
  EXPECT_DOUBLE_EQ(area(*overlapping), 175);
  const auto adjoining = read(R"({"type":"MultiPolygon","coordinates":[)" + square +
                              R"(,[[[10,0],[15,0],[15,10],[10,10],[10,0]]]]})");
  ASSERT_TRUE(adjoining) << adjoining.error().message();
  EXPECT_EQ(adjoining->polygons.size(), 1u);
  EXPECT_DOUBLE_EQ(area(*adjoining), 150);
}

TEST(GeoJson, PassesOverHeightsAndMembersItDoesNotKnow) {
  EXPECT_TRUE(read(
      R"({"type":"Polygon","bbox":[0,0,9,9],"coordinates":[[[0,0,5],[9,0,5],[9,9,5],[0,0,5]]],"x":{"y":[]}})"));
}

TEST(GeoJson, GrowsByTheMargin) {
  const auto region = read(R"({"type":"Polygon","coordinates":)" + square + "}", 2);
  ASSERT_TRUE(region);
  const double exact = 100 + 4 * 10 * 2 + pi * 4;
  EXPECT_GE(area(*region), exact);
  EXPECT_LT(area(*region), exact + 0.05);
}

TEST(GeoJson, RefusesWhatIsNoAreaAndSaysWhere) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"[]", "found a list of 0; allowed: an object with a type"},
      {"{}", "type: found nothing"},
      {R"({"type":5})", "type: found 5"},
      {R"({"type":"Point","coordinates":[0,0]})", "type: found \"Point\""},
      {R"({"type":"Polygon"})", "coordinates: found nothing; allowed: a list"},
      {R"({"type":"Polygon","coordinates":{}})", "coordinates: found an object; allowed: a list"},
      {R"({"type":"Polygon","coordinates":[]})", "coordinates: found a list of 0; allowed: a list of rings"},
      {R"({"type":"Polygon","coordinates":[5]})", "coordinates[0]: found 5; allowed: a list of positions"},
      {R"({"type":"Polygon","coordinates":[[[1],[2],[3]]]})", "coordinates[0][0]: found a list of 1"},
      {R"({"type":"Polygon","coordinates":[[["1","2"],[2,2],[3,3]]]})",
       "coordinates[0][0]: found a list of 2"},
      {R"({"type":"Polygon","coordinates":[[[0,0],[1,1],[2,2],[0,0]]]})",
       "coordinates[0]: found a ring of no area"},
      {R"({"type":"Polygon","coordinates":[[[0,0],[1e9,0],[0,1],[0,0]]]})",
       "coordinates[0]: found a corner at [1000000000, 0]"},
      {R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[0,9]],[[20,20],[21,20],[21,21]]]})",
       "coordinates[1]: found hole 1 lies outside every polygon"},
      {R"({"type":"FeatureCollection","features":{}})", "features: found an object; allowed: a list"},
      {R"({"type":"FeatureCollection","features":[{"type":"Feature"}]})",
       "features[0].geometry: found nothing"},
      {"{\n\"type\":\n\"Polygon\"", "r.geojson:3: found"},
      {"\x01\x02", "r.geojson:1: found"},
  };
  for (const auto& [text, message] : cases) {
    const auto region = read(text);
    ASSERT_FALSE(region) << text;
    EXPECT_THAT(region.error().message(), testing::HasSubstr(message));
  }
}

TEST(GeoJson, FaultsOfAUnionStandAtAPolygonOfTheFile) {
  // Four bars around a gap into which the fifth polygon reaches with a corner.
  const auto region = read(
      R"({"type":"MultiPolygon","coordinates":[[[[0,0],[10,0],[10,2],[0,2]]],[[[0,8],[10,8],[10,10],[0,10]]],
    [[[0,1],[2,1],[2,9],[0,9]]],[[[8,1],[10,1],[10,9],[8,9]]],[[[20,20],[30,20],[30,30]],[[25,22],[40,22],[40,23]]]]})");
  ASSERT_FALSE(region);
  EXPECT_THAT(region.error().key, testing::StartsWith("coordinates["));
}

}  // namespace
}  // namespace kempe
