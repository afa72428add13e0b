#include "reports/design_package.hpp"

#include <algorithm>
#include <utility>

#include "reports/data/design_json.hpp"
#include "reports/data/links_csv.hpp"
#include "reports/data/workspace_geojson.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/dxf_writer.hpp"
#include "reports/drawings/svg_writer.hpp"
#include "reports/workshop/workshop_pdf.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// How closely the map's arcs are followed, mm: a hundredth, and for linkages of few millimetres less.
double map_tolerance_of(const Design& design) {
  constexpr double most = 0.01, share = 1e-3;
  return std::min(most, share * chain_annulus(design.linkage).outer);
}

constexpr std::string_view workshop_name = "workshop.pdf";
constexpr const char* always[] = {"design.json", "links.csv", "bom.csv"};

bool is_needed(const std::string& file) {
  return std::find(std::begin(always), std::end(always), file) != std::end(always);
}

const std::string& title_of(const Design& design, const ReportExtras& extras) {
  return design.title.empty() ? extras.spec_name : design.title;
}

}  // namespace

std::string left_out_for_time(const std::string& file) { return file + " is left out: the time was over."; }

tl::expected<std::vector<std::string>, std::string> make_design_package(
    const Design& design, const CuttingSpec& cutting, const ReportExtras& extras,
    const std::function<tl::expected<void, std::string>(const OutputFile&)>& take, const TimeToFinish& time,
    std::optional<PartFiles> parts) {
  std::vector<std::string> left_out;
  const auto has_time_for = [&](const std::string& file) {
    if (is_needed(file) || !time.over()) return true;
    left_out.push_back(left_out_for_time(file));
    return false;
  };
  // One text after the other: those of a region of a million corners are large.
  const std::pair<const char*, std::function<std::string()>> files[] = {
      {"design.json", [&] { return design_json(design); }},
      {"links.csv", [&] { return links_csv(design); }},
      {"drawing.dxf", [&] { return dxf_text(design_drawing(design, cutting)); }},
      {"drawing.svg", [&] { return svg_text(design_drawing(design, cutting), drawing_title(design)); }},
      {"workspace.geojson", [&] { return workspace_geojson(design, map_tolerance_of(design)); }},
      {workshop_name.data(),
       [&] {
         return workshop_pdf(design, {title_of(design, extras), extras.program_version, extras.paper});
       }},
      {"report.html", [&] { return html_report(design, extras); }}};
  for (const auto& [name, text] : files)
    if (has_time_for(name))
      if (auto taken = take({name, text()}); !taken) return tl::unexpected(taken.error());
  if (!parts) parts = part_files(design, cutting, time.enough);
  for (const OutputFile& file : parts->files)
    if (has_time_for(file.name.string()))
      if (auto taken = take(file); !taken) return tl::unexpected(taken.error());
  left_out.insert(left_out.end(), parts->left_out.begin(), parts->left_out.end());
  return left_out;
}

}  // namespace kempe
