#include "reports/earlier_design.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <system_error>

#include "kinematics/links.hpp"
#include "reports/certificate.hpp"
#include "reports/front_folder.hpp"

namespace kempe {
namespace {

constexpr const char* design_name = "design.json";

std::vector<std::string> names_of_design_files() {
  std::vector<std::string> names{design_name,    "links.csv",          "bom.csv",
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

std::string point_folder(std::size_t index) { return fmt::format("{:02}", index + 1); }

std::vector<std::string> design_files_in(const std::filesystem::path& folder) {
  const bool has_front = has(folder, front_table_name);
  if (!has_front && !has(folder, design_name)) return {};
  std::vector<std::string> names = names_of_design_files();
  names.push_back(front_table_name);
  std::erase_if(names, [&](const std::string& name) { return !has(folder, name); });
  for (std::size_t i = 0; has_front && has(folder / point_folder(i), design_name); ++i)
    for (const std::string& name : design_files_in(folder / point_folder(i)))
      names.push_back(point_folder(i) + "/" + name);
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
  for (const std::string& name : gone)
    for (std::filesystem::path within = std::filesystem::path(name).parent_path(); !within.empty();
         within = within.parent_path())
      remove_if_empty(folder / within);
  return gone;
}

std::string removed_sentence(const std::vector<std::string>& names) {
  std::vector<std::string> told;
  std::map<std::string, int> of_points;
  for (const std::string& name : names) {
    const std::string first = name.substr(0, name.find('/'));
    if (first == name || first == "parts")
      told.push_back(name);
    else
      ++of_points[first];
  }
  for (const auto& [point, count] : of_points) told.push_back(fmt::format("{} files of {}/", count, point));
  return fmt::format("Removed, left by an earlier design: {}.", fmt::join(told, ", "));
}

}  // namespace kempe
