#include "reports/audit/recheck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>

#include "reports/audit/slack.hpp"
#include "reports/data/design_json.hpp"
#include "reports/drawings/part_drawings.hpp"
#include "reports/drawings/part_solid.hpp"
#include "specs/drawings/dxf_reader.hpp"
#include "specs/drawings/svg_reader.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

namespace fs = std::filesystem;

double perimeter(const ArcRing& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double chord = (ring[(i + 1) % ring.size()].at - ring[i].at).norm();
    const double quarter = std::atan(std::abs(ring[i].bulge));  // of the sweep
    sum += quarter == 0 ? chord : chord * 2 * quarter / std::sin(2 * quarter);
  }
  return sum;
}

/// Holes that its drawing has: those of which the kerf leaves something.
std::size_t drawn_holes(const CutPart& part) {
  return static_cast<std::size_t>(std::count_if(part.holes.begin(), part.holes.end(),
                                                [](const auto& hole) { return hole.diameter > 0; }));
}

/// How much area flattening may take away or add along all edges of a part.
double flattening_slack(const CutPart& part, double tolerance) {
  double holes = 0;
  for (const CutPart::Hole& hole : part.holes) holes += pi * hole.diameter;
  return tolerance * (perimeter(part.outline) + holes) + audit_slack::share_of_area * area(part);
}

/// The contents of a file of the folder; nothing if it is not there; an error sentence if it cannot be read.
using Contents =
    std::function<tl::expected<std::optional<std::string>, std::string>(const std::string& file)>;

tl::expected<std::optional<std::string>, std::string> contents_of(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return std::nullopt;
  auto text = read_text_file(file);
  if (!text) return tl::unexpected(text.error().message());
  return std::optional(std::move(*text));
}

class Recheck {
 public:
  Recheck(Contents contents, const Design& design, const CuttingSpec& cutting)
      : contents_(std::move(contents)), design_(design), parts_(cut_parts(design, cutting)),
        finished_(cut_parts(design, finished(cutting))) {}

  std::vector<std::string> run() {
    check_design();
    check_dxf("drawing.dxf", parts_);
    check_dxf("nested.dxf", parts_);
    for (const CutPart& part : parts_) {
      check_dxf("parts/" + part.name + ".dxf", {&part, 1});
      check_svg(part);
    }
    for (const CutPart& part : finished_) check_solid(part);
    return std::move(faults_);
  }

 private:
  template <class... Args>
  void fault(const std::string& file, fmt::format_string<Args...> format, Args&&... args) {
    faults_.push_back(file + ": " + fmt::format(format, std::forward<Args>(args)...));
  }

  std::optional<std::string> contents(const std::string& file) {
    auto text = contents_(file);
    if (text) return std::move(*text);
    fault(file, "{}", text.error());
    return std::nullopt;
  }

  void check_design() {
    const auto text = contents("design.json");
    if (!text) return;
    const auto linkage = read_design(*text, "design.json").and_then([](const StoredDesign& stored) {
      return linkage_of(stored, "design.json");
    });
    if (!linkage) return faults_.push_back(linkage.error().message());
    const auto stored = linkage->lengths().values(), wanted = design_.linkage.lengths().values();
    for (std::size_t i = 0; i < stored.size(); ++i)
      if (std::abs(stored[i] - wanted[i]) > audit_slack::same_mm)
        fault("design.json", "{} is {}, not {} mm", LinkLengths::names[i], stored[i], wanted[i]);
  }

  void check_dxf(const std::string& file, std::span<const CutPart> parts) {
    const auto text = contents(file);
    if (!text) return;
    const auto drawing = read_dxf(*text, file);
    if (!drawing) return faults_.push_back(drawing.error().message());
    if (drawing->unit != 1) fault(file, "the unit is not mm");
    for (const CutPart& part : parts) check_layer(file, *drawing, part);
  }

  void check_layer(const std::string& file, const DxfDrawing& drawing, const CutPart& part) {
    std::vector<const DxfPolyline*> outlines;
    std::vector<const DxfCircle*> holes;
    for (const DxfEntity& entity : drawing.entities) {
      if (std::visit([](const auto& one) { return one.layer; }, entity) != part.name) continue;
      const auto* outline = std::get_if<DxfPolyline>(&entity);
      const auto* hole = std::get_if<DxfCircle>(&entity);
      if (outline != nullptr && outline->closed)
        outlines.push_back(outline);
      else if (hole != nullptr && !hole->is_arc)
        holes.push_back(hole);
      else
        fault(file, "something on the layer {} that is neither outline nor hole", part.name);
    }
    if (outlines.size() != 1 || holes.size() != drawn_holes(part))
      return fault(file, "{} outlines and {} holes on the layer {}", outlines.size(), holes.size(),
                   part.name);
    check_outline(file, *outlines.front(), part);
    check_holes(file, holes, part);
  }

