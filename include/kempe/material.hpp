#pragma once
// What links are made of, as their stiffness, weight and strength see it.

#include <string>

namespace kempe {

/// A material, taken as elastic and the same in every direction. docs/loads.md lists those that a spec can name, with sources.
struct Material {
  std::string name{};   ///< "steel", or what the spec calls it; for people
  double E = 0;         ///< MPa (N/mm^2), > 0: modulus of elasticity
  double density = 0;   ///< kg/m^3, > 0
  double strength = 0;  ///< MPa, > 0: what the largest stress in a link is compared with
  bool operator==(const Material&) const = default;
};

}  // namespace kempe
