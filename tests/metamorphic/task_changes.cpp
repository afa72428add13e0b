#include "tests/metamorphic/task_changes.hpp"

#include <algorithm>
#include <cmath>

namespace kempe::metamorphic {
namespace {

template <class Move>
void move_rings(std::vector<Ring>& rings, Move move) {
  for (Ring& ring : rings)
    for (Point& corner : ring) corner = move(corner);
}

/// Every place of the task.
template <class Move>
Task moved(Task task, Move move) {
  move_rings(task.region, move);
  move_rings(task.region_holes, move);
  move_rings(task.pole_area, move);
  for (TaskObstacle& obstacle : task.obstacles) move_rings(obstacle.rings, move);
  task.pole = move(task.pole);
  return task;
}

ChangedTask equal(Task task) { return {std::move(task)}; }
ChangedTask looser(Task task) { return {std::move(task), Relation::looser}; }
ChangedTask tighter(Task task) { return {std::move(task), Relation::tighter}; }

std::vector<std::vector<Ring>*> all_rings(Task& task) {
  std::vector<std::vector<Ring>*> rings{&task.region, &task.region_holes, &task.pole_area};
  for (TaskObstacle& obstacle : task.obstacles) rings.push_back(&obstacle.rings);
  return rings;
}

std::optional<ChangedTask> relisted(const Task& task, Dice& dice) {
  Task changed = task;
  for (std::vector<Ring>* rings : all_rings(changed))
    for (Ring& ring : *rings) {
      std::rotate(ring.begin(), ring.begin() + dice.below(static_cast<int>(ring.size())), ring.end());
      if (dice.percent(50)) std::reverse(ring.begin(), ring.end());
    }
  std::reverse(changed.obstacles.begin(), changed.obstacles.end());
  return equal(std::move(changed));
}

/// Corners in the middle of edges: exactly on them, or so near that it is no matter.
std::optional<ChangedTask> with_flat_corners(const Task& task, Dice& dice) {
  Task changed = task;
  for (TaskObstacle& obstacle : changed.obstacles)
    for (Ring& ring : obstacle.rings) {
      const std::size_t at = static_cast<std::size_t>(dice.below(static_cast<int>(ring.size())));
      const Point between = 0.5 * (ring[at] + ring[(at + 1) % ring.size()]);
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(at) + 1, between);
    }
  if (changed.obstacles.empty()) return std::nullopt;
  return equal(std::move(changed));
}

/// What lies on one side of an upright or level line. (It may run along the line and back; that encloses nothing.)
Ring clipped(const Ring& ring, Eigen::Index axis, double line, double side) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double a_in = side * (a[axis] - line), b_in = side * (b[axis] - line);
    if (a_in >= 0) result.push_back(a);
    if (a_in * b_in >= 0) continue;
    Point crossing = a + (line - a[axis]) / (b[axis] - a[axis]) * (b - a);
    crossing[axis] = line;
    result.push_back(crossing);
  }
  return result;
}

std::optional<ChangedTask> cut_apart(const Task& task, Dice& dice) {
  if (task.obstacles.empty()) return std::nullopt;
  Task changed = task;
  const std::size_t which = static_cast<std::size_t>(dice.below(static_cast<int>(task.obstacles.size())));
  const TaskObstacle& whole = task.obstacles[which];
  const Ring& ring = whole.rings[0];
  const Eigen::Index axis = dice.below(2);
  const int one = dice.below(static_cast<int>(ring.size()));
  const int other = dice.below(static_cast<int>(ring.size()));
  const double line =
      0.5 * (ring[static_cast<std::size_t>(one)][axis] + ring[static_cast<std::size_t>(other)][axis]);
  const Ring below = clipped(ring, axis, line, -1), above = clipped(ring, axis, line, 1);
  const auto has_area = [](const Ring& part) {
    return part.size() > 2 && std::abs(signed_area(part)) > 1e-6 * part[0].norm();
  };
  if (!has_area(below) || !has_area(above)) return std::nullopt;
  changed.obstacles[which].rings = {below};
  TaskObstacle second = whole;
  second.rings = {above};
  changed.obstacles.push_back(second);
  return equal(std::move(changed));
}

std::optional<ChangedTask> obstacle_twice(const Task& task, Dice& dice) {
  if (task.obstacles.empty()) return std::nullopt;
  Task changed = task;
  const std::size_t which = static_cast<std::size_t>(dice.below(static_cast<int>(task.obstacles.size())));
  TaskObstacle again = task.obstacles[which];
  std::reverse(again.rings[0].begin(), again.rings[0].end());
  changed.obstacles.push_back(std::move(again));
  return equal(std::move(changed));
}

