#pragma once
// JSON from outside, with what the library passes over in silence refused. For sources only.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "kempe/input_error.hpp"

namespace kempe {

/// Parses a whole JSON text. The error carries the line; an empty text, a repeated key, a number beyond the
/// doubles and nesting deeper than 64 are refused (the library alone takes the last of repeated keys in
/// silence).
tl::expected<nlohmann::json, InputError> parse_json(std::string_view text, const std::string& file_name);

}  // namespace kempe
