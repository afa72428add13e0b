#pragma once
// The motion of a linkage as the page of an animation plots it: drivers, velocities, accelerations, and where links turn back.

#include <string>

#include "reports/linkages/scene.hpp"

namespace kempe {

/// Adds to every moment of a scene, whose moments are the run's frames, the drivers' values and the rates of all links, and to the
/// scene the marks: where a link or a slider turns back under one driver, found between two moments by a straight line through its
/// rates, and where the motion stopped.
void add_scene_motion(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run, int steps,
                      LinkageScene& scene);

/// What the page's script needs, as JSON: names of points and links, the drivers' labels, units and values, and for each moment six
/// numbers a moving link (velocities x, y, angle, then accelerations; null where there are none), y downward; the marks.
std::string scene_motion_json(const LinkageScene& scene);

}  // namespace kempe
