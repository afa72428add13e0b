// A fault has the same words whether a file has it or a program: each row says it both ways.

#include "kempe/validate.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <locale>
#include <string>
#include <vector>

#include "specs/spec_reader.hpp"

namespace kempe {
namespace {

constexpr double without_end = std::numeric_limits<double>::infinity();
const std::string copy_table = "[copy]\nscale = 1.4\nrotation_deg = 90\n";
const std::string region_table = "[region]\npolygon_mm = [[62, -5], [70, -5], [70, 5], [62, 5]]\n";

Spec sound() {
  Spec spec;
  spec.copy = Copy::of(1.4, radians(90));
  spec.region = Region::rectangle({62, -5}, {8, 10});
  return spec;
}

struct Fault {
  std::string name, toml;  ///< with what is sound where `toml` has no such table
  std::function<void(Spec&)> fill;
};

std::string file_with(const std::string& fault) {
  std::string text = fault;
  if (fault.find("[copy]") == std::string::npos) text = copy_table + text;
  if (fault.find("[region]") == std::string::npos && fault.find("# no region") == std::string::npos)
    text = text + region_table;
  return text;
}

Region rings(std::vector<Ring> outers, std::vector<Ring> holes = {}) {
  Region region;
  for (Ring& ring : outers) region.polygons.push_back({std::move(ring), {}});
  region.polygons.front().holes = std::move(holes);
  return region;
}

MechanismSpec given(std::array<int, 4> layers) { return {Grounding::pole, 50, 35, 0, layers}; }

const std::vector<Fault> faults{
    {"CopyTranslation", "[copy]\nscale = 1\n", [](Spec& s) { s.copy = Copy(); }},
    {"CopyNegative", "[copy]\nscale = -2\n", [](Spec& s) { s.copy = Copy::of(-2, 0); }},
    {"CopyNan", "[copy]\nscale = nan\n", [](Spec& s) { s.copy = Copy::of(std::nan(""), 0); }},
    {"CopyInfinite", "[copy]\nscale = inf\n", [](Spec& s) { s.copy = Copy::of(without_end, 0); }},
    {"CopyZero", "[copy]\nscale = 0\n", [](Spec& s) { s.copy = Copy::of(0, 0); }},
    {"CopyHuge", "[copy]\nscale = 1e12\n", [](Spec& s) { s.copy = Copy::of(1e12, 0); }},
    {"RotationHuge", "[copy]\nscale = 2\nrotation_deg = 7200\n",
     [](Spec& s) { s.copy = Copy::of(2, radians(7200)); }},
    {"RegionMissing", "# no region\n", [](Spec& s) { s.region = {}; }},
    {"RegionCrossing", "[region]\npolygon_mm = [[0, 0], [2, 2], [2, 0], [0, 2]]\n",
     [](Spec& s) {
       s.region = Region::polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
     }},
    {"RegionTwoCorners", "[region]\npolygon_mm = [[0, 0], [1, 0]]\n",
     [](Spec& s) {
       s.region = Region::polygon({{0, 0}, {1, 0}});
     }},
    {"RegionFlat", "[region]\npolygon_mm = [[0, 0], [1, 0], [2, 0]]\n",
     [](Spec& s) {
       s.region = Region::polygon({{0, 0}, {1, 0}, {2, 0}});
     }},
    {"RegionInfinite", "[region]\npolygon_mm = [[0, 0], [1, 0], [inf, 1]]\n",
     [](Spec& s) {
       s.region = Region::polygon({{0, 0}, {1, 0}, {without_end, 1}});
     }},
    {"RegionTooLarge", "[region]\npolygon_mm = [[0, 0], [1e12, 0], [0, 1e12]]\n",
     [](Spec& s) {
       s.region = Region::polygon({{0, 0}, {1e12, 0}, {0, 1e12}});
     }},
    {"RegionInRegion",
     "[region]\npolygon_mm = [[[0, 0], [9, 0], [9, 9], [0, 9]], [[1, 1], [2, 1], [2, 2]]]\n",
     [](Spec& s) {
       s.region = rings({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{1, 1}, {2, 1}, {2, 2}}});
     }},
    {"HoleOutside",
     "[region]\npolygon_mm = [[0, 0], [9, 0], [9, 9], [0, 9]]\nholes_mm = [[11, 1], [12, 1], [12, 2]]\n",
     [](Spec& s) {
       s.region = rings({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}, {{{11, 1}, {12, 1}, {12, 2}}});
     }},
    {"PoleFarAway", "[pole]\nat_mm = [1e8, 0]\n", [](Spec& s) { s.pole.place = Point(1e8, 0); }},
    {"PoleNotFinite", "[pole]\nat_mm = [0, inf]\n", [](Spec& s) { s.pole.place = Point(0, without_end); }},
    {"PoleAreaCrossing", "[pole]\nwithin_mm = [[0, 0], [2, 2], [2, 0], [0, 2]]\n",
     [](Spec& s) {
       s.pole.place = Region::polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
     }},
    {"PoleAreaEmpty", "[pole]\nwithin_mm = []\n", [](Spec& s) { s.pole.place = Region(); }},
    {"WidthNegative", "[links]\nwidth_mm = -3\n", [](Spec& s) { s.links.style.width = -3; }},
    {"PinWiderThanLink", "[links]\npin_diameter_mm = 14\n", [](Spec& s) { s.links.style.pin_diameter = 14; }},
    {"LinkNarrowerThanPin", "[links]\nwidth_mm = 4\n", [](Spec& s) { s.links.style.width = 4; }},
    {"ThicknessNan", "[links]\nthickness_mm = nan\n",
     [](Spec& s) { s.links.style.thickness = std::nan(""); }},
    {"LayersOne", "[links]\nlayers = 1\n", [](Spec& s) { s.links.layers = 1; }},
    {"LayersNine", "[links]\nlayers = 9\n", [](Spec& s) { s.links.layers = 9; }},
    {"ShortestAboveLongest", "[links]\nshortest_mm = 500\n", [](Spec& s) { s.links.shortest = 500; }},
    {"LongestBelowShortest", "[links]\nlongest_mm = 10\n", [](Spec& s) { s.links.longest = 10; }},
    {"WallZero", "[links]\nwall_mm = 0\n", [](Spec& s) { s.links.wall = 0; }},
    {"GridZero", "[links]\ngrid_mm = 0\n", [](Spec& s) { s.links.stock_lengths.grid = 0; }},
    {"GridTooCoarse", "[links]\ngrid_mm = 500\n", [](Spec& s) { s.links.stock_lengths.grid = 500; }},
    {"GridTooFine", "[links]\ngrid_mm = 0.001\n", [](Spec& s) { s.links.stock_lengths.grid = 0.001; }},
    {"GridAndStock", "[links]\ngrid_mm = 5\nstock_mm = [50, 60]\n",
     [](Spec& s) {
       s.links.stock_lengths.grid = 5;
       s.links.stock_lengths.stock = {50, 60};
     }},
    {"StockNegative", "[links]\nstock_mm = [100, -50]\n",
     [](Spec& s) {
       s.links.stock_lengths.stock = {100, -50};
     }},
    {"StockTooLong", "[links]\nstock_mm = [500, 600]\n",
     [](Spec& s) {
       s.links.stock_lengths.stock = {500, 600};
     }},
    {"LockedTooLong", "[links]\nVA_mm = 1200\n", [](Spec& s) { s.links.stock_lengths.locked[0] = 1200; }},
    {"OppositeSidesDiffer", "[links]\nVA_mm = 120\nBC_mm = 110\n",
     [](Spec& s) {
       s.links.stock_lengths.locked[0] = 120;
       s.links.stock_lengths.locked[3] = 110;
     }},
    {"ClearanceNegative", "[limits]\nclearance_mm = -0.5\n", [](Spec& s) { s.limits.clearance = -0.5; }},
    {"TransmissionNegative", "[limits]\ntransmission_deg = -1\n",
     [](Spec& s) { s.limits.transmission = radians(-1); }},
    {"TransmissionNinety", "[limits]\ntransmission_deg = 90\n",
     [](Spec& s) { s.limits.transmission = radians(90); }},
    {"SheetsGapNegative", "[limits]\nsheets_gap_mm = -2\n", [](Spec& s) { s.limits.copy_gap = -2; }},
    {"StripZero", "[limits]\nlongest_strip_mm = 0\n", [](Spec& s) { s.limits.longest_strip = 0; }},
    {"StripTooShort", "[limits]\nlongest_strip_mm = 20\n", [](Spec& s) { s.limits.longest_strip = 20; }},
    {"HardwareUnknown", "[links]\nhardware = \"M7 bolt\"\n", [](Spec& s) { s.links.hardware = "M7 bolt"; }},
    {"HardwareTooWide", "[links]\nhardware = \"608 bearing\"\n",
     [](Spec& s) { s.links.hardware = "608 bearing"; }},
    {"LoadErrorWithoutLoad", "[limits]\nload_error_mm = 0.1\n", [](Spec& s) { s.limits.load_error = 0.1; }},
    {"LoadErrorSoughtWithoutLoad", "[objective]\nminimize = \"load_error\"\n",
     [](Spec& s) { s.objective.objective = Objective::load_error; }},
    {"MassOfNothing", "[objective]\nminimize = \"mass\"\n",
     [](Spec& s) { s.objective.objective = Objective::mass; }},
    {"LoadWithoutMaterial", "[load]\npen_N = 10\n", [](Spec& s) { s.load = Load{10}; }},
    {"LoadOfNothing", "[load]\npen_N = 0\n[material]\nname = \"steel\"\n",
     [](Spec& s) {
       s.material = Material{"steel", 200000, 7850, 235};
       s.load = Load{0};
     }},
    {"SectionOfNoWidth", "[links]\nsections_mm = [[15, 5], [0, 5]]\n",
     [](Spec& s) {
       s.links.sections = {{15, 5}, {0, 5}};
     }},
    {"CopyErrorZero", "[limits]\ncopy_error_mm = 0\n[tolerance]\nlength_mm = 0.1\n",
     [](Spec& s) {
       s.limits.copy_error = 0;
       s.tolerance = Tolerance{0.1, 0};
     }},
    {"CopyErrorWithoutTolerance", "[limits]\ncopy_error_mm = 0.3\n",
     [](Spec& s) { s.limits.copy_error = 0.3; }},
    {"CopyErrorSoughtWithoutTolerance", "[objective]\nminimize = \"copy_error\"\n",
     [](Spec& s) { s.objective.objective = Objective::copy_error; }},
    {"CopyErrorOfNothing", "[objective]\nminimize = \"copy_error\"\n[tolerance]\nlength_mm = 0\n",
     [](Spec& s) {
       s.objective.objective = Objective::copy_error;
       s.tolerance = Tolerance{};
     }},
    {"RobustWithoutTolerances", "[tolerance]\nrobust = true\n",
     [](Spec& s) {
       s.tolerance = Tolerance{0, 0, true};
     }},
    {"ToleranceNegative", "[tolerance]\nlength_mm = -0.05\n",
     [](Spec& s) {
       s.tolerance = Tolerance{-0.05, 0};
     }},
    {"ToolNegative", "[tool]\ncutter_radius_mm = -1\n", [](Spec& s) { s.tool.cutter_radius = -1; }},
    {"GroundingsEmpty", "[objective]\ngroundings = []\n", [](Spec& s) { s.objective.groundings = {}; }},
    {"GroundingTwice", "[objective]\ngroundings = [\"pen\", \"pole\", \"pen\"]\n",
     [](Spec& s) {
       s.objective.groundings = {Grounding::pen, Grounding::pole, Grounding::pen};
     }},
    {"ObstacleFlat", "[[obstacles]]\npolygon_mm = [[0, 0], [1, 1], [2, 2]]\nlayers = [1, 1]\n",
     [](Spec& s) {
       s.obstacles.push_back({{{{0, 0}, {1, 1}, {2, 2}}, {}}});
     }},
    {"ObstacleInNoLayer", "[[obstacles]]\npolygon_mm = [[0, 0], [1, 0], [1, 1]]\nlayers = [0, 2]\n",
     [](Spec& s) {
       s.obstacles.push_back({{{{0, 0}, {1, 0}, {1, 1}}, {}}, 0, 2});
     }},
    {"ObstacleUpsideDown", "[[obstacles]]\npolygon_mm = [[0, 0], [1, 0], [1, 1]]\nlayers = [3, 2]\n",
     [](Spec& s) {
       s.obstacles.push_back({{{{0, 0}, {1, 0}, {1, 1}}, {}}, 3, 2});
     }},
    {"MechanismOfNoLength", "[mechanism]\nvertex = \"pole\"\nVA_mm = 0\nVB_mm = 35\n",
     [](Spec& s) { s.mechanism = MechanismSpec{.VA = 0, .VB = 35}; }},
    {"AssemblyOutOfRange", "[mechanism]\nvertex = \"pole\"\nVA_mm = 50\nVB_mm = 35\nassembly = 4\n",
     [](Spec& s) { s.mechanism = MechanismSpec{.VA = 50, .VB = 35, .assembly_mode = 4}; }},
    {"JoinedLinksInOneLayer",
     "[mechanism]\nvertex = \"pole\"\nVA_mm = 50\nVB_mm = 35\nlayers = [1, 1, 2, 2]\n",
     [](Spec& s) {
       s.mechanism = given({1, 1, 2, 2});
     }},
    {"LayersAboveLinks", "[mechanism]\nvertex = \"pole\"\nVA_mm = 50\nVB_mm = 35\nlayers = [1, 2, 3, 1]\n",
     [](Spec& s) {
       s.mechanism = given({1, 2, 3, 1});
     }},
    {"HoleFitTooLoose", "[cutting]\nhole_fit_mm = 11\n", [](Spec& s) { s.cutting.hole_fit = 11; }},
    {"KerfNegative", "[cutting]\nkerf_mm = -0.1\n", [](Spec& s) { s.cutting.kerf = -0.1; }},
    {"SheetZero", "[cutting]\nsheet_mm = [600, 0]\n", [](Spec& s) { s.cutting.stock_sheet = Point(600, 0); }},
    {"GapNegative", "[cutting]\ngap_mm = -1\n", [](Spec& s) { s.cutting.gap = -1; }},
};

class SameWords : public testing::TestWithParam<Fault> {};

TEST_P(SameWords, InAFileAndInAProgram) {
  const auto in_file = read_spec(file_with(GetParam().toml), "a.toml", ".");
  ASSERT_FALSE(in_file) << file_with(GetParam().toml);
  Spec spec = sound();
  GetParam().fill(spec);
  const auto in_program = validate(spec);
  ASSERT_TRUE(in_program) << in_file.error().message();
  EXPECT_EQ(in_program->key, in_file.error().key);
  EXPECT_EQ(in_program->found, in_file.error().found);
  EXPECT_EQ(in_program->allowed, in_file.error().allowed);
  EXPECT_EQ(in_program->file, "");
  EXPECT_EQ(in_program->line, 0);
}

INSTANTIATE_TEST_SUITE_P(Faults, SameWords, testing::ValuesIn(faults),
                         [](const auto& row) { return row.param.name; });

TEST(Validate, AcceptsWhatIsSound) { EXPECT_FALSE(validate(sound())); }

TEST(Validate, RefusesHolesWhereAFileHasNoWordsForThem) {
  const Polygon holed{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{1, 1}, {1, 2}, {2, 2}}}};
  Spec pole = sound(), obstacle = sound();
  pole.pole.place = Region{{holed}};
  obstacle.obstacles.push_back({holed});
  ASSERT_TRUE(validate(pole));
  EXPECT_EQ(validate(pole)->key, "pole.within_mm");
  ASSERT_TRUE(validate(obstacle));
  EXPECT_EQ(validate(obstacle)->key, "obstacles.polygon_mm");
}

