#include "reports/data/design_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "geometry/stated_angle.hpp"
#include "reports/audit/design_audit.hpp"
#include "tests/random.hpp"
#include "tests/reports/sample_designs.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;
using testing::plagiograph;
using testing::sample_design;

Json written() { return Json::parse(design_json(plagiograph())); }

/// The message with which a changed file is refused; empty if it is read.
std::string refusal(const Json& json) {
  const auto read = read_design(json.dump(), "d.json");
  return read ? "" : read.error().message();
}

TEST(DesignJson, HasEveryKeyOfTheContract) {
  const Json json = written();
  const Json contract = Json::parse(R"({"format":0,"copy":{"scale":0,"rotation_deg":0},
    "region":{"type":0,"coordinates":0},"mechanism":{"vertex":0,"pole":0,"tracer":0,"pen":0,"pole_position_mm":0,
    "shape":0,"opening_deg":0,"lengths_mm":{"VA":0,"VB":0,"AC":0,"BC":0,"AX":0,"CX":0,"BY":0,"CY":0},
    "orientation":{"parallelogram":0,"plate_ACX":0,"plate_BCY":0},"links":0,"link_width_mm":0,"pin_diameter_mm":0,
    "thickness_mm":0},"quality":{"size_mm":0,"transmission_min_deg":0,"clearance_min_mm":0,"copy_error_worst_mm":0,
    "copy_error_rss_mm":0,"distortion_worst_mm":0,"footprint_mm2":0,"lower_bound":0},"workspace":{"reachable_mm2":0,
    "usable_mm2":0,"collision_free_mm2":0,"uncertain_mm2":0,"region_covered":0,"largest_sheet":0},"verification":{
    "samples":0,"copy_error_max_mm":0,"loop_residual_max_mm":0,"scale":0,"rotation_deg":0,"flips":0,"certified":0},
    "search":{"objective":0,"value":0,"solvers":0,"evaluations":0,"seed":0}})");
  const Json flat = contract.flatten();
  for (const auto& [pointer, value] : flat.items())
    EXPECT_TRUE(json.contains(Json::json_pointer(pointer))) << pointer;
  EXPECT_EQ(json["mechanism"]["orientation"].dump(), R"({"parallelogram":1,"plate_ACX":-1,"plate_BCY":1})");
  EXPECT_EQ(json["mechanism"]["links"][2].dump(),
            R"({"name":"ACX","joints":["A","C","X"],"shape":"bent","layer":2})");
  EXPECT_EQ(json["copy"].dump(), R"({"scale":1.4,"rotation_deg":90.0})");
}

TEST(DesignJson, IsReadBackToTheLastBit) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double a, double b) { return test::uniform(random, a, b); };
  for (int i = 0; i < 300; ++i) {
    const double turn = i % 3 == 0 ? radians(std::floor(uniform(-179, 180))) : uniform(-pi, pi);
    const double scale = uniform(0.2, 4);
    Design design = sample_design(copy_ratio(scale, turn), all_groundings[random() % 3], uniform(15, 400),
                                  uniform(15, 400), static_cast<int>(random() % 2), PlateStyle::bent,
                                  {uniform(-100, 100), uniform(-100, 100)});
    design.scale = scale;
    design.rotation = turn;
    const auto read = read_design(design_json(design), "d.json");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->mechanism.lengths.values(), design.linkage.lengths().values());
    EXPECT_EQ(read->shape, design.linkage.shape());
    EXPECT_EQ(read->region, design.region);
    EXPECT_EQ(read->style, design.style);
    EXPECT_EQ(read->layers, design.layers);
    EXPECT_EQ(read->mechanism.sides, design.linkage.assembly_mode().sides);
    EXPECT_NEAR(read->rotation, design.rotation, 1e-15);
    EXPECT_NEAR(read->mechanism.opening.lower, design.opening.lower, 1e-15);
    const auto linkage = linkage_of(*read, "d.json");
    ASSERT_TRUE(linkage) << linkage.error().message();
    EXPECT_EQ(linkage->assembly_mode().number, design.linkage.assembly_mode().number);
    EXPECT_EQ(linkage->pole(), design.linkage.pole());
    EXPECT_NEAR(std::abs(linkage->k() - design.linkage.k()), 0, 1e-14);
  }
}

