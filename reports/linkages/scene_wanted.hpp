#pragma once
// The places that a generated linkage was asked for, as its page shows them: numbered in the picture, with their deviations beside it.

#include <string>
#include <vector>

#include "kempe/linkage.hpp"
#include "reports/linkages/picture.hpp"
#include "reports/linkages/scene.hpp"

namespace kempe {

/// Adds them to a scene and widens its box by them; `point` is the name of the point that shall take them.
void add_wanted_places(const LinkageFile& file, const std::vector<PlaceAskedFor>& places,
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
