// Materials, loads, sections: what is read, what a library's value says again, and every fault with its key.
#include "specs/load_reader.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "specs/materials.hpp"
#include "specs/spec_check.hpp"
#include "specs/spec_reader.hpp"

namespace kempe {
namespace {

const std::string task =
    "[copy]\nscale = 1.4\nrotation_deg = 90\n[region]\ncircle_mm = {centre = [66, 0], radius = 4}\n";

Spec spec_with(const std::string& more) {
  const auto spec = read_spec(task + more, "spec.toml", ".");
  EXPECT_TRUE(spec) << (spec ? "" : spec.error().message());
  return spec.value_or(Spec{});
}

InputError fault_of(const std::string& more) {
  const auto spec = read_spec(task + more, "spec.toml", ".");
  EXPECT_FALSE(spec) << more;
  return spec ? InputError{} : spec.error();
}

TEST(LoadReader, KnowsMaterialsByName) {
  for (const KnownMaterial& known : known_materials()) {
    const Spec spec = spec_with("[material]\nname = \"" + std::string(known.name) + "\"\n");
    ASSERT_TRUE(spec.material);
    EXPECT_EQ(*spec.material, as_material(known));
    EXPECT_GT(spec.material->E, 1000);
  }
  EXPECT_FALSE(spec_with("").material);
  EXPECT_FALSE(spec_with("").load);
}

TEST(LoadReader, TakesFiguresInPlaceOfAName) {
  const Spec own =
      spec_with("[material]\nname = \"oak\"\nE_GPa = 11\ndensity_kg_m3 = 700\nstrength_MPa = 60\n");
  EXPECT_EQ(*own.material, (Material{"oak", 11000, 700, 60}));
  const Spec stiffer = spec_with("[material]\nname = \"steel\"\nE_GPa = 210\n");
  EXPECT_EQ(*stiffer.material, (Material{"steel", 210000, 7850, 235}));
  EXPECT_EQ(fault_of("[material]\nname = \"oak\"\nE_GPa = 11\n").key, "material.name");
  EXPECT_EQ(fault_of("[material]\nE_GPa = 11\n").key, "material.E_GPa");
}

TEST(LoadReader, ReadsLoads) {
  const std::string steel = "[material]\nname = \"steel\"\n";
  const Spec spec = spec_with(steel + "[load]\npen_N = 10\nrests = [\"tracer\"]\n");
  ASSERT_TRUE(spec.load);
  EXPECT_EQ(spec.load->pen_force, 10);
  EXPECT_TRUE(spec.load->rests_at(Carrier::tracer));
  EXPECT_FALSE(spec.load->rests_at(Carrier::pen));
  EXPECT_EQ(fault_of("[load]\npen_N = 10\n").key, "load.pen_N");
  EXPECT_EQ(fault_of(steel + "[load]\nrests = [\"pen\"]\n").key, "load.pen_N");
  EXPECT_EQ(fault_of(steel + "[load]\npen_N = 10\nrests = [\"pen\", \"pen\"]\n").key, "load.rests");
  const InputError kilograms = fault_of(steel + "[load]\npen_kg = 1\n");
  EXPECT_EQ(kilograms.key, "load.pen_kg");
  EXPECT_NE(kilograms.allowed.find("pen_N: forces are in newtons"), std::string::npos);
}

TEST(LoadReader, ReadsMassesTiltGripAndFriction) {
  const std::string steel = "[material]\nname = \"steel\"\n";
  const Spec plain = spec_with(steel + "[load]\npen_N = 10\n");
  EXPECT_EQ(*plain.load, (Load{.pen_force = 10}));
  const Spec spec = spec_with(steel +
                              "[load]\npen_N = 10\npen_mass_kg = 3\ntracer_mass_kg = 0.2\ntilt_deg = "
                              "90\ngrip_mm = 40\nfriction = 0\n");
  const Load wanted{
      .pen_force = 10, .pen_mass = 3, .tracer_mass = 0.2, .tilt = pi / 2, .grip = 40, .friction = 0};
  EXPECT_EQ(*spec.load, wanted);
  const auto again = check_spec(spec);
  ASSERT_TRUE(again);
  EXPECT_EQ(*again->load, wanted);
  for (const std::string bad :
       {"pen_mass_kg = -1", "tracer_mass_kg = 1e5", "tilt_deg = 91", "grip_mm = 0", "friction = -0.1"})
    EXPECT_EQ(fault_of(steel + "[load]\npen_N = 10\n" + bad + "\n").key,
              "load." + bad.substr(0, bad.find(' ')));
}

TEST(LoadReader, AsksForWhatLimitsAndObjectivesNeed) {
  const std::string steel = "[material]\nname = \"steel\"\n";
  EXPECT_EQ(fault_of("[limits]\nload_error_mm = 0.1\n").key, "limits.load_error_mm");
  EXPECT_EQ(fault_of(steel + "[objective]\nminimize = \"load_error\"\n").key, "objective.minimize");
  EXPECT_EQ(fault_of("[objective]\nminimize = \"mass\"\n").key, "objective.minimize");
  EXPECT_EQ(spec_with(steel + "[objective]\nminimize = \"mass\"\n").objective.objective, Objective::mass);
  const std::string loaded = steel + "[load]\npen_N = 10\n", in_all = "[limits]\nload_error_in_all = true\n";
  EXPECT_EQ(fault_of(loaded + in_all).key, "limits.load_error_in_all");
  const std::string limited = loaded + in_all + "load_error_mm = 0.1\n";
  EXPECT_TRUE(spec_with(limited).limits.load_error_in_all);
  EXPECT_FALSE(spec_with(loaded).limits.load_error_in_all);
  EXPECT_EQ(fault_of(limited + "[objective]\nminimize = \"load_error\"\n").key, "limits.load_error_in_all");
  const auto again = read_spec(spec_as_toml(spec_with(limited)), "again.toml", ".");
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_TRUE(again->limits.load_error_in_all);
}

TEST(LoadReader, SortsSections) {
  const Spec spec = spec_with("[links]\nsections_mm = [[20, 5], [15, 5], [20, 5], [12, 8]]\n");
  const std::vector<LinkSection> sorted{{15, 5}, {12, 8}, {20, 5}};
  EXPECT_EQ(spec.links.sections, sorted);
  EXPECT_EQ(spec.links.style.width, 15);
  EXPECT_EQ(spec.links.style.thickness, 5);
  EXPECT_EQ(fault_of("[links]\nsections_mm = [[20, 5]]\nwidth_mm = 20\n").key, "links.width_mm");
  EXPECT_EQ(fault_of("[links]\nsections_mm = []\n").key, "links.sections_mm");
  std::string many = "[20, 5]";
  for (std::size_t i = 0; i < most_sections; ++i) many += ", [20, 5]";
  EXPECT_EQ(fault_of("[links]\nsections_mm = [" + many + "]\n").found, "33 sections");
  EXPECT_EQ(fault_of("[links]\nsections_mm = [15, 5]\n").key, "links.sections_mm");
  EXPECT_EQ(fault_of("[links]\nsections_mm = [[20, 5], [5, 20]]\n").key, "links.sections_mm");  // a pin of 6
  EXPECT_EQ(fault_of("[links]\nsections_mm = [[20, 5], [15, 5]]\n[mechanism]\nvertex = \"pole\"\nVA_mm = "
                     "50\nVB_mm = 35\n")
                .key,
            "links.sections_mm");
}

TEST(LoadReader, SaysAgainWhatItRead) {
  const Spec spec = spec_with(
      "[links]\nsections_mm = [[20, 5], [15, 5]]\n[material]\nname = \"PLA\"\n[load]\npen_N = 7\nrests = "
      "[\"pen\"]\n"
      "[limits]\nload_error_mm = 0.2\n[objective]\nminimize = \"load_error\"\n");
  const auto again = read_spec(spec_as_toml(spec), "again.toml", ".");
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->links.sections, spec.links.sections);
  EXPECT_EQ(again->links.style, spec.links.style);
  EXPECT_EQ(*again->material, *spec.material);
  EXPECT_EQ(*again->load, *spec.load);
  EXPECT_EQ(again->limits.load_error, spec.limits.load_error);
  const auto checked = check_spec(spec);
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->links.sections, spec.links.sections);
}

TEST(Materials, StandInTheirPageWithTheirSources) {
  std::ifstream stream(KEMPE_SOURCE_DIR "/docs/loads.md", std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  for (const KnownMaterial& known : known_materials()) {
    EXPECT_NE(page.find("| `" + std::string(known.name) + "` |"), std::string::npos) << known.name;
    EXPECT_NE(page.find(std::string(known.source)), std::string::npos) << known.name;
  }
}

}  // namespace
}  // namespace kempe
