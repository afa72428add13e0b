// docs/spec.md and docs/spec.schema.json say what spec_keys.hpp says.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "specs/key_checks.hpp"
#include "specs/spec_keys.hpp"
#include "specs/spec_schema.hpp"

namespace kempe {
namespace {

std::string contents_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Leaves the text that should stand in the documentation where it can be copied from.
std::string left_for_copying(const std::string& name, const std::string& text) {
  const std::string path = std::string(KEMPE_BINARY_DIR) + "/" + name;
  std::ofstream(path, std::ios::binary) << text;
  return "what should stand there has been written to " + path;
}

std::string code(std::string_view text) { return text.empty() ? "" : fmt::format("`{}`", text); }

/// The line of docs/spec.md about a key.
std::string table_row(const SpecKey& key) {
  std::string allowed = describe_allowed(key);
  const std::string fallback = key.required ? "required" : code(key.fallback);
  return fmt::format("| `{}` | {} | {} | {} | `{}` |", key.name, key.meaning, allowed, fallback, key.example);
}

/// The heading of a key's table in docs/spec.md.
std::string heading(std::string_view table) {
  if (table.empty()) return "## At the top";
  if (table == "obstacles" || table == "bodies") return fmt::format("## [[{}]]", table);
  if (table.ends_with("_mm")) return fmt::format("### {}", table);
  return fmt::format("## [{}]", table);
}

TEST(SpecDocumentation, HoldsALineForEachKeyUnderItsTable) {
  const std::string page = contents_of(KEMPE_SOURCE_DIR "/docs/spec.md");
  std::string all_rows, table;
  bool complete = true;
  for (const SpecKey& key : spec_keys()) {
    if (all_rows.empty() || key.table != table) all_rows += "\n" + heading(table = key.table) + "\n";
    all_rows += table_row(key) + "\n";
    const std::size_t start = page.find(heading(key.table) + "\n"), end = page.find("\n##", start + 1);
    complete &= start != std::string::npos &&
                page.substr(start, end - start).find(table_row(key)) != std::string::npos;
  }
  EXPECT_TRUE(complete) << left_for_copying("spec_rows.md", all_rows);
}

TEST(SpecDocumentation, HoldsNoOtherKeys) {
  std::set<std::string> known;
  for (const SpecKey& key : spec_keys()) known.insert(table_row(key));
  std::istringstream page(contents_of(KEMPE_SOURCE_DIR "/docs/spec.md"));
  for (std::string line; std::getline(page, line);) {
    EXPECT_TRUE(!line.starts_with("| `") || known.contains(line)) << line;
  }
}

TEST(SpecSchema, IsWhatTheTableOfKeysSays) {
  const nlohmann::ordered_json schema = spec_schema();
  const std::string text = schema.dump(2) + "\n";
  const bool same = contents_of(KEMPE_SOURCE_DIR "/docs/spec.schema.json") == text;
  EXPECT_TRUE(same) << left_for_copying("spec.schema.json", text);
}

TEST(SpecKeys, TakeTheirOwnExamplesAndDefaults) {
  for (const SpecKey& key : spec_keys()) {
    for (const std::string_view value : {key.example, key.fallback}) {
      if (value.empty()) continue;
      const auto table = parse_toml(fmt::format("{} = {}", key.name, value), "example");
      ASSERT_TRUE(table) << key.name;
      Complaints complaints("example");
      check_table(*table, key.table, "table", complaints);
      // Alone in its table it may lack others, but nothing is said about itself.
      if (complaints.none()) continue;
      std::vector<InputError> faults = complaints.all().others;
      faults.push_back(complaints.all());
      for (const InputError& fault : faults) EXPECT_EQ(fault.found, "nothing") << fault.message();
    }
  }
}

}  // namespace
}  // namespace kempe
