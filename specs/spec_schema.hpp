#pragma once
// The spec's JSON schema, made from the table of its keys. For sources only.

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

namespace kempe {

/// A JSON schema (draft 7) of specs: docs/spec.schema.json. Of the tables `outlined` it says only that they may be there.
nlohmann::ordered_json spec_schema(std::span<const std::string_view> outlined = {});

}  // namespace kempe
