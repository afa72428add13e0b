// A thousand-step drag of a spec: region, pole, obstacles, scale and rotation move by small steps there and back, and every step
// is sketched from the last. Prints a line of JSON: CPU times, and how far the sketches are from the search's designs.
// usage: kempe_drag_bench SPEC.toml [steps] [every]

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <variant>
#include <vector>

#include "kempe/validate.hpp"
#include "specs/spec_check.hpp"
#include "synthesis/search/search.hpp"
#include "synthesis/search/sketch.hpp"

namespace {

using namespace kempe;

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void move(Ring& ring, const Point& by) {
  for (Point& corner : ring) corner += by;
}
void move(Polygon& polygon, const Point& by) {
  move(polygon.outer, by);
  for (Ring& hole : polygon.holes) move(hole, by);
}

double extent_of(const Region& region) {
  Point lower = region.polygons.front().outer.front(), upper = lower;
  for (const Polygon& polygon : region.polygons)
    for (const Point& corner : polygon.outer) lower = lower.cwiseMin(corner), upper = upper.cwiseMax(corner);
  return (upper - lower).norm();
}

/// The spec at one step: five handles in turn, each there and back along a smooth way.
Spec dragged(const Spec& spec, int step, int steps) {
  constexpr int handles = 5;
  const int handle = step * handles / steps;
  const double t = static_cast<double>(step * handles % steps) / steps;
  const double far = std::sin(pi * t), round = std::sin(2 * pi * t);
  const double reach = 0.05 * extent_of(spec.region);
  Spec moved = spec;
  switch (handle) {
    case 0:  // a corner of the region
      moved.region.polygons.front().outer.front() += reach * far * Point(-0.3, -0.2);
      break;
    case 1:  // the pole
      if (auto* at = std::get_if<Point>(&moved.pole.place))
        *at += reach * Point(0.5 * far, 0.5 * round);
      else
        for (Polygon& polygon : std::get<Region>(moved.pole.place).polygons)
          move(polygon, reach * Point(far, round));
      break;
    case 2:  // an obstacle, or where there is none the region
      if (moved.obstacles.empty())
        for (Polygon& polygon : moved.region.polygons) move(polygon, reach * Point(far, round));
      else
        move(moved.obstacles.front().shape, reach * Point(far, round));
      break;
    case 3: moved.copy = Copy::of(spec.copy.scale() * (1 + 0.1 * far), spec.copy.rotation()); break;
    default: moved.copy = Copy::of(spec.copy.scale(), spec.copy.rotation() + 5 * degree * round);
  }
  return moved;
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 1000, every = argc > 3 ? std::atoi(argv[3]) : 25;
  const auto read = load(argv[1]);
  if (!std::holds_alternative<Spec>(read)) return 2;
  const Spec& spec = std::get<Spec>(read);
  SearchOptions options;
  options.diagnose = false;
  const auto first = synthesize(spec, options);
  if (!std::holds_alternative<FoundDesign>(first)) return 1;
  SketchedDesign last = sketch_of(std::get<FoundDesign>(first));
  std::vector<double> times, worse, stated;
  int without = 0, lost = 0, compared = 0, within = 0;
  for (int step = 0; step < steps; ++step) {
    const auto checked = check_spec(dragged(spec, step, steps));
    if (!checked) continue;
    const double start = cpu_s();
    last = sketched(*checked, last);
    times.push_back(1e3 * (cpu_s() - start));
    without += !last.design;
    if (last.design && last.bound) stated.push_back(std::abs(last.design->value / *last.bound - 1));
    if (step % every != 0) continue;
    const auto best = synthesize(*checked, options);
    const auto* found = std::get_if<FoundDesign>(&best);
    if (!found) continue;
    ++compared;
    if (!last.design) {
      ++lost;
      continue;
    }
    const double share = is_maximized(found->goal) ? found->value / last.design->value - 1
                                                   : last.design->value / found->value - 1;
    worse.push_back(share);
    within += share <= 0.02;
    if (share > 0.02)
      fmt::print(stderr, "step {}: {} ({}, mode {}) instead of {} ({}, mode {})\n", step, last.design->value,
                 name(last.design->linkage.grounding()), last.design->linkage.assembly_mode().number,
                 found->value, name(found->linkage.grounding()), found->linkage.assembly_mode().number);
  }
  fmt::print(
      R"({{"steps": {}, "ms_median": {:.3f}, "ms_95": {:.3f}, "ms_99": {:.3f}, "ms_most": {:.3f}, "without": {}, "compared": {}, "lost": {}, "within_2_percent": {}, "worse_median": {:.5f}, "worse_95": {:.5f}, "worse_most": {:.5f}, "stated_median": {:.4f}, "stated_95": {:.4f}}})"
      "\n",
      times.size(), percentile(times, 0.5), percentile(times, 0.95), percentile(times, 0.99),
      percentile(times, 1), without, compared, lost, within, percentile(worse, 0.5), percentile(worse, 0.95),
      percentile(worse, 1), percentile(stated, 0.5), percentile(stated, 0.95));
}
