// STEP files read again by OpenCASCADE: solids, volumes, holes.
#include "reports/drawings/step_assembly.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gp_Cylinder.hxx>
#include <random>

#include "reports/drawings/bom.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/part_drawings.hpp"
#include "reports/drawings/part_files.hpp"
#include "reports/drawings/step_writer.hpp"
#include "tests/random.hpp"
#include "tests/reports/sample_designs.hpp"

namespace kempe {
namespace {

using testing::plagiograph;
using testing::sample_design;

/// A solid as the reader finds it.
struct FoundSolid {
  double volume = 0;
  std::vector<Point> axes;  ///< of its whole cylinders of the wanted radius
};

TopoDS_Shape read_step(const std::string& text) {
  const auto path = std::filesystem::path(KEMPE_BINARY_DIR) / "test-output" / "assembly.step";
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  STEPControl_Reader reader;
  EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
  reader.TransferRoots();
  return reader.OneShape();
}

/// Axes of the cylinders of this radius, each once however many faces it has.
std::vector<Point> cylinder_axes(const TopoDS_Shape& shape, double radius) {
  std::vector<Point> axes;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(face.Current()));
    if (surface.GetType() != GeomAbs_Cylinder || std::abs(surface.Cylinder().Radius() - radius) > 1e-7)
      continue;
    const gp_Pnt at = surface.Cylinder().Axis().Location();
    const Point axis(at.X(), at.Y());
    if (std::none_of(axes.begin(), axes.end(),
                     [&](const Point& known) { return (known - axis).norm() < 1e-6; }))
      axes.push_back(axis);
  }
  return axes;
}

std::vector<FoundSolid> solids_of(const TopoDS_Shape& shape, double hole_radius) {
  std::vector<FoundSolid> found;
  for (TopExp_Explorer one(shape, TopAbs_SOLID); one.More(); one.Next()) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(one.Current(), properties, 1e-9);
    found.push_back({properties.Mass(), cylinder_axes(one.Current(), hole_radius)});
  }
  return found;
}

std::vector<Design> assembled_designs() {
  std::vector<Design> list{plagiograph()};
  list.push_back(sample_design(2.5, Grounding::tracer, 90, 70, 1, PlateStyle::bent, {20, -10}));
  list.push_back(
      sample_design(std::polar(1.0, radians(60)), Grounding::pen, 90, 70, 1, PlateStyle::triangle, {0, 5}));
  return list;
}

TEST(StepAssembly, ReadAgainHasTheLinksVolumesAndHoles) {
  CuttingSpec cutting;
  cutting.hole_fit = 0.1;  // so that a hole is no pin
  cutting.kerf = 0.3;      // which finished links do not have
  for (const Design& design : assembled_designs()) {
    const auto text = step_assembly(design, cutting);
    ASSERT_TRUE(text) << text.error();
    const Pose pose = assembly_pose(design);
    const auto parts = cut_parts(design, finished(cutting));
    const auto solids = solids_of(read_step(*text), 0.5 * parts[0].holes[0].diameter);
    ASSERT_EQ(solids.size(), 10U) << "four links, three pins, three posts";
    for (const CutPart& part : parts) {
      const double volume = area(part) * part.thickness;
      const auto same = std::find_if(solids.begin(), solids.end(), [&](const FoundSolid& solid) {
        return solid.axes.size() == part.holes.size() &&
               std::all_of(part.holes.begin(), part.holes.end(), [&](const CutPart::Hole& hole) {
                 return std::any_of(solid.axes.begin(), solid.axes.end(), [&](const Point& axis) {
                   return (axis - pose[hole.joint]).norm() < 1e-6;
                 });
               });
      });
      ASSERT_NE(same, solids.end()) << part.name << " has no solid with its holes on its joints";
      EXPECT_NEAR(same->volume, volume, 1e-6 * volume) << part.name;
    }
  }
}

/// Heads under layer 1 raise the linkage: links and pins stand higher, posts are as long as the bill says.
TEST(StepAssembly, StandsAsHighAsItsHeadsAskFor) {
  Design design = plagiograph();
  design.style = {.width = 20, .pin_diameter = 8, .thickness = 5};
  design.hardware = "M6 shoulder bolt";  // heads of 5.5 mm
  const auto text = step_assembly(design, {});
  ASSERT_TRUE(text) << text.error();
  const TopoDS_Shape shape = read_step(*text);
  std::vector<std::pair<double, double>> heights;
  for (TopExp_Explorer one(shape, TopAbs_SOLID); one.More(); one.Next()) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (TopExp_Explorer corner(one.Current(), TopAbs_VERTEX); corner.More(); corner.Next()) {
      const double z = BRep_Tool::Pnt(TopoDS::Vertex(corner.Current())).Z();
      low = std::min(low, z);
      high = std::max(high, z);
    }
    heights.emplace_back(low, high);
  }
  std::vector<std::pair<double, double>> wanted;
  for (const Link link : all_links)
    wanted.emplace_back(5.5 + 5 * (design.layers[link] - 1), 5.5 + 5 * design.layers[link]);
  for (const BomItem& item : bill_of_materials(design)) {
    if (item.item == "pin") wanted.emplace_back(5.5, 5.5 + item.length);  // each from layer 1
    if (item.item == "post") wanted.emplace_back(0, item.length);
  }
  const auto rounded = [](std::vector<std::pair<double, double>>& all) {
    for (auto& [low, high] : all) {
      low = std::round(low * 1e6);
      high = std::round(high * 1e6);
    }
    std::sort(all.begin(), all.end());
  };
  rounded(heights);
  rounded(wanted);
  EXPECT_EQ(heights, wanted);
}

