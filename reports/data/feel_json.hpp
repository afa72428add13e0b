#pragma once
// How an instrument feels in the hand as data: what `kempe synthesize --json` and Python's design.feel hold.

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "synthesis/design/design.hpp"

namespace kempe {

/// {"mass_min_kg", "mass_max_kg": felt at the tracer, "friction_share": of the work's drag, "hand_max_N": null where a dead point lies among the
/// openings, "weight_max_N": 0 on a level table, "counterweights", which balance it at every tilt: [{"link", "from", "arm_mm", "mass_kg", "direction_deg"}], "springs":
/// [{"link", "arm_mm", "height_mm", "rate_N_mm", "direction_deg"}], null where there are none}, as Feel has them (feel.hpp); directions
/// against the link's own side of the parallelogram. To nine digits. Nothing without a load or a material, and where the region is not reached.
std::optional<nlohmann::ordered_json> feel_values(const Design& design);

}  // namespace kempe
