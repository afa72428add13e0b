#pragma once
// Contact for the proven bound: which pairs of parts can matter, and which two points of theirs are nearest.

#include <vector>

#include "synthesis/lower_bound_box.hpp"
#include "workspace/self_contact.hpp"

namespace kempe::bounding {

/// Layer assignments of a grounding whose pairs of parts hold no other assignment's pairs: if no design keeps
/// its clearance in one of these, none does in any.
std::vector<LayerAssignment> least_layer_assignments(Complex k, Vertex vertex, int layers);

/// Two points, one of each part of a pair, that are nearest (or coincide) in a pose with these lengths and
/// opening, and how far apart they must stay, mm.
struct NearestPoints {
  MaterialPoint first, second;
  double needed = 0;
};
NearestPoints nearest_points(const ContactPair& pair, Complex shape, const LinkStyle& style, double a,
                             double b, double psi);

}  // namespace kempe::bounding
