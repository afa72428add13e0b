#pragma once
// The spec from TOML: docs/spec.md says what may stand in it, spec_keys.hpp holds the table of its keys.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "kempe/input_error.hpp"
#include "specs/spec.hpp"
#include "specs/spec_keys.hpp"

namespace kempe {

/// Reads and checks a spec. What comes back obeys every rule of docs/spec.md:
///  1. all numbers are finite, within the ranges of spec_keys.hpp, in mm and rad;
///  2. regions keep the invariant of Polygon; the copy ratio is neither 0 nor 1;
///  3. what is left out has the defaults of spec.hpp; the region may be empty only beside a [mechanism].
/// The error names every fault of the file, the topmost first: line, key, what was found, what is allowed; `file` is the
/// path as given.
tl::expected<Spec, InputError> read_spec_file(const std::filesystem::path& path);

/// The same from text. `file_name` is for error messages, region.file is looked for in `folder`.
tl::expected<Spec, InputError> read_spec(std::string_view text, const std::string& file_name,
                                         const std::filesystem::path& folder);

/// The unit of the lengths in a spec's text; mm if it does not say, or is not TOML.
SpecUnit unit_of_spec(std::string_view text);

/// The drawing that a spec's text names as region.file; nothing if it names none, or is not TOML.
std::optional<std::filesystem::path> region_file_of(std::string_view text);

}  // namespace kempe
