#pragma once
// Angles about the pole, and unions of them.

#include <vector>

namespace kempe::sweep {

/// Angles from `from` counter-clockwise to `to`, rad; from <= to.
struct Bearings {
  double from, to;
};

/// Those that overlap, or come as near to each other as `gap`, joined, by rising angle.
std::vector<Bearings> merged(std::vector<Bearings> all, double gap = 0);

/// The angles shifted by every bearing between two, cut at a whole turn; added to `all`.
void add_turned(const Bearings& angles, const Bearings& turned, std::vector<Bearings>& all);

}  // namespace kempe::sweep
