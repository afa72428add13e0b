#pragma once
// A spec's tables, from wherever they come. For sources only.

#include <tl/expected.hpp>

#include "kempe/spec.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// The same checks and values as read_spec() (spec_reader.hpp), of tables that stand in no file.
tl::expected<Spec, InputError> read_spec_table(toml::table root);

}  // namespace kempe
