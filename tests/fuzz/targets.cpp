#include "tests/fuzz/targets.hpp"

#include <array>
#include <cstdlib>
#include <vector>

#include "geometry/regions/region_checks.hpp"
#include "reports/audit/design_audit.hpp"
#include "specs/drawings/drawing_cover.hpp"
#include "specs/drawings/dxf_reader.hpp"
#include "specs/drawings/geojson_reader.hpp"
#include "specs/drawings/svg_reader.hpp"
#include "specs/generator_spec.hpp"
#include "specs/json_spec.hpp"
#include "specs/linkages/linkage_file.hpp"
#include "specs/measurements.hpp"
#include "specs/spec_reader.hpp"
#include "synthesis/verification/verification.hpp"
#include "tests/fuzz/degenerate_linkages.hpp"
#include "tests/fuzz/structured.hpp"

namespace kempe::fuzz {
namespace {

constexpr const char* file = "input";

void spec(std::string_view input) { (void)read_spec(input, file, "."); }
void geojson(std::string_view input) { (void)read_geojson_region(input, file, {}); }
void svg(std::string_view input) { (void)read_svg_region(input, file, {}); }
void dxf(std::string_view input) { (void)read_dxf_region(input, file, {}); }
void linkage(std::string_view input) { (void)parse_linkage_file(input, file); }
void measurements(std::string_view input) { (void)read_measurements(input, file); }

void design(std::string_view input) {
  const auto stored = read_design(input, file);
  if (stored) (void)verify(verification_task(*stored), {.outline_samples = 20, .hatch_lines = 1});
}

/// All that `kempe verify` looks at, the map included: some hundred times the work of the above.
void whole_audit(std::string_view input) {
  if (const auto stored = read_design(input, file)) (void)audit(*stored, file);
}

void generators(std::string_view input) {
  (void)read_function_spec(input, file);
  (void)read_inversor_spec(input, file);
  (void)read_path_spec(input, file);
}

/// The bytes as a drawing: strokes of small whole numbers, which cross, touch and fold back, grown by a margin. What comes
/// of it must keep the invariant of regions and contain the strokes' own corners where it is said to.
void scribbles(std::string_view input) {
  std::size_t at = 0;
  const auto byte = [&]() -> int { return at < input.size() ? static_cast<unsigned char>(input[at++]) : 0; };
  const Cover covers[] = {Cover::outline, Cover::outline, Cover::strokes, Cover::hull};
  RegionFileOptions options;
  options.cover = covers[byte() % 4];
  options.margin = byte() % 16 / 4.0;
  const double fraction = byte() % 2 == 0 ? 1 : 1 / 3.0;  // of a unit: thirds are no doubles
  constexpr std::size_t most_corners = 200;
  std::vector<DrawnStroke> strokes(1);
  for (std::size_t i = 0; 2 * i + 3 < input.size() && i < most_corners; ++i) {
    const int x = byte(), y = byte();
    if (x == 255) {
      strokes.back().closed = y % 2 == 0;
      strokes.emplace_back();
    } else {
      strokes.back().points.emplace_back(x * fraction, y * fraction);
    }
  }
  strokes.back().closed = true;
  std::erase_if(strokes, [](const DrawnStroke& stroke) { return stroke.points.size() < 2; });
  const auto region = covered_region(strokes, "", file, options);
  if (!region) return;
  std::vector<Ring> outers, holes;
  for (const Polygon& polygon : region->polygons) {
    outers.push_back(polygon.outer);
    holes.insert(holes.end(), polygon.holes.begin(), polygon.holes.end());
  }
  if (!assemble_region(outers, holes)) std::abort();
  if (options.cover != Cover::hull && options.cover != Cover::strokes) return;
  for (const DrawnStroke& stroke : strokes)
    for (const Point& corner : stroke.points)
      if (distance(*region, corner) > 1e-9) std::abort();
}

void lines(std::string_view input) {
  if (const auto text = toml_from_json(std::string(input), file)) (void)read_spec(*text, file, ".");
}

void motions(std::string_view input) { (void)move_linkage_from_choices(input); }

void choices(std::string_view input) { (void)design_from_choices(input); }

constexpr std::array all{Target{"specs", spec},
                         Target{"geojson", geojson},
                         Target{"svg", svg},
                         Target{"dxf", dxf},
                         Target{"linkages", linkage},
                         Target{"measurements", measurements},
                         Target{"designs", design},
                         Target{"audits", whole_audit},
                         Target{"generators", generators},
                         Target{"scribbles", scribbles},
                         Target{"lines", lines},
                         Target{"motions", motions},
                         Target{"choices", choices}};

}  // namespace

std::span<const Target> targets() { return all; }

const Target* find(std::string_view name) {
  for (const Target& target : all)
    if (target.name == name) return &target;
  return nullptr;
}

}  // namespace kempe::fuzz
