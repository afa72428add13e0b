#pragma once
// A moving linkage as one file to open: an HTML page with a slider, or an SVG that plays by itself.

#include <string>

#include "reports/linkages/scene.hpp"

namespace kempe {

/// A self-contained page (no network): the linkage on its traced curves, play button, slider over the steps,
/// speed, names on and off, and the coordinates of the traced points. Works from the keyboard: space, left,
/// right.
std::string animation_html(const LinkageScene& scene);

/// An SVG with SMIL animation, back and forth unless the motion runs around. Without a player it shows the
/// start.
std::string animation_svg(const LinkageScene& scene);

}  // namespace kempe
