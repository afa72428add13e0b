#pragma once
// What must hold whatever the input: a fault here is the program's own.

#include <string_view>

namespace kempe {

/// Ends the program if `holds` is false, with `condition` and the caller's place on standard error. In every build: a result
/// that rests on a broken invariant is worse than none.
void invariant(bool holds, std::string_view condition, const char* file = __builtin_FILE(),
               int line = __builtin_LINE());

}  // namespace kempe
