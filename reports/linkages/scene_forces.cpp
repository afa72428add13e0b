#include "reports/linkages/scene_forces.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace kempe {
namespace {

constexpr double longest_arrow = 0.2;  ///< of the picture's extent

/// A place or a force of the table as the page has it: y downward.
Point page_vector(const Point& p) { return {p.x(), -p.y()}; }

bool turns_a_link(const LinkageModel& model, std::size_t driver) {
  const auto number = static_cast<std::size_t>(model.linkage.drivers()[driver]);
  return std::holds_alternative<RelativeAngle>(model.linkage.constraints()[number].constraint);
}

/// The point that a driver pushes; nothing of one that turns a link or pushes two points apart.
std::optional<BodyPoint> pushed_by(const LinkageModel& model, std::size_t driver) {
  const auto number = static_cast<std::size_t>(model.linkage.drivers()[driver]);
  const auto* along = std::get_if<Coordinate>(&model.linkage.constraints()[number].constraint);
  return along ? std::optional(along->point) : std::nullopt;
}

std::string force_or_null(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "null";
}

}  // namespace

void add_scene_forces(const LinkageModel& model, const PlanarRun& run, double unit, LinkageScene& scene) {
  if (model.loads.empty()) return;
  const std::size_t drivers = model.linkage.drivers().size();
  for (std::size_t driver = 0; driver < drivers; ++driver)
    scene.drivers.push_back(
        {model.driver_label(static_cast<int>(driver)), turns_a_link(model, driver) ? "N m" : "N"});
  ForceFinder finder(model);
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const PlanarPosition& position = run.frames[i].position;
    LinkageScene::Moment& moment = scene.moments[i];
    const auto add_arrow = [&](const BodyPoint& at, const Point& force) {
      moment.arrows.push_back({page_vector(place(position, at) / unit), page_vector(force)});
    };
    for (const PointForce& force : model.loads.forces)
      add_arrow(force.at, turned(position, force.turns_with, force.newton));
    const auto reactions = finder.at(run.frames[i]);
    for (std::size_t driver = 0; driver < drivers; ++driver) {
      const Reaction reaction =
          reactions ? (*reactions)[static_cast<std::size_t>(model.linkage.drivers()[driver])] : Reaction{};
      moment.driver_forces.push_back(
          reactions ? std::optional(reaction.along / (turns_a_link(model, driver) ? moment_unit : 1))
                    : std::nullopt);
      if (const auto at = pushed_by(model, driver)) add_arrow(*at, reaction.force);
    }
  }
}

void fit_arrows(LinkageScene& scene) {
  for (const auto& moment : scene.moments)
    for (const SceneArrow& arrow : moment.arrows)
      scene.largest_force = std::max(scene.largest_force, arrow.force.norm());
  if (!(scene.largest_force > 0)) return;
  scene.arrow_scale = longest_arrow * scene.extent() / scene.largest_force;
  for (const auto& moment : scene.moments)
    for (const SceneArrow& arrow : moment.arrows) {
      const Point tail = arrow.at - scene.arrow_scale * arrow.force;
      scene.lower = scene.lower.cwiseMin(tail);
      scene.upper = scene.upper.cwiseMax(tail);
    }
}

std::string scene_forces_json(const LinkageScene& scene) {
  if (scene.drivers.empty()) return "null";
  std::string text = fmt::format("{{\"arrows\":{},\"scale\":{:.6g},\"units\":[",
                                 scene.moments.front().arrows.size(), scene.arrow_scale);
  for (std::size_t i = 0; i < scene.drivers.size(); ++i)
    text += fmt::format("{}\"{}\"", i ? "," : "", scene.drivers[i].unit);
  text += "],\"moments\":[";
  for (std::size_t i = 0; i < scene.moments.size(); ++i) {
    std::string row;
    for (const auto& value : scene.moments[i].driver_forces)
      row += (row.empty() ? "" : ",") + force_or_null(value);
    for (const SceneArrow& arrow : scene.moments[i].arrows)
      row += fmt::format(",{:.9g},{:.9g},{:.6g},{:.6g}", arrow.at.x(), arrow.at.y(), arrow.force.x(),
                         arrow.force.y());
    text += fmt::format("{}[{}]", i ? ",\n" : "", row);
  }
  return text + "]}";
}

}  // namespace kempe
