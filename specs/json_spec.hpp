#pragma once
// A spec written as JSON, as programs write it. It becomes TOML text, not tables in memory: those have no lines, by which the
// reader chooses the fault that it names.

#include <string>
#include <tl/expected.hpp>

#include "kempe/input_error.hpp"

namespace kempe {

/// A spec given as a JSON object, as the TOML text that means the same. The error, about `name`, says what is no JSON (keys
/// given twice and nesting deeper than 64 levels included), or what TOML cannot hold.
tl::expected<std::string, InputError> toml_from_json(const std::string& json, const std::string& name);

}  // namespace kempe
