#include "reports/part_files.hpp"

#include "reports/bom.hpp"
#include "reports/dxf_writer.hpp"
#include "reports/nesting.hpp"
#include "reports/part_drawings.hpp"
#include "reports/part_solid.hpp"
#include "reports/step_assembly.hpp"
#include "reports/svg_writer.hpp"

namespace kempe {
namespace {

std::vector<CutPart> parts_of_design(const Design& design, const CuttingSpec& cutting) {
  const auto parts = cut_parts(design, cutting);
  return {parts.begin(), parts.end()};
}

}  // namespace

std::vector<OutputFile> part_files(const Design& design, const CuttingSpec& cutting) {
  const std::vector<CutPart> parts = parts_of_design(design, cutting);
  std::vector<OutputFile> files;
  for (const CutPart& part : parts) {
    const std::string stem = "parts/" + part.name;
    const Drawing drawing = part_drawing(part);
    files.push_back({stem + ".dxf", dxf_text(drawing)});
    files.push_back({stem + ".svg", svg_text(drawing, "Link " + part.name)});
    files.push_back({stem + ".stl", stl_bytes(part_solid(part), "link " + part.name)});
  }
  if (auto step = step_assembly(design, cutting)) files.push_back({"parts/assembly.step", std::move(*step)});
  files.push_back({"bom.csv", bom_csv(design)});
  if (!cutting.sheet) return files;
  if (const auto nested = nest(parts, *cutting.sheet, cutting.gap))
    files.push_back({"nested.dxf", dxf_text(nested_drawing(parts, *nested, *cutting.sheet))});
  return files;
}

std::optional<std::string> nesting_fault(const Design& design, const CuttingSpec& cutting) {
  if (!cutting.sheet) return std::nullopt;
  const auto nested = nest(parts_of_design(design, cutting), *cutting.sheet, cutting.gap);
  return nested ? std::nullopt : std::optional(nested.error());
}

}  // namespace kempe
