#pragma once
// The materials that a spec can name, each with the source of its figures.

#include <span>
#include <string_view>

#include "kempe/links.hpp"

namespace kempe {

/// E stands in GPa in files and in MPa in the program.
inline constexpr double MPa_per_GPa = 1000, GPa_per_MPa = 1e-3;

/// A material with where its figures come from.
struct KnownMaterial {
  std::string_view name;            ///< as a spec writes it: "birch plywood"
  double E_GPa, density, strength;  ///< GPa, kg/m^3, MPa
  double G_GPa;                     ///< GPa; 0: E / 2.6
  std::string_view source;          ///< a sentence for docs/loads.md and the report
};

/// All of them, in the order of the documentation.
std::span<const KnownMaterial> known_materials();
/// The one of this name, or null.
const KnownMaterial* material_named(std::string_view name);
/// As the library's value.
Material as_material(const KnownMaterial& known);

}  // namespace kempe
