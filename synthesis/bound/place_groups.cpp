#include "synthesis/bound/place_groups.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace kempe::bounding {
namespace {

void group(PlaceGroups& tree, const std::vector<Point>& places, std::size_t first, std::size_t count) {
  const auto begin = tree.order.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  Point lower = places[*begin], upper = lower;
  for (auto place = begin; place != end; ++place) {
    lower = lower.cwiseMin(places[*place]);
    upper = upper.cwiseMax(places[*place]);
  }
  const Point centre = 0.5 * (lower + upper);
  double radius = 0;
  for (auto place = begin; place != end; ++place) radius = std::max(radius, (places[*place] - centre).norm());
  tree.groups.push_back({first, count, centre, radius});
  if (count == 1) return;
  const bool is_wide = upper.x() - lower.x() >= upper.y() - lower.y();
  const auto along = [&](std::size_t place) { return is_wide ? places[place].x() : places[place].y(); };
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(count / 2), end,
                   [&](std::size_t one, std::size_t other) {
                     return std::pair(along(one), one) < std::pair(along(other), other);
                   });
  group(tree, places, first, count / 2);
  group(tree, places, first + count / 2, count - count / 2);
}

}  // namespace

PlaceGroups groups_of(const std::vector<Point>& places) {
  PlaceGroups tree;
  tree.order.resize(places.size());
  std::iota(tree.order.begin(), tree.order.end(), std::size_t{0});
  if (places.empty()) return tree;
  tree.groups.reserve(2 * places.size() - 1);
  group(tree, places, 0, places.size());
  return tree;
}

}  // namespace kempe::bounding
