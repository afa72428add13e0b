#pragma once
// The browser page with a spec inside, to be changed there by hand (docs/studio.md).

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "kempe/export.hpp"
#include "kempe/input_error.hpp"

namespace kempe {

/// What `kempe studio` writes: one page (HTML) that opens with the spec. `page` is the text of the page that scripts/studio builds, `spec` a
/// spec's file (TOML), `name` what the page calls it; a drawing that the spec names is looked for in `folder`.
/// Errors: the spec's faults; a drawing that cannot be read; a page that is not the studio's (key "page").
KEMPE_EXPORT std::variant<std::string, InputError> studio_page(const std::string& page, std::string_view spec,
                                                               const std::string& name = "spec",
                                                               const std::filesystem::path& folder = {});

}  // namespace kempe
