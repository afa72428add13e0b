#pragma once
// A moving linkage as one file to open: an HTML page with a slider, or an SVG that plays by itself.

#include <string>

#include "reports/linkages/scene.hpp"

namespace kempe {

/// A self-contained page (no network): the linkage on its traced curves with dots equal in time, play button, slider over the
/// steps, speed, names on and off, and the coordinates of the traced points; arrows and polygons of velocities and accelerations,
/// reactions where there are loads; plots of any point, link or reaction over the driver; marks where the motion stands out; wanted
/// places with their deviations. A
/// point may be taken by hand. Works from the keyboard: space, left, right, N, V, A, R.
std::string animation_html(const LinkageScene& scene);

/// An SVG with SMIL animation, back and forth unless the motion runs around. Without a player it shows the
/// start.
std::string animation_svg(const LinkageScene& scene);

}  // namespace kempe
