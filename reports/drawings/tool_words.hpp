#pragma once
// Follower, cutter and template in words, for summary, report and bill.

#include <optional>
#include <string>
#include <vector>

#include "synthesis/design/tool_advice.hpp"

namespace kempe {

/// A sentence each: the pair that cuts the exact copy, and what the pair given does to the cut. Empty without [tool].
std::vector<std::string> tool_words(const std::optional<ToolAdvice>& tool);

/// "draw the template 0.7 mm larger all around"; empty where the cut is right as it is, or one of the two is not given.
std::string template_words(const std::optional<ToolAdvice>& tool);

}  // namespace kempe
