#pragma once

#include <string>

#include "synthesis/design/design.hpp"

namespace kempe::app {

/// The summary's lines about sag, friction, mass and balance; empty without [material].
std::string weight_lines(const Design& design);

}  // namespace kempe::app
