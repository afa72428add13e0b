// What a program that uses the library gets: designs, reasons, maps, traces.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "kempe/kempe.hpp"

namespace kempe {
namespace {

Spec small_task() {
  Spec spec;
  spec.copy = Copy::of(1.4, 90 * degree);
  spec.region = Region::rectangle({62, -5}, {8, 10});
  spec.links.style.width = 6;
  spec.links.style.pin_diameter = 3;
  return spec;
}

Spec given_mechanism() {
  Spec spec = small_task();
  spec.mechanism = MechanismSpec{.grounding = Grounding::pole, .VA = 50, .VB = 35, .assembly_mode = 3};
  spec.limits.transmission = 15 * degree;
  return spec;
}

TEST(Library, FindsADesignThatCopies) {
  const Outcome outcome = design(small_task());
  ASSERT_TRUE(outcome) << outcome.reason();
  EXPECT_EQ(outcome.kind(), Outcome::Kind::design);
  EXPECT_EQ(outcome.reason(), "");
  EXPECT_TRUE(outcome->map().covers_region()) << outcome->map().why_not_covered();
  ASSERT_TRUE(outcome->value());
  EXPECT_NEAR(*outcome->value(), outcome->size(), 1e-9 * outcome->size());
  ASSERT_TRUE(outcome->proven_bound());
  EXPECT_LE(*outcome->proven_bound(), *outcome->value());
  EXPECT_GE(outcome->transmission_min(), small_task().limits.transmission - 1e-9);
  EXPECT_TRUE(verify(*outcome).holds);
  for (const double x : {62.0, 65.5, 70.0})
    for (const double y : {-5.0, 1.0, 5.0}) {
      const auto answer = outcome->pose_with_tracer_at({x, y});
      ASSERT_TRUE(std::holds_alternative<Pose>(answer));
      const Pose& pose = std::get<Pose>(answer);
      const Point pen = outcome->grounding() == Grounding::pen ? pose.V : pose.Y;
      EXPECT_NEAR(pen.x(), -1.4 * y, 1e-9);  // a quarter turn about the origin, 1.4 times as large
      EXPECT_NEAR(pen.y(), 1.4 * x, 1e-9);
    }
}

TEST(Library, TellsTheProgressOfSearchBoundAndMapEachFromItsBeginning) {
  Spec spec = small_task();
  spec.pole.place = Region::rectangle({-20, -20}, {40, 40});
  std::vector<std::pair<std::string, double>> told;
  Options options;
  options.progress = [&](double share, std::string_view what) { told.emplace_back(what, share); };
  ASSERT_TRUE(design(spec, options));
  for (const auto& [what, share] : told) EXPECT_TRUE(share >= 0 && share <= 1) << what << " " << share;
  const auto first = [&](std::string_view what) {
    return std::find_if(told.begin(), told.end(), [&](const auto& one) { return one.first == what; });
  };
  EXPECT_TRUE(first("searching") < first("proving a bound"));
  EXPECT_TRUE(first("proving a bound") < first("mapping"));
  ASSERT_TRUE(first("mapping") < told.end());
  EXPECT_TRUE(std::is_sorted(first("mapping"), told.end()));  // of one name, by the share
  EXPECT_EQ(first("mapping")->second, 0);
  EXPECT_EQ(told.back(), std::pair(std::string("mapping"), 1.0));
}

TEST(Library, TellsTheProgressOfADiagnosis) {
  Spec spec = small_task();
  spec.limits.transmission = 88 * degree;
  std::vector<double> told;
  Options options;
  options.progress = [&](double share, std::string_view what) {
    if (what == "looking for what would help") told.push_back(share);
  };
  ASSERT_FALSE(design(spec, options));
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1);
}

TEST(Library, SaysHowFarADesignSinksWhereItHasAMaterial) {
  Spec spec = given_mechanism();
  EXPECT_FALSE(map(spec)->sag());
  spec.material = Material{"steel", 200e3, 7850, 235};
  spec.links.style.thickness = 2;
  const Outcome outcome = map(spec);
  ASSERT_TRUE(outcome) << outcome.reason();
  ASSERT_TRUE(outcome->sag());
  EXPECT_GT(*outcome->sag(), 0);
  EXPECT_NE(outcome->json().find("\"sag_max_mm\""), std::string::npos);
}

TEST(Library, SaysWhatPinsAndLayersDoUnderALoad) {
  Spec spec = given_mechanism();
  spec.material = Material{"steel", 200e3, 7850, 235};
  spec.links.style.thickness = 2;
  EXPECT_FALSE(map(spec)->load_error_layered());
  EXPECT_FALSE(map(spec)->load_rise());
  EXPECT_FALSE(map(spec)->stress() || map(spec)->stress_layered());
  spec.load = Load{.pen_force = 10};
  const Outcome outcome = map(spec);
  ASSERT_TRUE(outcome) << outcome.reason();
  ASSERT_TRUE(outcome->load_error() && outcome->load_error_layered() && outcome->load_rise());
  EXPECT_GT(*outcome->load_error_layered(), *outcome->load_error());
  EXPECT_GT(*outcome->load_rise(), 0);
  EXPECT_NE(outcome->json().find("\"load_error_layered_max_mm\""), std::string::npos);
  ASSERT_TRUE(outcome->stress() && outcome->stress_layered());
  EXPECT_GT(*outcome->stress_layered(), *outcome->stress());
  EXPECT_NE(outcome->json().find("\"stress_layered_max_MPa\""), std::string::npos);
}

TEST(Library, SaysWhatTheLinksOwnWeightDoesAlongATiltedTable) {
  Spec spec = given_mechanism();
  spec.material = Material{"steel", 200e3, 7850, 235};
  spec.links.style.thickness = 2;
  spec.load = Load{.pen_force = 10};
  const Outcome level = map(spec);
  EXPECT_FALSE(level->weight_error() || level->weight_error_layered() || level->weight_rise());
  spec.load->tilt = 1;  // rad
  const Outcome tilted = map(spec);
  ASSERT_TRUE(tilted) << tilted.reason();
  ASSERT_TRUE(tilted->weight_error() && tilted->weight_error_layered() && tilted->weight_rise());
  EXPECT_GT(*tilted->weight_error(), 0);
  EXPECT_GT(*tilted->weight_error_layered(), *tilted->weight_error());
  EXPECT_GT(*tilted->weight_rise(), 0);
  EXPECT_GT(*tilted->stress(), *level->stress());
}

TEST(Library, GivesTheSameDesignForAnyNumberOfThreads) {
  Options two;
  two.threads = 2;
  const Outcome one = design(small_task()), other = design(small_task(), two);
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->json(), other->json());
}

