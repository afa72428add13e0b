#include "specs/spec_schema.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "kempe/links.hpp"
#include "specs/spec_keys.hpp"
#include "specs/spec_unit.hpp"

namespace kempe {
namespace {

using nlohmann::ordered_json;

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
  ordered_json word{{"enum", words_of(key)}};
  ordered_json number = number_schema(key, "number"), whole = number_schema(key, "integer");
  ordered_json point = list_schema(number, 2, 2);
  const ordered_json ring = list_schema(point, 3);
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

}  // namespace

ordered_json spec_schema(std::span<const std::string_view> outlined) {
  ordered_json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                      {"title", "Spec of a copying linkage for kempe"},
                      {"type", "object"},
                      {"additionalProperties", false},
                      {"required", {"copy"}}};
  for (const SpecKey& key : spec_keys())
    if (key.table.empty()) schema["properties"][std::string(key.name)] = key_schema(key);
  for (const std::string_view table : spec_tables()) {
    const bool is_outlined = std::find(outlined.begin(), outlined.end(), table) != outlined.end();
    const ordered_json one = is_outlined ? ordered_json{{"type", "object"}} : table_schema(table);
    const bool is_list = table == "obstacles" || table == "bodies";
    schema["properties"][std::string(table)] = is_list ? list_schema(one, 0) : one;
  }
  return schema;
}

}  // namespace kempe
