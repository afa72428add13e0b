#include "synthesis/design/tool_advice.hpp"

namespace kempe {

std::optional<ToolAdvice> tool_advice(const ToolSpec& tool, double scale) {
  if (!tool.follower_radius && !tool.cutter_radius) return std::nullopt;
  ToolAdvice advice{.follower_radius = tool.follower_radius, .cutter_radius = tool.cutter_radius};
  if (tool.cutter_radius) advice.exact_follower_radius = *tool.cutter_radius / scale;
  if (tool.follower_radius) advice.exact_cutter_radius = *tool.follower_radius * scale;
  if (tool.follower_radius && tool.cutter_radius) {
    advice.cut_outside = scale * *tool.follower_radius - *tool.cutter_radius;
    advice.template_offset = *tool.cutter_radius / scale - *tool.follower_radius;
  }
  return advice;
}

}  // namespace kempe
