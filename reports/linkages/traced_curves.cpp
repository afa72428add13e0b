#include "reports/linkages/traced_curves.hpp"

#include <algorithm>

namespace kempe {

std::ptrdiff_t links_with(const LinkageFile& file, const std::string& name) {
  return std::count_if(file.links.begin(), file.links.end(), [&](const FileLink& link) {
    return std::any_of(link.joints.begin(), link.joints.end(),
                       [&](const auto& joint) { return joint.first == name; });
  });
}

std::vector<std::size_t> traced_points(const LinkageFile& file, const LinkageModel& model,
                                       const std::vector<ScenePoint>& points) {
  std::vector<std::size_t> traced;
  for (const std::string& name : file.output.trace) traced.push_back(model.point_numbers.at(name));
  if (!traced.empty()) return traced;
  for (const ScenePoint& point : points)
    if (!point.fixed && links_with(file, point.name) <= 1)
      traced.push_back(model.point_numbers.at(point.name));
  return traced;
}

std::string trace_curve(const LinkageScene& scene, std::size_t traced, const PictureScale& scale) {
  const ScenePoint& point = scene.points[traced];
  std::string data;
  for (const auto& moment : scene.moments)
    data += (data.empty() ? "M" : " L") + scale.pair(scene.place(point, moment));
  return drawn("path", "trace", scale)
      .with("stroke", link_colour(point.body))
      .with("stroke-width", scale.number(1.4 * scale.stroke))
      .with("d", data)
      .holding(SvgElement("title").saying(point.name).text())
      .text();
}

}  // namespace kempe