TEST(DesignJson, KeepsATitleWhateverItSays) {
  Design design = testing::plagiograph();
  EXPECT_EQ(design_json(design).find("title"), std::string::npos);
  const Region region = design.region;
  for (const std::string title : {"Sign", "\"region\": null, {", "für <b> \\ %"}) {
    design.title = title;
    const auto stored = read_design(design_json(design), "design.json");
    ASSERT_TRUE(stored) << stored.error().message();
    EXPECT_EQ(stored->title, title);
    EXPECT_TRUE(stored->unknown_keys.empty());
    EXPECT_EQ(area(stored->region), area(region));
  }
}

TEST(DesignJson, StatesWholeDegreesAsWholeDegrees) {
  for (int whole = -360; whole <= 360; ++whole) EXPECT_EQ(stated_degrees(radians(whole)), whole);
  EXPECT_EQ(stated_degrees(radians(12.345)), 12.345);
}

TEST(DesignJson, WritesNullForWhatIsInfiniteOrAbsent) {
  Design design = plagiograph();
  design.quality.clearance_min = std::numeric_limits<double>::infinity();
  design.quality.footprint = std::numeric_limits<double>::quiet_NaN();
  design.search.reset();
  const std::string text = design_json(design);
  const Json json = Json::parse(text);
  EXPECT_TRUE(json["quality"]["clearance_min_mm"].is_null());
  EXPECT_TRUE(json["quality"]["footprint_mm2"].is_null());
  EXPECT_TRUE(json["quality"]["copy_error_worst_mm"].is_null());
  EXPECT_TRUE(json["search"]["objective"].is_null());
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_TRUE(read_design(text, "d.json"));
}

