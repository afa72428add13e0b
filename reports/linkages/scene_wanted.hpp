#pragma once
// The places that a generated linkage was asked for, as its page shows them: numbered in the picture, with their deviations beside it.

#include <optional>
#include <string>
#include <vector>

#include "reports/linkages/picture.hpp"
#include "reports/linkages/scene.hpp"

namespace kempe {

/// A place asked for, and the one that the linkage reaches. mm, rad, y upward.
struct WantedPlace {
  Point at = Point::Zero(), reached = Point::Zero();
  std::optional<double> angle,
      reached_angle;  ///< both or none: directions of the body that carries the point, for poses
  double share = 0;   ///< of the motion, 0 to 1, after which it is reached
};

/// Adds them to a scene and widens its box by them; `point` is the name of the point that shall take them.
void add_wanted_places(const LinkageFile& file, const std::vector<WantedPlace>& places,
                       const std::string& point, LinkageScene& scene);

/// The numbered rings, a pose's with the axes of its frame, as SVG elements; empty where nothing was asked for.
std::string wanted_marks(const LinkageScene& scene, const PictureScale& scale);

/// Of poses, the axes that the link with the point carries with it, in its own frame; empty for other links, and without poses.
std::string carried_axes(const LinkageScene& scene, std::size_t body, const PictureScale& scale);

/// A sentence that says what the rings are and how far off the linkage is at most.
std::string wanted_sentence(const LinkageScene& scene);

/// The table of wanted and reached places as an HTML element; each row has a button that leads to its moment.
std::string wanted_table(const LinkageScene& scene);

}  // namespace kempe
