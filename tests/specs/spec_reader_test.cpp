#include "specs/spec_reader.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "specs/spec_check.hpp"
#include "tests/geometry/random_rings.hpp"

namespace kempe {
namespace {

const std::filesystem::path examples = std::filesystem::path(KEMPE_SOURCE_DIR) / "specs/examples";

Spec read_or_fail(const std::string& text) {
  const auto spec = read_spec(text, "spec.toml", KEMPE_SOURCE_DIR "/tests/corpus/specs");
  EXPECT_TRUE(spec) << (spec ? "" : spec.error().message()) << "\n" << text;
  return spec.value_or(Spec{});
}

const std::string shortest =
    "[copy]\nscale = 1.4\nrotation_deg = 90\n[region]\ncircle_mm = {centre = [66, 0], radius = 4}\n";

TEST(SpecReader, FillsInTheDefaultsOfTheTypes) {
  const Spec spec = read_or_fail(shortest), types;
  EXPECT_EQ(spec.links.style, types.links.style);
  EXPECT_EQ(spec.links.layers, types.links.layers);
  EXPECT_EQ(spec.links.shortest, types.links.shortest);
  EXPECT_EQ(spec.links.longest, types.links.longest);
  EXPECT_FALSE(spec.links.stock_lengths.any());
  EXPECT_EQ(spec.limits.clearance, types.limits.clearance);
  EXPECT_EQ(spec.limits.transmission, types.limits.transmission);
  EXPECT_FALSE(spec.limits.copy_gap || spec.limits.copy_error || spec.tolerance || spec.mechanism);
  EXPECT_FALSE(spec.tool.follower_radius || spec.tool.cutter_radius);
  EXPECT_TRUE(spec.obstacles.empty());
  EXPECT_EQ(std::get<Point>(spec.pole.place), Point(0, 0));
  EXPECT_EQ(spec.objective.objective, Objective::size);
  EXPECT_EQ(spec.objective.groundings, types.objective.groundings);
  EXPECT_EQ(spec.cutting.gap, types.cutting.gap);
  EXPECT_FALSE(spec.cutting.stock_sheet);
}

TEST(SpecReader, ReadsATitleOfOneLine) {
  EXPECT_EQ(read_or_fail(shortest).title, "");
  EXPECT_EQ(read_or_fail("title = \"Schild für Ž <b>\"\n" + shortest).title, "Schild für Ž <b>");
  const std::string long_title(most_title_bytes + 1, 'x');
  for (const std::string& title : {std::string("\"\""), std::string("7"), std::string("\"two\\nlines\""),
                                   std::string("\"\\u001b[31mred\""), "\"" + long_title + "\""}) {
    const auto spec = read_spec("title = " + title + "\n" + shortest, "spec.toml", ".");
    ASSERT_FALSE(spec) << title;
    EXPECT_EQ(spec.error().key, "title");
    EXPECT_EQ(spec.error().line, 1);
  }
}

TEST(SpecReader, TellsWhereAKeyOfTheTopBelongs) {
  const auto inside = read_spec(shortest + "title = \"sign\"\n", "spec.toml", ".");
  ASSERT_FALSE(inside);
  EXPECT_NE(inside.error().message().find("title at the top of the file"), std::string::npos)
      << inside.error().message();
  const auto misspelt = read_spec("titel = \"sign\"\n" + shortest, "spec.toml", ".");
  ASSERT_FALSE(misspelt);
  EXPECT_NE(misspelt.error().message().find("title (the nearest known key)"), std::string::npos)
      << misspelt.error().message();
}

TEST(SpecReader, ReadsEveryKeyOfTheContract) {
  const Spec spec = read_or_fail(R"(
[copy]
scale = 1.4
rotation_deg = 90
[region]
polygon_mm = [[[62,-5],[70,-5],[70,5],[62,5]], [[80,0],[80,9],[89,9],[89,0]]]
holes_mm = [[65,-1],[66,-1],[66,1]]
[pole]
within_mm = [[-5,-5],[5,-5],[0,5]]
[links]
width_mm = 13
pin_diameter_mm = 7
thickness_mm = 3
plate = "triangle"
layers = 4
shortest_mm = 20
longest_mm = 300
wall_mm = 2.5
grid_mm = 5
VA_mm = 120
CY_mm = 80.5
[limits]
clearance_mm = 0.75
transmission_deg = 25
sheets_gap_mm = 6
copy_error_mm = 0.3
longest_strip_mm = 290
[tolerance]
length_mm = 0.05
play_mm = 0.02
[tool]
follower_radius_mm = 3
cutter_radius_mm = 1.5
[[obstacles]]
name = "vice"
polygon_mm = [[0,100],[10,100],[10,110]]
layers = [1, 4]
[[obstacles]]
circle_mm = {centre = [0, 200], radius = 5}
[objective]
maximize = "transmission"
groundings = ["pen", "pole"]
[mechanism]
vertex = "tracer"
VA_mm = 50
VB_mm = 35
assembly = 3
layers = [1, 2, 3, 4]
[cutting]
process = "drill"
hole_fit_mm = 0.1
kerf_mm = 0.2
sheet_mm = [600, 300]
gap_mm = 8
)");
  EXPECT_EQ(spec.copy.k(), Complex(0, 1.4));
  EXPECT_EQ(spec.copy.scale(), 1.4);
  EXPECT_DOUBLE_EQ(spec.copy.rotation(), pi / 2);
  EXPECT_EQ(spec.region.polygons.size(), 2u);
  EXPECT_DOUBLE_EQ(area(spec.region), 80 - 1 + 81);
  EXPECT_DOUBLE_EQ(area(std::get<Region>(spec.pole.place)), 50);
  EXPECT_EQ(spec.links.style, (LinkStyle{13, 7, 3, PlateStyle::triangle}));
  EXPECT_EQ(spec.links.layers, 4);
  EXPECT_EQ(spec.links.shortest, 20);
  EXPECT_EQ(spec.links.longest, 300);
  EXPECT_EQ(spec.links.wall, 2.5);
  EXPECT_EQ(spec.links.stock_lengths.grid, 5);
  EXPECT_EQ(spec.links.stock_lengths.locked[0], 120);
  EXPECT_EQ(spec.links.stock_lengths.locked[7], 80.5);
  EXPECT_FALSE(spec.links.stock_lengths.locked[1]);
  EXPECT_EQ(spec.limits.clearance, 0.75);
  EXPECT_DOUBLE_EQ(spec.limits.transmission, 25 * pi / 180);
  EXPECT_EQ(spec.limits.copy_gap, 6);
  EXPECT_EQ(spec.limits.copy_error, 0.3);
  EXPECT_EQ(spec.limits.longest_strip, 290);
  EXPECT_EQ(spec.tolerance->length, 0.05);
  EXPECT_EQ(spec.tolerance->play, 0.02);
  EXPECT_EQ(spec.tool.follower_radius, 3);
  EXPECT_EQ(spec.tool.cutter_radius, 1.5);
  ASSERT_EQ(spec.obstacles.size(), 2u);
  EXPECT_EQ(spec.obstacles[0].name, "vice");
  EXPECT_EQ(spec.obstacles[0].lowest_layer, 1);
  EXPECT_EQ(spec.obstacles[0].highest_layer, 4);
  EXPECT_EQ(spec.obstacles[1].name, "obstacle 2");
  EXPECT_EQ(spec.obstacles[1].highest_layer, 8);
  EXPECT_EQ(spec.objective.objective, Objective::transmission);
  EXPECT_EQ(spec.objective.groundings, (std::vector{Grounding::pen, Grounding::pole}));
  ASSERT_TRUE(spec.mechanism);
  EXPECT_EQ(spec.mechanism->grounding, Grounding::tracer);
  EXPECT_EQ(spec.mechanism->VA, 50);
  EXPECT_EQ(spec.mechanism->VB, 35);
  EXPECT_EQ(spec.mechanism->assembly_mode, 3);
  EXPECT_EQ(spec.mechanism->layers, (std::array{1, 2, 3, 4}));
  EXPECT_EQ(spec.cutting.process, Process::drill);
  EXPECT_EQ(spec.cutting.hole_fit, 0.1);
  EXPECT_EQ(spec.cutting.kerf, 0.2);
  EXPECT_EQ(spec.cutting.stock_sheet, Point(600, 300));
  EXPECT_EQ(spec.cutting.gap, 8);
}

TEST(SpecReader, ReadsStockLengthsInOrderAndOnce) {
  EXPECT_EQ(read_or_fail(shortest + "[links]\nstock_mm = [120, 60, 90.5, 60]\n").links.stock_lengths.stock,
            (std::vector<double>{60, 90.5, 120}));
}

TEST(SpecReader, TakesScaleOrRotationAlone) {
  const std::string region = "[region]\ncircle_mm = {centre = [66, 0], radius = 4}\n";
  EXPECT_EQ(read_or_fail("[copy]\nscale = 2\n" + region).copy.k(), Complex(2, 0));
  EXPECT_EQ(read_or_fail("[copy]\nrotation_deg = 180\n" + region).copy.k(), Complex(-1, 0));
}

TEST(SpecReader, BringsRotationsIntoOneTurn) {
  const auto rotation = [](const std::string& degrees) {
    return read_or_fail("[copy]\nscale = 2\nrotation_deg = " + degrees +
                        "\n[region]\ncircle_mm = {centre = [66, 0], radius = 4}\n")
        .copy;
  };
  EXPECT_DOUBLE_EQ(rotation("-180").rotation(), pi);
  EXPECT_EQ(rotation("-180").k(), Complex(-2, 0));
  EXPECT_EQ(rotation("450").k(), Complex(0, 2));
  EXPECT_EQ(rotation("-90").k(), Complex(0, -2));
  EXPECT_DOUBLE_EQ(rotation("3500.5").rotation(), -99.5 * pi / 180);
}

TEST(SpecReader, PairsGiveRatioPoleAndResidual) {
  const Spec spec = read_or_fail(
      "[copy]\npairs_mm = [[[7.5,0],[0,10.5]], [[7,0],[0,9.8]], [[5.6,0],[0,7.84]]]\n"
      "[region]\ncircle_mm = {centre = [66, 0], radius = 4}\n");
  EXPECT_NEAR(std::abs(spec.copy.k() - Complex(0, 1.4)), 0, 1e-14);
  EXPECT_EQ(spec.copy.scale(), std::abs(spec.copy.k()));
  ASSERT_TRUE(spec.copy.fit());
  EXPECT_EQ(spec.copy.fit()->pairs, 3u);
  EXPECT_EQ(std::get<Point>(spec.pole.place), Point(0, 0));
}

TEST(SpecReader, PairsPutThePoleAtTheirFixedPointUnlessThePoleIsGiven) {
  // k = 2 about (10, 20).
  const std::string copy = "[copy]\npairs_mm = [[[11, 20], [12, 20]], [[10, 25], [10, 30]]]\n";
  const std::string region = "[region]\ncircle_mm = {centre = [66, 0], radius = 4}\n";
  EXPECT_LT((std::get<Point>(read_or_fail(copy + region).pole.place) - Point(10, 20)).norm(), 1e-12);
  EXPECT_EQ(std::get<Point>(read_or_fail(copy + region + "[pole]\nat_mm = [1, 2]\n").pole.place),
            Point(1, 2));
}

TEST(SpecReader, CircleCoversTheCircle) {
  const Spec spec = read_or_fail(shortest);
  const DistanceRange range = distance_range(spec.region, {66, 0});
  EXPECT_LT(range.farthest, 4 * (1 + 2.5e-6));
  for (int i = 0; i < 1000; ++i) {
    EXPECT_TRUE(contains(spec.region, Point(66, 0) + as_point(std::polar(4 * (1 - 1e-12), 0.0123 * i))));
  }
}

TEST(SpecReader, RectangleStandsOnItsLowerLeftCorner) {
  const Spec spec =
      read_or_fail("[copy]\nscale = 2\n[region]\nrectangle_mm = {at = [62, -5], size = [8, 10]}\n");
  EXPECT_EQ(spec.region.polygons.at(0).outer, (Ring{{62, -5}, {70, -5}, {70, 5}, {62, 5}}));
}

TEST(SpecReader, UnitesPolygonsThatOverlap) {
  const Spec spec = read_or_fail(
      "[copy]\nscale = 2\n[region]\npolygon_mm = [[[0,0],[4,0],[4,4],[0,4]], [[4,0],[8,0],[8,4],[4,4]], "
      "[[2,2],[6,2],[6,9]]]\n");
  EXPECT_EQ(spec.region.polygons.size(), 1u);
  EXPECT_TRUE(contains(spec.region, {5.9, 8.5}));
  EXPECT_FALSE(contains(spec.region, {7, 5}));
}

TEST(SpecReader, GrowsTheRegionByItsMargin) {
  const Spec spec = read_or_fail(
      "[copy]\nscale = 2\n[region]\nrectangle_mm = {at = [50, 0], size = [10, 10]}\nmargin_mm = 2\n");
  EXPECT_NEAR(area(spec.region), 100 + 80 + 4 * pi, 0.05);
  EXPECT_TRUE(contains(spec.region, {48, 5}));
}

TEST(SpecReader, LooksForRegionFilesBesideTheSpec) {
  const Spec spec = read_or_fail("[copy]\nscale = 2\n[region]\nfile = \"square.geojson\"\n");
  EXPECT_DOUBLE_EQ(area(spec.region), 100);
}

TEST(SpecReader, NeedsNoRegionBesideAMechanism) {
  EXPECT_TRUE(read_or_fail("[copy]\nscale = 2\n[mechanism]\nvertex = \"pole\"\nVA_mm = 50\nVB_mm = 50\n")
                  .region.empty());
}

TEST(SpecReader, SelfCrossingObstaclesFallApartIntoSimpleOnes) {
  const Spec spec = read_or_fail(
      shortest + "[[obstacles]]\npolygon_mm = [[0, 0], [2, 2], [2, 0], [0, 2]]\nlayers = [2, 3]\n");
  ASSERT_EQ(spec.obstacles.size(), 2u);
  for (const Obstacle& part : spec.obstacles) {
    EXPECT_DOUBLE_EQ(signed_area(part.shape.outer), 1);
    EXPECT_EQ(part.name, "obstacle 1");
    EXPECT_EQ(part.lowest_layer, 2);
  }
}

std::string ring_text(const Ring& ring) {
  std::string text = "[";
  for (const Point& corner : ring) text += fmt::format("[{}, {}],\n", corner.x(), corner.y());
  return text + "]\n";
}

const std::string with_bodies = shortest + R"(
[[bodies]]
name = "router"
at = "pen"
circle_mm = {centre = [1, 2], radius = 60}
layers = [3, 8]
[[bodies]]
at = "tracer"
polygon_mm = [[-4, -3], [4, -3], [0, 5]]
[table]
rectangle_mm = {at = [-50, -40], size = [600, 400]}
)";

TEST(SpecReader, ReadsBodiesAndTheTable) {
  const Spec spec = read_or_fail(with_bodies);
  ASSERT_EQ(spec.bodies.size(), 2u);
  EXPECT_EQ(spec.bodies[0].name, "router");
  EXPECT_EQ(spec.bodies[0].at, Carrier::pen);
  EXPECT_EQ(spec.bodies[0].lowest_layer, 3);
  EXPECT_EQ(std::get<Disc>(spec.bodies[0].shape).centre, Point(1, 2));
  EXPECT_EQ(std::get<Disc>(spec.bodies[0].shape).radius, 60);
  EXPECT_EQ(spec.bodies[1].name, "body 2");
  EXPECT_EQ(spec.bodies[1].at, Carrier::tracer);
  EXPECT_EQ(spec.bodies[1].highest_layer, 8);
  EXPECT_EQ(std::get<Polygon>(spec.bodies[1].shape).outer.size(), 3u);
  ASSERT_TRUE(spec.table);
  EXPECT_EQ(signed_area(spec.table->outer), 600 * 400);
}

TEST(SpecReader, ReadsShortFormsAndInchesOfBodiesAndTheTable) {
  const std::string in_mm =
      shortest +
      "[[bodies]]\nat = \"pen\"\ncircle_mm = [25.4, 50.8, 127]\n[table]\nrectangle_mm = [0, 0, 508, 254]\n";
  const std::string in_inches =
      "units = \"in\"\n[copy]\nscale = 1.4\nrotation_deg = 90\n[region]\ncircle_in = [2.5, 0, 0.1]\n"
      "[[bodies]]\nat = \"pen\"\ncircle_in = [1, 2, 5]\n[table]\nrectangle_in = {at = [0, 0], size = [20, "
      "10]}\n";
  for (const std::string& text : {in_mm, in_inches}) {
    const Spec spec = read_or_fail(text);
    ASSERT_EQ(spec.bodies.size(), 1u);
    const Disc& disc = std::get<Disc>(spec.bodies[0].shape);
    EXPECT_NEAR((disc.centre - Point(25.4, 50.8)).norm(), 0, 1e-12);
    EXPECT_NEAR(disc.radius, 127, 1e-12);
    ASSERT_TRUE(spec.table);
    EXPECT_NEAR(signed_area(spec.table->outer), 508 * 254, 1e-6);
  }
}

TEST(SpecReader, WritesBodiesAndTheTableSoThatTheyAreReadBack) {
  const Spec spec = read_or_fail(with_bodies), again = read_or_fail(spec_as_toml(spec));
  ASSERT_EQ(again.bodies.size(), spec.bodies.size());
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    EXPECT_EQ(again.bodies[i].name, spec.bodies[i].name);
    EXPECT_EQ(again.bodies[i].at, spec.bodies[i].at);
    EXPECT_EQ(again.bodies[i].lowest_layer, spec.bodies[i].lowest_layer);
  }
  EXPECT_EQ(std::get<Disc>(again.bodies[0].shape).radius, 60);
  EXPECT_EQ(again.table, spec.table);
}