  void check_outline(const std::string& file, const DxfPolyline& outline, const CutPart& part) {
    ArcRing ring;
    for (const DxfVertex& vertex : outline.vertices) ring.push_back({vertex.at, vertex.bulge});
    const double found = signed_area(ring), wanted = signed_area(part.outline);
    if (!(std::abs(found - wanted) <= audit_slack::share_of_rounding * wanted))
      fault(file, "{} encloses {} instead of {} mm2", part.name, found, wanted);
  }

  void check_holes(const std::string& file, const std::vector<const DxfCircle*>& holes, const CutPart& part) {
    for (std::size_t i = 0; i < holes.size(); ++i) {
      if (std::abs(2 * holes[i]->radius - part.holes[i].diameter) > audit_slack::same_mm)
        fault(file, "a hole of {} instead of {} mm in {}", 2 * holes[i]->radius, part.holes[i].diameter,
              part.name);
      for (std::size_t j = 0; j < i; ++j) {
        const double found = (holes[i]->centre - holes[j]->centre).norm();
        const double wanted = length_between(part.holes[i].joint, part.holes[j].joint);
        if (!(std::abs(found - wanted) <= audit_slack::same_mm))
          fault(file, "holes {} and {} of {} are {} instead of {} mm apart", letter(part.holes[j].joint),
                letter(part.holes[i].joint), part.name, found, wanted);
      }
    }
  }

  double length_between(Joint one, Joint other) const {
    const auto values = design_.linkage.lengths().values();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string_view name = LinkLengths::names[i];
      if (name.find(letter(one)) != std::string_view::npos &&
          name.find(letter(other)) != std::string_view::npos)
        return values[i];
    }
    return 0;
  }

  void check_svg(const CutPart& part) {
    const std::string file = "parts/" + part.name + ".svg";
    const auto text = contents(file);
    if (!text) return;
    constexpr double tolerance = 0.001;
    const auto drawing = read_svg(*text, file, {.tolerance = tolerance});
    if (!drawing) return faults_.push_back(drawing.error().message());
    if (drawing->strokes.size() != 1 + part.holes.size())
      return fault(file, "{} shapes", drawing->strokes.size());
    double found = 0;
    for (std::size_t i = 0; i < drawing->strokes.size(); ++i)
      found += (i == 0 ? 1 : -1) * std::abs(signed_area(drawing->strokes[i].points));
    if (!(std::abs(found - area(part)) <= flattening_slack(part, tolerance)))
      fault(file, "{} mm2 instead of {}", found, area(part));
  }

  void check_solid(const CutPart& part) {
    const std::string file = "parts/" + part.name + ".stl";
    const auto text = contents(file);
    if (!text) return;
    const auto solid = read_stl(*text);
    if (!solid) return fault(file, "{}", solid.error());
    if (!is_closed(*solid)) fault(file, "the surface is not closed");
    const double found = volume(*solid), wanted = area(part) * part.thickness;
    const double tolerance = chord_tolerance(0.5 * design_.style.width);
    if (!(std::abs(found - wanted) <= part.thickness * flattening_slack(part, tolerance)))
      fault(file, "{} mm3 instead of {}", found, wanted);
  }

  Contents contents_;
  const Design& design_;
  std::array<CutPart, 4> parts_, finished_;  ///< as cut and after it
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> recheck(const fs::path& folder, const Design& design, const CuttingSpec& cutting) {
  return Recheck([&](const std::string& file) { return contents_of(folder / file); }, design, cutting).run();
}

std::vector<std::string> recheck(const FolderDraft& draft, const Design& design, const CuttingSpec& cutting) {
  const Contents drafted =
      [&](const std::string& file) -> tl::expected<std::optional<std::string>, std::string> {
    const auto place = draft.draft_of(file);
    if (!place) return std::nullopt;
    return contents_of(*place);
  };
  return Recheck(drafted, design, cutting).run();
}

std::vector<std::string> recheck(const std::vector<OutputFile>& files, const Design& design,
                                 const CuttingSpec& cutting) {
  const Contents given =
      [&](const std::string& name) -> tl::expected<std::optional<std::string>, std::string> {
    for (const OutputFile& file : files)
      if (file.name == name) return file.contents;
    return std::nullopt;
  };
  return Recheck(given, design, cutting).run();
}

}  // namespace kempe
