// Poles worth starting from. Without obstacles a pole enters only by the annulus in which it sees the region,
// and an annulus inside another one is never worse: what covers the wider one covers the narrower. So the
// poles that matter are those whose annulus holds no other, a curve through the area.
#include <algorithm>
#include <cmath>

#include "synthesis/problem/design_problem.hpp"

namespace kempe {
namespace {

using Sample = SearchSpace::PoleSample;

/// Those that no other beats, by rising farthest distance.
std::vector<Sample> undominated(std::vector<Sample> samples) {
  std::stable_sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return a.distances.farthest < b.distances.farthest ||
           (a.distances.farthest == b.distances.farthest && a.distances.nearest > b.distances.nearest);
  });
  std::vector<Sample> kept;
  for (const Sample& sample : samples)
    if (kept.empty() || sample.distances.nearest > kept.back().distances.nearest) kept.push_back(sample);
  return kept;
}

/// About `count` of them, evenly by the ratio of their distances (the ends included).
std::vector<Point> thinned(const std::vector<Sample>& samples, int count) {
  std::vector<Point> poles;
  if (samples.empty()) return poles;
  const auto ratio = [](const Sample& sample) {
    return std::log(sample.distances.farthest / sample.distances.nearest);
  };
  const double step = (ratio(samples.front()) - ratio(samples.back())) / std::max(1, count - 1);
  double next = ratio(samples.front());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i + 1 < samples.size() && ratio(samples[i]) > next) continue;
    poles.push_back(samples[i].pole);
    next = ratio(samples[i]) - step;
  }
  return poles;
}

}  // namespace

std::vector<Point> DesignProblem::start_poles(int count) const {
  if (!layout_.pole_is_free) return {layout_.origin};
  std::vector<Sample> usable;
  for (const Sample& sample : space_.pole_samples())
    if (sample.distances.nearest > 0 &&
        reach_.lambda_limit(sample.distances.nearest, sample.distances.farthest, allowed_))
      usable.push_back(sample);
  return thinned(undominated(std::move(usable)), count);
}

}  // namespace kempe