std::string turning(const char* at, const char* link) {
  return fmt::format(
      "[[bodies]]\nat = \"{}\"\nturns_with = \"{}\"\ncircle_mm = {{centre = [9, 0], radius = 5}}\n", at,
      link);
}

TEST(SpecReader, ABodyThatTurnsWithALinkLeavesTheGroundingsInWhichTheLinkHasItsPoint) {
  using List = std::vector<Grounding>;
  const Grounding pole = Grounding::pole, tracer = Grounding::tracer, pen = Grounding::pen;
  const std::tuple<std::string, Link, List> cases[] = {
      {turning("pen", "BCY"), Link::BCY, {pole, tracer}},
      {turning("pen", "VA"), Link::VA, {pen}},
      {turning("tracer", "ACX"), Link::ACX, {pole}},
      {turning("tracer", "VB") + turning("pen", "BCY"), Link::VB, {tracer}}};
  for (const auto& [text, link, groundings] : cases) {
    const Spec spec = read_or_fail(shortest + text), again = read_or_fail(spec_as_toml(spec));
    EXPECT_EQ(spec.bodies.front().turns_with, link);
    EXPECT_EQ(again.bodies.front().turns_with, link);
    EXPECT_EQ(spec.objective.groundings, groundings) << text;
    EXPECT_EQ(again.objective.groundings, groundings) << text;
  }
  EXPECT_FALSE(read_or_fail(with_bodies).bodies[0].turns_with);
}

