#include "reports/drawings/part_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <tuple>

#include "kempe/point.hpp"
#include "reports/audit/recheck.hpp"
#include "reports/data/design_json.hpp"
#include "reports/design_package.hpp"
#include "reports/drawings/bom.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/dxf_writer.hpp"
#include "reports/drawings/nesting.hpp"
#include "reports/drawings/part_drawings.hpp"
#include "reports/drawings/part_solid.hpp"
#include "tests/reports/sample_designs.hpp"

namespace kempe {
namespace {

constexpr double inch = 25.4;  // mm

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::plagiograph;
using testing::sample_design;

std::vector<Design> designs() {
  std::vector<Design> list{plagiograph()};
  for (const PlateStyle plate : {PlateStyle::bent, PlateStyle::triangle})
    for (const Grounding grounding : all_groundings)
      for (const Complex k :
           {Complex(2.5), Complex(-1.0 / 3), std::polar(1.0, radians(60)), Complex(0.9, 0.1)})
        list.push_back(sample_design(k, grounding, 90, 70, 1, plate, {20, -10}));
  return list;
}

std::vector<CutPart> parts(const Design& design) {
  const auto all = cut_parts(design, {});
  return {all.begin(), all.end()};
}

/// Points along the outline, dense enough for distances to a twentieth of a millimetre.
Ring dense(const ArcRing& ring, const Placement& placement) {
  const Ring corners = flattened(ArcPolygon{placed(ring, placement), {}}, 0.001, Flatten::grows).outer;
  Ring result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point way = corners[(i + 1) % corners.size()] - corners[i];
    const int steps = 1 + static_cast<int>(way.norm() / 0.7);
    for (int j = 0; j < steps; ++j) result.push_back(corners[i] + way * j / steps);
  }
  return result;
}

std::vector<OutputFile> with_drawing(std::vector<OutputFile> files, const Design& design,
                                     const CuttingSpec& cutting) {
  files.push_back({"design.json", design_json(design)});
  files.push_back({"drawing.dxf", dxf_text(design_drawing(design, cutting))});
  return files;
}

struct Package {
  std::vector<std::string> names, left_out;
};
Package package_of(const Design& design, const TimeToFinish& time) {
  Package package;
  package.left_out = *make_design_package(
      design, {}, {},
      [&](const OutputFile& file) -> tl::expected<void, std::string> {
        package.names.push_back(file.name.string());
        return {};
      },
      time);
  return package;
}

TEST(DesignPackage, IsTheDesignAndItsTablesOnceTheTimeIsOver) {
  const StopFlag set([] { return true; });
  const Package whole = package_of(plagiograph(), {}), late = package_of(plagiograph(), {set, set}),
                hurried = package_of(plagiograph(), {.enough = set});
  EXPECT_THAT(late.names, ::testing::ElementsAre("design.json", "links.csv", "bom.csv"));
  for (const std::string& name : whole.names)
    if (std::find(late.names.begin(), late.names.end(), name) == late.names.end()) {
      EXPECT_THAT(late.left_out, ::testing::Contains(HasSubstr(name)));
      EXPECT_EQ(std::find(hurried.names.begin(), hurried.names.end(), name) == hurried.names.end(),
                name == "parts/assembly.step");
    }
}

TEST(Nesting, KeepsPartsApartAndOnTheSheet) {
  const Point sheet(300, 250);
  const double gap = 4;
  for (const Design& design : designs()) {
    const auto all = parts(design);
    const auto nested = nest(all, sheet, gap);
    if (!nested) continue;
    std::vector<Ring> outlines;
    for (std::size_t i = 0; i < all.size(); ++i)
      outlines.push_back(dense(all[i].outline, (*nested)[i].placement));
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const Point& p : outlines[i]) {
        ASSERT_GE(p.minCoeff(), gap - 0.01);
        ASSERT_GE((sheet - p).minCoeff(), gap - 0.01);
      }
      for (std::size_t j = 0; j < i; ++j) {
        if ((*nested)[i].sheet != (*nested)[j].sheet) continue;
        double nearest = HUGE_VAL;
        for (const Point& p : outlines[i])
          for (const Point& q : outlines[j]) nearest = std::min(nearest, (p - q).squaredNorm());
        EXPECT_GE(std::sqrt(nearest), gap - 0.1);
        EXPECT_FALSE(contains(Region{{Polygon{outlines[i], {}}}}, outlines[j][0]));
        EXPECT_FALSE(contains(Region{{Polygon{outlines[j], {}}}}, outlines[i][0]));
      }
    }
  }
}

