#pragma once
// Intervals of the opening d = arg q - arg p, the one inner freedom of the copying linkage.

#include <optional>
#include <vector>

namespace kempe {

/// A closed interval of the opening, rad, within [-pi, pi]; empty when lower > upper.
struct OpeningInterval {
  double lower = 1;
  double upper = 0;

  bool empty() const { return !(lower <= upper); }
  double width() const { return empty() ? 0 : upper - lower; }
  double middle() const { return 0.5 * (lower + upper); }
  bool contains(double opening) const { return lower <= opening && opening <= upper; }
  bool contains(const OpeningInterval& other) const {
    return other.empty() || (lower <= other.lower && other.upper <= upper);
  }
  bool operator==(const OpeningInterval&) const = default;
};

/// The openings in both; empty if there are none.
OpeningInterval intersect(const OpeningInterval& a, const OpeningInterval& b);

/// The interval without `margin` (rad, >= 0) at each end.
OpeningInterval shrink(const OpeningInterval& interval, double margin);

/// The widest of the intervals (the first of equals); nothing for none.
std::optional<OpeningInterval> widest(const std::vector<OpeningInterval>& intervals);

}  // namespace kempe
