#pragma once
// What is wrong with something that came from outside: where, what was found, what is allowed.

#include <string>
#include <vector>

#include "kempe/export.hpp"

namespace kempe {

/// A fault of a file, or of a spec filled in a program (then without file and line); and whatever else is wrong there.
struct KEMPE_EXPORT InputError {
  std::string file;     ///< as the user named it; empty if not from a file
  int line = 0;         ///< from 1; 0: no one line
  std::string key;      ///< dotted, as in a spec's file: "copy.scale"; empty: no one key
  std::string found;    ///< what stands there
  std::string allowed;  ///< what may stand there
  /// The further faults, in the order of the file; none of them has others.
  std::vector<InputError> others = {};

  /// Of this fault alone: "FILE:LINE: KEY: found FOUND; allowed: ALLOWED" without the parts that are empty; what could
  /// mislead on a terminal is written out.
  std::string message() const;
  /// This fault's message and those of the others, a line each.
  std::string messages() const;
};

}  // namespace kempe
