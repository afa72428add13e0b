#pragma once
// Bodies that begin above the links of the point that carries them.

#include <string>
#include <vector>

#include "reports/drawings/joint_stack.hpp"

namespace kempe {

/// mm: how far above a tracer's or pen's own stack a body begins that this point carries; 0 where it begins beside it or on it.
double height_above(const Design& design, const Body& body, const JointStack& stack);

/// A sentence for each such body: contact knows the body and the stack, and not what joins them; and which links pass there too near.
std::vector<std::string> mounting_words(const Design& design);

}  // namespace kempe
