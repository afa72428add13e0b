// The table, the animation, the JSON and the pictures of a moving linkage.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "kinematics/planar/mobility.hpp"
#include "reports/linkages/animation.hpp"
#include "reports/linkages/centres_picture.hpp"
#include "reports/linkages/centres_steps.hpp"
#include "reports/linkages/forces.hpp"
#include "reports/linkages/json.hpp"
#include "reports/linkages/solve_table.hpp"

namespace kempe {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Moved {
  LinkageFile file;
  LinkageModel model;
  PlanarPosition start;
  PlanarRun run;
  int steps;

  explicit Moved(LinkageFile read) : file(std::move(read)), model(linkage_model(file)), steps(file.steps) {
    start = start_assembly_modes(file, model)->front();
    run = *run_motion(model.linkage, start, model.schedule, steps);
  }
  LinkageScene scene() const { return linkage_scene(file, model, run, steps); }
};

Moved example(const std::string& name) {
  return Moved(*read_linkage_file(KEMPE_SOURCE_DIR "/specs/examples/linkages/" + name + ".toml"));
}

/// A rocker that the crank drives into its dead point.
Moved stopping() {
  return Moved(*parse_linkage_file(R"(
name = "<b>A & \"B\"</b>"
[ground]
A = [0, 0]
D = [60, 0]
[links]
crank = { joints = ["A", "B"], A-B = 45 }
rod = { joints = ["B", "C"], B-C = 50 }
rocker = { joints = ["D", "C"], D-C = 40 }
[[drivers]]
angle = "crank"
from_deg = 30
to_deg = 180
[motion]
steps = 10
[guess]
C = [70, 38]
[output]
velocities = true
accelerations = true
angles = ["rocker"]
)",
                                   "stop.toml"));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(SolveTable, NamesUnitsInItsColumns) {
  const Moved press = example("shear-press");
  const auto lines = lines_of(csv_text(solve_table(press.file, press.model, press.run, press.steps)));
  ASSERT_EQ(lines.size(), 10u);
  EXPECT_EQ(
      lines[0],
      "step,time_s,P_x_m,P_y_m,B_x_m,B_y_m,C_x_m,C_y_m,lever_angle_deg,rod_angle_deg,transmission_B_C_G_deg");
  EXPECT_THAT(lines[1], testing::StartsWith("0,0,0.415331193145904,0.5,"));
  EXPECT_THAT(lines[9], testing::StartsWith("8,1,0.57662812973354,0.3,"));
}

TEST(SolveTable, EndsWithTheLastGoodPositionAndNeverWithNaN) {
  const Moved moved = stopping();
  ASSERT_TRUE(moved.run.stop);
  const SolveTable table = solve_table(moved.file, moved.model, moved.run, moved.steps);
  const double step = *table.rows.back()[0];
  EXPECT_NE(step, std::floor(step));
  const auto lines = lines_of(csv_text(table));
  EXPECT_THAT(lines.back(), HasSubstr(",,"));  // no rates at a dead point
  for (const std::string& line : lines) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','),
              static_cast<std::ptrdiff_t>(table.columns.size()) - 1);
    if (&line == &lines[0]) continue;
    EXPECT_FALSE(std::regex_search(line, std::regex("[a-z]"))) << line;
  }
}

TEST(LinkageAnimation, IsOneFileThatAsksTheNetworkForNothing) {
  for (const std::string& page :
       {animation_html(example("hart").scene()), animation_svg(example("hart").scene())}) {
    std::string bare = page;
    for (std::size_t at; (at = bare.find("http://www.w3.org/2000/svg")) != std::string::npos;)
      bare.erase(at, 26);
    for (std::size_t at; (at = bare.find("url(#")) != std::string::npos;)
      bare.erase(at, 5);  // the page's own
    for (const char* reference : {"http:", "https:", "src=", "href=", "url(", "@import"})
      EXPECT_THAT(bare, Not(HasSubstr(reference)));
    EXPECT_THAT(page, Not(HasSubstr("nan")));
    EXPECT_THAT(page, Not(HasSubstr("inf\"")));
  }
}