/// One layer range as two.
std::optional<ChangedTask> split_by_layers(const Task& task, Dice&) {
  Task changed = task;
  for (TaskObstacle& obstacle : changed.obstacles) {
    const std::array<int, 2> layers = obstacle.layers.value_or(std::array<int, 2>{1, 8});
    if (layers[0] == layers[1]) continue;
    TaskObstacle above = obstacle;
    obstacle.layers = std::array<int, 2>{layers[0], layers[0]};
    above.layers = std::array<int, 2>{layers[0] + 1, layers[1]};
    changed.obstacles.push_back(std::move(above));
    return equal(std::move(changed));
  }
  return std::nullopt;
}

/// Whole millimetres, a tenth of the distances: what is on round numbers stays there.
std::optional<ChangedTask> shifted_near(const Task& task, Dice& dice) {
  const int x = dice.whole(-300, 300);
  const int y = dice.whole(-300, 300);
  return equal(shifted(task, Point(x, y)));
}

std::optional<ChangedTask> shifted_far(const Task& task, Dice& dice) {
  const double far = dice.one_of({1e3, 1e4, 1e5, 1e6});
  const double bearing = dice.below(8) * pi / 4;
  return equal(shifted(task, as_point(std::polar(far, bearing)).array().round().matrix()));
}

std::optional<ChangedTask> turned(const Task& task, Dice&) {
  return equal(moved(task, [](const Point& z) { return Point(-z.y(), z.x()); }));
}

std::optional<ChangedTask> mirrored(const Task& task, Dice&) {
  Task changed = moved(task, [](const Point& z) { return Point(z.x(), -z.y()); });
  changed.rotation_deg = -task.rotation_deg;
  return equal(std::move(changed));
}

std::optional<ChangedTask> made_larger(const Task& task, Dice& dice) {
  const double factor = dice.one_of({0.1, 0.5, 2.0, 10.0});
  if (factor * task.width > 1000 || factor * task.longest > 1e6 || factor * task.clearance > 1000)
    return std::nullopt;
  ChangedTask changed = equal(enlarged(task, factor));
  changed.unit = factor;
  return changed;
}

/// What was traced is drawn, what was drawn is traced: the same linkages with tracer and pen exchanged.
std::optional<ChangedTask> led_by_the_pen(const Task& task, Dice&) {
  if (!task.pole_area.empty() || task.copy_error || task.objective == "copy_error" || task.grid ||
      !task.stock.empty() || !task.locked.empty())
    return std::nullopt;
  const double turn = task.rotation_deg * pi / 180;
  const Complex k = copy_ratio(task.scale, std::abs(task.rotation_deg) == 180 ? pi : turn);
  const auto image = [&](const Point& z) {
    return as_point(as_complex(task.pole) + k * as_complex(z - task.pole));
  };
  Task changed = task;
  move_rings(changed.region, image);
  move_rings(changed.region_holes, image);
  changed.scale = 1 / task.scale;
  changed.rotation_deg = -task.rotation_deg;
  for (std::string& grounding : changed.groundings)
    if (grounding != "pole") grounding = grounding == "tracer" ? "pen" : "tracer";
  ChangedTask result = equal(std::move(changed));
  result.same_copy_error = false;
  return result;
}

std::optional<ChangedTask> another_layer(const Task& task, Dice&) {
  if (task.layers >= 4) return std::nullopt;
  Task changed = task;
  ++changed.layers;
  return looser(std::move(changed));
}

/// Everything that stands on the table a layer higher, and a layer more: every design may stand a layer higher too.
std::optional<ChangedTask> lifted(const Task& task, Dice&) {
  if (task.layers >= 4 || task.obstacles.empty()) return std::nullopt;
  Task changed = task;
  ++changed.layers;
  for (TaskObstacle& obstacle : changed.obstacles) {
    const std::array<int, 2> layers = obstacle.layers.value_or(std::array<int, 2>{1, 8});
    obstacle.layers = std::array<int, 2>{std::min(8, layers[0] + 1), std::min(8, layers[1] + 1)};
  }
  return looser(std::move(changed));
}

std::optional<ChangedTask> limit_loosened(const Task& task, Dice& dice) {
  Task changed = task;
  switch (dice.below(6)) {
    case 0: changed.clearance *= dice.one_of({0.0, 0.5, 0.9}); break;
    case 1: changed.transmission_deg *= dice.one_of({0.5, 0.9, 0.97}); break;
    case 2: changed.shortest *= dice.one_of({0.5, 0.9}); break;
    case 3: changed.longest *= dice.one_of({1.1, 2.0}); break;
    case 4:
      if (!task.copy_gap) return std::nullopt;
      changed.copy_gap = dice.percent(50) ? std::optional(0.5 * *task.copy_gap) : std::nullopt;
      break;
    default:
      if (!task.copy_error) return std::nullopt;
      changed.copy_error = dice.percent(50) ? std::optional(1.3 * *task.copy_error) : std::nullopt;
  }
  // With a grid another limit may make another ratio the best one.
  if (task.grid || !task.stock.empty()) return std::nullopt;
  return looser(std::move(changed));
}

