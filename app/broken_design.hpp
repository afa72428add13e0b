#pragma once
// What a design's file states and does not hold, for a person.

#include <string>

#include "reports/audit/design_audit.hpp"

namespace kempe::app {

/// "FILE:" and a line for each limit or figure that is broken.
std::string broken_text(const DesignAudit& found, const std::string& file);

}  // namespace kempe::app
