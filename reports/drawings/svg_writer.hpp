#pragma once
// A drawing as SVG, 1:1: one user unit is one millimetre.

#include <string>
#include <string_view>

#include "reports/drawings/drawing.hpp"

namespace kempe {

/// A whole SVG document: width and height in mm, a group a layer (its id the layer's name), lines and true
/// arcs as paths, holes as circles, texts escaped. Y points down in SVG: what is up in the drawing is up on
/// the page. `margin` (mm) is left free around the drawing.
std::string svg_text(const Drawing& drawing, std::string_view title, double margin = 5);

/// An outline as path data, y turned downward, 12 decimals.
std::string outline_path(const ArcRing& ring, bool closed);

}  // namespace kempe
