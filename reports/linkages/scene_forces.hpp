#pragma once
// The forces of a moving linkage as the page of an animation shows them.

#include <optional>
#include <string>

#include "reports/linkages/forces.hpp"
#include "reports/linkages/scene.hpp"

namespace kempe {

/// Adds to every moment of a scene, whose moments are the run's frames, the arrows of the forces at points and of the
/// drivers, the values of these, and the forces in joints, guides and bars. Nothing without loads.
void add_scene_forces(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run,
                      LinkageScene& scene);

/// Chooses the arrows' scale by the scene's box, and widens the box so that all of them lie in it.
void fit_arrows(LinkageScene& scene);

/// What the page's script needs, as JSON: the drivers' labels and units, the arrows' count and scale, a row for each moment: the
/// drivers' values, then x, y of each arrow's tip and its components. The same of the reactions, null where there are none.
/// "null" without loads.
std::string scene_forces_json(const LinkageScene& scene);

}  // namespace kempe