TEST(Library, SaysWhyThereIsNoDesign) {
  Spec spec = small_task();
  spec.links.longest = 20;
  const Outcome outcome = design(spec);
  EXPECT_FALSE(outcome);
  EXPECT_EQ(outcome.kind(), Outcome::Kind::no_design);
  EXPECT_TRUE(outcome.proven());
  EXPECT_NE(outcome.reason(), "");
}

TEST(Library, SaysWhatIsWrongWithASpec) {
  Spec spec = small_task();
  spec.links.style.width = -3;
  for (const Outcome& outcome : {design(spec), map(spec)}) {
    EXPECT_EQ(outcome.kind(), Outcome::Kind::bad_spec);
    ASSERT_TRUE(outcome.fault());
    EXPECT_EQ(outcome.fault()->key, "links.width_mm");
    EXPECT_EQ(outcome.reason(), outcome.fault()->message());
    EXPECT_EQ(validate(spec)->message(), outcome.reason());
  }
}

TEST(Library, StopsWhenAsked) {
  Options options;
  options.stop = [] { return true; };
  EXPECT_EQ(design(small_task(), options).kind(), Outcome::Kind::stopped);
}

TEST(Library, MapsAGivenMechanism) {
  const Outcome outcome = map(given_mechanism());
  ASSERT_TRUE(outcome) << outcome.reason();
  EXPECT_EQ(outcome->lengths().VA, 50);
  EXPECT_EQ(outcome->lengths().VB, 35);
  EXPECT_FALSE(outcome->value());
  const Map& map = outcome->map();
  EXPECT_GE(map.reachable_area(), map.usable_area());
  EXPECT_GE(map.usable_area(), map.collision_free_area());
  EXPECT_TRUE(map.at({66, 0}).free) << map.at({66, 0}).sentence;
  EXPECT_FALSE(map.at({500, 0}).free);
}

TEST(Library, WantsAMechanismToMap) {
  const Outcome outcome = map(small_task());
  ASSERT_TRUE(outcome.fault());
  EXPECT_EQ(outcome.fault()->key, "mechanism");
}

