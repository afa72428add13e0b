#include "reports/drawings/tool_words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace kempe {

std::string template_words(const std::optional<ToolAdvice>& tool) {
  constexpr double none = 1e-9;  // mm
  if (!tool || !tool->template_offset || std::abs(*tool->template_offset) <= none) return "";
  return fmt::format("draw the template {:.4g} mm {} all around", std::abs(*tool->template_offset),
                     *tool->template_offset > 0 ? "larger" : "smaller");
}

std::vector<std::string> tool_words(const std::optional<ToolAdvice>& tool) {
  if (!tool) return {};
  std::vector<std::string> words;
  if (tool->exact_follower_radius)
    words.push_back(
        fmt::format("for a cutter of radius {:.4g} mm a follower of radius {:.4g} mm cuts the exact copy",
                    *tool->cutter_radius, *tool->exact_follower_radius));
  else
    words.push_back(
        fmt::format("with a follower of radius {:.4g} mm a cutter of radius {:.4g} mm cuts the exact copy",
                    *tool->follower_radius, *tool->exact_cutter_radius));
  if (const std::string offset = template_words(tool); !offset.empty())
    words.push_back(fmt::format("with the follower of radius {:.4g} mm the cut lies {:.4g} mm {}: {}",
                                *tool->follower_radius, std::abs(*tool->cut_outside),
                                *tool->cut_outside > 0 ? "outside" : "inside", offset));
  return words;
}

}  // namespace kempe
