#include "workspace/sweep/polar_bins.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point.hpp"

namespace kempe::sweep {

PolarBins::PolarBins(int rings, int bins, double radius)
    : rings_(rings), bins_(bins), step_(radius / rings),
      change_(static_cast<std::size_t>(rings_ * (bins_ + 1)), 0) {}

void PolarBins::fill(int ring, const Bearings& angles) {
  const double per_bin = bins_ / (2 * pi);
  if (angles.to - angles.from >= 2 * pi) return add(ring, 0, bins_);
  const double first = std::floor(angles.from * per_bin), past = std::ceil(angles.to * per_bin);
  const int count = std::min(bins_, static_cast<int>(past - first));
  const int start = static_cast<int>(first - bins_ * std::floor(first / bins_));
  add(ring, start, std::min(bins_, start + count));
  if (start + count > bins_) add(ring, 0, start + count - bins_);
}

std::vector<std::array<int, 2>> PolarBins::runs(int ring) const {
  std::vector<std::array<int, 2>> found;
  int depth = 0;
  for (int bin = 0; bin <= bins_; ++bin) {
    const int before = depth;
    depth += bin < bins_ ? change_[at(ring, bin)] : -depth;
    if (before == 0 && depth > 0) found.push_back({bin, bin});
    if (before > 0 && depth == 0) found.back()[1] = bin;
  }
  return found;
}

double PolarBins::area() const {
  double sum = 0;
  for (int ring = 0; ring < rings_; ++ring)
    for (const auto& [from, to] : runs(ring)) sum += (to - from) * middle(ring);
  return sum * step_ * 2 * pi / bins_;
}

std::size_t PolarBins::at(int ring, int bin) const {
  return static_cast<std::size_t>(ring) * static_cast<std::size_t>(bins_ + 1) + static_cast<std::size_t>(bin);
}

void PolarBins::add(int ring, int from, int to) {
  if (to <= from) return;
  ++change_[at(ring, from)];
  --change_[at(ring, to)];
}

}  // namespace kempe::sweep
