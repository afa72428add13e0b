#pragma once
// Linkages next to what has no answer, from the bytes of a fuzzer: joints almost on each other, slides almost parallel or
// coincident, gears of many teeth, in any unit and size.

#include <string>
#include <string_view>

namespace kempe::fuzz {

/// A linkage file that the reader takes. Zeros once the bytes are used up; 64 suffice.
std::string linkage_from_choices(std::string_view input);

enum class Motion { runs, stops, does_not_start };

/// Reads, assembles and moves the linkage of the bytes, and asks for its mobility and centres. Aborts if the file is refused,
/// if a position shown is not closed, or if mobility and drivers contradict a motion that runs.
Motion move_linkage_from_choices(std::string_view input, const std::string& name = "fuzzed linkage");

}  // namespace kempe::fuzz
