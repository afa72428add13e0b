#pragma once
// Which discrete choices a search has to look at.

#include <vector>

#include "synthesis/design_problem.hpp"
#include "synthesis/requirements.hpp"

namespace kempe {

/// A choice with the pairs of parts that must keep their clearance.
struct ContactChoice {
  Choice choice;
  ContactTerms terms;
};

/// Every grounding that the spec permits, assembly and layer assignment, in that order, without those that
/// cannot be better than one before or after them: where another assignment of the same grounding and
/// assembly must keep apart only some of the same pairs (and stays clear of the same obstacles), and, for
/// straight plates without obstacles, the mirror image of an assembly.
std::vector<ContactChoice> choices_of(const Spec& spec);

}  // namespace kempe