TEST(StepAssembly, NamesEveryPart) {
  const auto text = step_assembly(plagiograph(), {});
  ASSERT_TRUE(text) << text.error();
  for (const char* name : {"copying linkage", "VA", "VB", "ACX", "BCY", "pole post V", "pin A", "pin B",
                           "pin C", "tracer X", "pen Y"})
    EXPECT_THAT(*text, ::testing::HasSubstr("PRODUCT('" + std::string(name) + "'")) << name;
}

TEST(StepAssembly, SameDesignSameBytes) {
  const auto one = step_assembly(plagiograph(), {}), other = step_assembly(plagiograph(), {});
  ASSERT_TRUE(one && other);
  EXPECT_EQ(*one, *other);
}

TEST(StepAssembly, StandsAmongTheParts) {
  const auto files = part_files(plagiograph(), {}).files;
  EXPECT_TRUE(std::any_of(files.begin(), files.end(),
                          [](const OutputFile& file) { return file.name == "parts/assembly.step"; }));
}

TEST(StepAssembly, OfPartsThatAreNoSolidsIsRefused) {
  Design design = plagiograph();
  design.style.thickness = 0;
  const auto text = step_assembly(design, {});
  ASSERT_FALSE(text);
  EXPECT_THAT(text.error(),
              ::testing::HasSubstr("no parts/assembly.step: VA would reach from 0 to 0 mm above the table"));
}

/// What a person draws between walls that bulge out and in, round holes, and cylinders.
TEST(StepWriter, SolidsAreWholeAndAsLargeAsTheirOutlines) {
  std::mt19937_64 random(7);
  const auto between = [&](double low, double high) { return test::uniform(random, low, high); };
  for (int round = 0; round < 60; ++round) {
    const int corners = 2 + round % 9;
    const double size = std::pow(10, between(-1, 4)), turn = between(-pi, pi);
    const Point at(size * between(-5, 5), size * between(-5, 5));
    StepPlate plate{"plate", {}, {}, size * between(-1, 1), 0};
    plate.top = plate.bottom + size * between(0.01, 1);
    for (int i = 0; i < corners; ++i) {
      const double bulge = corners == 2 ? between(0.3, 1) : i % 3 == 0 ? 0 : between(-0.2, 0.4);
      plate.outline.push_back({at + size * as_point(std::polar(1.0, turn + 2 * pi * i / corners)), bulge});
    }
    if (corners > 2) plate.holes.push_back({at, size * between(0.01, 0.2)});
    double wanted = signed_area(plate.outline);
    for (const auto& hole : plate.holes) wanted -= 0.25 * pi * hole.diameter * hole.diameter;
    const StepCylinder pin{"pin", {at.x() + 9 * size, at.y()}, size, plate.bottom, plate.top};
    const auto text = step_text({"both", {plate}, {pin}});
    ASSERT_TRUE(text) << text.error();
    const TopoDS_Shape shape = read_step(*text);
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid()) << *text;
    const auto solids = solids_of(shape, 0.5 * size);
    ASSERT_EQ(solids.size(), 2U);
    const double height = plate.top - plate.bottom;
    EXPECT_NEAR(solids[0].volume, wanted * height, 1e-6 * wanted * height) << corners;
    EXPECT_NEAR(solids[1].volume, 0.25 * pi * size * size * height, 1e-6 * size * size * height);
    ASSERT_EQ(solids[1].axes.size(), 1U);
    EXPECT_LT((solids[1].axes[0] - pin.centre).norm(), 1e-9);
  }
}

TEST(StepWriter, NamesAreStringsOfTheFormat) {
  const auto text = step_text({"it's", {}, {{"a\\b\xC3\xB6", {0, 0}, 1, 0, 1}}});
  ASSERT_TRUE(text) << text.error();
  EXPECT_THAT(*text, ::testing::HasSubstr("PRODUCT('it''s','it''s'"));
  EXPECT_THAT(*text, ::testing::HasSubstr("PRODUCT('a\\\\b__'"));
}

}  // namespace
}  // namespace kempe
