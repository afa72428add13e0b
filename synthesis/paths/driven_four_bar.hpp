#pragma once
// A four-bar with its coupler point as bodies and joints of the general solver.

#include <optional>

#include "kinematics/planar/linkage.hpp"
#include "synthesis/paths/coupler_four_bar.hpp"

namespace kempe {

struct DrivenFourBar {
  PlanarLinkage linkage;  ///< joints "A0", "A", "B", "B0" and the driver
  PlanarPosition guess;   ///< for the ground and its three bodies
  int crank = 0, coupler = 0, rocker = 0;
  CouplerFourBar::Place place;  ///< where the joints are at the start, mm
};

/// The linkage with its driver at `angle` (rad, from the x axis), `start` being the crank's angle there. Nothing where it does not close.
std::optional<DrivenFourBar> driven_four_bar(const CouplerFourBar& linkage, CognateDriver driver,
                                             double angle, double start);

}  // namespace kempe
