#pragma once
// Places of the tracer in groups: where nothing can be hit from anywhere in a circle, its places need not be looked at one by one.

#include <cstddef>
#include <vector>

#include "kempe/point.hpp"

namespace kempe::bounding {

/// Places that follow each other in PlaceGroups::order, and a circle around them.
struct PlaceGroup {
  std::size_t first, places;
  Point centre;   ///< mm
  double radius;  ///< mm
};

/// A tree of groups, each before its halves: the first half of a group follows it, the second comes 2 * (places / 2) groups after it.
struct PlaceGroups {
  std::vector<PlaceGroup> groups;
  std::vector<std::size_t> order;  ///< numbers of the places
};
PlaceGroups groups_of(const std::vector<Point>& places);

/// From a group downwards. `visit(group, what)` returns what its halves are to be visited with, null or false if they need not be;
/// `at(number, what)` is called with single places and returns false once that is enough. True if it never did.
template <typename What, typename Visit, typename At>
bool descend(const PlaceGroups& tree, std::size_t group, const What& what, const Visit& visit, const At& at) {
  const PlaceGroup& here = tree.groups[group];
  if (here.places == 1) return at(tree.order[here.first], what);
  const What left = visit(here, what);
  return !left || (descend(tree, group + 1, left, visit, at) &&
                   descend(tree, group + 2 * (here.places / 2), left, visit, at));
}

}  // namespace kempe::bounding
