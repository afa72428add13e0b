#include "reports/design_package.hpp"

#include <iterator>

#include "reports/design_drawing.hpp"
#include "reports/design_json.hpp"
#include "reports/dxf_writer.hpp"
#include "reports/links_csv.hpp"
#include "reports/part_files.hpp"
#include "reports/svg_writer.hpp"
#include "reports/workspace_geojson.hpp"

namespace kempe {

std::vector<OutputFile> design_package(const Design& design, const CuttingSpec& cutting,
                                       const ReportExtras& extras) {
  const Drawing drawing = design_drawing(design, cutting);
  std::vector<OutputFile> files{{"design.json", design_json(design)},
                                {"links.csv", links_csv(design)},
                                {"drawing.dxf", dxf_text(drawing)},
                                {"drawing.svg", svg_text(drawing, drawing_title(design))},
                                {"workspace.geojson", workspace_geojson(design)},
                                {"report.html", html_report(design, extras)}};
  std::vector<OutputFile> parts = part_files(design, cutting);
  files.insert(files.end(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
  return files;
}

}  // namespace kempe
