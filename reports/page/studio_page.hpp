#pragma once
// The studio's page (docs/studio.md) with a spec inside: it opens with that spec instead of a template.

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "kempe/input_error.hpp"

namespace kempe {

/// What a page is to open with. Every text may be anything: it is escaped.
struct StudioSpec {
  struct Drawing {
    std::string name;  ///< the file's name alone
    std::string text;
  };
  std::string name;                ///< what the page calls it: "plagiograph"
  std::string text;                ///< the spec, TOML
  std::optional<Drawing> drawing;  ///< what region.file names
};

/// A spec's text with the drawing that it names, which is looked for in `folder`. The error is that of the drawing's file.
tl::expected<StudioSpec, InputError> studio_spec(std::string name, std::string text,
                                                 const std::filesystem::path& folder);

/// The file of a design's folder that holds the studio's page with the spec inside.
inline constexpr const char* studio_page_name = "studio.html";

/// The page that scripts/studio has built, with the spec in place of the one that it holds, if any. Nothing if `page` is not the
/// studio's. The spec is data in the page, never script or markup: what the page's security policy allows does not change.
std::optional<std::string> studio_page_with(const std::string& page, const StudioSpec& spec);

}  // namespace kempe