TEST(SpecReader, RefusesALinkThatDoesNotHaveTheBodysPoint) {
  const std::string mechanism = "[mechanism]\nvertex = \"pole\"\nVA_mm = 50\nVB_mm = 35\n";
  const std::pair<std::string, const char*> faults[] = {
      {turning("pen", "ACX"), "VA or VB or BCY"},
      {turning("pen", "hand"), "one of \"VA\", \"VB\", \"ACX\", \"BCY\""},
      {turning("pen", "VA") + turning("tracer", "ACX"), "BCY"},
      {mechanism + turning("pen", "VB"), "BCY"}};
  for (const auto& [text, allowed] : faults) {
    const auto spec = read_spec(shortest + text, "spec.toml", {});
    ASSERT_FALSE(spec) << text;
    EXPECT_EQ(spec.error().key, "bodies.turns_with");
    EXPECT_NE(spec.error().message().find(allowed), std::string::npos) << spec.error().message();
    EXPECT_GT(spec.error().line, 0);
  }
}

TEST(SpecReader, RefusesBodiesAndTablesThatSayNothingDefinite) {
  const std::pair<const char*, const char*> faults[] = {
      {"bodies = 3\n", "bodies"},
      {"[[bodies]]\ncircle_mm = {centre = [0, 0], radius = 5}\n", "bodies.at"},
      {"[[bodies]]\nat = \"hand\"\ncircle_mm = {centre = [0, 0], radius = 5}\n", "bodies.at"},
      {"[[bodies]]\nat = \"pen\"\n", "bodies"},
      {"[[bodies]]\nat = \"pen\"\ncircle_mm = {centre = [0, 0], radius = 0}\n", "bodies.circle_mm.radius"},
      {"[[bodies]]\nat = \"pen\"\npolygon_mm = [[0, 0], [1, 1], [2, 2]]\n", "bodies.polygon_mm"},
      {"[[bodies]]\nat = \"pen\"\nlayers = [4, 3]\ncircle_mm = {centre = [0, 0], radius = 5}\n",
       "bodies.layers"},
      {"[table]\n", "table"},
      {"[table]\npolygon_mm = [[0, 0], [9, 9], [9, 0], [0, 9]]\n", "table.polygon_mm"},
      {"[tolerance]\nlength_mm = 0.1\nrobust = true\n[table]\ncircle_mm = {centre = [0, 0], radius = 500}\n",
       "tolerance.robust"}};
  for (const auto& [text, key] : faults) {
    const std::string whole = std::string(text).starts_with("bodies") ? text + shortest : shortest + text;
    const auto spec = read_spec(whole, "spec.toml", {});
    ASSERT_FALSE(spec) << text;
    EXPECT_EQ(spec.error().key, key) << spec.error().message();
  }
}