TEST(LinkageAnimation, EscapesNamesAndTellsAnEarlyEnd) {
  const std::string page = animation_html(stopping().scene());
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;A &amp;"));
  EXPECT_THAT(page, HasSubstr("The motion ends early: dead point."));
}

TEST(LinkageAnimation, HoldsEveryMomentOfEveryLink) {
  const Moved moved = example("six-bar-plagiograph");
  const std::string page = animation_html(moved.scene());
  const std::string mark = "<script type=\"application/json\" id=\"scene\">";
  const std::size_t start = page.find(mark) + mark.size();
  const auto scene = nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start));
  ASSERT_EQ(scene["moments"].size(), 121u);
  EXPECT_TRUE(scene["closed"]);
  const auto& moment = scene["moments"][40];
  ASSERT_EQ(moment.size(), 1u + 3u * 5u);
  EXPECT_NEAR(moment[1].get<double>(), moved.run.frames[40].position[1].at.x(), 1e-6);
  EXPECT_NEAR(moment[2].get<double>(), -moved.run.frames[40].position[1].at.y(), 1e-6);  // y downward
  EXPECT_NEAR(moment[3].get<double>(), -moved.run.frames[40].position[1].angle, 1e-6);
}

TEST(LinkageScene, BoxHoldsEveryPointOfEveryMoment) {
  for (const char* name : {"shear-press", "geared-five-bar", "right-angle-inversor"}) {
    const LinkageScene scene = example(name).scene();
    for (const auto& moment : scene.moments)
      for (const ScenePoint& point : scene.points) {
        const Point at = scene.place(point, moment);
        EXPECT_TRUE((at.array() >= scene.lower.array() - 1e-9).all() &&
                    (at.array() <= scene.upper.array() + 1e-9).all());
      }
  }
}

TEST(MobilityJson, SaysWhyCountAndTruthDiffer) {
  const Moved wrong = example("pantograph-by-distances");
  const auto object = nlohmann::json::parse(
      mobility_json(wrong.file, wrong.model, mobility_of(wrong.model.linkage, wrong.start)));
  EXPECT_EQ(object["mobility"], 2);
  EXPECT_EQ(object["notes"].size(), 2u);

  const LinkageFile cranks = *parse_linkage_file(R"(
[ground]
A = [0, 0]
D = [60, 0]
E = [30, 0]
[links]
crank = { joints = ["A", "B"], A-B = 20 }
rod = { joints = ["B", "F", "C"], along = [0, 30, 60] }
rocker = { joints = ["D", "C"], D-C = 20 }
middle = { joints = ["E", "F"], E-F = 20 }
[guess]
B = [10, 17]
F = [40, 17]
C = [70, 17]
)",
                                                 "cranks.toml");
  const LinkageModel model = linkage_model(cranks);
  const auto closed = solve_from(model.linkage, guessed_position(cranks, model));
  ASSERT_TRUE(closed);
  const auto three =
      nlohmann::json::parse(mobility_json(cranks, model, mobility_of(model.linkage, closed->position)));
  EXPECT_EQ(three["gruebler"], 0);
  EXPECT_EQ(three["mobility"], 1);
  ASSERT_EQ(three["redundant"].size(), 1u);
  EXPECT_EQ(three["sentences"][0], "Gruebler counts 0, the true mobility is 1: 1 equation is redundant");
  EXPECT_THAT(three["sentences"][1].get<std::string>(), HasSubstr("the count knows"));
  EXPECT_THAT(three["sentences"][2].get<std::string>(), HasSubstr("joint F (rod, middle)"));
}

