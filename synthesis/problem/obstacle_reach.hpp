#pragma once
// Which obstacles can any permitted instrument touch at all?
//
// V, X and Y are the pole, the tracer and the pen in some order, so wherever the tracer covers the region they stand at
// places that no length changes: the pole in its area, the tracer in the region, the pen at pole + k (tracer - pole). Every
// link hangs at one of them:
//     bar VA within VA of V,  bar VB within VB of V,  plate ACX within max(AX, CX) of X,  plate BCY within max(BY, CY) of Y,
// and pins and posts stand at joints of links. The limits and locks bound each of these lengths. An obstacle farther from
// the box around these places than that length, half the width and the clearance is touched by no permitted instrument.

#include <string>
#include <vector>

#include "synthesis/problem/requirements.hpp"

namespace kempe {

/// For every obstacle of the spec: may a part of a design that keeps `limits`, with the spec's ratio, groundings and locked
/// lengths, come nearer to it than the clearance while the tracer covers the region? False is certain.
std::vector<bool> obstacles_in_reach(const Spec& spec, const Requirements& limits);

/// The spec with those obstacles alone: it has the same designs.
Spec with_obstacles_in_reach(const Spec& spec, const Requirements& limits);

/// The names of the others, for the spec's own limits, in the spec's order.
std::vector<std::string> names_out_of_reach(const Spec& spec);

}  // namespace kempe
