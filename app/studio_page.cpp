#include "app/studio_page.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>
#include <vector>

#include "app/own_files.hpp"
#include "reports/page/studio_page.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

namespace fs = std::filesystem;

/// Where the page may be.
std::vector<fs::path> places() {
  if (const char* named = std::getenv("KEMPE_STUDIO"); named != nullptr && *named != '\0') return {named};
  const auto own = own_places(KEMPE_INSTALLED_STUDIO, KEMPE_BUILT_STUDIO);
  if (!own) return {};
  std::vector<fs::path> all{own->installed};
  if (own->built) all.push_back(*own->built);
  return all;
}

std::string not_built(const std::vector<fs::path>& looked_at) {
  std::string where;
  for (const fs::path& place : looked_at) where += (where.empty() ? "" : ", ") + printable(place.string());
  return fmt::format(
      "the studio's page is not there: scripts/studio builds out/studio.html (looked for: {}; the "
      "environment's "
      "KEMPE_STUDIO may name another place)",
      where.empty() ? "nothing" : where);
}

}  // namespace

tl::expected<BuiltStudio, std::string> find_studio() {
  const std::vector<fs::path> looked_at = places();
  for (const fs::path& place : looked_at) {
    std::error_code error;
    if (!fs::exists(place, error)) continue;
    auto page = read_text_file(place);
    if (!page) return tl::unexpected(page.error().message());
    return BuiltStudio{place, std::move(*page)};
  }
  return tl::unexpected(not_built(looked_at));
}

tl::expected<std::string, std::string> studio_page(const BuiltStudio& studio, const LoadedSpec& spec) {
  const auto inside =
      studio_spec(fs::path(spec.file).stem().string(), spec.text, fs::path(spec.file).parent_path());
  if (!inside) return tl::unexpected(inside.error().message());
  if (auto page = studio_page_with(studio.page, *inside)) return std::move(*page);
  return tl::unexpected(fmt::format(
      "{}: found no page of the studio; allowed: one that scripts/studio of this version has built",
      printable(studio.file.string())));
}

CLI::Option* add_studio_option(CLI::App& command, bool& wanted) {
  return command.add_flag(
      "--studio", wanted,
      "Also write studio.html, the browser page with this spec inside; the report leads to it");
}

tl::expected<std::string, std::string> studio_page_if(bool wanted, const LoadedSpec& spec) {
  if (!wanted) return std::string();
  return find_studio().and_then([&](const BuiltStudio& studio) { return studio_page(studio, spec); });
}

}  // namespace kempe::app
