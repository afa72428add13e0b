// Poses by the million and a search from C++, for python_module.py: the same design, the same places, the same sums.
//
// usage: kempe_python_bench DESIGN.json COUNT ROUNDS

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <kempe/kempe.hpp>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace {

/// A point a step along a spiral about the origin, to 90 mm: some within reach, some not.
std::vector<kempe::Point> spiral(std::size_t count) {
  std::vector<kempe::Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    points[i] = 90 * share * kempe::Point(std::cos(1000 * share), std::sin(1000 * share));
  }
  return points;
}

/// The task of python_module.py.
kempe::Spec small_plagiograph() {
  kempe::Spec spec;
  spec.copy = kempe::Copy::of(1.4, 90 * kempe::degree);
  spec.region = kempe::Region::rectangle({62, -5}, {8, 10});
  spec.links.style.width = 6;
  spec.links.style.pin_diameter = 3;
  return spec;
}

/// CPU time of this process.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  std::ifstream stream(arguments[1], std::ios::binary);
  const auto found = kempe::restore(std::string(std::istreambuf_iterator<char>(stream), {}));
  const auto* design = std::get_if<kempe::FinishedDesign>(&found);
  if (!design) return 1;
  const std::vector<kempe::Point> tracers = spiral(std::strtoul(arguments[2], nullptr, 10));
  double best = std::numeric_limits<double>::infinity(), sum = 0;
  for (int round = std::atoi(arguments[3]); round > 0; --round) {
    const double start = seconds();
    std::vector<kempe::Point> pens(tracers.size());
    for (std::size_t i = 0; i < tracers.size(); ++i) {
      const auto pose = design->pose_with_tracer_at(tracers[i]);
      const auto* there = std::get_if<kempe::Pose>(&pose);
      pens[i] = there ? (design->grounding() == kempe::Grounding::pen ? there->V : there->Y)
                      : kempe::Point::Constant(std::numeric_limits<double>::quiet_NaN());
    }
    best = std::min(best, seconds() - start);
    sum = 0;
    for (const kempe::Point& pen : pens)
      if (pen.allFinite()) sum += pen.x() + pen.y();
  }
  double design_seconds = std::numeric_limits<double>::infinity();
  kempe::Options options;
  options.threads = 1;
  for (int round = std::atoi(arguments[3]); round > 0; --round) {
    const double start = seconds();
    if (!kempe::design(small_plagiograph(), options)) return 1;
    design_seconds = std::min(design_seconds, seconds() - start);
  }
  std::cout.precision(17);
  std::cout << "{\"seconds\": " << best << ", \"sum\": " << sum << ", \"design\": " << design_seconds
            << "}\n";
}
