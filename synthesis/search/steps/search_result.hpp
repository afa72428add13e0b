#pragma once
// What the search for one goal comes back with, and which of two is better.

#include <algorithm>

#include "synthesis/search/steps/outcome.hpp"
#include "synthesis/search/steps/rank.hpp"

namespace kempe {

struct SearchResult {
  std::optional<FoundDesign> design{};
  bool stopped = false;        ///< by time or by request
  bool proven_none = false;    ///< interval arithmetic proves that no design keeps the limits
  bool exhausted = false;      ///< the tree leaves nothing better that the search could find
  bool none_in_stock = false;  ///< there is a design with any lengths, and none was found with stock lengths
  /// That no design with the exact ratio beats, of the goal; where one was proven.
  std::optional<double> bound{};
  std::uint64_t evaluations = 0;
};

inline bool has_design(const SearchResult& found) { return found.design.has_value(); }

/// True if a has the better value of the goal, or at one value the smaller size, by more than rounding; both have been found for it.
inline bool is_better(Goal goal, const FoundDesign& a, const FoundDesign& b) {
  const double here = rank(a.value), there = rank(b.value);
  if (here == there) return rank(a.attained.size) < rank(b.attained.size);
  return is_maximized(goal) ? here > there : here < there;
}

/// `best` becomes `other` if that is better, or all there is.
inline void keep_better(Goal goal, const std::optional<FoundDesign>& other,
                        std::optional<FoundDesign>& best) {
  if (other && (!best || is_better(goal, *other, *best))) best = other;
}

/// The one of two bounds that says more; `one` may be absent.
inline double tighter_bound(Goal goal, const std::optional<double>& one, double other) {
  if (!one) return other;
  return is_maximized(goal) ? std::min(*one, other) : std::max(*one, other);
}

}  // namespace kempe
