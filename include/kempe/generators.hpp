#pragma once
// Function generators, inversors and path generators: linkages designed for a task, each with its linkage file.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kempe/design.hpp"
#include "kempe/export.hpp"
#include "kempe/input_error.hpp"
#include "kempe/linkage.hpp"

namespace kempe {

/// A linkage that was designed, as text of a linkage file (kempe/linkage.hpp).
struct GeneratedLinkage {
  std::string
      kind;  ///< "four_bar"; "peaucellier", "hart" or "right_angle"; "answer_1", "answer_1_cognate_1", "answer_1_copy", ...
  std::string text;  ///< TOML
  /// Of a path generator: what its point P was asked for, in the order of the task; Linkage::animation() shows it.
  std::vector<PlaceAskedFor> wanted{};
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
  bool stopped = false;  ///< by a time limit or `stop`, before anything was found
};

/// A four-bar whose output crank shows a function of its input crank (TOML, docs/function-generator.md), as `kempe function`
/// designs it. Some seconds; minutes where the function bends a lot. Of the options the time limit and the stop count: the best so far
/// then comes back, its JSON says "complete": false.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_function(
    const std::filesystem::path& file, const Options& options = {});
/// The same of a file's text; `name` stands for the file in messages.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_function_text(
    std::string_view spec, const std::string& name = "", const Options& options = {});

/// The inversors for a lens (TOML, docs/inversor.md), as `kempe inversor` designs them: the smallest first.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_inversor(
    const std::filesystem::path& file);
/// The same of a file's text; `name` stands for the file in messages.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_inversor_text(
    std::string_view spec, const std::string& name = "");

/// Kempe and Sylvester's plagiograph on the coupler: two links more, and a point that draws the coupler curve scaled and turned about a
/// pivot.
struct PlagiographOptions {
  double scale = 1;     ///< 0.001 to 1000
  double rotation = 0;  ///< rad, -2 pi to 2 pi
  std::string pole;     ///< "crank" or "rocker": its fixed pivot; "": the one farther from change points
  int cognate = 0;      ///< 0: on the answer; 1 or 2: on that cognate of it
};

/// Four-bars whose coupler follows points or takes poses (TOML, docs/path.md), as `kempe path` designs them: the best first,
/// each followed by its cognates if it has them, and by its copy ("answer_1_copy") where `copy` asks for one and there is one (else
/// the JSON says why not). A second or so. Errors: those of the file; an option that cannot be (keys "copy.scale", "copy.rotation_deg",
/// "copy.pole", "copy.cognate").
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_path(
    const std::filesystem::path& file, const std::optional<PlagiographOptions>& copy = {});
/// The same of a file's text; `name` stands for the file in messages.
KEMPE_EXPORT std::variant<Generated, InputError, NothingGenerated> generate_path_text(
    std::string_view spec, const std::string& name = "", const std::optional<PlagiographOptions>& copy = {});

}  // namespace kempe
