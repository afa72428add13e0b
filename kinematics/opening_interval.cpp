#include "kinematics/opening_interval.hpp"

#include <algorithm>

namespace kempe {

OpeningInterval intersect(const OpeningInterval& a, const OpeningInterval& b) {
  if (a.empty() || b.empty()) return {};
  const OpeningInterval both{std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
  return both.empty() ? OpeningInterval{} : both;
}

OpeningInterval shrink(const OpeningInterval& interval, double margin) {
  const OpeningInterval inner{interval.lower + margin, interval.upper - margin};
  return inner.empty() ? OpeningInterval{} : inner;
}

std::optional<OpeningInterval> widest(const std::vector<OpeningInterval>& intervals) {
  const auto best = std::max_element(intervals.begin(), intervals.end(),
                                     [](const auto& a, const auto& b) { return a.width() < b.width(); });
  if (best == intervals.end() || best->empty()) return std::nullopt;
  return *best;
}

}  // namespace kempe
