// The kernels: poses one by one and in columns, a Newton step, a contact interval, the load error, the map, the search.

#include <benchmark/benchmark.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "forward_task.hpp"
#include "kinematics/planar/factors.hpp"
#include "kinematics/pose_batch.hpp"
#include "map_task.hpp"
#include "specs/spec_reader.hpp"
#include "synthesis/loads/load_error.hpp"
#include "synthesis/search/search.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

const std::string examples = KEMPE_SOURCE_DIR "/specs/examples/";

CopyingLinkage plagiograph() { return bench::report_task().linkage; }

/// Tracers on a circle within the reach, in columns.
struct Circle {
  std::vector<double> x, y;
  explicit Circle(std::size_t count) : x(count), y(count) {
    for (std::size_t i = 0; i < count; ++i) {
      const double turn = 2 * pi * static_cast<double>(i) / static_cast<double>(count);
      x[i] = 66 + 5 * std::cos(turn);
      y[i] = 5 * std::sin(turn);
    }
  }
};

void per_item(benchmark::State& state, std::int64_t items) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * items);
  state.counters["s_per_item"] =
      benchmark::Counter(static_cast<double>(state.iterations() * items),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void pose(benchmark::State& state) {
  const CopyingLinkage linkage = plagiograph();
  const Circle tracers(1000);
  for (auto _ : state)
    for (std::size_t i = 0; i < tracers.x.size(); ++i)
      benchmark::DoNotOptimize(linkage.pose_with_tracer_at({tracers.x[i], tracers.y[i]}));
  per_item(state, 1000);
}
BENCHMARK(pose);

void pose_batch(benchmark::State& state) {
  const CopyingLinkage linkage = plagiograph();
  const Circle tracers(static_cast<std::size_t>(state.range(0)));
  PoseBatch poses;
  poses_with_tracer_at(linkage, tracers.x, tracers.y, poses);  // takes its room
  for (auto _ : state) {
    poses_with_tracer_at(linkage, tracers.x, tracers.y, poses);
    benchmark::DoNotOptimize(poses.reached());
  }
  if (poses.reached() != tracers.x.size()) throw std::logic_error("a pose is missing");
  per_item(state, state.range(0));
}
BENCHMARK(pose_batch)->RangeMultiplier(10)->Range(1000, 10'000'000);

bench::ForwardTask linkage_task(const char* name) {
  return bench::forward_task(examples + "linkages/" + name + ".toml", 360);
}

void newton_step(benchmark::State& state, const char* name) {
  const bench::ForwardTask task = linkage_task(name);
  const auto path = PlanarPath::from(task.model.linkage, task.start, task.values.front());
  if (!path) throw std::logic_error("does not start");
  PlanarEquations equations = path->equations();
  PlanarFactors factors(equations);
  const Eigen::VectorXd q = path->unknowns();
  Eigen::VectorXd f, change;
  Eigen::MatrixXd jacobian;
  for (auto _ : state) {
    equations.residual_and_jacobian(q, f, jacobian);
    factors.compute(jacobian);
    factors.solve(f, change);
    benchmark::DoNotOptimize(change.data());
  }
  state.counters["unknowns"] = static_cast<double>(q.size());
  per_item(state, 1);
}
BENCHMARK_CAPTURE(newton_step, plagiograph, "plagiograph");
BENCHMARK_CAPTURE(newton_step, peaucellier, "peaucellier-lipkin");

/// A degree a pose, certified and solved to rounding.
void general_solver_pose(benchmark::State& state, const char* name) {
  const bench::ForwardTask task = linkage_task(name);
  auto path = PlanarPath::from(task.model.linkage, task.start, task.values.front());
  if (!path) throw std::logic_error("does not start");
  std::size_t i = 0;
  for (auto _ : state) {
    if (!path->advance(task.values[i])) throw std::logic_error("stopped");
    i = (i + 1) % task.values.size();
  }
  per_item(state, 1);
}
BENCHMARK_CAPTURE(general_solver_pose, plagiograph, "plagiograph");

void contact_interval(benchmark::State& state) {
  const MapTask task = bench::report_task();
  for (auto _ : state)
    benchmark::DoNotOptimize(contact_free_openings(
        task.linkage, task.style, task.layers, task.limits.clearance, task.linkage.assembly_mode().openings));
  per_item(state, 1);
}
BENCHMARK(contact_interval);

/// Worst and least over all openings that a region uses.
void load_error(benchmark::State& state) {
  const CopyingLinkage linkage = plagiograph();
  const LoadErrorProfile profile(linkage.k(), linkage.grounding(), {}, {"steel", 200000, 7850, 235}, 10);
  const OpeningInterval openings = linkage.openings_with_transmission(radians(30));
  for (auto _ : state) benchmark::DoNotOptimize(profile.over({linkage.VA(), linkage.VB()}, openings));
  per_item(state, 1);
}
BENCHMARK(load_error);

void map(benchmark::State& state) {
  const MapTask task = bench::task_with(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(map_workspace(task, {.largest_sheets = false}));
  per_item(state, 1);
}
BENCHMARK(map)->Arg(0)->Arg(50)->Unit(benchmark::kMillisecond);

void search(benchmark::State& state, const char* name) {
  const auto spec = read_spec_file(examples + name + ".toml");
  if (!spec) throw std::logic_error("cannot read the spec");
  for (auto _ : state) benchmark::DoNotOptimize(synthesize(*spec, {}));
  per_item(state, 1);
}
BENCHMARK_CAPTURE(search, plagiograph, "plagiograph")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(search, nameplate, "nameplate")->Unit(benchmark::kMillisecond);

/// The nameplate with a limit on the load error that binds: 0.009 mm where the smallest gives way by 0.0101 mm.
void search_with_load(benchmark::State& state) {
  auto spec = read_spec_file(examples + "nameplate.toml");
  if (!spec) throw std::logic_error("cannot read the spec");
  spec->material = Material{"steel", 200000, 7850, 235};
  spec->load = Load{10};
  spec->limits.load_error = 0.009;
  for (auto _ : state) benchmark::DoNotOptimize(synthesize(*spec, {}));
  per_item(state, 1);
}
BENCHMARK(search_with_load)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kempe
