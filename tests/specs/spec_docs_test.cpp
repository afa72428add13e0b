// docs/spec.md and docs/spec.schema.json say what spec_keys.hpp says.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "kempe/links.hpp"
#include "specs/key_checks.hpp"
#include "specs/spec_keys.hpp"
#include "specs/spec_unit.hpp"

namespace kempe {
namespace {

using nlohmann::ordered_json;

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

ordered_json number_schema(const SpecKey& key, const char* type) {
  ordered_json schema{{"type", type}};
  if (std::isfinite(key.range.lower)) {
    schema[key.range.without_lower ? "exclusiveMinimum" : "minimum"] = key.range.lower;
    schema[key.range.without_upper ? "exclusiveMaximum" : "maximum"] = key.range.upper;
  }
  return schema;
}

ordered_json list_schema(ordered_json items, std::size_t least,
                         std::optional<std::size_t> most = std::nullopt) {
  ordered_json schema{{"type", "array"}, {"items", std::move(items)}, {"minItems", least}};
  if (most) schema["maxItems"] = *most;
  return schema;
}

ordered_json table_schema(std::string_view table);

/// Two numbers, of which the first is to the second as the copy is to the original.
constexpr const char* ratio_pattern = "^ *[0-9.]+ *[:/] *[0-9.]+ *$";

ordered_json value_schema(const SpecKey& key) {
  const ordered_json word{{"enum", words_of(key)}};
  const ordered_json number = number_schema(key, "number"), whole = number_schema(key, "integer");
  const ordered_json point = list_schema(number, 2, 2), ring = list_schema(point, 3);
  switch (key.kind) {
    case KeyKind::number: return number;
    case KeyKind::ratio: return {{"anyOf", {number, {{"type", "string"}, {"pattern", ratio_pattern}}}}};
    case KeyKind::whole_number: return whole;
    case KeyKind::truth: return {{"type", "boolean"}};
    case KeyKind::choice: return word;
    case KeyKind::choices: {
      ordered_json schema = list_schema(word, 1);
      schema["uniqueItems"] = true;
      return schema;
    }
    case KeyKind::joint_choices: {
      ordered_json by_joint{{"type", "object"}, {"additionalProperties", false}, {"minProperties", 1}};
      for (const char* joint : {"default", "V", "A", "B", "C", "X", "Y"})
        by_joint["properties"][joint] = word;
      return {{"anyOf", {word, by_joint}}};
    }
    case KeyKind::text: return {{"type", "string"}, {"minLength", 1}};
    case KeyKind::numbers: return list_schema(number, 1);
    case KeyKind::point: return point;
    case KeyKind::sections: return list_schema(point, 1, most_sections);
    case KeyKind::layer_range: return list_schema(whole, 2, 2);
    case KeyKind::link_layers: return list_schema(whole, 4, 4);
    case KeyKind::rings: return {{"anyOf", {ring, list_schema(ring, 1)}}};
    case KeyKind::rectangle:
      return {{"anyOf", {table_schema(key.name), list_schema({{"type", "number"}}, 4, 4)}}};
    case KeyKind::circle:
      return {{"anyOf", {table_schema(key.name), list_schema({{"type", "number"}}, 3, 3)}}};
    case KeyKind::pairs: return list_schema(list_schema(point, 2, 2), 2);
  }
  return {};
}

ordered_json key_schema(const SpecKey& key) {
  ordered_json schema = value_schema(key);
  schema["description"] = std::string(key.meaning);
  if (!key.fallback.empty()) schema["default"] = ordered_json::parse(key.fallback);
  return schema;
}

/// In inches the keys of lengths end in _in: their ranges are those of the millimetres, which a schema cannot convert.
void allow_inches(ordered_json& schema) {
  schema["patternProperties"]["_in$"] = {
      {"description", "with units = \"in\" at the top: the same key in inches"}};
}

ordered_json table_schema(std::string_view table) {
  ordered_json schema{{"type", "object"}, {"additionalProperties", false}};
  std::vector<std::string> lengths, lengths_in_inches;
  for (const SpecKey& key : spec_keys()) {
    if (key.table != table) continue;
    schema["properties"][std::string(key.name)] = key_schema(key);
    if (!key.required) continue;
    if (!key.name.ends_with("_mm")) {
      schema["required"].push_back(std::string(key.name));
      continue;
    }
    lengths.emplace_back(key.name);
    lengths_in_inches.push_back(name_in(SpecUnit::inch, key.name));
  }
  if (!table.ends_with("_mm")) allow_inches(schema);
  if (!lengths.empty()) schema["anyOf"] = {{{"required", lengths}}, {{"required", lengths_in_inches}}};
  return schema;
}

TEST(SpecSchema, IsWhatTheTableOfKeysSays) {
  ordered_json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                      {"title", "Spec of a copying linkage for kempe"},
                      {"type", "object"},
                      {"additionalProperties", false},
                      {"required", {"copy"}}};
  for (const SpecKey& key : spec_keys())
    if (key.table.empty()) schema["properties"][std::string(key.name)] = key_schema(key);
  for (const std::string_view table : spec_tables()) {
    const ordered_json one = table_schema(table);
    const bool is_list = table == "obstacles" || table == "bodies";
    schema["properties"][std::string(table)] = is_list ? list_schema(one, 0) : one;
  }
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
