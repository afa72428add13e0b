#include "reports/design_package.hpp"

#include <algorithm>
#include <utility>

#include "reports/data/design_json.hpp"
#include "reports/data/links_csv.hpp"
#include "reports/data/workspace_geojson.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/dxf_writer.hpp"
#include "reports/drawings/part_files.hpp"
#include "reports/drawings/svg_writer.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// How closely the map's arcs are followed, mm: a hundredth, and for linkages of few millimetres less.
double map_tolerance_of(const Design& design) {
  constexpr double most = 0.01, share = 1e-3;
  return std::min(most, share * chain_annulus(design.linkage).outer);
}

}  // namespace

tl::expected<std::vector<std::string>, std::string> make_design_package(
    const Design& design, const CuttingSpec& cutting, const ReportExtras& extras,
    const std::function<tl::expected<void, std::string>(const OutputFile&)>& take) {
  // One text after the other: those of a region of a million corners are large.
  const std::pair<const char*, std::function<std::string()>> files[] = {
      {"design.json", [&] { return design_json(design); }},
      {"links.csv", [&] { return links_csv(design); }},
      {"drawing.dxf", [&] { return dxf_text(design_drawing(design, cutting)); }},
      {"drawing.svg", [&] { return svg_text(design_drawing(design, cutting), drawing_title(design)); }},
      {"workspace.geojson", [&] { return workspace_geojson(design, map_tolerance_of(design)); }},
      {"report.html", [&] { return html_report(design, extras); }}};
  for (const auto& [name, text] : files)
    if (auto taken = take({name, text()}); !taken) return tl::unexpected(taken.error());
  PartFiles parts = part_files(design, cutting);
  for (const OutputFile& file : parts.files)
    if (auto taken = take(file); !taken) return tl::unexpected(taken.error());
  return std::move(parts.left_out);
}

}  // namespace kempe
