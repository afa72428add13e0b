#pragma once
// Which discrete choices a search has to look at.

#include <vector>

#include "synthesis/problem/design_problem.hpp"
#include "synthesis/problem/requirements.hpp"

namespace kempe {

/// A choice with the pairs of parts that must keep their clearance.
struct ContactChoice {
  Choice choice;
  ContactTerms terms;
  /// Straight plates without obstacles: the mirror image of a choice before it, about the line from the pole to the
  /// tracer. It differs from that one in its footprint alone.
  bool is_mirror_image = false;
};

/// Every grounding that the spec permits, assembly mode and layer assignment, in that order, without those that
/// cannot be better than one before or after them: where another assignment of the same grounding and
/// assembly mode, no higher and with no longer pins if the sag is limited, demands only what this one demands too
/// (layer_demands.hpp).
std::vector<ContactChoice> choices_of(const Spec& spec);

}  // namespace kempe
