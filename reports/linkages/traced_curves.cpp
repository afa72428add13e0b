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

std::size_t beat_of(const LinkageScene& scene) {
  double longest = 0;
  for (const std::size_t traced : scene.traced) {
    double length = 0;
    for (std::size_t i = 1; i < scene.moments.size(); ++i)
      length += (scene.place(scene.points[traced], scene.moments[i]) -
                 scene.place(scene.points[traced], scene.moments[i - 1]))
                    .norm();
    longest = std::max(longest, length);
  }
  constexpr double apart = 0.03;  // of the picture: dots of an even motion do not touch
  const double dots = std::clamp(longest / (apart * std::max(scene.extent(), 1e-300)), 6., 36.);
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(static_cast<double>(scene.moments.size() - 1) / dots));
}

std::string trace_beats(const LinkageScene& scene, std::size_t traced, const PictureScale& scale) {
  const ScenePoint& point = scene.points[traced];
  std::string dots;
  for (std::size_t i = 0; i < scene.moments.size(); i += beat_of(scene)) {
    const Point at = scene.place(point, scene.moments[i]);
    dots += SvgElement("circle")
                .with("cx", scale.number(at.x()))
                .with("cy", scale.number(at.y()))
                .with("r", scale.number(1.7 * scale.stroke))
                .text();
  }
  return SvgElement("g").with("class", "beats").with("fill", link_colour(point.body)).holding(dots).text();
}

}  // namespace kempe
