#pragma once
// Bars that hold three points in a line: said by distances alone such a figure is shaky (its equations lose
// rank in every position), said as one straight link it is rigid.

#include <string>
#include <vector>

#include "specs/linkages/linkage_file.hpp"

namespace kempe {

struct StraightBars {
  std::vector<FileLink> links;     ///< one a straight row of three or more points, named after them: "O-A-C"
  std::vector<FileBar> remaining;  ///< bars that belong to no such row
  std::vector<std::string> notes;  ///< a sentence a row: what was read, and how to say it better
};

/// Takes together bars A-B, B-C, A-C whose lengths add up (|AB| + |BC| = |AC| within 1e-9), and further
/// points that two of a row's points hold in the same line. `unit` is for the notes.
StraightBars join_straight_bars(const std::vector<FileBar>& bars, const LengthUnit& unit);

}  // namespace kempe