TEST(Library, ObstaclesTakeFromTheFreeWorkspace) {
  Spec obstructed = given_mechanism();
  obstructed.obstacles.push_back({Region::rectangle({60, -20}, {10, 10}).polygons.front(), 1, 8, "vice"});
  const Outcome free = map(given_mechanism()), less = map(obstructed);
  ASSERT_TRUE(free && less);
  EXPECT_LT(less->map().collision_free_area(), free->map().collision_free_area());
  bool named = false;
  for (const Loss& loss : less->map().losses())
    for (const std::string& part : loss.parts) named = named || part == "vice";
  EXPECT_TRUE(named);
}

TEST(Library, TracesADrawing) {
  const Outcome outcome = map(given_mechanism());
  ASSERT_TRUE(outcome);
  const auto traced = trace(*outcome, {{{63, -4}, {69, -4}, {69, 4}}, {{1000, 0}, {1010, 0}}});
  ASSERT_TRUE(std::holds_alternative<CopiedDrawing>(traced));
  const auto& copy = std::get<CopiedDrawing>(traced);
  ASSERT_EQ(copy.drawn.size(), 1u);
  EXPECT_NEAR(copy.drawn_length, 14, 1e-6);
  EXPECT_NEAR(copy.missing_length, 10, 1e-6);
  EXPECT_NEAR((copy.drawn[0].points.front() - Point(5.6, 88.2)).norm(), 0, 1e-9);
}

constexpr const char* corner_svg =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="6mm" height="8mm" viewBox="0 0 6 8"><path d="M0 8H6V0"/></svg>)";

TEST(Library, TracesASvgAsItTracesItsLines) {
  const Outcome outcome = map(given_mechanism());
  ASSERT_TRUE(outcome);
  DrawingOptions options;
  options.at = Point(63, -4);
  options.step = 0.49;
  options.keep_joints = true;
  const auto found = trace_svg(*outcome, corner_svg, options, "corner.svg");
  const auto lines = trace(*outcome, {{{63, -4}, {69, -4}, {69, 4}}}, 0.49);
  ASSERT_TRUE(std::holds_alternative<TracedDrawing>(found));
  const auto& [copy, json, svg, joints, forces] = std::get<TracedDrawing>(found);
  const auto& expected = std::get<CopiedDrawing>(lines);
  ASSERT_EQ(copy.drawn.size(), 1u);
  ASSERT_EQ(copy.drawn[0].points.size(), expected.drawn[0].points.size());
  for (std::size_t i = 0; i < copy.drawn[0].points.size(); ++i)
    EXPECT_NEAR((copy.drawn[0].points[i] - expected.drawn[0].points[i]).norm(), 0, 1e-9);
  EXPECT_EQ(copy.poses, expected.poses);
  EXPECT_NE(svg.find("corner.svg, copied"), std::string::npos);
  EXPECT_EQ(static_cast<std::size_t>(std::count(joints.begin(), joints.end(), '\n')), copy.poses + 1);
  EXPECT_EQ(forces, "");
  EXPECT_EQ(json.find("\"copy\""), std::string::npos);
}

