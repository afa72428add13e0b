#include "reports/drawings/design_drawing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "reports/data/atomic_file.hpp"
#include "reports/drawings/dxf_writer.hpp"
#include "reports/drawings/part_drawings.hpp"
#include "reports/drawings/svg_writer.hpp"
#include "tests/random.hpp"
#include "tests/reports/sample_designs.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;
using testing::plagiograph;
using testing::sample_design;

std::filesystem::path output_folder() {
  const auto folder = std::filesystem::path(KEMPE_BINARY_DIR) / "test-output" / "drawings";
  std::filesystem::create_directories(folder);
  return folder;
}

Json expectation(const std::filesystem::path& dxf, const Design& design, const CuttingSpec& cutting) {
  const LinkLengths l = design.linkage.lengths();
  const std::string style = design.style.plate == PlateStyle::bent ? "bent" : "triangle";
  return {{"dxf", dxf.string()},
          {"width", design.style.width},
          {"kerf", cutting.kerf},
          {"hole", design.style.pin_diameter + cutting.hole_fit - cutting.kerf},
          {"links",
           {{{"name", "VA"}, {"style", "bar"}, {"joints", "VA"}, {"lengths", {l.VA}}},
            {{"name", "VB"}, {"style", "bar"}, {"joints", "VB"}, {"lengths", {l.VB}}},
            {{"name", "ACX"}, {"style", style}, {"joints", "ACX"}, {"lengths", {l.AC, l.AX, l.CX}}},
            {{"name", "BCY"}, {"style", style}, {"joints", "BCY"}, {"lengths", {l.BC, l.BY, l.CY}}}}}};
}

TEST(DesignDrawing, IsJudgedFaultlessByEzdxf) {
  std::vector<std::pair<Design, CuttingSpec>> cases{
      {plagiograph(), {}}, {plagiograph(), {.hole_fit = 0.1, .kerf = 0.2, .stock_sheet = {}}}};
  for (const PlateStyle plate : {PlateStyle::bent, PlateStyle::triangle})
    for (const Grounding grounding : all_groundings)
      for (const Complex k : {Complex(2.5), Complex(-1.0 / 3), std::polar(1.0, radians(60)), Complex(0, -1),
                              Complex(1.001), Complex(1000)})
        cases.push_back({sample_design(k, grounding, 90, 70, 1, plate, {20, -10}), {}});
  Json expectations = Json::array();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto& [design, cutting] = cases[i];
    const auto path = output_folder() / fmt::format("drawing {}.dxf", i);
    ASSERT_TRUE(write_whole(path, dxf_text(design_drawing(design, cutting))));
    expectations.push_back(expectation(path, design, cutting));
  }
  ASSERT_GT(expectations.size(), 20U);
  const auto list = output_folder() / "expectations.json";
  ASSERT_TRUE(write_whole(list, expectations.dump()));
  const std::string command =
      fmt::format("/usr/bin/python3 '{}/tests/reports/dxf_oracle.py' '{}'", KEMPE_SOURCE_DIR, list.string());
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(DesignDrawing, StatesRatioRotationUnitsLayersAndLengths) {
  const std::string dxf = dxf_text(design_drawing(plagiograph()));
  for (const char* words : {"scale 1.4, rotation 90 deg", "Angle from bar VA to bar VB", "Units mm",
                            "1 = VA BCY, 2 = VB ACX", "CY = 86.0233"})
    EXPECT_NE(dxf.find(words), std::string::npos) << words;
  Design lifted = plagiograph();
  lifted.layers.of = {2, 4, 4, 2};
  EXPECT_NE(dxf_text(design_drawing(lifted)).find("1 = empty, 2 = VA BCY, 3 = empty, 4 = VB ACX"),
            std::string::npos);
}

