#pragma once
// What links are made of, as their stiffness, weight and strength see it.

#include <optional>
#include <string>

namespace kempe {

/// A material, taken as elastic and the same in every direction. docs/loads.md lists those that a spec can name, with sources.
struct Material {
  std::string name{};         ///< "steel", or what the spec calls it; for people
  double E = 0;               ///< MPa (N/mm^2), > 0: modulus of elasticity
  double density = 0;         ///< kg/m^3, > 0
  double strength = 0;        ///< MPa, > 0: what the largest stress in a link is compared with
  std::optional<double> G{};  ///< MPa, > 0: shear modulus; absent: E / 2.6, as of Poisson's ratio 0.3
  /// MPa
  double shear_modulus() const { return G.value_or(E / 2.6); }
  bool operator==(const Material&) const = default;
};

}  // namespace kempe
