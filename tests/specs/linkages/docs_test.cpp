// docs/linkage-file.md and docs/linkage.schema.json say what linkages/keys.hpp says.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "specs/linkages/keys.hpp"

namespace kempe {
namespace {

using nlohmann::json;

std::string contents_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The part of the page under the heading that names a table; all of it for inner tables.
std::string section_of(const std::string& page, std::string_view table) {
  if (table.find('.') != std::string_view::npos && table != "links.*") return page;
  const std::string name(table.substr(0, table.find('.')));
  for (const std::string& heading : {"## [[" + name + "]]\n", "## [" + name + "]", "and [" + name + "]\n",
                                     std::string(name.empty() ? "## Top level" : "\f")}) {
    const std::size_t start = page.find(heading);
    if (start != std::string::npos) return page.substr(start, page.find("\n## ", start) - start);
  }
  return {};
}

TEST(LinkageDocumentation, ExplainsEveryKeyUnderItsTable) {
  const std::string page = contents_of(KEMPE_SOURCE_DIR "/docs/linkage-file.md");
  for (const LinkageKey& key : linkage_keys()) {
    const std::string section = section_of(page, key.table);
    EXPECT_FALSE(section.empty()) << key.table;
    const bool is_table = key.table.empty() && key.allowed.find("table") != std::string_view::npos;
    if (key.name == "*") continue;
    if (is_table) {
      EXPECT_NE(page.find("[" + std::string(key.name) + "]"), std::string::npos) << key.name;
      continue;
    }
    EXPECT_NE(section.find(std::string(key.name)), std::string::npos) << key.table << "." << key.name;
  }
}

/// The schema's object for a table.
const json& schema_of(const json& root, const std::string& table) {
  const json& properties = root.at("properties");
  if (table.empty()) return root;
  if (table == "links.*") return root.at("$defs").at("link");
  if (table == "bounds.*") return properties.at("bounds").at("additionalProperties");
  if (table == "masses.*") return properties.at("masses").at("additionalProperties");
  if (table == "drivers.circle") return properties.at("drivers").at("items").at("properties").at("circle");
  const json& schema = properties.at(table);
  return schema.contains("items") ? schema.at("items") : schema;
}

TEST(LinkageSchema, KnowsTheSameKeys) {
  const json root = json::parse(contents_of(KEMPE_SOURCE_DIR "/docs/linkage.schema.json"));
  std::size_t known = 0;
  for (const LinkageKey& key : linkage_keys()) {
    const json& schema = schema_of(root, std::string(key.table));
    if (key.name == "*") {
      EXPECT_TRUE(schema.at("additionalProperties").is_object()) << key.table;
    } else if (key.name == "A-B" || key.name == "A-B-C_deg") {
      EXPECT_EQ(schema.at("patternProperties").size(), 2u);
    } else {
      EXPECT_TRUE(schema.at("properties").contains(std::string(key.name))) << key.table << "." << key.name;
      EXPECT_FALSE(schema.at("additionalProperties").is_object());
      ++known;
    }
  }
  std::size_t in_schema = 0;
  for (const char* table : {"", "links.*", "sliders", "angles", "gears", "racks", "drivers", "drivers.circle",
                            "forces", "moments", "masses.*", "motion", "bounds.*", "output"})
    in_schema += schema_of(root, table).at("properties").size();
  EXPECT_EQ(in_schema, known);  // and no others
}

}  // namespace
}  // namespace kempe