TEST(Library, RefusesDrawingsAndOptionsThatCannotBe) {
  const Outcome outcome = map(given_mechanism());
  ASSERT_TRUE(outcome);
  const auto key = [&](const DrawingOptions& options, const char* svg = corner_svg) -> std::string {
    const auto found = trace_svg(*outcome, svg, options, "corner.svg");
    const auto* fault = std::get_if<InputError>(&found);
    return fault ? fault->key + fault->file : "none";
  };
  DrawingOptions options;
  EXPECT_EQ(key(options), "none");
  EXPECT_EQ(key(options, "no SVG"), "corner.svg");
  options.fit = true;
  options.scale = 2;
  EXPECT_EQ(key(options), "fit");
  options = {};
  options.keep_forces = true;
  EXPECT_EQ(key(options), "material");
  for (const double bad : {0.0, -1.0, 1e9, std::nan("")}) {
    options = {};
    options.scale = bad;
    EXPECT_EQ(key(options), "scale");
    options = {};
    options.tolerance = bad;
    EXPECT_EQ(key(options), "tolerance_mm");
    options = {};
    options.step = bad;
    EXPECT_EQ(key(options), "step_mm");
  }
  options = {};
  options.at = Point(0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(key(options), "at");
}

TEST(Library, TracesNothingThatIsNoNumberAndSaysSo) {
  const Outcome outcome = map(given_mechanism());
  ASSERT_TRUE(outcome);
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refused = [&](const std::vector<Polyline>& lines, double step) -> std::string {
    const auto traced = trace(*outcome, lines, step);
    const auto* fault = std::get_if<InputError>(&traced);
    return fault ? fault->key : "";
  };
  const Polyline good{{63, -4}, {69, -4}};
  EXPECT_EQ(refused({good}, 0.5), "");
  for (const double step : {0.0, -0.5, std::nan(""), infinity, -infinity})
    EXPECT_EQ(refused({good}, step), "step") << step;
  EXPECT_EQ(refused({good, {{std::nan(""), 0}, {1, 1}}}, 0.5), "lines[1]");
  EXPECT_EQ(refused({{{0, 0}, {1, infinity}}, good}, 0.5), "lines[0]");
}

TEST(Library, AStopEndsTheSimulationOfACalibration) {
  const auto file =
      std::filesystem::path(KEMPE_SOURCE_DIR) / "specs" / "examples" / "calibration" / "simulate.toml";
  int asked = 0;
  CalibrationOptions options;
  options.simulate = true;
  options.stop = [&asked] { return ++asked >= 3; };
  const auto found = calibrate_file_with(options, file);
  ASSERT_TRUE(std::holds_alternative<CalibratedInstrument>(found));
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(std::get<CalibratedInstrument>(found).simulated, "");
  EXPECT_NE(std::get<CalibratedInstrument>(found).json, "");
}

TEST(Library, RegionsAreWhatTheySay) {
  EXPECT_EQ(Region::rectangle({1, 2}, {3, 4}).polygons[0].outer, (Ring{{1, 2}, {4, 2}, {4, 6}, {1, 6}}));
  const Region circle = Region::circle({5, -3}, 2);
  for (const Point& corner : circle.polygons[0].outer)
    EXPECT_NEAR((corner - Point(5, -3)).norm(), 2, 2 * 2.4e-6);
  EXPECT_FALSE(validate([] {
    Spec spec = small_task();
    spec.region = Region::polygon({{62, -5}, {62, 5}, {70, 5}, {70, -5}});  // clockwise
    return spec;
  }()));
}

TEST(Library, GivesAFrontOrSaysWhyThereIsNone) {
  const auto found = front(small_task(), Objective::size, Objective::transmission, 3);
  ASSERT_TRUE(std::holds_alternative<Front>(found));
  const Front& points = std::get<Front>(found);
  EXPECT_TRUE(points.complete);
  ASSERT_GE(points.points.size(), 2U);
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const FrontPoint& point = points.points[i];
    EXPECT_NEAR(point.first, point.design.size(), 1e-9 * point.first);
    EXPECT_NEAR(point.second, point.design.transmission_min(), 1e-6);
    EXPECT_FALSE(point.design.proven_bound());
    if (i == 0) continue;
    EXPECT_GT(point.first, points.points[i - 1].first);
    EXPECT_GT(point.second, points.points[i - 1].second);
  }
  Spec narrow = small_task();
  narrow.links.longest = 20;
  const auto none = front(narrow, Objective::size, Objective::transmission, 3);
  ASSERT_TRUE(std::holds_alternative<Outcome>(none));
  EXPECT_EQ(std::get<Outcome>(none).kind(), Outcome::Kind::no_design);
  const auto fault_of = [](const std::variant<Front, Outcome>& answer) {
    return std::get<Outcome>(answer).fault().value().key;
  };
  EXPECT_EQ(fault_of(front(small_task(), Objective::size, Objective::mass)), "material");
  EXPECT_EQ(fault_of(front(small_task(), Objective::size, Objective::size)), "between");
  EXPECT_EQ(fault_of(front(small_task(), Objective::size, Objective::transmission, 1)), "points");
  Options at_once;
  at_once.time_limit = 0;
  const auto stopped = front(small_task(), Objective::size, Objective::transmission, 3, at_once);
  ASSERT_TRUE(std::holds_alternative<Outcome>(stopped));
  EXPECT_EQ(std::get<Outcome>(stopped).kind(), Outcome::Kind::stopped);
}

}  // namespace
}  // namespace kempe