TEST(MobilityJson, WritesGrueblersCountWithItsNumbers) {
  Mobility m;
  m.links = 5;
  m.full_joints = 6;
  EXPECT_EQ(gruebler_in_numbers(m), "3 (n - 1) - 2 j1 - j2 = 3 (5 - 1) - 2 * 6 - 0 = 0");
  m.particles = 2;
  m.half_joints = 3;
  m.gruebler = 1;
  EXPECT_EQ(gruebler_in_numbers(m), "3 (n - 1) + 2 p - 2 j1 - j2 = 3 (5 - 1) + 2 * 2 - 2 * 6 - 3 = 1");
}

TEST(MobilityJson, ListsAssortments) {
  const auto six = nlohmann::json::parse(number_synthesis_json(6, 1, number_synthesis(6, 1)));
  EXPECT_EQ(six["joints"], 7);
  EXPECT_EQ(six["assortments"], nlohmann::json::parse(R"([{"n2": 4, "n3": 2, "n4": 0}])"));
  EXPECT_THAT(number_synthesis_json(5, 1, number_synthesis(5, 1)), HasSubstr("no joints fit"));
}

TEST(CentresJson, HoldsAllPairsWithTheirLines) {
  const Moved moved = example("watt-six-bar");
  const RunFrame& frame = moved.run.frames[17];
  const auto centres = instant_centres(moved.model.linkage, frame.position, frame.rate);
  const auto object =
      nlohmann::json::parse(centres_json(moved.file, moved.model, 17, frame, {2 * pi}, centres));
  EXPECT_EQ(object["count"], 15);
  int primary = 0, found = 0;
  for (const auto& centre : object["centres"]) {
    EXPECT_LT(centre["velocity_error"].get<double>(), 1e-9);
    primary += centre["source"] == "primary" ? 1 : 0;
    if (centre["source"] == "aronhold-kennedy") {
      ++found;
      EXPECT_EQ(centre["lines"].size(), 2u);
      EXPECT_EQ(centre["lines"][0]["through"].size(), 2u);
    }
  }
  EXPECT_EQ(primary, 7);
  EXPECT_EQ(found, 8);
}

TEST(CentresPicture, LabelsEveryCentreOnceAndLosesNone) {
  const Moved moved = example("plagiograph");
  const PlanarRun moment{{moved.run.frames[3]}, std::nullopt};
  const auto centres = instant_centres(moved.model.linkage, moment.frames[0].position, moment.frames[0].rate);
  const std::string picture =
      centres_svg(linkage_scene(moved.file, moved.model, moment, moved.steps), centres, 10);
  for (int i = 1; i <= 5; ++i)
    for (int j = i + 1; j <= 5; ++j)
      EXPECT_THAT(picture, HasSubstr(std::to_string(i) + "-" + std::to_string(j)));
  EXPECT_THAT(picture, HasSubstr("2-5  at infinity"));
  EXPECT_THAT(picture, HasSubstr("3-4  at infinity"));
}

/// Where a picture has the dot before a label.
Point dot_of(const std::string& picture, const std::string& label) {
  const std::regex dot("<circle[^>]*cx=\"([^\"]*)\" cy=\"([^\"]*)\"[^>]*/>\\s*<text[^>]*>" + label +
                       "</text>");
  std::smatch found;
  EXPECT_TRUE(std::regex_search(picture, found, dot)) << label;
  return found.empty() ? Point(0, 0) : Point(std::stod(found[1]), std::stod(found[2]));
}

