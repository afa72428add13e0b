#include "tests/metamorphic/task_dice.hpp"

#include <algorithm>
#include <cmath>

#include "specs/spec_reader.hpp"
#include "tests/geometry/grid_outlines.hpp"
#include "tests/metamorphic/task_changes.hpp"
#include "tests/random.hpp"

namespace kempe::metamorphic {
namespace {

/// Whole numbers about (0, 0), some tens across; shapes that people draw.
Ring rectangle(double width, double height) { return {{0, 0}, {width, 0}, {width, height}, {0, height}}; }

Ring draw_rectangle(Dice& dice, int most) {
  const int wide = dice.whole(1, most), high = dice.whole(1, most);
  return rectangle(wide, high);
}

Ring draw_l(Dice& dice) {
  const int thick = dice.whole(1, 4), wide = thick + dice.whole(1, 6), high = thick + dice.whole(1, 6);
  return {{0, 0},        Point(wide, 0), Point(wide, thick), Point(thick, thick), Point(thick, high),
          Point(0, high)};
}

Ring draw_u(Dice& dice) {
  const int thick = dice.whole(1, 3), inner = dice.whole(1, 6), deep = dice.whole(1, 6);
  const int wide = 2 * thick + inner, high = thick + deep;
  return {{0, 0},
          Point(wide, 0),
          Point(wide, high),
          Point(wide - thick, high),
          Point(wide - thick, thick),
          Point(thick, thick),
          Point(thick, high),
          Point(0, high)};
}

Ring draw_comb(Dice& dice) {
  const int teeth = dice.whole(2, 4), deep = dice.whole(2, 6);
  Ring ring{Point(2 * teeth - 1, 0)};
  for (int i = teeth - 1; i >= 0; --i) {
    ring.emplace_back(2 * i + 1, deep);
    ring.emplace_back(2 * i, deep);
    if (i == 0) break;
    ring.emplace_back(2 * i, 1);
    ring.emplace_back(2 * i - 1, 1);
  }
  ring.emplace_back(0, 0);
  return ring;
}

/// Corners within the straight edges of a rectangle.
Ring draw_rectangle_with_flat_corners(Dice& dice) {
  const int wide = dice.whole(2, 6), high = dice.whole(2, 6);
  const int at = dice.whole(1, wide - 1), up = dice.whole(1, high - 1);
  return {{0, 0}, Point(at, 0), Point(wide, 0), Point(wide, up), Point(wide, high), Point(0, high)};
}

Ring draw_outline(Dice& dice) {
  switch (dice.below(9)) {
    case 0: return draw_l(dice);
    case 1: return draw_u(dice);
    case 2: return draw_comb(dice);
    case 3: return draw_rectangle_with_flat_corners(dice);
    case 4: return test::grid_polygon(dice.engine(), dice.whole(3, 6)).outer;
    case 5: {
      const int reach = dice.whole(3, 9), other = dice.whole(1, 9);
      return {{0, 0}, Point(reach, 0), Point(dice.below(reach + 1), other)};
    }
    case 6: {  // a rail
      const int length = dice.whole(10, 40);
      return rectangle(length, 1);
    }
    default: return draw_rectangle(dice, 9);
  }
}

Point middle(const Ring& ring) {
  Point lower = ring[0], upper = ring[0];
  for (const Point& corner : ring) lower = lower.cwiseMin(corner), upper = upper.cwiseMax(corner);
  return (0.5 * (lower + upper)).array().round().matrix();
}

double largest_extent(const Ring& ring) {
  double extent = 0;
  for (const Point& corner : ring) extent = std::max(extent, (corner - middle(ring)).norm());
  return extent;
}

/// Enlarged by whole numbers to about `radius` and moved so that its middle is at `centre`, turned by quarters.
Ring placed(Ring ring, double radius, const Point& centre, int quarters) {
  const double step = std::max(1.0, std::round(radius / largest_extent(ring)));
  const Point from = middle(ring);
  for (Point& corner : ring) {
    corner = step * (corner - from);
    for (int i = 0; i < quarters; ++i) corner = Point(-corner.y(), corner.x());
    corner += centre;
  }
  return ring;
}

Point draw_whole_point(Dice& dice, double reach) {
  const double x = std::round(dice.uniform(-reach, reach));
  const double y = std::round(dice.uniform(-reach, reach));
  return {x, y};
}

Point draw_direction(Dice& dice, double length) {
  const double bearing = dice.percent(40) ? dice.below(8) * pi / 4 : dice.uniform(-pi, pi);
  return (as_point(std::polar(length, bearing))).array().round().matrix();
}

void draw_copy(Dice& dice, Task& task) {
  switch (dice.below(6)) {
    case 0: task.scale = dice.log_uniform(0.02, 50); break;
    case 1: task.scale = dice.log_uniform(0.3, 3); break;
    case 2: task.scale = dice.one_of({0.02, 0.05, 0.1, 8.0, 10.0, 20.0, 50.0}); break;
    default: task.scale = dice.one_of({0.2, 0.25, 0.5, 0.75, 0.8, 1.0, 1.25, 1.4, 1.5, 2.0, 3.0, 4.0, 5.0});
  }
  switch (dice.below(8)) {
    case 0:
    case 1: task.rotation_deg = 180; break;
    case 2: task.rotation_deg = 0; break;
    case 3:
    case 4: task.rotation_deg = dice.one_of({30.0, 45.0, 60.0, 90.0, -90.0, 120.0, -135.0, 150.0}); break;
    case 5:
      if (dice.percent(40)) {
        const double straight = dice.one_of({0.0, 180.0});
        task.rotation_deg = straight + dice.one_of({-1.0, 1.0}) * dice.log_uniform(1e-9, 1);
        break;
      }
      [[fallthrough]];
    default: task.rotation_deg = dice.uniform(-180, 180);
  }
  if (std::abs(copy_ratio(task.scale, task.rotation_deg * pi / 180) - 1.0) < 0.05) task.scale = 2;
}

/// In some hundred millimetres about the pole at (0, 0).
void draw_region(Dice& dice, Task& task) {
  const double away = dice.log_uniform(40, 300);
  if (dice.percent(10)) {  // around the pole
    const double inner = std::round(away * dice.uniform(0.4, 0.8)),
                 outer = std::round(away * dice.uniform(1, 1.6));
    const auto square = [](double half) {
      return Ring{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    };
    if (dice.percent(50)) {
      task.region = {square(outer)};
      task.region_holes = {square(inner)};
    } else {  // a U around the pole
      task.region = {{{-outer, -outer},
                      {outer, -outer},
                      {outer, outer},
                      {inner, outer},
                      {inner, -inner},
                      {-inner, -inner},
                      {-inner, outer},
                      {-outer, outer}}};
    }
    return;
  }
  const Point centre = draw_direction(dice, away);
  const double radius = away * dice.log_uniform(0.03, 0.5);
  const int quarters = dice.below(4);
  const Ring outline = dice.percent(45) ? draw_rectangle(dice, 5) : draw_outline(dice);
  task.region = {placed(outline, radius, centre, quarters)};
  if (dice.percent(5)) {  // a second piece, which may not touch the first
    const Point beside = draw_direction(dice, 3 * radius + 3);
    task.region.push_back(placed(rectangle(2, 1), 0.5 * radius, centre + beside, 0));
  }
}

void draw_pole(Dice& dice, Task& task) {
  if (!dice.percent(30)) return;
  const double radius = dice.log_uniform(3, 60);
  const Point centre = draw_whole_point(dice, 20);
  const int quarters = dice.below(4);
  const Ring outline = dice.percent(60) ? draw_rectangle(dice, 4) : draw_outline(dice);
  task.pole_area = {placed(outline, radius, centre, quarters)};
}

double reach_of(const Task& task) {
  double reach = 0;
  for (const Ring& ring : task.region)
    for (const Point& corner : ring) reach = std::max(reach, (corner - task.pole).norm());
  return reach;
}

void draw_links(Dice& dice, Task& task) {
  task.width = dice.one_of({2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0});
  task.pin_diameter = task.width * dice.one_of({1.0, 0.75, 0.5, 0.5, 0.5, 0.25});
  task.triangle_plates = dice.percent(40);
  task.layers = dice.percent(68) ? 2 : dice.percent(75) ? 3 : 4;
  task.shortest = dice.percent(50) ? 15 : dice.one_of({1.0, 5.0, 10.0, 20.0, 30.0}) + task.width;
  const double reach = reach_of(task);
  const double larger_sheet = dice.percent(85) ? std::max(1.0, task.scale) : 1;
  task.longest =
      std::max(2 * task.shortest, std::round(reach * dice.one_of({1.2, 2.0, 3.0, 4.0, 10.0}) * larger_sheet));
  if (dice.percent(4)) task.grid = dice.one_of({5.0, 10.0, 2.5});
  if (dice.percent(4)) {
    const std::string key = dice.one_of<const char*>({"VA_mm", "VB_mm", "AX_mm", "BY_mm", "CX_mm"});
    task.locked[key] = std::round(dice.uniform(task.shortest + 1, std::min(task.longest, 4 * reach) - 1));
    if (task.locked[key] < task.shortest || task.locked[key] > task.longest) task.locked.clear();
  }
  if (task.grid && std::floor(task.longest / *task.grid) * *task.grid < task.shortest) task.grid.reset();
}

void draw_limits(Dice& dice, Task& task) {
  task.clearance = dice.one_of({0.0, 0.1, 0.5, 0.5, 1.0, 2.0});
  task.transmission_deg = dice.percent(8) ? 0 : dice.one_of({5.0, 10.0, 15.0, 20.0, 20.0, 25.0, 30.0, 35.0});
  if (dice.percent(25)) task.copy_gap = dice.one_of({0.0, 1.0, 5.0, 20.0});
  if (dice.percent(20)) {
    task.length_tolerance = dice.one_of({0.02, 0.05, 0.1});
    if (dice.percent(60)) task.play = dice.one_of({0.01, 0.05});
    if (dice.percent(60)) task.copy_error = dice.log_uniform(0.1, 5) * std::max(1.0, task.scale);
  }
}

void draw_obstacle_layers(Dice& dice, const Task& task, TaskObstacle& obstacle) {
  switch (dice.below(6)) {
    case 0:
    case 1: obstacle.layers = {1, 1}; break;
    case 2: {
      const int lowest = dice.whole(1, task.layers + 1);
      obstacle.layers = {lowest, dice.whole(lowest, 8)};
      break;
    }
    default: break;  // all of them
  }
}

TaskObstacle draw_obstacle(Dice& dice, const Task& task) {
  const double reach = reach_of(task);
  const double far = reach * (dice.percent(50) ? 1 : std::max(1.0, std::min(3.0, task.scale)));
  const double away = far * dice.uniform(0.15, 1.3), radius = far * dice.log_uniform(0.03, 0.4);
  const Point centre = draw_direction(dice, away);
  TaskObstacle obstacle;
  const Ring outline = draw_outline(dice);
  obstacle.rings = {placed(outline, radius, centre, dice.below(4))};
  draw_obstacle_layers(dice, task, obstacle);
  return obstacle;
}

/// Frames that hold a sheet down all around: only what comes from above gets in.
void add_frame(Dice& dice, Task& task) {
  Point lower = task.region[0][0], upper = lower;
  for (const Point& corner : task.region[0]) lower = lower.cwiseMin(corner), upper = upper.cwiseMax(corner);
  const double gap = std::ceil(0.5 * task.pin_diameter + task.clearance) + dice.whole(1, 10),
               thick = dice.whole(2, 12);
  const Point inner_low = lower.array() - gap, inner_high = upper.array() + gap;
  const Point low = inner_low.array() - thick, high = inner_high.array() + thick;
  const auto rail = [&](double x0, double y0, double x1, double y1) {
    task.obstacles.push_back({{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}, std::array<int, 2>{1, 1}});
  };
  rail(low.x(), low.y(), high.x(), inner_low.y());
  rail(low.x(), inner_high.y(), high.x(), high.y());
  if (dice.percent(50)) rail(low.x(), inner_low.y(), inner_low.x(), inner_high.y());
}

void draw_obstacles(Dice& dice, Task& task) {
  const int roll = dice.below(100);
  const int count = roll < 45 ? 0 : roll < 80 ? 1 : roll < 95 ? 2 : 3;
  for (int i = 0; i < count; ++i) task.obstacles.push_back(draw_obstacle(dice, task));
  if (task.layers > 2 && dice.percent(25)) add_frame(dice, task);
  // Four layers beside obstacles take many seconds.
  if (task.layers == 4 && !task.obstacles.empty() && !dice.percent(20)) task.layers = 3;
}

void draw_objective(Dice& dice, Task& task) {
  const int roll = dice.below(100);
  if (roll < 18) task.objective = "transmission";
  if (roll >= 18 && roll < 26 && (task.length_tolerance || task.play)) task.objective = "copy_error";
  if (roll >= 98 && task.obstacles.empty() && task.layers == 2) task.objective = "footprint";
  if (!dice.percent(25)) return;
  const char* one = dice.one_of<const char*>({"pole", "tracer", "pen"});
  const char* other = dice.one_of<const char*>({"pole", "tracer", "pen"});
  task.groundings = {one};
  if (std::string(other) != one) task.groundings.emplace_back(other);
}

/// Small or large instruments, far from the origin.
Task in_another_frame(Dice& dice, Task task) {
  if (dice.percent(25)) task = enlarged(task, dice.one_of({0.01, 0.1, 0.5, 10.0}));
  if (dice.percent(12)) {
    const double far = dice.one_of({1e3, 1e4, 1e5, 1e6});
    task = shifted(task, draw_direction(dice, far));
  }
  return task;
}

bool is_taken(const Task& task) { return read_spec(toml_of(task), "task", ".").has_value(); }

}  // namespace

double Dice::uniform(double lower, double upper) { return test::uniform(random_, lower, upper); }

double Dice::log_uniform(double lower, double upper) {
  return std::exp(uniform(std::log(lower), std::log(upper)));
}

std::optional<Task> with_obstacle_in_the_way(const Task& task, const CopyingLinkage& linkage, Dice& dice) {
  const Ring& ring = task.region[0];
  const auto pose =
      linkage.pose_with_tracer_at(ring[static_cast<std::size_t>(dice.below(static_cast<int>(ring.size())))]);
  if (!pose) return std::nullopt;
  const Joint from = all_joints[static_cast<std::size_t>(dice.below(6))];
  const Joint to = all_joints[static_cast<std::size_t>(dice.below(6))];
  const Point at = (*pose)[from] + dice.uniform(0, 1) * ((*pose)[to] - (*pose)[from]);
  const Ring outline = draw_outline(dice);
  const double radius = linkage.size() * dice.log_uniform(0.02, 0.25);
  const double aside = dice.uniform(0, 1) * (radius + task.width);
  const double bearing = dice.uniform(-pi, pi);
  // On round numbers, however large the task: a thousandth of the radius or so, as a power of ten.
  const double round = std::pow(10, std::floor(std::log10(radius)) - 1);
  TaskObstacle obstacle;
  Ring placed_outline = placed(outline, radius / round, Point::Zero(), dice.below(4));
  const Point centre = ((at + as_point(std::polar(aside, bearing))) / round).array().round().matrix();
  for (Point& corner : placed_outline) corner = round * (corner + centre);
  obstacle.rings = {std::move(placed_outline)};
  draw_obstacle_layers(dice, task, obstacle);
  Task changed = task;
  changed.obstacles.push_back(std::move(obstacle));
  if (!is_taken(changed)) return std::nullopt;
  return changed;
}

Task draw_task(Dice& dice) {
  for (;;) {
    Task task;
    draw_copy(dice, task);
    draw_region(dice, task);
    draw_pole(dice, task);
    draw_links(dice, task);
    draw_limits(dice, task);
    draw_obstacles(dice, task);
    draw_objective(dice, task);
    task = in_another_frame(dice, std::move(task));
    if (is_taken(task)) return task;  // else rings touch
  }
}

}  // namespace kempe::metamorphic
