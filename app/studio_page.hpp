#pragma once
// The studio's page for a spec: found where it has been built or installed, and filled.

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "app/design_run.hpp"

namespace kempe::app {

/// The page that scripts/studio has built, as it is.
struct BuiltStudio {
  std::filesystem::path file;
  std::string page;
};

/// Looked for, in this order: where the environment's KEMPE_STUDIO says; in share/kempe of the folder where the program is installed;
/// in out/ of the tree where it has been built. The error is a sentence that names what was looked at and the command that builds it.
tl::expected<BuiltStudio, std::string> find_studio();

/// The page with the spec inside, and with the drawing that the spec names. The error is a sentence.
tl::expected<std::string, std::string> studio_page(const BuiltStudio& studio, const LoadedSpec& spec);

/// The option --studio of a command that writes a design's folder.
CLI::Option* add_studio_option(CLI::App& command, bool& wanted);

/// The page for the design's folder; an empty text if it is not wanted. The error is a sentence.
tl::expected<std::string, std::string> studio_page_if(bool wanted, const LoadedSpec& spec);

}  // namespace kempe::app