TEST(Nesting, UsesMoreSheetsWhenOneIsFull) {
  const auto nested = nest(parts(sample_design(2.5, Grounding::tracer, 90, 70, 1)), {250, 30}, 2);
  ASSERT_TRUE(nested) << nested.error();
  std::size_t last = 0;
  for (const NestedPart& part : *nested) last = std::max(last, part.sheet);
  EXPECT_GE(last, 1U);
}

TEST(Nesting, TurnsAPartThatFitsOnlyAslant) {
  Design design = sample_design(2.5, Grounding::tracer, 130, 30, 1);
  const auto one = std::vector<CutPart>{cut_part(design, Link::VA, {})};
  EXPECT_TRUE(nest(one, {118, 118}, 0));
}

TEST(Nesting, NamesThePartThatDoesNotFit) {
  const Design design = sample_design(2.5, Grounding::tracer, 90, 70, 1);
  CuttingSpec cutting;
  cutting.stock_sheet = Point(100, 30);
  const PartFiles parts = part_files(design, cutting);
  ASSERT_EQ(parts.left_out.size(), 1U);
  EXPECT_THAT(parts.left_out[0], HasSubstr("no nested.dxf: link "));
  EXPECT_THAT(parts.left_out[0], HasSubstr("does not fit on a sheet of 100 x 30 mm"));
  for (const OutputFile& file : parts.files) EXPECT_NE(file.name, "nested.dxf");
}

TEST(PartSolid, IsClosedAndHasThePartsVolume) {
  for (const Design& design : designs())
    for (const CutPart& part : parts(design)) {
      const Solid solid = part_solid(part, 0.001);
      EXPECT_TRUE(is_closed(solid));
      EXPECT_NEAR(volume(solid) / (area(part) * part.thickness), 1, 1e-3);
      const auto read = read_stl(stl_bytes(solid, part.name));
      ASSERT_TRUE(read);
      EXPECT_TRUE(is_closed(*read));
      EXPECT_NEAR(volume(*read), volume(solid), 1e-6 * volume(solid));  // STL stores 32-bit floats
    }
}

/// A pin that is nearly as wide as its link, up to as wide, with fits that make the hole wider still: parts whole, or none
/// and a sentence.
TEST(PartFiles, AreWholeOrLeftOutHoweverThinTheWall) {
  for (const PlateStyle plate : {PlateStyle::bent, PlateStyle::triangle})
    for (const double share : {0.9, 0.95, 0.99, 0.995, 0.997, 0.9981, 0.9999, 1 - 1e-9, 1.0})
      for (const double fit : {-0.1, 0.0, 0.02, 0.5})
        for (const double kerf : {0.0, 0.2}) {
          Design design = sample_design(std::polar(1.0, radians(60)), Grounding::tracer, 90, 70, 1, plate);
          design.style.pin_diameter = share * design.style.width;
          CuttingSpec cutting;
          cutting.hole_fit = fit;
          cutting.kerf = kerf;
          cutting.stock_sheet = Point(600, 400);
          const PartFiles made = part_files(design, cutting);
          const double hole = design.style.pin_diameter + fit;
          const bool has_wall = 0.5 * (design.style.width - hole) > 0.001 * hole;
          EXPECT_EQ(made.files.size() > 1, has_wall) << share << " " << fit;
          EXPECT_EQ(made.left_out.empty(), has_wall);
          if (!has_wall) {
            EXPECT_THAT(made.left_out[0], HasSubstr("leave no wall in links 12 mm wide"));
          }
          EXPECT_THAT(recheck(with_drawing(made.files, design, cutting), design, cutting), IsEmpty());
        }
}

