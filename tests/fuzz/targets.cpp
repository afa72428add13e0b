#include "tests/fuzz/targets.hpp"

#include <array>

#include "reports/design_audit.hpp"
#include "specs/dxf_reader.hpp"
#include "specs/generator_spec.hpp"
#include "specs/geojson_reader.hpp"
#include "specs/linkage_file.hpp"
#include "specs/measurements.hpp"
#include "specs/spec_reader.hpp"
#include "specs/svg_reader.hpp"
#include "synthesis/verification.hpp"
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
  if (!stored) return;
  (void)verify(verification_task(*stored), {.outline_samples = 20, .hatch_lines = 1});
  (void)audit(*stored, file);
}

void generators(std::string_view input) {
  (void)read_function_spec(input, file);
  (void)read_inversor_spec(input, file);
}

void choices(std::string_view input) { (void)design_from_choices(input); }

constexpr std::array all{
    Target{"specs", spec},     Target{"geojson", geojson},       Target{"svg", svg},
    Target{"dxf", dxf},        Target{"linkages", linkage},      Target{"measurements", measurements},
    Target{"designs", design}, Target{"generators", generators}, Target{"choices", choices}};

}  // namespace

std::span<const Target> targets() { return all; }

const Target* find(std::string_view name) {
  for (const Target& target : all)
    if (target.name == name) return &target;
  return nullptr;
}

}  // namespace kempe::fuzz