/// Every example spec of the program.
std::vector<std::filesystem::path> examples() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(KEMPE_SOURCE_DIR "/specs/examples"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  return files;
}

TEST(TomlText, ReadBackIsTheSameSpec) {
  int specs = 0;
  for (const auto& file : examples()) {
    const auto loaded = load(file);
    ASSERT_TRUE(std::holds_alternative<Spec>(loaded)) << file;
    const Spec& spec = std::get<Spec>(loaded);
    EXPECT_FALSE(validate(spec)) << file;
    const auto again = read_spec(toml_text(spec), "again", ".");
    ASSERT_TRUE(again) << again.error().message() << "\n" << toml_text(spec);
    EXPECT_EQ(again->region, spec.region) << file;
    EXPECT_EQ(again->copy.scale(), spec.copy.scale()) << file;
    EXPECT_EQ(again->copy.rotation(), spec.copy.rotation()) << file;
    EXPECT_EQ(again->pole.place, spec.pole.place) << file;
    EXPECT_EQ(again->links.style, spec.links.style) << file;
    EXPECT_EQ(again->links.stock_lengths.locked, spec.links.stock_lengths.locked) << file;
    EXPECT_EQ(again->limits.transmission, spec.limits.transmission) << file;
    EXPECT_EQ(again->limits.clearance, spec.limits.clearance) << file;
    EXPECT_EQ(again->obstacles.size(), spec.obstacles.size()) << file;
    EXPECT_EQ(toml_text(*again), toml_text(spec)) << file;
    ++specs;
  }
  EXPECT_GE(specs, 9);
}