TEST(DesignDrawing, LeavesOutCornersOfTheRegionThatNoEyeTellsApart) {
  Design design = plagiograph();
  const Point centre(70, 0);
  Ring ring;
  for (int i = 0; i < 200'000; ++i) ring.push_back(centre + as_point(std::polar(5.0, 2 * pi * i / 200'000)));
  design.region = Region{{{ring, {}}}};
  for (const Shape& shape : design_drawing(design).shapes) {
    const auto* outline = std::get_if<OutlineShape>(&shape);
    if (outline == nullptr || outline->layer != "REGION" || outline->ring.size() == 4)
      continue;  // 4: a frame
    EXPECT_LT(outline->ring.size(), 25'000U);
    ASSERT_GT(outline->ring.size(), 3'000U);
    const Box box = bounding_box(outline->ring);
    for (std::size_t i = 1; i < outline->ring.size(); ++i) {
      EXPECT_NEAR((outline->ring[i].at - 0.5 * (box.lower + box.upper)).norm(), 5, 1e-5);
      EXPECT_LT((outline->ring[i].at - outline->ring[i - 1].at).norm(), 0.002);
    }
  }
}

TEST(DesignDrawing, IsTheSameInSvg) {
  const std::string svg = svg_text(design_drawing(plagiograph()), "a <b> & \"c\"");
  EXPECT_NE(svg.find("<title>a &lt;b&gt; &amp; &quot;c&quot;</title>"), std::string::npos);
  for (const char* id : {"id=\"VA\"", "id=\"VB\"", "id=\"ACX\"", "id=\"BCY\"", "id=\"LABELS\"",
                         "id=\"ASSEMBLY\"", "id=\"TITLE\""})
    EXPECT_NE(svg.find(id), std::string::npos) << id;
  EXPECT_NE(svg.find("mm\" viewBox="), std::string::npos);
}

TEST(PartDrawings, KeepThePlatesTurnedTheRightWayRound) {
  for (const Grounding grounding : all_groundings)
    for (const double turn : {90.0, -120.0, 17.0})
      for (const int assembly_mode : {0, 1, 2, 3}) {
        const Design design = sample_design(std::polar(1.3, radians(turn)), grounding, 90, 70, assembly_mode);
        const auto expected = design.linkage.assembly_mode().sides;
        const auto side_turned = [&](Link link) {
          const auto holes = cut_part(design, link, {}).holes;
          const double turned = cross(holes[1].centre - holes[0].centre, holes[2].centre - holes[1].centre);
          return side_of(turned);
        };
        EXPECT_EQ(side_turned(Link::ACX), expected.plate_ACX);
        EXPECT_EQ(side_turned(Link::BCY), expected.plate_BCY);
      }
}

TEST(PartDrawings, EngraveInsideTheOutlineAndBesideTheHoles) {
  for (const Complex k : {Complex(0, 1.4), Complex(2.5), Complex(-1.0 / 3), std::polar(1.0, radians(60))})
    for (const PlateStyle plate : {PlateStyle::bent, PlateStyle::triangle}) {
      const Design design = sample_design(k, Grounding::tracer, 90, 70, 1, plate);
      for (const Link link : all_links) {
        const CutPart part = cut_part(design, link, {});
        ASSERT_FALSE(part.labels.empty());
        const Box box = bounding_box(part.outline);
        for (const TextShape& label : part.labels) {
          const Box text = bounding_box(Drawing{{}, {label}});
          EXPECT_TRUE((text.lower.array() > box.lower.array()).all() &&
                      (text.upper.array() < box.upper.array()).all());
          const Point middle = 0.5 * (text.lower + text.upper);
          for (const CutPart::Hole& hole : part.holes)
            EXPECT_GT((middle - hole.centre).norm(), 0.5 * hole.diameter);
        }
      }
    }
}

/// Wide and narrow links, thin and thick pins, all rotations: neither name nor letter lies on a hole or on another.
TEST(PartDrawings, EngraveOnNoHoleAndOnNoOtherWords) {
  std::size_t letters = 0, joints = 0;
  for (int turn = -180; turn <= 180; turn += 4)
    for (const PlateStyle plate : {PlateStyle::bent, PlateStyle::triangle})
      for (const double pin : {1.0, 3.0, 8.0}) {
        Design design = sample_design(std::polar(0.8, radians(turn)), Grounding::pole, 90, 57, 0, plate);
        design.style.width = 20;
        design.style.pin_diameter = pin;
        for (const Link link : all_links) {
          const CutPart part = cut_part(design, link, {});
          ASSERT_FALSE(part.labels.empty()) << turn;
          EXPECT_EQ(part.labels[0].text, part.name);
          letters += part.labels.size() - 1;
          joints += part.holes.size();
          // places all over each text
          std::vector<std::vector<Point>> covered;
          for (const TextShape& label : part.labels) {
            const Point along = as_point(std::polar(text_width(label), label.turn)),
                        up = as_point(std::polar(label.height, label.turn + pi / 2));
            covered.emplace_back();
            for (int i = 0; i <= 30; ++i)
              for (int j = 0; j <= 10; ++j)
                covered.back().push_back(label.at + (i / 30.0 - 0.5) * along + j / 10.0 * up);
            for (const Point& place : covered.back())
              for (const CutPart::Hole& hole : part.holes)
                ASSERT_GT((place - hole.centre).norm(), 0.5 * hole.diameter)
                    << turn << ' ' << label.text << " on hole " << letter(hole.joint);
          }
          for (std::size_t i = 0; i < covered.size(); ++i)
            for (const Point& place : covered[i])
              for (std::size_t j = 0; j < covered.size(); ++j) {
                if (i == j) continue;
                const TextShape& other = part.labels[j];
                const Complex there = as_complex(place - other.at) * std::polar(1.0, -other.turn);
                ASSERT_FALSE(std::abs(there.real()) < 0.5 * text_width(other) && there.imag() > 0 &&
                             there.imag() < other.height)
                    << turn << ' ' << part.labels[i].text << " on " << other.text;
              }
        }
      }
  EXPECT_GT(100 * letters, 95 * joints);
}

TEST(DxfWriter, CutsNoCharacterOfALongText) {
  std::string name;
  for (int i = 0; i < 200; ++i) name += "\u0416";
  for (const char* before : {"", "a", "ab", "abc", "abcd"}) {
    const std::string dxf = dxf_text(Drawing{{{"L"}}, {TextShape{"L", before + name, {0, 0}}}});
    const auto from = dxf.find(std::string("\n  1\n") + before + "\\U+0416") + 5;
    const std::string text = dxf.substr(from, dxf.find('\n', from) - from);
    EXPECT_LE(text.size(), 250U);
    EXPECT_EQ((text.size() - std::string(before).size()) % 7, 0U) << text;
  }
}

TEST(DxfWriter, EscapesTexts) {
  const Drawing drawing{{{"L"}}, {TextShape{"L", "60\u00b0 \U0001F600\n0\nEOF %%d \xff", {0, 0}}}};
  const std::string dxf = dxf_text(drawing);
  EXPECT_NE(dxf.find("60\\U+00B0 ? 0 EOF % %d \\U+FFFD\n"), std::string::npos) << dxf;
}

TEST(Drawing, BoxesOfArcsAreTight) {
  std::mt19937_64 random(3);
  const auto uniform = [&](double a, double b) { return test::uniform(random, a, b); };
  for (int i = 0; i < 500; ++i) {
    const Point centre(uniform(-5, 5), uniform(-5, 5));
    const double radius = uniform(0.1, 5), start = uniform(-pi, pi), sweep = uniform(-6.2, 6.2);
    const auto at = [&](double angle) { return Point(centre + as_point(std::polar(radius, angle))); };
    const Box box = bounding_box(ArcRing{{at(start), std::tan(sweep / 4)}, {at(start + sweep), 0}});
    Point lower = at(start), upper = at(start);
    for (int j = 0; j <= 4000; ++j) {
      const Point p = at(start + sweep * j / 4000);
      lower = lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
    EXPECT_LT((box.lower - lower).norm() + (box.upper - upper).norm(), 1e-4 * radius);
  }
}

}  // namespace
}  // namespace kempe
