#pragma once
// What the page's scripts know of the design, as JSON; its only source, so that the page decides nothing
// itself.

#include <string>

#include "reports/pictures/map_picture.hpp"

namespace kempe {

/// One JSON object. Points are [x, y] in mm, table frame, y upward; angles rad; complex numbers [re, im];
/// joints are indices into "VABCXY". Regions and obstacles are thinned to what the picture can show.
std::string report_model(const Design& design, const MapPicture& picture);

/// Of that what draws the linkage and moves it: k, s, vertex, VA, VB, pole, assembly, joints, width, pin_radius and bodies.
std::string linkage_model(const CopyingLinkage& linkage, const LayerAssignment& layers,
                          const LinkStyle& style);

}  // namespace kempe