std::optional<ChangedTask> limit_tightened(const Task& task, Dice& dice) {
  if (task.grid || !task.stock.empty()) return std::nullopt;
  Task changed = task;
  switch (dice.below(4)) {
    case 0: changed.clearance = 1.2 * task.clearance + 0.02 * task.width; break;
    case 1: changed.transmission_deg = 1.1 * task.transmission_deg + 1; break;
    case 2:
      changed.longest *= 0.9;
      if (changed.longest <= changed.shortest) return std::nullopt;
      break;
    default: changed.copy_gap = 1.5 * task.copy_gap.value_or(0);
  }
  for (const auto& [key, length] : changed.locked)
    if (length > changed.longest) return std::nullopt;
  return tighter(std::move(changed));
}

std::optional<ChangedTask> obstacle_removed(const Task& task, Dice& dice) {
  if (task.obstacles.empty()) return std::nullopt;
  Task changed = task;
  changed.obstacles.erase(changed.obstacles.begin() + dice.below(static_cast<int>(task.obstacles.size())));
  return looser(std::move(changed));
}

std::optional<ChangedTask> thinner(const Task& task, Dice&) {
  Task changed = task;
  if (task.triangle_plates)
    changed.triangle_plates = false;  // two arms lie within their triangle
  else
    changed.pin_diameter *= 0.8;
  return looser(std::move(changed));
}

std::optional<ChangedTask> lock_removed(const Task& task, Dice&) {
  if (task.locked.empty()) return std::nullopt;
  Task changed = task;
  changed.locked.clear();
  return looser(std::move(changed));
}

/// The pole may stand about its place.
std::optional<ChangedTask> pole_freed(const Task& task, Dice& dice) {
  if (!task.pole_area.empty() || task.grid || !task.stock.empty()) return std::nullopt;
  Task changed = task;
  const double reach = task.width * dice.one_of({0.2, 1.0, 3.0});
  const Point& at = task.pole;
  changed.pole_area = {{{at.x() - reach, at.y() - reach},
                        {at.x() + reach, at.y() - reach},
                        {at.x() + reach, at.y() + reach},
                        {at.x() - reach, at.y() + reach}}};
  return looser(std::move(changed));
}

std::optional<ChangedTask> all_groundings(const Task& task, Dice&) {
  if (task.groundings.size() == 3) return std::nullopt;
  Task changed = task;
  changed.groundings = {"pole", "tracer", "pen"};
  return looser(std::move(changed));
}

/// A triangle of the region's corners must be covered, not all of it. (Of a ring without holes that is convex.)
std::optional<ChangedTask> less_to_cover(const Task& task, Dice& dice) {
  if (task.region.size() > 1 || !task.region_holes.empty() || task.region[0].size() != 4) return std::nullopt;
  const Ring& ring = task.region[0];
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double area = cross(ring[(i + 1) % 4] - ring[i], ring[(i + 2) % 4] - ring[(i + 1) % 4]);
    if (sum * area < 0) return std::nullopt;
    sum += area;
  }
  Task changed = task;
  changed.region[0].erase(changed.region[0].begin() + dice.below(4));
  return looser(std::move(changed));
}

}  // namespace

Task shifted(Task task, const Point& by) {
  return moved(std::move(task), [&](const Point& z) -> Point { return z + by; });
}

Task enlarged(Task task, double factor) {
  task = moved(std::move(task), [&](const Point& z) -> Point { return factor * z; });
  for (double* length : {&task.width, &task.pin_diameter, &task.shortest, &task.longest, &task.clearance})
    *length *= factor;
  for (std::optional<double>* length :
       {&task.grid, &task.copy_gap, &task.copy_error, &task.length_tolerance, &task.play})
    if (*length) **length *= factor;
  for (double& length : task.stock) length *= factor;
  for (auto& [key, length] : task.locked) length *= factor;
  return task;
}

const std::vector<Change>& changes() {
  static const std::vector<Change> all{{"relisted", relisted},
                                       {"flat corners", with_flat_corners},
                                       {"obstacle cut apart", cut_apart},
                                       {"obstacle twice", obstacle_twice},
                                       {"obstacle split by layers", split_by_layers},
                                       {"shifted", shifted_near},
                                       {"shifted far", shifted_far},
                                       {"turned", turned},
                                       {"mirrored", mirrored},
                                       {"enlarged", made_larger},
                                       {"led by the pen", led_by_the_pen},
                                       {"another layer", another_layer},
                                       {"lifted", lifted},
                                       {"limit loosened", limit_loosened},
                                       {"limit tightened", limit_tightened},
                                       {"obstacle removed", obstacle_removed},
                                       {"thinner parts", thinner},
                                       {"length unlocked", lock_removed},
                                       {"pole freed", pole_freed},
                                       {"all groundings", all_groundings},
                                       {"less to cover", less_to_cover}};
  return all;
}

}  // namespace kempe::metamorphic
