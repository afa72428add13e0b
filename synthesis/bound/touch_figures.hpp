#pragma once
// What designs of a box miss of the distances that they have to keep, to first order: for the proven bound's backends.

#include <optional>

#include "synthesis/bound/touches.hpp"
#include "synthesis/bound/tracer_place.hpp"

namespace kempe::bounding {

/// 1 - (distance / needed)^2. `near`, `far`: the places where the linkage is asked about. Nothing where no bound is known.
std::optional<FirstOrder> contact_figure(const BoxMiddle& middle, const ContactTouch& touch,
                                         const Point& near, const Point& far);

/// 1 - distance / needed, of the features that are nearest in the middle design. Nothing where they need not be what decides in the others.
std::optional<FirstOrder> obstacle_figure(const BoxMiddle& middle, const ObstacleTouch& touch);

}  // namespace kempe::bounding
