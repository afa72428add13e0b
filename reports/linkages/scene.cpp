#include "reports/linkages/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/linkages/scene_forces.hpp"
#include "reports/linkages/scene_motion.hpp"
#include "reports/linkages/traced_curves.hpp"

namespace kempe {
namespace {

Point downward(const Point& p) { return {p.x(), -p.y()}; }

/// Convex hull by Andrew's chains; straight rows keep their two ends.
std::vector<Point> hull_of(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  for (const int way : {1, -1}) {
    const std::size_t start = hull.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& next = way > 0 ? points[i] : points[points.size() - 1 - i];
      while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], next - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(next);
    }
    hull.pop_back();
  }
  return hull;
}

class SceneBuilder {
 public:
  SceneBuilder(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run, int steps)
      : file_(file), model_(model), run_(run), steps_(steps) {}

  LinkageScene build() {
    scene_.title = file_.name;
    scene_.unit = file_.unit.name;
    add_bodies();
    add_points();
    for (const RunFrame& frame : run_.frames) add_moment(frame);
    add_scene_forces(file_, model_, run_, scene_);
    find_box();
    fit_arrows(scene_);
    add_lines_and_wheels();
    widen_for_wheels();
    scene_.traced = traced_points(file_, model_, scene_.points);
    const auto& first = run_.frames.front().position;
    const auto& last = run_.frames.back().position;
    scene_.closed = run_.frames.size() > 2 && same_assembly_mode(model_.linkage, first, last);
    add_scene_motion(file_, model_, run_, steps_, scene_);
    if (run_.stop) scene_.ending = std::string(kempe::name(run_.stop->end));
    return std::move(scene_);
  }

 private:
  Point scaled(const Point& p) const { return downward(p / file_.unit.in_mm); }
  SceneBody& body(const std::string& name) {
    return scene_.bodies[static_cast<std::size_t>(model_.body(name))];
  }

  void add_bodies() {
    for (int number = 0; number < model_.linkage.body_count(); ++number)
      scene_.bodies.emplace_back().name = model_.linkage.body_name(number);
    for (const FileSlider& slider : file_.sliders) {
      scene_.bodies.emplace_back().name = "slider of " + slider.name();
      scene_.bodies.back().is_block = true;
    }
    for (const FileLink& link : file_.links) {
      std::vector<Point> joints;
      for (const auto& [name, place] : link.joints) joints.push_back(scaled(place));
      body(link.name).pins = joints;
      body(link.name).hull = hull_of(joints);
    }
  }

  void add_points() {
    for (const ModelPoint& point : model_.points)
      scene_.points.push_back({point.name, point.place.body, scaled(point.place.local),
                               model_.is_fixed(point.name),
                               model_.is_fixed(point.name) && links_with(file_, point.name) > 0});
  }

  void add_moment(const RunFrame& frame) {
    LinkageScene::Moment moment{frame.share * steps_, {}, {}};
    for (const BodyPlacement& placement : frame.position) {
      moment.at.push_back(scaled(placement.at));
      moment.angle.push_back(-placement.angle);
    }
    for (const FileSlider& slider : file_.sliders) {
      const double carrier = frame.position[static_cast<std::size_t>(model_.body(slider.line.link))].angle;
      moment.at.push_back(scaled(place(frame.position, guided_by(slider))));
      moment.angle.push_back(-carrier - slider.line.direction);
    }
    scene_.moments.push_back(std::move(moment));
  }

  void find_box() {
    const double far = std::numeric_limits<double>::max();
    scene_.lower = Point(far, far);
    scene_.upper = -scene_.lower;
    for (const auto& moment : scene_.moments)
      for (const ScenePoint& point : scene_.points) {
        const Point at = scene_.place(point, moment);
        scene_.lower = scene_.lower.cwiseMin(at);
        scene_.upper = scene_.upper.cwiseMax(at);
      }
  }

