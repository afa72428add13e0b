#pragma once
// Specs from files, and specs filled in a program, checked alike.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "kempe/export.hpp"
#include "kempe/input_error.hpp"
#include "kempe/spec.hpp"

namespace kempe {

/// What is wrong with a spec, or nothing. The checks are the file reader's own, so the same fault has the same words: key,
/// what was found, what is allowed. Numbers are named in the file's units (mm, degrees).
KEMPE_EXPORT std::optional<InputError> validate(const Spec& spec);

/// The spec of a TOML file (docs/spec.md), checked; a drawing it names is looked for beside it. Or what is wrong, with the
/// line.
KEMPE_EXPORT std::variant<Spec, InputError> load(const std::filesystem::path& file);

/// The same of a text. `name` stands for the file in messages, unless empty; a drawing it names is looked for in `folder`.
KEMPE_EXPORT std::variant<Spec, InputError> parse(std::string_view text, const std::string& name = "",
                                                  const std::filesystem::path& folder = {});

/// The spec as a file would say it (TOML, docs/spec.md). Keys with their default value are left out. load() reads it back; the text
/// of a spec that validate() refuses may be one that load() refuses.
KEMPE_EXPORT std::string toml_text(const Spec& spec);

}  // namespace kempe
