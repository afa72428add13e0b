#pragma once
// workspace.geojson: the map for other programs, a Feature a layer.

#include <string>

#include "synthesis/design/design.hpp"

namespace kempe {

/// A FeatureCollection with the structure of RFC 7946; the coordinates are mm in the table's frame, not
/// degrees.
///
/// Every feature's properties have `layer` (reachable, usable, collision_free, uncertain, region, copy,
/// copy_workspace, obstacles, footprint: each stands once, perhaps empty; obstacles once each with their
/// layers; lost areas with `cause` and `parts`; transmission contours with `transmission_deg`) and
/// `tolerance_mm`. Arcs are flattened to within `tolerance` (mm, > 0): free sets shrink, forbidden and
/// uncertain ones grow.
std::string workspace_geojson(const Design& design, double tolerance = 0.01);

}  // namespace kempe