TEST(DesignJson, KeepsAMechanismWithoutAUsableOpening) {
  Design design = plagiograph();
  design.opening = {};
  const auto read = read_design(design_json(design), "d.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(read->mechanism.opening.empty());
  EXPECT_EQ(linkage_of(*read, "d.json")->assembly_mode().number, design.linkage.assembly_mode().number);
}

TEST(DesignJson, KeepsTheLimitsTheTolerancesAndTheObstacles) {
  Design design = plagiograph();
  design.limits.transmission = radians(25);
  design.limits.copy_gap = 5;
  design.tolerance = Tolerance{0.05, 0.02};
  design.obstacles = {{.shape = {{{0, 0}, {10, 0}, {0, 10}}, {}}, .lowest_layer = 1, .highest_layer = 4}};
  const auto read = read_design(design_json(design), "d.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->limits->transmission, radians(25));
  EXPECT_EQ(read->limits->copy_gap, 5);
  EXPECT_EQ(read->tolerance->play, 0.02);
  ASSERT_EQ(read->obstacles.size(), 1U);
  EXPECT_EQ(read->obstacles[0].shape, design.obstacles[0].shape);
  EXPECT_EQ(read->obstacles[0].highest_layer, 4);
}

TEST(DesignJson, KeepsWhatTheSpecAllowed) {
  Design design = plagiograph();
  Allowed& allowed = design.allowed.emplace();
  allowed.pole.place = Region{{Polygon{{{-1, -2}, {3, -2}, {3, 4}}, {}}}};
  allowed.layers = 4;
  allowed.shortest = 12.5;
  allowed.longest = 600;
  allowed.stock_lengths = {.grid = std::nullopt, .stock = {35, 50, 100}, .locked = {}};
  allowed.stock_lengths.locked[1] = 35;
  allowed.groundings = {Grounding::pen, Grounding::pole};
  design.cutting = {.hole_fit = -0.1, .kerf = 0.2, .stock_sheet = Point(600, 300), .gap = 7};
  design.map.map_tolerance = 0.02;
  const auto read = read_design(design_json(design), "d.json");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_TRUE(read->allowed);
  EXPECT_EQ(std::get<Region>(read->allowed->pole.place), std::get<Region>(allowed.pole.place));
  EXPECT_EQ(read->allowed->layers, 4);
  EXPECT_EQ(read->allowed->shortest, 12.5);
  EXPECT_EQ(read->allowed->longest, 600);
  EXPECT_FALSE(read->allowed->stock_lengths.grid);
  EXPECT_EQ(read->allowed->stock_lengths.stock, allowed.stock_lengths.stock);
  EXPECT_EQ(read->allowed->stock_lengths.locked, allowed.stock_lengths.locked);
  EXPECT_EQ(read->allowed->groundings, allowed.groundings);
  ASSERT_TRUE(read->cutting);
  EXPECT_EQ(read->cutting->hole_fit, -0.1);
  EXPECT_EQ(read->cutting->kerf, 0.2);
  EXPECT_EQ(read->cutting->stock_sheet, design.cutting.stock_sheet);
  EXPECT_EQ(read->cutting->gap, 7);
  EXPECT_EQ(read->map.map_tolerance, 0.02);
  EXPECT_TRUE(read->unknown_keys.empty());
  design.allowed->pole.place = Point(3, -4);
  EXPECT_EQ(std::get<Point>(read_design(design_json(design), "d.json")->allowed->pole.place), Point(3, -4));
}

TEST(DesignJson, KeepsMaterialAndLoadWithTheirFigures) {
  Design design = plagiograph();
  for (const char* key : {"material", "load", "load_error", "mass_kg", "sections_mm", "sag"})
    EXPECT_EQ(design_json(design).find(key), std::string::npos) << key;
  design.material = Material{"birch plywood", 8000, 680, 35};
  design.load = Load{.pen_force = 12.5, .rests = {Carrier::pen}};
  design.limits.load_error = 0.25;
  design.quality.loads = LoadFigures{0.2, 0.01, 30, 17.5, HUGE_VAL};
  design.quality.mass = 0.125;
  design.allowed.emplace().sections = {{15, 5}, {20, 5}};
  design.allowed->groundings = {Grounding::pole};
  design.allowed->shortest = design.allowed->longest = 15;
  const auto read = read_design(design_json(design), "d.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(read->unknown_keys.empty());
  EXPECT_EQ(*read->material, *design.material);
  EXPECT_EQ(*read->load, *design.load);
  EXPECT_EQ(read->limits->load_error, 0.25);
  ASSERT_TRUE(read->quality.loads);
  EXPECT_EQ(read->quality.loads->error_max, 0.2);
  EXPECT_EQ(read->quality.loads->error_min, 0.01);
  EXPECT_EQ(read->quality.loads->pin_force_max, 30);
  EXPECT_EQ(read->quality.loads->hand_force_max, 17.5);
  EXPECT_EQ(read->quality.loads->stress_max, HUGE_VAL);
  EXPECT_FALSE(read->quality.layered);
  EXPECT_EQ(read->quality.mass, 0.125);
  EXPECT_EQ(read->allowed->sections, design.allowed->sections);
}

TEST(DesignJson, KeepsWhatPinsAndLayersAdd) {
  Design design = plagiograph();
  const Json without = Json::parse(design_json(design));
  EXPECT_FALSE(without["quality"].contains("load_error_layered_max_mm"));
  design.quality.layered = LayeredFigures{0.25, 0.01};
  const Json with = Json::parse(design_json(design));
  const auto read = read_design(with.dump(), "d.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(read->unknown_keys.empty());
  ASSERT_TRUE(read->quality.layered);
  EXPECT_EQ(read->quality.layered->error_max, 0.25);
  EXPECT_EQ(read->quality.layered->rise_max, 0.01);
  EXPECT_FALSE(read->quality.layered->stress_max);
  Json one = with;
  one["quality"]["stress_layered_max_MPa"] = 12.5;
  EXPECT_EQ(read_design(one.dump(), "d.json")->quality.layered->stress_max, 12.5);
  design.quality.layered->stress_max = 12.5;
  EXPECT_EQ(Json::parse(design_json(design)), one);
  one = with;
  one["quality"].erase("load_rise_max_mm");
  EXPECT_EQ(read_design(one.dump(), "d.json").error().key, "quality.load_rise_max_mm");
  one = with;
  one["quality"]["load_error_layered_max_mm"] = "much";
  EXPECT_EQ(read_design(one.dump(), "d.json").error().key, "quality.load_error_layered_max_mm");
  const auto older = read_design(without.dump(), "d.json");
  ASSERT_TRUE(older) << older.error().message();
  EXPECT_FALSE(older->quality.layered);
}

TEST(DesignJson, KeepsWhatTheLinksOwnWeightDoes) {
  Design design = plagiograph();
  design.quality.loads = LoadFigures{0.2, 0.01, 30, 17.5, 12};
  design.quality.layered = LayeredFigures{0.25, 0.01};
  EXPECT_EQ(design_json(design).find("weight_"), std::string::npos);
  design.quality.loads->weight_error_max = 0.125;
  design.quality.layered->weight_error_max = 0.5;
  design.quality.layered->weight_rise_max = 0.75;
  const Json with = Json::parse(design_json(design));
  const auto read = read_design(with.dump(), "d.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(read->unknown_keys.empty());
  EXPECT_EQ(read->quality.loads->weight_error_max, 0.125);
  EXPECT_EQ(read->quality.layered->weight_error_max, 0.5);
  EXPECT_EQ(read->quality.layered->weight_rise_max, 0.75);
  for (const char* key : {"weight_error_layered_max_mm", "weight_rise_max_mm"}) {
    Json one = with;
    one["quality"].erase(key);
    EXPECT_EQ(read_design(one.dump(), "d.json").error().key, std::string("quality.") + key);
  }
  // At a dead point the hand cannot hold the links.
  design.quality.loads->pin_force_max = HUGE_VAL;
  const auto dead = read_design(design_json(design), "d.json");
  ASSERT_TRUE(dead) << dead.error().message();
  EXPECT_EQ(dead->quality.loads->pin_force_max, HUGE_VAL);
}

TEST(DesignJson, NamesEveryKeyItDoesNotKnow) {
  Json json = written();
  for (const char* pointer :
       {"/colour", "/copy/skew", "/mechanism/links/2/colour", "/quality/cost_eur", "/limits/noise_mm"})
    json[Json::json_pointer(pointer)] = 1;
  const auto read = read_design(json.dump(), "d.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->unknown_keys, (std::vector<std::string>{"colour", "copy.skew", "mechanism.links[2].colour",
                                                          "quality.cost_eur", "limits.noise_mm"}));
  EXPECT_EQ(audit(*read, "d.json").error().key, "limits.noise_mm");
}

TEST(DesignJson, KeepsAHandEditedLengthForTheVerificationToSee) {
  Json json = written();
  json["mechanism"]["lengths_mm"]["CY"] = 86.5;
  const auto read = read_design(json.dump(), "d.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->mechanism.lengths.CY, 86.5);
  EXPECT_EQ(verification_task(*read).mechanism.lengths.CY, 86.5);
  const auto linkage = linkage_of(*read, "d.json");
  ASSERT_FALSE(linkage);
  EXPECT_NE(linkage.error().message().find("lengths_mm.CY: found 86.5"), std::string::npos);
}

TEST(DesignJson, RefusesAFileCutShortAnywhere) {
  const std::string text = design_json(plagiograph());
  for (std::size_t length = 0; length + 2 < text.size(); length += 37) {
    const auto read = read_design(text.substr(0, length), "d.json");
    ASSERT_FALSE(read) << length;
    EXPECT_EQ(read.error().file, "d.json");
  }
  EXPECT_GT(read_design(text.substr(0, text.size() / 2), "d.json").error().line, 1);
}

TEST(DesignJson, RefusesEveryMissingKeyItNeeds) {
  const Json whole = written();
  for (const char* pointer :
       {"/format", "/copy", "/copy/scale", "/copy/rotation_deg", "/region", "/mechanism", "/mechanism/vertex",
        "/mechanism/pole", "/mechanism/pen", "/mechanism/pole_position_mm", "/mechanism/shape",
        "/mechanism/opening_deg", "/mechanism/lengths_mm/BY", "/mechanism/orientation/plate_ACX",
        "/mechanism/links", "/mechanism/link_width_mm", "/quality", "/workspace/region_covered",
        "/verification/certified"}) {
    Json json = whole;
    const Json::json_pointer place(pointer);
    json[place.parent_pointer()].erase(place.back());
    EXPECT_NE(refusal(json).find(place.back()), std::string::npos) << pointer << ": " << refusal(json);
  }
}

TEST(DesignJson, RefusesWrongTypesAndValuesOutOfRange) {
  const Json whole = written();
  const auto refused_with = [&](const char* pointer, const Json& value) {
    Json json = whole;
    json[Json::json_pointer(pointer)] = value;
    return refusal(json);
  };
  EXPECT_NE(refused_with("/format", "kempe-design/2").find("kempe-design/1"), std::string::npos);
  EXPECT_NE(refused_with("/copy/scale", -1), "");
  EXPECT_NE(refused_with("/copy/scale", "1.4"), "");
  EXPECT_NE(refused_with("/copy/rotation_deg", nullptr), "");
  EXPECT_NE(refused_with("/mechanism/lengths_mm/VA", 0), "");
  EXPECT_NE(refused_with("/mechanism/lengths_mm/VA", 1e300), "");
  EXPECT_NE(refused_with("/mechanism/opening_deg", Json::array({160, 100})), "");
  EXPECT_NE(refused_with("/mechanism/opening_deg", Json::array({100})), "");
  EXPECT_NE(refused_with("/mechanism/vertex", "middle"), "");
  EXPECT_NE(refused_with("/mechanism/tracer", "Y"), "");
  EXPECT_NE(refused_with("/mechanism/orientation/parallelogram", 0), "");
  EXPECT_NE(refused_with("/mechanism/orientation/plate_ACX", 2), "");
  EXPECT_NE(refused_with("/mechanism/links/2/joints/1", "B"), "");
  EXPECT_NE(refused_with("/mechanism/links/2/layer", 1.5), "");
  EXPECT_NE(refused_with("/mechanism/links/2/layer", 18446744073709551615ULL), "");
  EXPECT_NE(refused_with("/region/type", "Polygon"), "");
  EXPECT_NE(refused_with("/region/coordinates/0/0/0/0", "x"), "");
  EXPECT_NE(refused_with("/region/coordinates/0/0/0/0", 5), "");
  EXPECT_NE(refused_with("/verification/certified", 1), "");
  EXPECT_NE(refused_with("/workspace", Json::array()), "");
}

TEST(DesignJson, RefusesHostileText) {
  const auto message = [](const std::string& text) { return read_design(text, "d.json").error().message(); };
  const std::string whole = design_json(plagiograph());
  std::string twice = whole;
  twice.insert(twice.find("\"VB\""), "\"VA\": 51, ");
  EXPECT_NE(message(twice).find("twice"), std::string::npos);
  std::string huge = whole;
  huge.replace(huge.find("1.4"), 3, "1e999");
  EXPECT_NE(message(huge), "");
  std::string nan = whole;
  nan.replace(nan.find("1.4"), 3, "NaN");
  EXPECT_NE(message(nan).find("d.json:"), std::string::npos);
  EXPECT_NE(message(std::string(1'000'000, '[')), "");
  EXPECT_NE(message(std::string(1000, '[') + std::string(1000, ']')).find("nested"), std::string::npos);
  EXPECT_NE(message(std::string("\0\xff\x01garbage", 10)), "");
  EXPECT_NE(message(""), "");
  EXPECT_NE(message("[]"), "");
  EXPECT_NE(message("null"), "");
}

}  // namespace
}  // namespace kempe
