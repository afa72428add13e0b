// How long the map takes by number of obstacles and by tolerance, and its parts.
//
// What is mapped stands in map_task.hpp.

#include <benchmark/benchmark.h>

#include <cmath>

#include "map_task.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/map/layer_choice.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using namespace bench;

const MapOptions no_sheets{.largest_sheets = false};

void map_by_obstacles(benchmark::State& state) {
  const MapTask task = task_with(static_cast<int>(state.range(0)));
  WorkspaceMap map;
  for (auto _ : state) map = map_workspace(task, no_sheets);
  const double free = area(map.collision_free), uncertain = area(map.uncertain);
  state.counters["free_mm2"] = free;
  state.counters["uncertain_share"] = free > 0 ? uncertain / free : 0;
}
BENCHMARK(map_by_obstacles)
    ->Arg(0)
    ->Arg(1)
    ->Arg(2)
    ->Arg(5)
    ->Arg(10)
    ->Arg(25)
    ->Arg(50)
    ->Arg(100)
    ->Arg(200)
    ->Arg(400)
    ->Unit(benchmark::kMillisecond);

void map_by_tolerance(benchmark::State& state) {
  const MapTask task = task_with(20);
  const double tolerance = 1.0 / static_cast<double>(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(map_workspace(task, {.map_tolerance = tolerance, .largest_sheets = false}));
}
BENCHMARK(map_by_tolerance)->Arg(20)->Arg(100)->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond);

void free_openings(benchmark::State& state) {
  const MapTask task = report_task();
  const auto layers = layer_assignments(4)[static_cast<std::size_t>(state.range(0))];
  for (auto _ : state)
    benchmark::DoNotOptimize(
        contact_free_openings(task.linkage, task.style, layers, 0.5, task.linkage.assembly_mode().openings));
}
BENCHMARK(free_openings)->Arg(0)->Arg(37)->Unit(benchmark::kMicrosecond);

void smallest_self_gap(benchmark::State& state) {
  const MapTask task = report_task();
  for (auto _ : state)
    benchmark::DoNotOptimize(smallest_gap_over(task.linkage, task.style, task.layers, {0.5, 1.2}));
}
BENCHMARK(smallest_self_gap)->Unit(benchmark::kMicrosecond);

/// A region of 10^5 corners and 40 holes, its copy a few millimetres from an obstacle.
void region_of_many_corners(benchmark::State& state) {
  MapTask task = report_task();
  task.obstacles = {{disc({122, 0}, 15, 20), 1, 2, {}}};
  Polygon comb = disc({0, -68.5}, 5, 60'000);
  for (int i = 0; i < 40; ++i) {
    Ring hole = disc({-2.8 + 0.8 * (i % 8), -70.7 + 1.1 * (i / 8)}, 0.3, 1000).outer;
    comb.holes.emplace_back(hole.rbegin(), hole.rend());
  }
  task.region = {{comb}};
  bool covered = false, uncertain = false;
  for (auto _ : state) {
    const Coverage coverage = map_workspace(task, no_sheets).coverage;
    covered = coverage.covered;
    uncertain = coverage.uncertain;
  }
  state.counters["covered"] = covered;
  state.counters["uncertain"] = uncertain;
}
BENCHMARK(region_of_many_corners)->Unit(benchmark::kMillisecond);

void obstacle_of_a_million_corners(benchmark::State& state) {
  MapTask task = report_task();
  task.obstacles = {{disc({100, 0}, 20, 1'000'000), 1, 2, {}}};
  for (auto _ : state) benchmark::DoNotOptimize(map_workspace(task, no_sheets));
}
BENCHMARK(obstacle_of_a_million_corners)->Unit(benchmark::kMillisecond);

void map_with_largest_sheets(benchmark::State& state) {
  MapTask task = task_with(10);
  task.region = {{disc({0, -64}, 5, 40)}};
  for (auto _ : state) benchmark::DoNotOptimize(map_workspace(task, {}));
}
BENCHMARK(map_with_largest_sheets)->Unit(benchmark::kMillisecond);

void all_layer_assignments(benchmark::State& state) {
  MapTask task = task_with(10);
  task.region = {{disc({0, -64}, 5, 40)}};
  for (auto _ : state) benchmark::DoNotOptimize(choose_layers(task, 4));
}
BENCHMARK(all_layer_assignments)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kempe
