#include "reports/earlier_design.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>

#include "kinematics/links.hpp"
#include "reports/certificate.hpp"

namespace kempe {
namespace {

std::vector<std::string> names_of_design_files() {
  std::vector<std::string> names{"design.json",  "links.csv",          "bom.csv",
                                 "drawing.dxf",  "drawing.svg",        "workspace.geojson",
                                 "workshop.pdf", "report.html",        certificate_name,
                                 "nested.dxf",   "parts/assembly.step"};
  for (const Link link : all_links)
    for (const char* ending : {"dxf", "svg", "stl"})
      names.push_back(fmt::format("parts/{}.{}", name(link), ending));
  return names;
}

bool has(const std::filesystem::path& folder, const std::string& name) {
  std::error_code fault;
  return std::filesystem::is_regular_file(folder / name, fault);
}

/// Nothing where it holds something, or is a link to elsewhere.
void remove_if_empty(const std::filesystem::path& folder) {
  std::error_code fault;
  if (std::filesystem::symlink_status(folder, fault).type() == std::filesystem::file_type::directory)
    std::filesystem::remove(folder, fault);
}

}  // namespace

std::vector<std::string> design_files_in(const std::filesystem::path& folder) {
  if (!has(folder, "design.json")) return {};
  std::vector<std::string> names = names_of_design_files();
  std::erase_if(names, [&](const std::string& name) { return !has(folder, name); });
  return names;
}

std::vector<std::string> remove_left_over(const std::filesystem::path& folder,
                                          const std::vector<std::string>& earlier,
                                          const std::vector<std::string>& written) {
  std::vector<std::string> gone;
  std::error_code fault;
  for (const std::string& name : earlier)
    if (std::find(written.begin(), written.end(), name) == written.end() &&
        std::filesystem::remove(folder / name, fault))
      gone.push_back(name);
  if (gone.empty()) return gone;
  remove_if_empty(folder / "parts");
  remove_if_empty(folder);
  return gone;
}

std::string removed_sentence(const std::vector<std::string>& names) {
  return fmt::format("Removed, of an earlier design: {}.", fmt::join(names, ", "));
}

}  // namespace kempe
