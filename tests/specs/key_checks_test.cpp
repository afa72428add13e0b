#include "specs/key_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "specs/spec_keys.hpp"

namespace kempe {
namespace {

TEST(Nearest, TakesTheFewestEdits) {
  const std::vector<std::string_view> words{"width_mm", "longest_mm", "shortest_mm", "plate"};
  EXPECT_EQ(nearest("widht_mm", words), "width_mm");
  EXPECT_EQ(nearest("longset_mm", words), "longest_mm");
  EXPECT_EQ(nearest("plates", words), "plate");
}

TEST(Nearest, IsNoneWhereNoneIsNear) {
  const std::vector<std::string_view> words{"width_mm", "longest_mm", "plate", "at"};
  for (const std::string_view far : {"", "motion", "shortst", "plotter", "wide", "x", "to"})
    EXPECT_FALSE(nearest(far, words)) << far;
  EXPECT_FALSE(nearest("plate", {}));
  EXPECT_EQ(known_instead("widht_mm", words), "width_mm (the nearest known key)");
  EXPECT_EQ(known_instead("motion", {"copy", "region"}, "table"), "one of the tables copy, region");
  EXPECT_EQ(known_instead("motion", {}), "no key");
}

TEST(SpecKeys, AreNamedOnceInTablesThatExist) {
  for (const SpecKey& key : spec_keys()) {
    EXPECT_EQ(find_spec_key(key.table, key.name), &key) << key.name;
    const auto tables = spec_tables();
    const bool inner = key.table.empty() || key.table == "rectangle_mm" || key.table == "circle_mm";
    EXPECT_TRUE(inner || std::find(tables.begin(), tables.end(), key.table) != tables.end()) << key.table;
    EXPECT_FALSE(key.meaning.empty());
    EXPECT_FALSE(describe_allowed(key).empty());
  }
}

TEST(SpecKeys, OfOneLetterMissingAreAllRecognised) {
  for (const SpecKey& key : spec_keys()) {
    std::vector<std::string_view> names;
    for (const SpecKey& other : spec_keys()) {
      if (other.table == key.table) names.push_back(other.name);
    }
    std::string typo(key.name);
    typo.erase(typo.size() / 2, 1);
    const std::string_view found = nearest(typo, names).value_or("");
    // VA_mm and VB_mm without a letter are as near to each other.
    EXPECT_TRUE(found == key.name || key.name.size() == 5) << typo << " -> " << found;
  }
}

TEST(KeyRange, EndsBelongToItUnlessLeftOut) {
  EXPECT_TRUE((KeyRange{0, 1}.contains(0)));
  EXPECT_TRUE((KeyRange{0, 1}.contains(1)));
  EXPECT_FALSE((KeyRange{0, 1, true, true}.contains(0)));
  EXPECT_FALSE((KeyRange{0, 1, true, true}.contains(1)));
  EXPECT_EQ((KeyRange{0, 90, false, true}.describe()), ">= 0 and < 90");
}

}  // namespace
}  // namespace kempe
