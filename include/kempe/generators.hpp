#pragma once
// Function generators, inversors and path generators: linkages designed for a task, each with its linkage file.

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/export.hpp"
#include "kempe/input_error.hpp"

namespace kempe {

/// A linkage that was designed, as text of a linkage file (kempe/linkage.hpp).
struct GeneratedLinkage {
  std::string
      kind;  ///< "four_bar"; "peaucellier", "hart" or "right_angle"; "answer_1", "answer_1_cognate_1", ...
  std::string text;  ///< TOML
};

/// What came out.
struct Generated {
  std::string json;                        ///< what the command prints with --json, equations included
  std::vector<GeneratedLinkage> linkages;  ///< the best first
  std::string plot;                        ///< SVG of a function generator's structural error; else empty
};

/// Why nothing came out.
struct NothingGenerated {
  std::string sentence;  ///< for a person
  bool proven = false;   ///< false: a search found none
};

/// A four-bar whose output crank shows a function of its input crank (TOML, docs/function-generator.md), as `kempe function`
/// designs it. Some seconds at most.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_function(
    const std::filesystem::path& file);
/// The same of a file's text; `name` stands for the file in messages.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_function_text(
    std::string_view spec, const std::string& name = "");

/// The inversors for a lens (TOML, docs/inversor.md), as `kempe inversor` designs them: the smallest first.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_inversor(
    const std::filesystem::path& file);
/// The same of a file's text; `name` stands for the file in messages.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_inversor_text(
    std::string_view spec, const std::string& name = "");

/// Four-bars whose coupler follows points or takes poses (TOML, docs/path.md), as `kempe path` designs them: the best first,
/// each followed by its cognates if it has them. A second or so.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_path(
    const std::filesystem::path& file);
/// The same of a file's text; `name` stands for the file in messages.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_path_text(
    std::string_view spec, const std::string& name = "");

}  // namespace kempe