TEST(PartFiles, AreLeftOutWhereHolesRunIntoEachOther) {
  Design design = sample_design(Complex(2.5), Grounding::pole, 90, 12, 0);
  for (const double pin : {3.0, 7.1, 7.3, 11.0}) {  // AX = 12 / 2.5 = 4.8, CX = 7.2
    design.style.pin_diameter = pin;
    const PartFiles made = part_files(design, {});
    EXPECT_EQ(made.files.size() == 1, pin > 4.8) << pin;
    EXPECT_EQ(made.files.back().name, "bom.csv");
    if (pin > 4.8) {
      EXPECT_THAT(made.left_out[0], HasSubstr("link ACX has its holes"));
    }
  }
}

TEST(PartFiles, AreLeftOutWhereNothingIsLeftOfAHole) {
  Design design = plagiograph();
  const std::tuple<double, double, const char*> cases[] = {
      {0.0, 6.0, "kerf_mm"}, {0.0, 10.0, "kerf_mm"}, {-1.0, 5.0, "kerf_mm"}};
  for (const auto& [fit, kerf, words] : cases) {
    CuttingSpec cutting;
    cutting.hole_fit = fit;
    cutting.kerf = kerf;
    const PartFiles made = part_files(design, cutting);
    ASSERT_EQ(made.left_out.size(), 1U);
    EXPECT_THAT(made.left_out[0], HasSubstr(words));
    EXPECT_THAT(recheck(with_drawing(made.files, design, cutting), design, cutting), IsEmpty());
  }
  design.style.pin_diameter = 0.5;
  CuttingSpec cutting;
  cutting.hole_fit = -1;
  EXPECT_THAT(part_files(design, cutting).left_out.at(0), HasSubstr("hole_fit_mm"));
}

TEST(PartFiles, LeaveOutASolidThatFloatsCannotHold) {
  Design design = sample_design(Complex(2.5), Grounding::pole, 9e5, 7e5, 0);
  EXPECT_TRUE(part_files(design, {}).left_out.empty());
  design.style.pin_diameter = 11.9;  // a wall of 0.05 mm, and floats of this size are 0.06 to 0.12 mm apart
  const PartFiles made = part_files(design, {});
  EXPECT_EQ(made.left_out.size(), 4U);
  EXPECT_THAT(made.left_out[0], HasSubstr("no parts/VA.stl"));
  EXPECT_THAT(recheck(with_drawing(made.files, design, {}), design, {}), IsEmpty());
}

/// Printers and mills allow for their own tools: a solid is finished, what is cut to lines is not.
TEST(PartFiles, HaveTheKerfInDrawingsAlone) {
  const CuttingSpec fitted{.hole_fit = 0.1, .kerf = 0, .stock_sheet = {}},
      cut{.hole_fit = 0.1, .kerf = 0.3, .stock_sheet = {}};
  const auto one = part_files(plagiograph(), fitted).files, other = part_files(plagiograph(), cut).files;
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    const std::string ends = one[i].name.extension();
    const bool has_kerf = ends == ".dxf" || ends == ".svg";
    EXPECT_EQ(one[i].contents != other[i].contents, has_kerf) << one[i].name;
  }
  EXPECT_THAT(recheck(with_drawing(other, plagiograph(), cut), plagiograph(), cut), IsEmpty());
}

/// A micro instrument's holes are as round as others', in files of no more triangles.
TEST(PartSolid, IsRoundAtEverySize) {
  const double ordinary = static_cast<double>(part_solid(parts(plagiograph())[2]).size());
  for (const double size : {1e-3, 1e-2, 1.0, 10.0}) {
    Design design =
        testing::sample_design(copy_ratio(1.4, radians(90)), Grounding::pole, 50 * size, 35 * size, 3);
    design.style = {.width = 12 * size, .pin_diameter = 6 * size, .thickness = 4 * size};
    for (const CutPart& part : parts(design)) {
      const Solid solid = part_solid(part);
      EXPECT_LT(static_cast<double>(solid.size()), 4 * ordinary);
      EXPECT_NEAR(volume(solid) / (area(part) * part.thickness), 1, 5e-3);
      for (const CutPart::Hole& hole : part.holes)
        for (const Triangle& triangle : solid)
          for (std::size_t i = 0; i < 3;
               ++i) {  // no edge runs through the hole nearer than its flats may lie
            const Point a = triangle[i].head<2>() - hole.centre,
                        b = triangle[(i + 1) % 3].head<2>() - hole.centre;
            const double share =
                (b - a).squaredNorm() > 0 ? std::clamp(-a.dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) : 0;
            EXPECT_GT((a + share * (b - a)).norm(), 0.994 * 0.5 * hole.diameter);
          }
    }
  }
}

