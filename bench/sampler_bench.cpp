// The map beside a plain grid sampler of equal accuracy. Both look at the same two angles. The sampler asks for the
// gap at the corners of a grid; a cell whose corners disagree is in doubt, the others it takes for decided, without
// proof. Its grid is as fine as it must be for the same share in doubt as the map's, with cells that are square in the
// tracer's plane.
//
// usage: kempe_sampler_bench OBSTACLES
// Prints one JSON object: times, the number of samples, and the scene for samplers in other languages.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "map_task.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/contact/contact_scene.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"

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
  return contact_free_openings(task.linkage, task.style, task.layers, task.limits.clearance,
                               task.linkage.openings_with_transmission(task.limits.transmission))
      .at(0)
      .interval;
}

struct Sampled {
  double samples;       ///< number of grid corners
  double doubt;         ///< area of cells in doubt over that of free ones
  double free_corners;  ///< share
};

/// Samples a grid of about `count` cells, turned by a share of a cell.
Sampled sample_grid(const MapTask& task, const ContactScene& scene, const OpeningInterval& openings,
                    double count, double turned) {
  const auto radius = [&](double opening) { return task.linkage.radius_at(opening); };
  const double inner = radius(openings.lower), outer = radius(openings.upper);
  const double aspect = pi * (inner + outer) / std::abs(outer - inner);
  const auto across = static_cast<std::size_t>(std::ceil(std::sqrt(count * aspect)));
  const auto upwards = static_cast<std::size_t>(std::ceil(std::sqrt(count / aspect)));
  std::vector<char> below(across), above(across);
  double free = 0, doubt = 0, free_corners = 0, radius_below = inner;
  for (std::size_t j = 0; j <= upwards; ++j) {
    const double opening =
        openings.lower + openings.width() * static_cast<double>(j) / static_cast<double>(upwards);
    for (std::size_t i = 0; i < across; ++i) {
      const double bearing = 2 * pi * (static_cast<double>(i) + turned) / static_cast<double>(across);
      above[i] = tightest_obstacle(scene, opening, bearing).gap >= task.limits.clearance;
      free_corners += above[i];
    }
    const double here = radius(opening), area = std::abs(here * here - radius_below * radius_below);
    for (std::size_t i = 0; j > 0 && i < across; ++i) {
      const std::size_t next = i + 1 < across ? i + 1 : 0;
      const int corners = below[i] + below[next] + above[i] + above[next];
      (corners == 4 ? free : doubt) += corners > 0 ? area : 0;
    }
    radius_below = here;
    std::swap(below, above);
  }
  const double samples = static_cast<double>(across * (upwards + 1));
  return {samples, doubt / free, free_corners / samples};
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
          {"clearance_mm", task.limits.clearance},
          {"obstacles", std::move(obstacles)}};
}

/// Finer grids are not run: their share in doubt falls with the root of the number of samples (3 % from 4,000 to 130,000
/// samples).
constexpr double most_samples = 400'000;
/// Grids of as many sizes, each turned a bit further: how one grid happens to lie on a single obstacle moves the number of
/// samples by 15 %.
constexpr int grids = 12;

int run(int obstacles) {
  const MapTask task = task_with(obstacles);
  WorkspaceMap map;
  const double map_time = least_time([&] { map = map_workspace(task, {.largest_sheets = false}); });
  const OpeningInterval openings = free_openings_of(task);
  const ContactScene scene(task);
  const double doubt = area(map.uncertain) / area(map.collision_free);
  const auto samples_needed = [&](const Sampled& grid) {
    return grid.samples * (grid.doubt / doubt) * (grid.doubt / doubt);
  };
  const double cells = std::min(samples_needed(sample_grid(task, scene, openings, 10'000, 0)), most_samples);
  double samples = 0, free_share = 0, sample_time = 1e300;
  for (int i = 0; i < grids; ++i) {
    const double share = static_cast<double>(i) / grids, begin = cpu_seconds();
    const Sampled grid = sample_grid(task, scene, openings, (0.7 + 0.6 * share) * cells, share);
    sample_time = std::min(sample_time, (cpu_seconds() - begin) / grid.samples);
    samples += samples_needed(grid) / grids;
    free_share += grid.free_corners / grids;
  }
  const nlohmann::ordered_json json{{"obstacles", obstacles},
                                    {"map_s", map_time},
                                    {"free_mm2", area(map.collision_free)},
                                    {"uncertain_mm2", area(map.uncertain)},
                                    {"samples", samples},
                                    {"sample_us", 1e6 * sample_time},
                                    {"sampler_s", sample_time * samples},
                                    {"free_share", free_share},
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
