#pragma once
// The limits that have a value: how a person knows each, how far it may be moved, and the value that would do.

#include <array>
#include <optional>

#include "specs/spec_keys.hpp"
#include "synthesis/problem/requirements.hpp"

namespace kempe {

/// A limit that can be moved.
struct MovableLimit {
  Goal goal;
  const char* key;
  double unit;     ///< the key's unit in mm or rad
  double loosest;  ///< that a spec can state, in mm or rad; what can be left out is looser still
};

inline constexpr std::array movable_limits{
    MovableLimit{Goal::transmission, "limits.transmission_deg", pi / 180, 0},
    MovableLimit{Goal::clearance, "limits.clearance_mm", 1, 0},
    MovableLimit{Goal::longest, "links.longest_mm", 1, 1e6},
    MovableLimit{Goal::copy_gap, "limits.sheets_gap_mm", 1, 0},
    MovableLimit{Goal::copy_error, "limits.copy_error_mm", 1, 1e3},
    MovableLimit{Goal::load_error, "limits.load_error_mm", 1, 1e3},
    MovableLimit{Goal::pole_margin, "pole.within_mm", 1, 1e4},
};

/// The limit's value in force; nothing if the spec does not have it.
std::optional<double> value_of(const Requirements& limits, const Spec& spec, Goal goal);

/// The limit moved past the value attained (slack::give_of_value), rounded outwards to at most six digits in its own
/// unit; never past the loosest.
double possible_value(const MovableLimit& limit, double demanded, double attained);

/// The same limit where the spec's file has lengths in that unit; its key is named as ever.
MovableLimit stated_in(SpecUnit unit, MovableLimit limit);

/// "limits.transmission_deg = 30 is in the way; 27.4 would do"; of a limit stated in that unit.
std::string sentence_of(const MovableLimit& limit, double demanded, double possible, SpecUnit unit);

}  // namespace kempe