/// Numbers with a decimal comma and a point between thousands, as a host program may have asked for.
struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(TomlText, IsTheSameInEveryLocale) {
  Spec spec = sound();
  spec.copy = Copy::of(1.25, 0.3);
  spec.limits.transmission = 0.35;
  spec.links.longest = 12345.5;
  spec.links.layers = 4;
  const std::string text = toml_text(spec);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
  const std::string with_commas = toml_text(spec);
  const auto fault = validate(spec);
  std::locale::global(before);
  EXPECT_EQ(with_commas, text);
  EXPECT_FALSE(fault);
}

TEST(Load, SaysWhatIsWrongAndWhere) {
  const auto loaded = load(KEMPE_SOURCE_DIR "/tests/corpus/specs/links-width-negative.toml");
  ASSERT_TRUE(std::holds_alternative<InputError>(loaded));
  EXPECT_EQ(std::get<InputError>(loaded).line, 8);
}

TEST(Copy, HoldsOneRatio) {
  EXPECT_EQ(Copy().k(), Complex(1, 0));
  EXPECT_EQ(Copy::of(1.4, radians(90)).k(), Complex(0, 1.4));
  EXPECT_EQ(Copy::of(Complex(0, 1.4)).scale(), 1.4);
  EXPECT_EQ(Copy::of(Complex(0, 1.4)).rotation(), pi / 2);
  EXPECT_EQ(Copy::of(Complex(-2, 0)).rotation(), pi);
  for (int i = 1; i < 400; ++i) {
    const Copy copy = Copy::of(0.01 * i, 0.0157 * i - pi);
    EXPECT_EQ(copy.scale(), 0.01 * i);
    EXPECT_NEAR(copy.k().real(), copy.scale() * std::cos(copy.rotation()), 1e-15 * copy.scale());
    EXPECT_NEAR(copy.k().imag(), copy.scale() * std::sin(copy.rotation()), 1e-15 * copy.scale());
  }
}

}  // namespace
}  // namespace kempe