  void widen_for_wheels() {
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body)
      for (const SceneBody::Wheel& wheel : scene_.bodies[body].wheels)
        for (const auto& moment : scene_.moments) {
          const Point centre = scene_.place({"", static_cast<int>(body), wheel.centre, false}, moment);
          scene_.lower = scene_.lower.cwiseMin(centre - Point(wheel.radius, wheel.radius));
          scene_.upper = scene_.upper.cwiseMax(centre + Point(wheel.radius, wheel.radius));
        }
  }

  void add_lines_and_wheels() {
    for (const FileSlider& slider : file_.sliders) add_guide(slider.line, guided_by(slider));
    for (const FileRack& rack : file_.racks) {
      const Point centre = model_.point(rack.centre).local;  // on the pinion if that is the point's home
      add_guide(rack.line, model_.point(rack.centre));
      const bool home = model_.point(rack.centre).body == model_.body(rack.pinion);
      body(rack.pinion)
          .wheels.push_back({home ? scaled(centre) : Point(0, 0), std::abs(rack.radius) / file_.unit.in_mm});
    }
    for (const FileGears& gears : file_.gears) add_wheels(gears);
  }

  BodyPoint guided_by(const FileSlider& slider) const {
    return slider.point.empty() ? BodyPoint{model_.body(slider.link), Point::Zero()}
                                : model_.point(slider.point);
  }

  /// The part of a line that is used, as seen from the line's link.
  void add_guide(const FileLine& line, const BodyPoint& guided) {
    const int carrier = model_.body(line.link);
    const Point along(std::cos(line.direction), std::sin(line.direction));
    double least = 0, most = 0;
    for (const RunFrame& frame : run_.frames) {
      const Point origin = place(frame.position, {carrier, line.through});
      const Point ahead = place(frame.position, {carrier, line.through + along}) - origin;
      const double way = ahead.dot(place(frame.position, guided) - origin);
      least = std::min(least, way);
      most = std::max(most, way);
    }
    const double margin = 0.06 * scene_.extent() * file_.unit.in_mm;
    scene_.bodies[static_cast<std::size_t>(carrier)].guides.push_back(
        {scaled(line.through + (least - margin) * along), scaled(line.through + (most + margin) * along)});
  }

  /// Pitch circles, as large as the centres' distance allows.
  void add_wheels(const FileGears& gears) {
    const auto pivot = [&](const std::string& wheel) -> std::optional<Point> {
      for (const auto& [name, constraint] : model_.linkage.constraints())
        if (const auto* joint = std::get_if<Revolute>(&constraint))
          for (const auto& [a, b] : {std::pair(joint->a, joint->b), std::pair(joint->b, joint->a)})
            if (a.body == model_.body(wheel) && b.body == model_.body(gears.carrier)) return a.local;
      return std::nullopt;
    };
    const auto first = pivot(gears.first), second = pivot(gears.second);
    if (!first || !second) return;
    const auto& position = run_.frames.front().position;
    const double apart = (place(position, {model_.body(gears.first), *first}) -
                          place(position, {model_.body(gears.second), *second}))
                             .norm();
    const double sum = std::abs(gears.first_radius + gears.second_radius);
    const double scale = sum > 0 ? apart / sum / file_.unit.in_mm : 1 / file_.unit.in_mm;
    body(gears.first).wheels.push_back({scaled(*first), gears.first_radius * scale});
    body(gears.second).wheels.push_back({scaled(*second), std::abs(gears.second_radius) * scale});
  }

  const LinkageFile& file_;
  const LinkageModel& model_;
  const PlanarRun& run_;
  int steps_;
  LinkageScene scene_;
};

}  // namespace

Point LinkageScene::place(const ScenePoint& point, const Moment& moment) const {
  const auto body = static_cast<std::size_t>(point.body);
  const double c = std::cos(moment.angle[body]), s = std::sin(moment.angle[body]);
  return moment.at[body] +
         Point(c * point.local.x() - s * point.local.y(), s * point.local.x() + c * point.local.y());
}

LinkageScene linkage_scene(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run,
                           int steps) {
  return SceneBuilder(file, model, run, steps).build();
}

}  // namespace kempe
