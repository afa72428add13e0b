// The map beside a plain grid sampler of equal accuracy: both look at the same two angles, the sampler at the middle of
// every cell of a grid whose cells are as small as those that the map leaves in doubt (0.5 % of the free area), so
// that the same band would stay in doubt, without proof.
//
// usage: kempe_sampler_bench OBSTACLES
// Prints one JSON object: times, the number of samples, and the scene for samplers in other languages.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>

#include "map_task.hpp"
#include "workspace/angle_grid.hpp"
#include "workspace/clearance.hpp"
#include "workspace/contact_scene.hpp"
#include "workspace/reach.hpp"
#include "workspace/subdivision.hpp"

namespace kempe::bench {
namespace {

double cpu_seconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Least CPU seconds of three rounds, and of as many more as fit into half a second: what takes a millisecond is measured as
/// warm as what takes long.
template <class Work>
double least_time(const Work& work) {
  constexpr int rounds = 3;
  constexpr double enough = 0.5;
  double least = 1e300, all = 0;
  for (int i = 0; i < rounds || all < enough; ++i) {
    const double begin = cpu_seconds();
    work();
    const double spent = cpu_seconds() - begin;
    least = std::min(least, spent);
    all += spent;
  }
  return least;
}

OpeningInterval free_openings_of(const MapTask& task) {
  return contact_free_openings(task.linkage, task.style, task.layers, task.clearance,
                               task.linkage.openings_with_transmission(task.transmission))
      .at(0)
      .interval;
}

/// Cells of a grid as fine as the map's cells in doubt.
double samples_needed(const MapTask& task, const ContactScene& scene, const OpeningInterval& openings) {
  const EdgeTree nothing;
  Subdivision cells(scene, nothing, AngleGrid(task.linkage, openings), task.clearance);
  while (cells.open_area() > 0.005 * cells.free_area() && cells.split([](const OpenCell&) { return true; })) {
  }
  const double cell = cells.open_area() / static_cast<double>(cells.open().size());
  return cells.grid().area({0, 0, AngleGrid::turn, AngleGrid::rise}) / cell;
}

nlohmann::ordered_json scene_of(const MapTask& task, const OpeningInterval& openings) {
  auto obstacles = nlohmann::ordered_json::array();
  for (const auto& obstacle : task.obstacles) {
    auto ring = nlohmann::ordered_json::array();
    for (const Point& corner : obstacle.shape.outer) ring.push_back({corner.x(), corner.y()});
    obstacles.push_back(std::move(ring));
  }
  return {{"VA_mm", task.linkage.VA()},
          {"VB_mm", task.linkage.VB()},
          {"shape", {task.linkage.shape().real(), task.linkage.shape().imag()}},
          {"opening", {openings.lower, openings.upper}},
          {"width_mm", task.style.width},
          {"clearance_mm", task.clearance},
          {"obstacles", std::move(obstacles)}};
}

int run(int obstacles) {
  const MapTask task = task_with(obstacles);
  WorkspaceMap map;
  const double map_time = least_time([&] { map = map_workspace(task, {.largest_sheets = false}); });
  const OpeningInterval openings = free_openings_of(task);
  const ContactScene scene(task);
  const double count = samples_needed(task, scene, openings);
  constexpr int tried = 200'000;
  Dice dice;
  int free = 0;
  const double sample_time =
      least_time([&] {
        free = 0;
        for (int i = 0; i < tried; ++i) {
          const double opening = dice.between(openings.lower, openings.upper);
          free += tightest_obstacle(scene, opening, dice.between(-pi, pi)).gap >= task.clearance;
        }
      }) /
      tried;
  const nlohmann::ordered_json json{{"obstacles", obstacles},
                                    {"map_s", map_time},
                                    {"free_mm2", area(map.collision_free)},
                                    {"uncertain_mm2", area(map.uncertain)},
                                    {"samples", count},
                                    {"sample_us", 1e6 * sample_time},
                                    {"sampler_s", sample_time * count},
                                    {"free_share", static_cast<double>(free) / tried},
                                    {"scene", scene_of(task, openings)}};
  fmt::print("{}\n", json.dump());
  return 0;
}

}  // namespace
}  // namespace kempe::bench

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: {} OBSTACLES\n", argv[0]);
    return 2;
  }
  return kempe::bench::run(std::atoi(argv[1]));
}
