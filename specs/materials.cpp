// Rounded to what a builder can count on: of a range that data sheets give, the softer or weaker end.
#include "specs/materials.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

namespace kempe {
namespace {

constexpr KnownMaterial materials[] = {
    {"steel", 200, 7850, 235, 0,
     "structural steel S235: E as in ANSI/AISC 360, density as in EN 1991-1-1, yield strength as in EN "
     "10025-2"},
    {"aluminium", 70, 2700, 150, 0,
     "EN AW-6060 T66: E and density as in EN 1999-1-1, 0.2 % proof stress of extruded profiles as in EN "
     "755-2"},
    {"brass", 102, 8440, 230, 0,
     "CuZn38Pb2 (CW608N): E and density as in suppliers' data sheets, 0.2 % proof stress of temper R410 as "
     "in EN 12164"},
    {"birch plywood", 8, 680, 35, 0.6,
     "Handbook of Finnish Plywood: tension and compression across the face grain, rounded down, since links "
     "lie in any direction; edgewise shear modulus of plywood, 0.586 to 0.758 GPa, as in MatWeb's data "
     "sheet"},
    {"PLA", 3, 1240, 26, 0,
     "printed solid: suppliers' data sheets give E of 2.5 to 4 GPa; the yield stress is that of the weaker "
     "build direction"},
    {"acrylic", 3, 1190, 70, 0, "cast PMMA sheet: the least values that ISO 7823-1 asks for"},
};

}  // namespace

std::span<const KnownMaterial> known_materials() { return materials; }

const KnownMaterial* material_named(std::string_view name) {
  const auto* found = std::find_if(std::begin(materials), std::end(materials),
                                   [&](const KnownMaterial& each) { return each.name == name; });
  return found == std::end(materials) ? nullptr : found;
}

Material as_material(const KnownMaterial& known) {
  return {std::string(known.name), MPa_per_GPa * known.E_GPa, known.density, known.strength,
          known.G_GPa > 0 ? std::optional(MPa_per_GPa * known.G_GPa) : std::nullopt};
}

}  // namespace kempe