TEST(PartSolid, ReadsNoBrokenStl) {
  const std::string bytes = stl_bytes(part_solid(parts(plagiograph())[0]), "VA");
  EXPECT_FALSE(read_stl(bytes.substr(0, 40)));
  EXPECT_FALSE(read_stl(bytes.substr(0, bytes.size() - 1)));
  EXPECT_NE(bytes.substr(0, 5), "solid");
}

TEST(Bom, ListsPinsByTheLayersThatTheyJoin) {
  Design design = plagiograph();
  design.layers.of = {1, 4, 2, 3};
  const std::string csv = bom_csv(design);
  EXPECT_THAT(csv, HasSubstr("pin,pin A,1,6,8,,,,,\"joins VA and ACX; countersunk head"));
  EXPECT_THAT(csv, HasSubstr("pin,pin B,1,6,8,,,,,\"joins VB and BCY\""));
  EXPECT_THAT(csv, HasSubstr("post,pole post V,1,6,16,,,"));
  EXPECT_THAT(csv, HasSubstr("spacer,spacer V,1,6,8,12,,,,\"between the links\""));
  EXPECT_THAT(csv, HasSubstr("spacer,spacer Y,1,6,8,12,,,,\"under the lowest link\""));
  EXPECT_THAT(csv, HasSubstr("washer,washer,6,6"));
}

/// Heads of bought pins raise layer 1: a plain pin's head has as much room.
TEST(Bom, AsksForNoCountersunkHeadUnderARaisedLinkage) {
  Design design = plagiograph();
  design.style = {.width = 25, .pin_diameter = 8, .thickness = 5};
  design.hardware.at[static_cast<std::size_t>(Joint::A)] = "M6 bolt";  // a head of 6 mm and a washer of 1.6
  const std::string csv = bom_csv(design);
  EXPECT_THAT(csv, HasSubstr("layer 1 stands 7.6 mm above the table"));
  EXPECT_THAT(csv, Not(HasSubstr("countersunk")));
  EXPECT_THAT(csv, HasSubstr("\"joins VB and BCY; head at most 7.60 mm high, the room under layer 1\""));
}

TEST(Bom, QuotesNamesFromOutside) {
  Design design = plagiograph();
  design.bodies = {Body{.shape = Disc{Point::Zero(), 1}, .name = "a \"5 in\" hand,\nheld"}};
  EXPECT_THAT(bom_csv(design), HasSubstr("draws the copy, carries a \"\"5 in\"\" hand,\\nheld\"\n"));
}

TEST(Bom, HasLengthsToAThousandth) {
  Design design = testing::sample_design(1.6, Grounding::pole, 100 / 3.0, 70, 0);
  EXPECT_THAT(bom_csv(design), HasSubstr("link,VA,1,,45.333,12,4,45.333,12,"));
  design.style = {.width = 0.001 / 3, .pin_diameter = 0.0001, .thickness = 0.0001};
  EXPECT_THAT(bom_csv(design), HasSubstr(",0.000333333,0.0001,"));
}

TEST(Bom, SaysHowLongThePiecesOfAStripAre) {
  const auto remark = [](double size, double width) {
    Design design = testing::sample_design(2.5, Grounding::tracer, 9 * size, 7 * size, 1);
    design.style = {.width = width, .pin_diameter = width / 2, .thickness = 0.25 * inch};
    return bom_csv(design);
  };
  EXPECT_THAT(remark(10, 0.75 * inch), HasSubstr("strip,strip 19.05 x 6.35,1,"));
  EXPECT_THAT(remark(10, 0.75 * inch), HasSubstr("VB 89.05"));
  EXPECT_THAT(remark(1e-4, 1e-4), HasSubstr("VB 0.0008"));
}

