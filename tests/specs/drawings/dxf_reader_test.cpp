#include "specs/drawings/dxf_reader.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace kempe {
namespace {

using ::testing::HasSubstr;

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The folder with drawings and what ezdxf makes of them.
const std::filesystem::path& oracle_folder() {
  static const std::filesystem::path folder = [] {
    const auto path =
        std::filesystem::path(KEMPE_BINARY_DIR) / "test-output" / ("dxf-" + std::to_string(::getpid()));
    std::filesystem::create_directories(path);
    const auto command = fmt::format("/usr/bin/python3 '{}/tests/specs/drawings/dxf_oracle.py' '{}'",
                                     KEMPE_SOURCE_DIR, path.string());
    EXPECT_EQ(std::system(command.c_str()), 0);
    return path;
  }();
  return folder;
}

double distance_to(const Stroke& line, bool closed, const Point& p) {
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    const Point from = line[i], way = line[(i + 1) % line.size()] - from;
    const double t =
        way.squaredNorm() > 0 ? std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
    nearest = std::min(nearest, (p - from - t * way).norm());
  }
  return nearest;
}

/// Largest distance of a point of one set of lines from the other set, pairing strokes in order.
void expect_same_lines(const std::string& name, double unit) {
  const auto drawing = read_dxf(contents(oracle_folder() / (name + ".dxf")), name);
  ASSERT_TRUE(drawing) << drawing.error().message();
  constexpr double tolerance = 1e-3;
  const auto strokes = dxf_strokes(*drawing, name, unit, tolerance);
  ASSERT_TRUE(strokes) << strokes.error().message();
  const auto expected = nlohmann::json::parse(contents(oracle_folder() / (name + ".json")));
  ASSERT_EQ(strokes->size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    Stroke theirs;
    for (const auto& p : expected[i]) theirs.push_back(unit * Point(p[0], p[1]));
    const DrawnStroke& ours = (*strokes)[i];
    double worst = 0;
    for (std::size_t j = 0; j < theirs.size(); j += 7)
      worst = std::max(worst, distance_to(ours.points, ours.closed, theirs[j]));
    for (std::size_t j = 0; j < ours.points.size(); j += 7)
      worst = std::max(worst, distance_to(theirs, false, ours.points[j]));
    EXPECT_LT(worst, tolerance + 2e-4 * unit) << name << " entity " << i;
  }
}

TEST(DxfReader, DrawsWhatEzdxfDraws) {
  expect_same_lines("r12", 1);
  expect_same_lines("r2000", 25.4);
  expect_same_lines("r2018", 10);
  expect_same_lines("blocks", 1);
}

TEST(DxfReader, TakesTheUnitFromTheFile) {
  EXPECT_EQ(read_dxf(contents(oracle_folder() / "r2000.dxf"), "d")->unit, 25.4);
  EXPECT_EQ(read_dxf(contents(oracle_folder() / "r2018.dxf"), "d")->unit, 10);
  EXPECT_EQ(read_dxf(contents(oracle_folder() / "r12.dxf"), "d")->unit, std::nullopt);
}

TEST(DxfReader, AsksForTheUnitsThatAFileDoesNotSay) {
  const std::string text = contents(oracle_folder() / "r12.dxf");
  const auto region = read_dxf_region(text, "d.dxf", {});
  ASSERT_FALSE(region);
  EXPECT_THAT(region.error().message(), HasSubstr("region.units"));
  const auto in_mm = read_dxf_region(text, "d.dxf", {.unit = 1.0}),
             in_inches = read_dxf_region(text, "d.dxf", {.unit = 25.4});
  ASSERT_TRUE(in_mm && in_inches);
  EXPECT_NEAR(area(*in_inches) / area(*in_mm), 25.4 * 25.4, 1);
}

TEST(DxfReader, KeepsEntitiesAsTheyStand) {
  const std::string text =
      "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n8\nVA\n66\n1\n70\n1\n0\nVERTEX\n8\nVA\n10\n1.25\n20\n2\n42\n0."
      "5\n0\nVERTEX\n8\n"
      "VA\n10\n3\n20\n4\n0\nSEQEND\n0\nCIRCLE\n8\nVB\n10\n5\n20\n6\n40\n7\n0\nENDSEC\n0\nEOF\n";
  const auto drawing = read_dxf(text, "d");
  ASSERT_TRUE(drawing);
  ASSERT_EQ(drawing->entities.size(), 2U);
  const auto& polyline = std::get<DxfPolyline>(drawing->entities[0]);
  EXPECT_TRUE(polyline.closed);
  EXPECT_EQ(polyline.layer, "VA");
  EXPECT_EQ(polyline.vertices.at(0).at, Point(1.25, 2));
  EXPECT_EQ(polyline.vertices.at(0).bulge, 0.5);
  EXPECT_EQ(std::get<DxfCircle>(drawing->entities[1]).radius, 7);
}

