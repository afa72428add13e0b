// Thousands of damaged specs: the reader must always answer, with a spec that keeps its promises or with an
// error.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "geometry/regions/region_checks.hpp"
#include "specs/drawings/geojson_reader.hpp"
#include "specs/spec_reader.hpp"
#include "tests/geometry/random_rings.hpp"
#include "tests/samples.hpp"

namespace kempe {
namespace {

const std::filesystem::path source(KEMPE_SOURCE_DIR);

std::vector<std::string> files_in(const std::filesystem::path& folder, const char* extension) {
  std::vector<std::string> texts;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == extension && entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return texts;
}

const std::vector<std::string> tokens{"nan",
                                      "inf",
                                      "-inf",
                                      "1e308",
                                      "-1e-308",
                                      "0",
                                      "-0.0",
                                      "9223372036854775807",
                                      "1e7",
                                      "[",
                                      "]",
                                      "[]",
                                      "[[]]",
                                      "{}",
                                      "\"\"",
                                      "true",
                                      "\n[copy]\n",
                                      "\n[region]\n",
                                      "\n[[obstacles]]\n",
                                      "pairs_mm = [[[0,0],[1,1]],[[1,0],[2,3]]]\n",
                                      "=",
                                      ",",
                                      ".",
                                      "\"",
                                      "'''",
                                      "\xff",
                                      std::string(1, '\0'),
                                      "# ",
                                      "2026-01-01",
                                      "0x7f",
                                      "layers = [1,2,2,1]\n",
                                      "[1, 2]",
                                      "[[0,0],[1,0],[1,1]]"};

std::size_t place_in(std::mt19937_64& random, const std::string& text) {
  return random() % (text.size() + 1);
}

void damage(std::mt19937_64& random, std::string& text, const std::vector<std::string>& others) {
  const std::size_t at = place_in(random, text);
  const std::size_t length = std::min<std::size_t>(random() % 12, text.size() - at);
  switch (random() % 7) {
    case 0: text.insert(at, tokens[random() % tokens.size()]); break;
    case 1: text.replace(at, length, tokens[random() % tokens.size()]); break;
    case 2: text.erase(at, length); break;
    case 3: text.insert(at, text.substr(at, length)); break;
    case 4: text.resize(at); break;
    case 5:
      if (at < text.size()) text[at] = static_cast<char>(random());
      break;
    default: {
      const std::string& other = others[random() % others.size()];
      const std::size_t from = place_in(random, other);
      text.insert(at, other.substr(from, random() % 60));
    }
  }
}

bool keeps_invariant(const Region& region) {
  std::vector<Ring> outers, holes;
  for (const Polygon& polygon : region.polygons) {
    if (!(signed_area(polygon.outer) > 0)) return false;
    outers.push_back(polygon.outer);
    holes.insert(holes.end(), polygon.holes.begin(), polygon.holes.end());
  }
  return region.empty() || assemble_region(outers, holes).has_value();
}

void expect_promises_kept(const Spec& spec) {
  EXPECT_TRUE(std::isfinite(spec.copy.scale()) && spec.copy.scale() > 0);
  EXPECT_GT(std::abs(spec.copy.k() - 1.0), 1e-7);
  EXPECT_TRUE(std::abs(spec.copy.rotation()) <= pi);
  EXPECT_TRUE(keeps_invariant(spec.region));
  EXPECT_TRUE(!spec.region.empty() || spec.mechanism);
  EXPECT_TRUE(spec.pole.is_fixed() || keeps_invariant(std::get<Region>(spec.pole.place)));
  EXPECT_TRUE(0 < spec.links.style.pin_diameter && spec.links.style.pin_diameter <= spec.links.style.width);
  EXPECT_LE(spec.links.shortest, spec.links.longest);
  EXPECT_TRUE(2 <= spec.links.layers && spec.links.layers <= 8);
  EXPECT_TRUE(0 <= spec.limits.transmission && spec.limits.transmission < pi / 2);
  EXPECT_FALSE(spec.objective.groundings.empty());
  for (const Obstacle& obstacle : spec.obstacles) {
    EXPECT_TRUE(keeps_invariant({{obstacle.shape}}));
    EXPECT_TRUE(1 <= obstacle.lowest_layer && obstacle.lowest_layer <= obstacle.highest_layer);
  }
}

TEST(SpecReader, AnswersEveryDamagedSpec) {
  std::mt19937_64 random(1);
  const std::filesystem::path faulty_folder = source / "tests/corpus/specs";
  const std::vector<std::string> good = files_in(source / "specs/examples", ".toml"),
                                 faulty = files_in(faulty_folder, ".toml");
  int accepted = 0, refused = 0;
  for (int i = 0; i < test::samples(30000); ++i) {
    const std::vector<std::string>& texts = i % 2 == 0 ? good : faulty;
    std::string text = texts[random() % texts.size()];
    for (int edits = 1 + static_cast<int>(random() % 3); edits > 0; --edits) damage(random, text, faulty);
    const auto spec = read_spec(text, "damaged.toml", faulty_folder);
    if (spec) {
      ++accepted;
      expect_promises_kept(*spec);
    } else {
      ++refused;
      EXPECT_FALSE(spec.error().found.empty()) << text;
      EXPECT_FALSE(spec.error().allowed.empty()) << text;
      EXPECT_LT(spec.error().message().size(), 2000u);
    }
  }
  EXPECT_GT(accepted, test::expected(1500));
  EXPECT_GT(refused, test::expected(15000));
}

TEST(GeoJson, AnswersEveryDamagedFile) {
  std::mt19937_64 random(2);
  const std::vector<std::string> texts = files_in(source / "tests/corpus/specs", ".geojson");
  int accepted = 0;
  for (int i = 0; i < 10000; ++i) {
    std::string text = texts[random() % texts.size()];
    for (int edits = 1 + static_cast<int>(random() % 2); edits > 0; --edits) damage(random, text, texts);
    const auto region = read_geojson_region(text, "damaged.geojson", {});
    accepted += region.has_value();
    EXPECT_TRUE(region ? !region->empty() && keeps_invariant(*region) : !region.error().found.empty())
        << text;
  }
  EXPECT_GT(accepted, 100);
}

}  // namespace
}  // namespace kempe