TEST(PartFiles, OfAPoleFarFromTheOriginAreAsExact) {
  const Point far(9.9e6, 9.9e6);
  const Design design =
      testing::sample_design(copy_ratio(1.4, radians(90)), Grounding::pole, 50, 35, 3, PlateStyle::bent, far);
  const PartFiles made = part_files(design, {});
  EXPECT_THAT(recheck(with_drawing(made.files, design, {}), design, {}), IsEmpty());
}

TEST(Bom, LiftsALinkageOnSpacers) {
  Design design = plagiograph();
  design.layers.of = {2, 3, 3, 2};
  design.quality.clearance_min = 3;  // a spacer as wide as a link just fits
  const std::string csv = bom_csv(design);
  EXPECT_THAT(csv, HasSubstr("pin,pin A,1,6,8,,,,,\"joins VA and ACX\""));
  EXPECT_THAT(csv, HasSubstr("pin,pin B,1,6,8,,,,,\"joins VB and BCY\""));
  EXPECT_THAT(csv, HasSubstr("pin,pin C,1,6,8,,,,,\"joins ACX and BCY\""));
  EXPECT_THAT(csv, HasSubstr("post,pole post V,1,6,12,,,"));
  EXPECT_THAT(csv, HasSubstr("post,tracer X,1,6,12,,,"));
  EXPECT_THAT(csv, HasSubstr("post,pen Y,1,6,8,,,"));
  EXPECT_THAT(csv, HasSubstr("spacer,spacer V,1,6,4,12,,,,\"under the lowest link\""));
  EXPECT_THAT(csv, HasSubstr("spacer,spacer X,1,6,8,12,,,,\"under the lowest link\""));
  EXPECT_THAT(csv, HasSubstr("spacer,spacer Y,1,6,4,12,,,,\"under the lowest link\""));
  EXPECT_THAT(csv, Not(HasSubstr("countersunk head")));
}

class WrittenFolder {
 public:
  WrittenFolder(const Design& design, const CuttingSpec& cutting) {
    path = std::filesystem::path(KEMPE_BINARY_DIR) / "test-output" / ("parts-" + std::to_string(::getpid()));
    auto files = part_files(design, cutting).files;
    files.push_back({"design.json", design_json(design)});
    files.push_back({"drawing.dxf", dxf_text(design_drawing(design, cutting))});
    EXPECT_TRUE(write_whole(path, files));
  }
  ~WrittenFolder() { std::filesystem::remove_all(path); }
  /// Replaces the first `from` in a file.
  void edit(const std::string& name, const std::string& from, const std::string& to) const {
    std::ifstream in(path / name, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    std::ofstream(path / name, std::ios::binary) << text.replace(at, from.size(), to);
  }
  std::filesystem::path path;
};

TEST(Recheck, FindsNothingWrongWithWhatWasWritten) {
  for (const Design& design : designs()) {
    CuttingSpec cutting;
    cutting.hole_fit = 0.1;
    cutting.kerf = 0.2;
    cutting.stock_sheet = Point(600, 400);
    const WrittenFolder folder(design, cutting);
    EXPECT_TRUE(std::filesystem::exists(folder.path / "nested.dxf"));
    EXPECT_THAT(recheck(folder.path, design, cutting), IsEmpty());
  }
}

TEST(Recheck, SeesEveryDamage) {
  const Design design = plagiograph();
  const WrittenFolder folder(design, {});
  folder.edit("parts/VA.dxf", "50.0", "50.00001");
  folder.edit("parts/VB.dxf", " 30\n0.0\n 70\n1\n", " 30\n0.0\n 70\n0\n");
  folder.edit("parts/ACX.svg", "r=\"3\"", "r=\"4\"");
  folder.edit("design.json", "86.02", "86.03");
  folder.edit("drawing.dxf", "CIRCLE", "POINT");
  std::filesystem::resize_file(folder.path / "parts/BCY.stl", 500);
  const std::string all = ::testing::PrintToString(recheck(folder.path, design, {}));
  for (const char* words : {"parts/VA.dxf", "parts/VB.dxf", "parts/ACX.svg", "lengths_mm.CY",
                            "drawing.dxf: 1 outlines and 1 holes", "parts/BCY.stl"})
    EXPECT_THAT(all, HasSubstr(words));
}

}  // namespace
}  // namespace kempe