TEST(DxfReader, RefusesWhatIsNoDxf) {
  const auto message = [](const std::string& text) { return read_dxf(text, "d.dxf").error().message(); };
  EXPECT_THAT(message(""), HasSubstr("empty"));
  EXPECT_THAT(message("hello\nworld\n"), HasSubstr("not DXF"));
  EXPECT_THAT(message("AutoCAD Binary DXF\r\n\x1a"), HasSubstr("binary"));
  const std::string whole = contents(oracle_folder() / "r2000.dxf");
  EXPECT_THAT(message(whole.substr(0, whole.size() / 2)), HasSubstr("d.dxf"));
  EXPECT_THAT(message("0\nSECTION\n2\nENTITIES\nx\ny\n0\nEOF\n"), HasSubstr("d.dxf:5"));
  const std::string polyline = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n90\n2\n10\n0\n20\n0\n0042\n";
  EXPECT_THAT(message(polyline + "\n10\n1\n20\n1\n0\nENDSEC\n0\nEOF\n"), HasSubstr("d.dxf:14"));
  EXPECT_THAT(message(polyline + "nan\n10\n1\n20\n1\n0\nENDSEC\n0\nEOF\n"), HasSubstr("no number"));
}

TEST(DxfReader, DrawsBulgesOfEverySize) {
  // The farthest place of the arc from its chord is half the chord times the bulge.
  for (const double bulge : {1e-300, 1e-160, 1e-12, 1e-3, 0.5, 1.0, 20.0}) {
    DxfDrawing drawing;
    drawing.entities.emplace_back(DxfPolyline{"", {{{0, 0}, bulge}, {{10, 0}, 0}}, false});
    const auto strokes = dxf_strokes(drawing, "d", 1, 1e-6);
    ASSERT_TRUE(strokes) << bulge;
    double depth = 0;
    for (const Point& point : strokes->front().points) depth = std::max(depth, std::abs(point.y()));
    EXPECT_NEAR(depth, 5 * bulge, 1e-5 * std::max(1.0, bulge)) << bulge;
  }
  for (const double bulge : {1e9, 1e160, 1e300}) {
    DxfDrawing drawing;
    drawing.entities.emplace_back(DxfPolyline{"", {{{0, 0}, bulge}, {{10, 0}, 0}}, false});
    EXPECT_FALSE(dxf_strokes(drawing, "d", 1, 0.1)) << bulge;
  }
}

TEST(DxfReader, SurvivesFilesCutAndDamagedAnywhere) {
  const std::string whole = contents(oracle_folder() / "r2018.dxf");
  for (std::size_t cut = 0; cut < whole.size(); cut += 997) {
    static_cast<void>(read_dxf(whole.substr(0, cut), "d"));
    const auto ended = read_dxf(whole.substr(0, cut) + "\n0\nEOF\n", "d");
    if (ended) static_cast<void>(dxf_strokes(*ended, "d", 1, 0.1));
    std::string damaged = whole;
    damaged[cut] = static_cast<char>('0' + cut % 10);
    const auto read = read_dxf(damaged, "d");
    if (read) static_cast<void>(dxf_strokes(*read, "d", 1, 0.1));
  }
}

TEST(DxfReader, MakesNoRoomForMoreThanTheFileHolds) {
  for (const char* count : {"LWPOLYLINE\n90\n30000000", "LWPOLYLINE\n 090\n+30000000",
                            "SPLINE\n72\n500000000", "SPLINE\n73\n99999999999999999999", "SPLINE\n74\n70000",
                            "LEADER\n76\n2000000000", "HATCH\n91\n2000000000"}) {
    const auto drawing =
        read_dxf(std::string("0\nSECTION\n2\nENTITIES\n0\n") + count + "\n0\nENDSEC\n0\nEOF\n", "d.dxf");
    ASSERT_FALSE(drawing) << count;
    EXPECT_THAT(drawing.error().message(), HasSubstr("d.dxf:8: ")) << count;
    EXPECT_THAT(drawing.error().message(), HasSubstr("at most as many as the file holds")) << count;
  }
}

TEST(DxfReader, RefusesBlocksInACircleAndHugeArrays) {
  const auto with_insert = [](const std::string& more) {
    return "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nb\n10\n0\n20\n0\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n1\n0"
           "\nINSERT\n8\n0\n2\n" +
           more +
           "\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n8\n0\n2\nb\n10\n0\n20\n0\n0\nENDSEC\n"
           "0\nEOF\n";
  };
  for (const char* more : {"b\n10\n0\n20\n0", "c\n10\n0\n20\n0\n70\n30000\n71\n30000"}) {
    const auto drawing = read_dxf(with_insert(more), "d");
    ASSERT_TRUE(drawing);
    const auto strokes = dxf_strokes(*drawing, "d", 1, 0.1);
    EXPECT_EQ(strokes.has_value(), more[0] == 'c');  // no block c: nothing to put in
  }
}

}  // namespace
}  // namespace kempe