TEST(CentresPicture, TellsCentresThatNearlyCoincideApartInAnInset) {
  const Moved moved = example("watt-six-bar");
  const PlanarRun moment{{moved.run.frames[1]}, std::nullopt};
  const auto centres = instant_centres(moved.model.linkage, moment.frames[0].position, moment.frames[0].rate);
  const std::string picture =
      centres_svg(linkage_scene(moved.file, moved.model, moment, moved.steps), centres, 1);
  const auto count = [&](const std::string& words) {
    std::size_t times = 0;
    for (std::size_t at = picture.find(words); at != std::string::npos; at = picture.find(words, at + 1))
      ++times;
    return times;
  };
  std::map<std::string, Point> places;
  for (const InstantCentre& centre : centres) {
    const std::string name = std::to_string(centre.first + 1) + "-" + std::to_string(centre.second + 1);
    EXPECT_EQ(count(">" + name + "</text>"), 1u) << name;
    places[name] = {centre.at.x(), -centre.at.y()};
  }
  EXPECT_EQ(count(">inset a"), 2u);
  EXPECT_EQ(count(">inset b"), 2u);
  // Drawn larger, but as they lie.
  const Point from = dot_of(picture, "2-3"), drawn = dot_of(picture, "2-4") - from;
  const Point true_way = places["2-4"] - places["2-3"];
  EXPECT_GT(drawn.norm(), 5 * true_way.norm());
  for (const std::string name : {"2-5", "2-6"}) {
    const Point way = dot_of(picture, name) - from, expected = places[name] - places["2-3"];
    EXPECT_LT((way / drawn.norm() - expected / true_way.norm()).norm(), 0.02) << name;
  }
}

TEST(CentresPicture, KeepsLabelsOffEachOther) {
  for (const char* name : {"jansen", "double-rocker", "watt-six-bar"}) {
    const Moved moved = example(name);
    const PlanarRun moment{{moved.run.frames[1]}, std::nullopt};
    const auto centres =
        instant_centres(moved.model.linkage, moment.frames[0].position, moment.frames[0].rate);
    const std::string picture = centres_svg(linkage_scene(moved.file, moved.model, moment, moved.steps),
                                            centres, moved.file.unit.in_mm);
    EXPECT_FALSE(std::regex_search(picture, std::regex("at \\([^)]*e-")))
        << name << ": a zero but for rounding";
    std::smatch style;
    ASSERT_TRUE(std::regex_search(picture, style, std::regex("\\.centre\\{font:([0-9.]+)px")));
    const double font = std::stod(style[1]);
    struct Words {
      double x, y, width;
    };
    std::vector<Words> all;
    const std::regex words("<text class=\"centre[^\"]*\" x=\"([^\"]*)\" y=\"([^\"]*)\"[^>]*>([^<]*)<");
    for (auto at = std::sregex_iterator(picture.begin(), picture.end(), words); at != std::sregex_iterator();
         ++at)
      all.push_back(
          {std::stod((*at)[1]), std::stod((*at)[2]), 0.55 * font * static_cast<double>((*at)[3].length())});
    EXPECT_GE(all.size(), 5u);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Words &a = all[i], &b = all[j];
        const bool apart = a.x + a.width < b.x || b.x + b.width < a.x || std::abs(a.y - b.y) > 0.75 * font;
        EXPECT_TRUE(apart) << name << ": words at (" << a.x << ", " << a.y << ") and (" << b.x << ", " << b.y
                           << ")";
      }
  }
}

TEST(CentreSteps, GiveEveryCentreOnceAndFromCentresOnOneLineWithIt) {
  for (const std::string name :
       {"watt-six-bar", "plagiograph", "shear-press", "slider-crank", "peaucellier-lipkin"}) {
    const Moved moved = example(name);
    for (const std::size_t frame : {std::size_t{1}, std::size_t{3}}) {
      const RunFrame& at = moved.run.frames[frame];
      const auto centres = instant_centres(moved.model.linkage, at.position, at.rate);
      const auto steps = centre_steps(moved.model, centres);
      ASSERT_EQ(steps.size(), centres.size());
      std::map<std::string, Eigen::Vector3d> known;  // homogeneous, so that those at infinity are points too
      int through_lines = 0;
      for (const CentreStep& step : steps) {
        const InstantCentre& centre = *step.centre;
        const bool is_far = centre.kind == InstantCentre::Kind::at_infinity;
        const double size = moved.model.linkage.size();
        const Eigen::Vector3d place = is_far ? Eigen::Vector3d(centre.direction.x(), centre.direction.y(), 0)
                                             : Eigen::Vector3d(centre.at.x() / size, centre.at.y() / size, 1);
        EXPECT_EQ(step.uses.size() % 2, 0u);
        for (std::size_t i = 0; i + 1 < step.uses.size(); i += 2, ++through_lines) {
          ASSERT_TRUE(known.count(step.uses[i]) && known.count(step.uses[i + 1])) << name << " " << step.name;
          const Eigen::Vector3d a = place.normalized(), b = known[step.uses[i]].normalized(),
                                c = known[step.uses[i + 1]].normalized();
          const double volume = a.x() * (b.y() * c.z() - b.z() * c.y()) +
                                a.y() * (b.z() * c.x() - b.x() * c.z()) +
                                a.z() * (b.x() * c.y() - b.y() * c.x());
          EXPECT_LT(std::abs(volume), 1e-9) << name << " " << step.name;
        }
        EXPECT_TRUE(known.emplace(step.name, place).second) << step.name;
        EXPECT_FALSE(step.reason.empty());
      }
      EXPECT_GT(through_lines, 0) << name;
    }
  }
}

