// What a linkage file says is what the model holds.
#include "specs/linkages/linkage_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kinematics/planar/mobility.hpp"
#include "specs/linkages/model.hpp"
#include "specs/linkages/path_data.hpp"
#include "specs/linkages/rigid_link.hpp"
#include "specs/linkages/straight_bars.hpp"

namespace kempe {
namespace {

using testing::HasSubstr;

LinkageFile parsed(const std::string& text) {
  auto file = parse_linkage_file(text, "test.toml");
  EXPECT_TRUE(file) << file.error().message();
  return file.value_or(LinkageFile{});
}

TEST(LinkageFile, UnitsScaleLengthsAndOnlyLengths) {
  const LinkageFile file = parsed(R"(
unit = "in"
[ground]
A = [1, 2]
[links]
crank = { joints = ["A", "B"], A-B = 3 }
[[drivers]]
angle = "crank"
from_deg = 0
to_deg = 90
rate_deg = 180
[guess]
B = [4, 2]
[bounds]
B = { x = [3, 5] }
)");
  EXPECT_EQ(file.unit, (LengthUnit{"in", 25.4}));
  EXPECT_LT((file.ground[0].second - Point(25.4, 50.8)).norm(), 1e-12);
  EXPECT_NEAR(file.links[0].joints[1].second.x(), 76.2, 1e-12);
  const auto& range = std::get<DriverRange>(file.drivers[0].motion);
  EXPECT_NEAR(range.to, pi / 2, 1e-15);
  EXPECT_NEAR(*range.rate, pi, 1e-15);
  EXPECT_NEAR(file.bounds[0].place[0]->first, 76.2, 1e-12);
  EXPECT_EQ(file.name, "test");
}

TEST(LinkageFile, BoundsAndGuessPickTheAssembly) {
  const std::string bars = R"(
[ground]
A = [0, 0]
D = [3, 0]
[links]
crank = { joints = ["A", "B"], A-B = 1 }
rod = { joints = ["B", "C"], B-C = 2.5 }
rocker = { joints = ["D", "C"], D-C = 2 }
[[drivers]]
angle = "crank"
from_deg = 50
to_deg = 60
)";
  const auto C_of = [&](const std::string& choice) {
    const LinkageFile file = parsed(bars + choice);
    const LinkageModel model = linkage_model(file);
    const auto found = start_assembly_modes(file, model);
    EXPECT_TRUE(found);
    EXPECT_EQ(found->size(), 2u);
    return place(found->front(), model.point("C"));
  };
  EXPECT_GT(C_of("[guess]\nC = [2, 2]\n").y(), 0);
  EXPECT_LT(C_of("[guess]\nC = [2, -2]\n").y(), 0);
  EXPECT_GT(C_of("[bounds]\nC = { y = [0, 9] }\n").y(), 0);
  EXPECT_LT(C_of("[bounds]\nC = { y = [-9, 0] }\n").y(), 0);
  EXPECT_LT(C_of("[bounds]\nrocker = { angle_deg = [200, 350] }\n").y(), 0);  // whole turns do not count
  const LinkageFile file = parsed(bars + "[bounds]\nC = { y = [7, 9] }\n");
  const auto none = start_assembly_modes(file, linkage_model(file));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().unmet, std::vector<std::string>{"C"});
}

TEST(LinkageFile, TheSameFileGivesTheSameAssemblies) {
  const auto file = read_linkage_file(KEMPE_SOURCE_DIR "/specs/examples/linkages/watt-six-bar.toml");
  ASSERT_TRUE(file);
  const LinkageModel model = linkage_model(*file);
  const auto once = start_assembly_modes(*file, model), twice = start_assembly_modes(*file, model);
  EXPECT_EQ(*once, *twice);
  EXPECT_EQ(once->size(), 4u);  // two closings of the four-bar times two of the dyad
}

TEST(LinkageFile, ALinkGivenThreeWaysIsTheSame) {
  const auto joints_of = [](const std::string& plate) {
    return parsed("[links]\nplate = " + plate + "\n").links[0].joints;
  };
  const auto by_lengths =
      joints_of(R"({ joints = ["A", "B", "P"], A-B = 4, B-P = 5, A-P = 3, side = "left" })");
  const auto by_angle = joints_of(R"({ joints = ["A", "B", "P"], A-B = 4, A-P = 3, B-A-P_deg = 90 })");
  const auto by_places = joints_of("{ at = { A = [0, 0], B = [4, 0], P = [0, 3] } }");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(by_lengths[i].first, by_places[i].first);
    EXPECT_LT((by_lengths[i].second - by_places[i].second).norm(), 1e-14);
    EXPECT_LT((by_angle[i].second - by_places[i].second).norm(), 1e-14);
  }
  const auto right = joints_of(R"({ joints = ["A", "B", "P"], A-B = 4, B-P = 5, A-P = 3, side = "right" })");
  EXPECT_LT((right[2].second - Point(0, -3)).norm(), 1e-14);
}

TEST(RigidLink, FlatTrianglesAreStraightRowsAndNeedNoSide) {
  const auto places = place_joints({{"A", "B", "C"}, {{0, 1, 3}, {1, 2, 4}, {0, 2, 7}}, {}, {}});
  ASSERT_TRUE(places);
  EXPECT_LT(((*places)[2] - Point(7, 0)).norm(), 1e-6);
  EXPECT_NEAR((*places)[2].y(), 0, 1e-15);
}

