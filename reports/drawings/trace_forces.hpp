#pragma once
// What the hand feels along a traced drawing, as a table and as colours along the copy.

#include <cstddef>
#include <string>

#include "synthesis/verification/drawing_trace.hpp"

namespace kempe {

/// stroke, tracer_x_mm, tracer_y_mm, hand_x_N, hand_y_N, hand_N, friction_N, pole_N, pin_A_N, pin_B_N, pin_C_N, pin_V_N, mass_felt_kg,
/// give_x_mm, give_y_mm: a row for each pose that was reached; at a dead point all after the tracer's place is empty. Needs
/// TraceOptions::keep_poses.
std::string forces_csv(const Trace& trace, const HandWork& work);

/// The hand's forces over what was drawn.
struct HandForces {
  double least = infinity, most = 0;  ///< N, of the finite ones; least > most: there is none
  std::size_t dead_points = 0;        ///< positions where no force holds the pen
  bool any() const { return least <= most; }
};
/// Needs TracedLine::hand.
HandForces hand_forces(const Trace& trace);

/// The lines drawn, each in pieces coloured by the hand's force, and a legend below `box`; SVG elements, y turned downward. Needs
/// TracedLine::hand.
std::string coloured_by_hand(const Trace& trace, const Box& box);
/// mm that the legend takes below the box.
inline constexpr double legend_height = 12;

}  // namespace kempe
