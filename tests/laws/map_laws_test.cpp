// Laws of the map: it only shrinks when more clearance or wider links are asked for, and it moves with its task.
#include "geometry/regions/region_algebra.hpp"
#include "tests/geometry/grid_outlines.hpp"
#include "tests/laws/law.hpp"
#include "tests/laws/movement.hpp"
#include "workspace/map/workspace_map.hpp"
#include "workspace/reach.hpp"

namespace kempe::laws {
namespace {

Obstacle draw_obstacle(const CopyingLinkage& linkage) {
  const double size = linkage.size() * *between(0.02, 0.2);
  const Point at = linkage.pole() + *point(linkage.size());
  if (*rc::gen::arbitrary<bool>()) {
    std::mt19937_64 random(static_cast<unsigned>(*whole(0, 1 << 20)));
    return {test::grid_polygon_about(random, at, size), 1, *whole(1, 4), "obstacle"};
  }
  const Point across = size * Point(1, *between(-1, 1)), up = size * Point(-*between(0, 1), 1);
  return {{{at, at + across, at + across + up, at + up}, {}}, 1, *whole(1, 4), "obstacle"};
}

MapTask draw_map_task() {
  const CopyingLinkage linkage = draw_linkage(10);
  MapTask task{.linkage = linkage, .style = draw_style(), .layers = draw_layers()};
  task.limits.clearance = *between(0, 3);
  task.limits.transmission = radians(*between(0, 30));
  const int obstacles = *whole(0, 3);
  for (int i = 0; i < obstacles; ++i) task.obstacles.push_back(draw_obstacle(linkage));
  return task;
}

Point draw_place(const MapTask& task) {
  return task.linkage.tracer_at(draw_opening(task.linkage, 0.01), *between(-pi, pi));
}

/// Whatever is free for the stricter task is free for the looser one.
void only_shrinks(const MapTask& looser, const MapTask& stricter) {
  for (int i = 0; i < 10; ++i) {
    const Point place = draw_place(looser);
    const Verdict strict = verdict_at(stricter, place), loose = verdict_at(looser, place);
    if (strict.free && !strict.uncertain) RC_ASSERT(loose.free || loose.uncertain);
  }
}

TEST(MapLaws, MoreClearanceNeverFreesAPlace) {
  law(500, [] {
    const MapTask looser = draw_map_task();
    MapTask stricter = looser;
    stricter.limits.clearance += *logarithmic(1e-6, 10);
    only_shrinks(looser, stricter);
  });
}

TEST(MapLaws, WiderLinksNeverFreeAPlace) {
  law(500, [] {
    const MapTask looser = draw_map_task();
    MapTask stricter = looser;
    stricter.style.width *= *between(1, 2);
    only_shrinks(looser, stricter);
  });
}

TEST(MapLaws, ThickerPinsNeverFreeAPlace) {
  law(300, [] {
    const MapTask looser = draw_map_task();
    MapTask stricter = looser;
    stricter.style.pin_diameter += (stricter.style.width - stricter.style.pin_diameter) * *between(0, 1);
    only_shrinks(looser, stricter);
  });
}

TEST(MapLaws, AnotherObstacleNeverFreesAPlace) {
  law(300, [] {
    const MapTask looser = draw_map_task();
    MapTask stricter = looser;
    stricter.obstacles.push_back(draw_obstacle(looser.linkage));
    only_shrinks(looser, stricter);
  });
}

TEST(MapLaws, ASteeperTransmissionLimitNeverFreesAPlace) {
  law(300, [] {
    const MapTask looser = draw_map_task();
    MapTask stricter = looser;
    stricter.limits.transmission += *between(0, 0.5);
    only_shrinks(looser, stricter);
  });
}

TEST(MapLaws, TheWholeMapShrinksWithMoreClearanceAndWiderLinks) {
  law(15, [] {
    const MapTask looser = draw_map_task();
    MapTask stricter = looser;
    if (*rc::gen::arbitrary<bool>())
      stricter.limits.clearance += *between(0.1, 5);
    else
      stricter.style.width *= *between(1.1, 2);
    const MapOptions options{.map_tolerance = 0.02, .largest_sheets = false};
    const WorkspaceMap wide = map_workspace(looser, options), narrow = map_workspace(stricter, options);
    const double unsure = area(wide.uncertain) + area(narrow.uncertain);
    const double outside = area(difference(narrow.collision_free, wide.collision_free));
    RC_ASSERT(outside <= unsure + 1e-6 * area(wide.reachable));
  });
}

TEST(MapLaws, ReachUsableAndFreeAreNested) {
  law(15, [] {
    const MapTask task = draw_map_task();
    const WorkspaceMap map = map_workspace(task, {.map_tolerance = 0.02, .largest_sheets = false});
    const double rounding = 1e-6 * area(map.reachable) + 1e-9;
    RC_ASSERT(area(difference(map.usable, map.reachable)) <= rounding);
    RC_ASSERT(area(difference(map.collision_free, map.usable)) <= rounding);
    RC_ASSERT(area(intersection(map.collision_free, map.uncertain)) <= rounding);
  });
}

TEST(MapLaws, VerdictsMoveWithTheTask) {
  law(500, [] {
    const MapTask task = draw_map_task();
    const Movement movement{.scale = *logarithmic(0.2, 5),
                            .turn = *angle(),
                            .shift = *point(500),
                            .mirror = *rc::gen::arbitrary<bool>()};
    const CopyingLinkage& l = task.linkage;
    const Complex k = movement.mirror ? std::conj(l.k()) : l.k();
    const auto linkage = CopyingLinkage::make(
        k, l.grounding(), movement.scale * l.VA(), movement.scale * l.VB(),
        movement.assembly_mode(l.assembly_mode().number, l.k(), l.grounding()), movement(l.pole()));
    RC_ASSERT(linkage.has_value());
    MapTask moved = task;
    moved.linkage = *linkage;
    moved.style.width *= movement.scale;
    moved.style.pin_diameter *= movement.scale;
    moved.style.thickness *= movement.scale;
    moved.limits.clearance *= movement.scale;
    for (Obstacle& obstacle : moved.obstacles) obstacle.shape = movement(obstacle.shape);
    for (int i = 0; i < 5; ++i) {
      const Point place = draw_place(task);
      const Verdict here = verdict_at(task, place), there = verdict_at(moved, movement(place));
      if (here.uncertain || there.uncertain) continue;
      RC_ASSERT(here.free == there.free);
      RC_ASSERT(here.cause == there.cause);
      // Of several parts in contact either may be named: their gaps can be equal.
      RC_ASSERT(here.parts.size() == there.parts.size());
    }
  });
}

}  // namespace
}  // namespace kempe::laws