TEST(RigidLink, FourJointsBySixLengthsNeedNoSideForTheLast) {
  const Point D(1.5, -2.25);
  const Point A(0, 0), B(5, 0), C(1, 3);
  const auto places = place_joints({{"A", "B", "C", "D"},
                                    {{0, 1, 5},
                                     {0, 2, C.norm()},
                                     {1, 2, (C - B).norm()},
                                     {0, 3, D.norm()},
                                     {1, 3, (D - B).norm()},
                                     {2, 3, (D - C).norm()}},
                                    {},
                                    Side::left});
  ASSERT_TRUE(places) << places.error().found;
  EXPECT_LT(((*places)[2] - C).norm(), 1e-12);
  EXPECT_LT(((*places)[3] - D).norm(), 1e-12);  // on the right, because the sixth length says so
}

TEST(PathData, CommandsOfEveryKindMeetTheirEnds) {
  const auto end_of = [](const std::string& data) {
    const auto pieces = read_path_data(data);
    EXPECT_TRUE(pieces) << data;
    return pieces->back().end();
  };
  EXPECT_EQ(end_of("M1 2 L3 4"), Point(3, 4));
  EXPECT_EQ(end_of("m1 2 3 4 5 6"), Point(9, 12));
  EXPECT_EQ(end_of("M1,2H5v-3"), Point(5, -1));
  EXPECT_EQ(end_of("M0 0C1 1 2 1 3 0s2-1 3 0"), Point(6, 0));
  EXPECT_EQ(end_of("M0 0Q1 1 2 0T4 0"), Point(4, 0));
  EXPECT_LT((end_of("M0 0A5 5 0 0 1 5 5") - Point(5, 5)).norm(), 1e-14);
  EXPECT_LT((end_of("M0 0a5 3 30 1010 4") - Point(10, 4)).norm(), 1e-14);  // flags run together
  EXPECT_EQ(end_of("M0 0L1e1-.5z"), Point(0, 0));
}

TEST(PathData, ArcsAreOnTheirCircleAndEllipse) {
  const auto half = read_path_data("M2 0A2 2 0 0 1 -2 0");
  ASSERT_EQ(half->size(), 1u);
  EXPECT_NEAR((*half)[0].length(), 2 * pi, 1e-14);
  EXPECT_LT(((*half)[0].at(pi).at - Point(0, 2)).norm(), 1e-14);  // sweep 1: towards positive angles
  const auto ellipse = read_path_data("M3 0A3 1 0 0 1 -3 0A3 1 0 0 1 3 0", 10);
  for (const PathPiece& piece : *ellipse)
    for (double way = 0; way <= piece.length(); way += piece.length() / 16) {
      const Point p = piece.at(way).at / 10;
      EXPECT_NEAR(p.x() * p.x() / 9 + p.y() * p.y(), 1, 1e-7);
    }
}

TEST(PathData, SaysWhatIsWrong) {
  const auto fault = [](const std::string& data) {
    const auto pieces = read_path_data(data);
    EXPECT_FALSE(pieces) << data;
    return pieces ? std::string() : pieces.error();
  };
  EXPECT_THAT(fault(""), HasSubstr("no length"));
  EXPECT_THAT(fault("L 3 4"), HasSubstr("no M"));
  EXPECT_THAT(fault("M 1 2 L 3"), HasSubstr("no number"));
  EXPECT_THAT(fault("M 1 2 X 3 4"), HasSubstr("no number before \"X"));
  EXPECT_THAT(fault("M 0 0 L 1 0 M 5 5 L 6 6"), HasSubstr("second sub-path"));
  EXPECT_THAT(fault("M 0 0 L nan 1"), HasSubstr("no number"));
}

TEST(StraightBars, RowsOfManyPointsJoinAndOthersStay) {
  const std::vector<FileBar> bars{{"O", "A", 6}, {"A", "B", 3}, {"O", "B", 9},
                                  {"B", "C", 1}, {"A", "C", 4}, {"C", "X", 2}};
  const StraightBars joined = join_straight_bars(bars, {});
  ASSERT_EQ(joined.links.size(), 1u);
  EXPECT_EQ(joined.links[0].name, "O-A-B-C");
  EXPECT_EQ(joined.links[0].joints.back(), (NamedPoint{"C", Point(10, 0)}));
  ASSERT_EQ(joined.remaining.size(), 1u);
  EXPECT_EQ(joined.remaining[0].b, "X");
  EXPECT_THAT(joined.notes[0], HasSubstr("along = [0, 6, 9, 10]"));
  EXPECT_TRUE(join_straight_bars({{"A", "B", 3}, {"B", "C", 4}, {"A", "C", 5}}, {}).links.empty());
}

TEST(StraightBars, DistancesAloneWouldMisjudgeTheMobility) {
  // The same row left as distances: what two well-known sketch solvers see.
  const LinkageFile file = parsed("[ground]\nA = [0, 0]\n[bars]\nA-B = 2\nB-C = 1\nA-C = 3.0000001\n");
  const LinkageModel almost = linkage_model(file);  // not straight enough to be joined
  EXPECT_EQ(file.links.size(), 0u);
  EXPECT_EQ(almost.linkage.particle_count(), 2);
}

}  // namespace
}  // namespace kempe