TEST(SpecReader, ReadsRegionsOfAMillionCorners) {
  Ring ring;
  for (int i = 0; i < 1'000'000; ++i) {
    ring.push_back(Point(100, 0) + as_point(std::polar(50.0, 2 * pi * i / 1e6)));
  }
  const Spec spec = read_or_fail("[copy]\nscale = 2\n[region]\npolygon_mm = " + ring_text(ring));
  ASSERT_EQ(spec.region.polygons.size(), 1u);
  EXPECT_EQ(spec.region.polygons[0].outer, ring);
}

// Thousands of convex parts, each taken away from thousands.
TEST(SpecReader, RefusesBodiesThatMeetTooManyCorners) {
  const auto saw = [](int teeth) {
    std::string corners;
    for (int i = 0; i < teeth; ++i) corners += fmt::format("[{0}, 0], [{0}.5, 3], ", i);
    return fmt::format("polygon_mm = [{}[{}, 0], [{}, -1], [0, -1]]\n", corners, teeth, teeth);
  };
  const std::string start = shortest + "[[bodies]]\nat = 'pen'\nlayers = [1, 2]\n";
  const std::string obstacle = "[[obstacles]]\nlayers = [1, 2]\n" + saw(3000);
  EXPECT_TRUE(read_spec(start + saw(10) + obstacle, "-", {}));
  const auto refused = read_spec(start + saw(3000) + obstacle, "-", {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("bodies: found outlines that meet others in"), std::string::npos)
      << refused.error().message();
  EXPECT_TRUE(read_spec(start + "turns_with = 'BCY'\n" + saw(3000) + obstacle, "-", {}));
}

TEST(SpecReader, ReadsObstaclesOfManyCorners) {
  std::mt19937_64 random(7);
  const Ring ring = star_ring(random, 200'000, 40);
  const Spec spec = read_or_fail(shortest + "[[obstacles]]\npolygon_mm = " + ring_text(ring));
  ASSERT_EQ(spec.obstacles.size(), 1u);
  EXPECT_EQ(spec.obstacles[0].shape.outer, ring);
}

/// Writes values as it goes and reads them back.
TEST(SpecReader, ReadsBackRandomSpecs) {
  std::mt19937_64 random(8);
  for (int i = 0; i < 500; ++i) {
    const double scale = std::exp(uniform(random, -4, 4)), rotation = uniform(random, -179, 179);
    const double width = uniform(random, 1, 40), pin = uniform(random, 0.1, width),
                 thickness = uniform(random, 0.1, 20);
    const double shortest_length = uniform(random, 1, 50), longest = uniform(random, 60, 900);
    const double clearance = uniform(random, 0, 5), transmission = uniform(random, 0, 89),
                 gap = uniform(random, 0, 50);
    const int layers = 2 + static_cast<int>(random() % 7);
    Ring ring = star_ring(random, 3 + i % 20, 80), pole = star_ring(random, 5, 30);
    const Spec spec = read_or_fail(fmt::format(
        "[copy]\nscale = {}\nrotation_deg = {}\n[region]\npolygon_mm = {}[pole]\nwithin_mm = "
        "{}[links]\nwidth_mm = {}\n"
        "pin_diameter_mm = {}\nthickness_mm = {}\nlayers = {}\nshortest_mm = {}\nlongest_mm = {}\n[limits]\n"
        "clearance_mm = {}\ntransmission_deg = {}\nsheets_gap_mm = {}\n",
        scale, rotation, ring_text(ring), ring_text(pole), width, pin, thickness, layers, shortest_length,
        longest, clearance, transmission, gap));
    EXPECT_EQ(spec.copy.scale(), scale);
    EXPECT_DOUBLE_EQ(spec.copy.rotation(), rotation * pi / 180);
    EXPECT_LT(std::abs(spec.copy.k() - std::polar(scale, rotation * pi / 180)), 1e-14 * scale);
    EXPECT_EQ(spec.region, (Region{{{ring, {}}}}));
    EXPECT_EQ(std::get<Region>(spec.pole.place), (Region{{{pole, {}}}}));
    EXPECT_EQ(spec.links.style, (LinkStyle{width, pin, thickness, PlateStyle::bent}));
    EXPECT_EQ(spec.links.layers, layers);
    EXPECT_EQ(spec.links.shortest, shortest_length);
    EXPECT_EQ(spec.links.longest, longest);
    EXPECT_EQ(spec.limits.clearance, clearance);
    EXPECT_DOUBLE_EQ(spec.limits.transmission, transmission * pi / 180);
    EXPECT_EQ(spec.limits.copy_gap, gap);
  }
}

std::vector<std::filesystem::path> example_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(examples)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(SpecExamples, AreAllRead) {
  EXPECT_GE(example_files().size(), 5u);
  for (const auto& file : example_files()) {
    const auto spec = read_spec_file(file);
    EXPECT_TRUE(spec) << spec.error().message();
  }
}

}  // namespace
}  // namespace kempe