TEST(CentresPicture, DrawsTheNormalOfASlider) {
  const Moved moved = example("shear-press");
  const PlanarRun moment{{moved.run.frames[0]}, std::nullopt};
  const auto centres = instant_centres(moved.model.linkage, moment.frames[0].position, moment.frames[0].rate);
  const std::string picture =
      centres_svg(linkage_scene(moved.file, moved.model, moment, moved.steps), centres, 1000);
  std::smatch line;  // of the blade's guide, which is upright: level, through the blade
  ASSERT_TRUE(std::regex_search(
      picture, line,
      std::regex("class=\"line normal\" d=\"M[-0-9.]+[ ,]([-0-9.]+) L[-0-9.]+[ ,]([-0-9.]+)\"")));
  EXPECT_EQ(line[1], line[2]);
}

Moved with_loads(const std::string& text) { return Moved(*parse_linkage_file(text, "loads.toml")); }

TEST(Animation, ShowsForcesAndWhatTheDriversBear) {
  const Moved press = example("shear-press-forces");
  const LinkageScene scene = press.scene();
  const std::string page = animation_html(scene);
  EXPECT_THAT(page, HasSubstr("<b>driver P.y</b> <span id=\"force0\">"));
  EXPECT_THAT(page, HasSubstr("id=\"arrow0\""));
  EXPECT_THAT(page, HasSubstr("id=\"arrow1\""));
  EXPECT_THAT(page, Not(HasSubstr("id=\"arrow2\"")));
  EXPECT_THAT(page, HasSubstr("Red arrows are forces, the longest is 2000 N."));
  for (const auto& moment : scene.moments) {
    ASSERT_EQ(moment.arrows.size(), 2u);
    EXPECT_EQ(moment.arrows[0].force, Point(0, -2000));  // up, y downward
    EXPECT_NEAR(moment.arrows[1].force.y(), -moment.driver_forces[0].value(), 1e-9);
    for (const SceneArrow& arrow : moment.arrows) {
      const Point tail = arrow.at - scene.arrow_scale * arrow.force;
      EXPECT_TRUE((tail.array() >= scene.lower.array()).all() && (tail.array() <= scene.upper.array()).all());
    }
  }
  EXPECT_THAT(animation_html(example("shear-press").scene()), HasSubstr("\"loads\":null"));
}

TEST(SolveTable, NamesEveryForceByWhatBearsIt) {
  const Moved press = example("shear-press-forces");
  const SolveTable table = solve_table(press.file, press.model, press.run, press.steps);
  const std::vector<std::string> forces(table.columns.end() - 7, table.columns.end());
  EXPECT_EQ(forces,
            (std::vector<std::string>{"drive_P_y_N", "A_on_lever_x_N", "A_on_lever_y_N", "B_on_rod_x_N",
                                      "B_on_rod_y_N", "C_from_ground_x_N", "C_from_ground_y_N"}));
  EXPECT_EQ(table.kinds.back(), ColumnKind::force);
  const auto sentences = force_sentences(press.file, press.model, table);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(sentences[0], "driver P.y: -928.866 N at step 0, its largest");
  EXPECT_EQ(sentences[1], "largest reaction: 2300.67 N in joint B (lever, rod) at step 0");
  Moved quiet = press;
  quiet.file.output.reactions = false;
  EXPECT_EQ(force_columns(quiet.file, quiet.model).size(), 1u);
  const Moved without = example("shear-press");
  EXPECT_TRUE(force_columns(without.file, without.model).empty());
}

