#include "app/studio_page.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>
#include <vector>

#include "reports/page/studio_page.hpp"
#include "specs/spec_reader.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

namespace fs = std::filesystem;

/// Where the page may be, from the program's own place: KEMPE_INSTALLED_STUDIO and KEMPE_BUILT_STUDIO are relative to its folder, so
/// that an installation can be moved.
std::vector<fs::path> places() {
  if (const char* named = std::getenv("KEMPE_STUDIO"); named != nullptr && *named != '\0') return {named};
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (error) return {};
  std::vector<fs::path> all{(folder / KEMPE_INSTALLED_STUDIO).lexically_normal()};
  // Only of a build's own tree: the same steps from elsewhere lead to folders that have nothing to do with Kempe.
  if (fs::exists(folder / ".." / "CMakeCache.txt", error))
    all.push_back((folder / KEMPE_BUILT_STUDIO).lexically_normal());
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
  StudioSpec inside{fs::path(shown_name(spec.file)).stem().string(), spec.text, std::nullopt};
  if (const auto drawing = region_file_of(spec.text)) {
    auto text = read_text_file(fs::path(spec.file).parent_path() / *drawing);
    if (!text) return tl::unexpected(text.error().message());
    inside.drawing = {shown_name(drawing->string()), std::move(*text)};
  }
  if (auto page = studio_page_with(studio.page, inside)) return std::move(*page);
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
