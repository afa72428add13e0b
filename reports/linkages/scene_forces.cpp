#include "reports/linkages/scene_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

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

/// A joint, guide or bar whose force is an arrow: where it acts, and what it is called ("B on rod").
struct ShownReaction {
  int constraint;
  BodyPoint at;
  std::string label;
};

std::vector<ShownReaction> shown_reactions(const LinkageFile& file, const LinkageModel& model) {
  std::vector<ShownReaction> shown;
  if (!file.output.reactions) return shown;
  const auto& constraints = model.linkage.constraints();
  for (int i = 0; i < static_cast<int>(constraints.size()); ++i) {
    if (model.linkage.is_driver(i)) continue;
    const auto& [name, constraint] = constraints[static_cast<std::size_t>(i)];
    if (const auto* joint = std::get_if<Revolute>(&constraint))
      shown.push_back({i, joint->a, name + " on " + model.linkage.body_name(joint->b.body)});
    else if (const auto* guide = std::get_if<Coordinate>(&constraint))
      shown.push_back({i, guide->point, name + " from " + model.linkage.body_name(guide->origin.body)});
    else if (const auto* bar = std::get_if<Distance>(&constraint))
      shown.push_back({i, bar->a, name});
  }
  return shown;
}

std::string force_or_null(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "null";
}

/// "reactions":[labels],"forces":[a row for each moment: x, y, fx, fy or null for each]
std::string reactions_json(const LinkageScene& scene) {
  std::string labels, rows;
  for (const std::string& label : scene.reactions)
    labels += (labels.empty() ? "" : ",") + nlohmann::json(label).dump();
  for (const auto& moment : scene.moments) {
    std::string row;
    for (const auto& one : moment.reactions)
      row += (row.empty() ? "" : ",") + (one ? fmt::format("[{:.9g},{:.9g},{:.9g},{:.9g}]", one->at.x(),
                                                           one->at.y(), one->force.x(), one->force.y())
                                             : std::string("null"));
    rows += (rows.empty() ? "[" : ",\n[") + row + "]";
  }
  return "\"reactions\":[" + labels + "],\"forces\":[" + rows + "]";
}

}  // namespace

void add_scene_forces(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run,
                      LinkageScene& scene) {
  if (model.loads.empty()) return;
  const double unit = file.unit.in_mm;
  const std::vector<ShownReaction> shown = shown_reactions(file, model);
  for (const ShownReaction& reaction : shown) scene.reactions.push_back(reaction.label);
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
    for (const ShownReaction& one : shown) {
      const bool known = reactions && (*reactions)[static_cast<std::size_t>(one.constraint)].determined;
      moment.reactions.push_back(
          known ? std::optional(
                      SceneArrow{page_vector(place(position, one.at) / unit),
                                 page_vector((*reactions)[static_cast<std::size_t>(one.constraint)].force)})
                : std::nullopt);
    }
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
  return text + "]," + reactions_json(scene) + "}";
}

}  // namespace kempe
