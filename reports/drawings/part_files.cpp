#include "reports/drawings/part_files.hpp"

#include <fmt/format.h>

#include "reports/drawings/bom.hpp"
#include "reports/drawings/dxf_writer.hpp"
#include "reports/drawings/nesting.hpp"
#include "reports/drawings/part_drawings.hpp"
#include "reports/drawings/part_solid.hpp"
#include "reports/drawings/parts_fault.hpp"
#include "reports/drawings/step_assembly.hpp"
#include "reports/drawings/svg_writer.hpp"

namespace kempe {
namespace {

std::vector<CutPart> parts_of_design(const Design& design, const CuttingSpec& cutting) {
  const auto parts = cut_parts(design, cutting);
  return {parts.begin(), parts.end()};
}

void add_drawings(PartFiles& parts, const CutPart& part) {
  const std::string stem = "parts/" + part.name;
  const Drawing drawing = part_drawing(part);
  parts.files.push_back({stem + ".dxf", dxf_text(drawing)});
  parts.files.push_back({stem + ".svg", svg_text(drawing, "Link " + part.name)});
}

/// `part`: finished, since what prints or mills a solid allows for its own tool.
void add_solid(PartFiles& parts, const CutPart& part) {
  const std::string stem = "parts/" + part.name;
  if (const Solid solid = part_solid(part); !solid.empty())
    parts.files.push_back({stem + ".stl", stl_bytes(solid, "link " + part.name)});
  else
    parts.left_out.push_back(fmt::format(
        "no {}.stl: at this size the format's numbers cannot hold a wall of {:.6g} mm", stem, part.wall));
}

void add_nested(PartFiles& result, const std::vector<CutPart>& parts, const CuttingSpec& cutting) {
  const auto nested = nest(parts, *cutting.stock_sheet, cutting.gap);
  if (nested)
    result.files.push_back({"nested.dxf", dxf_text(nested_drawing(parts, *nested, *cutting.stock_sheet))});
  else
    result.left_out.push_back("no nested.dxf: " + nested.error());
}

void add_assembly(PartFiles& result, const Design& design, const CuttingSpec& cutting, const StopFlag& stop) {
  if (stop()) return result.left_out.push_back("parts/assembly.step is left out: the time was over.");
  if (auto step = step_assembly(design, cutting))
    result.files.push_back({"parts/assembly.step", std::move(*step)});
  else
    result.left_out.push_back(step.error());
}

}  // namespace

PartFiles part_files(const Design& design, const CuttingSpec& cutting, const StopFlag& stop) {
  PartFiles result;
  const auto fault = parts_fault(design, cutting);
  const std::vector<CutPart> parts = fault ? std::vector<CutPart>{} : parts_of_design(design, cutting);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    add_drawings(result, parts[i]);
    add_solid(result, cut_part(design, all_links[i], finished(cutting)));
  }
  if (fault)
    result.left_out.push_back("no files of the parts: " + fault->sentence);
  else
    add_assembly(result, design, cutting, stop);
  result.files.push_back({"bom.csv", bom_csv(design)});
  if (cutting.stock_sheet && !fault) add_nested(result, parts, cutting);
  return result;
}

}  // namespace kempe
