#pragma once

#include <string>

#include "synthesis/design/design.hpp"

namespace kempe::app {

/// The summary's lines about sag, friction, mass and balance; empty without [material].
std::string weight_lines(const Design& design);

/// The whole error of the made and loaded instrument, part by part, and what would help most. Empty without a load.
std::string budget_lines(const Design& design);

}  // namespace kempe::app
