#pragma once
// Coupler curves: which points of a moving linkage are traced, and what they draw.

#include <string>
#include <vector>

#include "reports/linkages/picture.hpp"

namespace kempe {

/// How many links of the file have a joint of this name.
std::ptrdiff_t links_with(const LinkageFile& file, const std::string& name);

/// The traced points by their numbers in `points`, which are the model's: those that the file names in output.trace; if it
/// names none, every point of a driver path and every joint that belongs to one link only.
std::vector<std::size_t> traced_points(const LinkageFile& file, const LinkageModel& model,
                                       const std::vector<ScenePoint>& points);

/// The curve of a traced point as an SVG element.
std::string trace_curve(const LinkageScene& scene, std::size_t traced, const PictureScale& scale);

/// How many moments lie between two dots on a curve: 6 to 36 dots, fewer on short curves.
std::size_t beat_of(const LinkageScene& scene);

/// Dots on a traced point's curve, equal in time: far apart where it is fast.
std::string trace_beats(const LinkageScene& scene, std::size_t traced, const PictureScale& scale);

}  // namespace kempe
