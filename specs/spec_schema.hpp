#pragma once
// The spec's JSON schema, made from the table of its keys. For sources only.

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

namespace kempe {

/// A JSON schema (draft 7) of specs: docs/spec.schema.json. Without the tables `left_out`, which then are neither described nor
/// forbidden.
nlohmann::ordered_json spec_schema(std::span<const std::string_view> left_out = {});

}  // namespace kempe
