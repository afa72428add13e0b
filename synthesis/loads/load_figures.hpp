#pragma once
// What the load does to a design over its region.

#include <optional>

namespace kempe {

/// The worst of each over the openings that the region uses, and over all directions of the force at the pen.
struct LoadFigures {
  double error_max = 0;       ///< mm, most that the pen gives way, in the plane
  double error_min = 0;       ///< mm, that it gives way in the stiffest direction at the stiffest opening
  double pin_force_max = 0;   ///< N, at the pin (A, B, C, V or the pole's) that bears most
  double hand_force_max = 0;  ///< N, at the tracer
  double stress_max =
      0;  ///< MPa, in the link that is strained most: bending and pull in the plane, across the joint's hole
  /// mm, most that the pen gives way in the plane by the links' own weight; absent on a level table. On a tilted one pin_force_max and
  /// stress_max have that weight too.
  std::optional<double> weight_error_max{};
};

/// The worst of each with the links in their layers and pins that give way (layer_offsets.hpp), over the same openings and directions.
struct LayeredFigures {
  double error_max = 0;  ///< mm, most that the pen gives way in the plane: links, pins and layers together
  double rise_max = 0;   ///< mm, most that tracer or pen rises or sinks under the load
  /// MPa, in the link that is strained most: with bending and twist out of the plane. Absent where a hole leaves nothing of a link or moments
  /// lose their digits.
  std::optional<double> stress_max{};
  /// mm, by the links' own weight along a tilted table: most that the pen gives way in the plane with links, pins and layers together, and that
  /// tracer or pen rises or sinks. Absent on a level table.
  std::optional<double> weight_error_max{}, weight_rise_max{};
};

}  // namespace kempe