TEST(SolveTable, LeavesOutWhatRigidLinksDoNotDetermine) {
  const Moved cranks = with_loads(R"(
[ground]
A = [0, 0]
B = [20, 0]
C = [40, 0]
[links]
bar = { joints = ["D", "E", "F"], along = [0, 20, 40] }
a = { joints = ["A", "D"], A-D = 10 }
b = { joints = ["B", "E"], B-E = 10 }
c = { joints = ["C", "F"], C-F = 10 }
[[drivers]]
angle = "a"
from_deg = 30
to_deg = 80
[[forces]]
at = "F"
newton = [0, -5]
turns_with = "a"
[guess]
D = [8.7, 5]
E = [28.7, 5]
F = [48.7, 5]
[motion]
steps = 4
)");
  const SolveTable table = solve_table(cranks.file, cranks.model, cranks.run, cranks.steps);
  const std::size_t drive = table.columns.size() - 13;
  EXPECT_EQ(table.columns[drive], "drive_angle_of_a_N_m");
  for (std::size_t row = 0; row < 5; ++row) {
    EXPECT_NEAR(table.rows[row][drive].value(), 0.05, 1e-12);  // 5 N square to 10 mm
    for (std::size_t column = drive + 1; column < table.columns.size(); ++column)
      EXPECT_FALSE(table.rows[row][column].has_value()) << table.columns[column];
  }
  EXPECT_THAT(
      force_sentences(cranks.file, cranks.model, table).back(),
      HasSubstr("rigid links do not say how these share the loads (the linkage is over-constrained)"));
  EXPECT_EQ(undetermined_reactions(cranks.file, cranks.model, table).size(), 6u);
}

TEST(SolveTable, GivesNoForceAtADeadPoint) {
  Moved moved = stopping();
  moved.model.loads.forces = {{moved.model.point("C"), Point(1, 2), PlanarLinkage::ground}};
  ASSERT_TRUE(moved.run.stop);
  const SolveTable table = solve_table(moved.file, moved.model, moved.run, moved.steps);
  EXPECT_TRUE(table.rows.front().back().has_value());
  EXPECT_FALSE(table.rows.back().back().has_value());
}

TEST(SolveTable, SumsTheBearingsOfGearsUpToTheirLoads) {
  // A moment of 2 N m on the second wheel (40 mm) comes from a tooth force of 50 N, which both bearings feel.
  const Moved gears = with_loads(R"(
[ground]
A = [0, 0]
B = [60, 0]
[links]
first = { at = { A = [0, 0] } }
second = { at = { B = [0, 0] } }
[[gears]]
wheels = ["first", "second"]
teeth = [10, 20]
[[drivers]]
angle = "first"
from_deg = 0
to_deg = 90
[[moments]]
on = "second"
newton_m = 2
)");
  const SolveTable table = solve_table(gears.file, gears.model, gears.run, gears.steps);
  const auto value = [&](const std::string& name) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), name);
    EXPECT_NE(found, table.columns.end()) << name;
    return table.rows[7][static_cast<std::size_t>(found - table.columns.begin())].value();
  };
  EXPECT_NEAR(value("drive_angle_of_first_N_m"), 1, 1e-12);
  EXPECT_NEAR(value("gears_first_and_second_N"), -50, 1e-10);
  EXPECT_NEAR(value("A_on_first_y_N"), 50, 1e-10);
  EXPECT_NEAR(value("B_on_second_y_N"), -50, 1e-10);
}

}  // namespace
}  // namespace kempe
