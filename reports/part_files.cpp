#include "reports/part_files.hpp"

#include <fmt/format.h>

#include <iterator>

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

std::optional<std::string> holes_fault(const Design& design, const CuttingSpec& cutting) {
  for (const CutPart& part : cut_parts(design, cutting))
    for (auto one = part.holes.begin(); one != part.holes.end(); ++one)
      for (auto other = std::next(one); other != part.holes.end(); ++other) {
        const double apart = (one->centre - other->centre).norm();
        if (apart < part.hole_diameter)
          return fmt::format(
              "link {} has its holes {} and {}, {:.6g} mm wide, {:.6g} mm apart; links.shortest_mm above "
              "{:.6g} "
              "keeps them apart, or thinner pins",
              part.name, letter(one->joint), letter(other->joint), part.hole_diameter, apart,
              part.hole_diameter);
      }
  return std::nullopt;
}

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
