#pragma once
// Instant centres drawn on the linkage.

#include <string>
#include <vector>

#include "kinematics/planar/instant_centres.hpp"
#include "reports/linkages/scene.hpp"

namespace kempe {

/// An SVG of one moment: the links, every finite centre within reach with its links' numbers, the two lines
/// that gave it, arrows for centres at infinity or far away, and a legend that numbers the links. `scene`
/// holds that one moment; `unit` is mm a unit of the scene.
std::string centres_svg(const LinkageScene& scene, const std::vector<InstantCentre>& centres, double unit);

/// The same as an element <svg id="centres"> for a page that lists the links and says by a style sheet how things look: no legend, and
/// each centre's lines (g.lines), dot and label tell by data-centre or data-centres whose they are.
std::string centres_drawing(const LinkageScene& scene, const std::vector<InstantCentre>& centres,
                            double unit);

}  // namespace kempe
