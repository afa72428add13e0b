#include "workspace/sweep/bearings.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point.hpp"

namespace kempe::sweep {

std::vector<Bearings> merged(std::vector<Bearings> all, double gap) {
  std::sort(all.begin(), all.end(), [](const Bearings& a, const Bearings& b) { return a.from < b.from; });
  std::vector<Bearings> found;
  for (const Bearings& one : all) {
    if (!found.empty() && one.from <= found.back().to + gap)
      found.back().to = std::max(found.back().to, one.to);
    else
      found.push_back(one);
  }
  return found;
}

void add_turned(const Bearings& angles, const Bearings& turned, std::vector<Bearings>& all) {
  const double width = std::min(2 * pi, angles.to - angles.from + turned.to - turned.from);
  double from = angles.from + turned.from;
  from -= 2 * pi * std::floor(from / (2 * pi));
  all.push_back({from, std::min(from + width, 2 * pi)});
  if (from + width > 2 * pi) all.push_back({0, from + width - 2 * pi});
}

}  // namespace kempe::sweep
