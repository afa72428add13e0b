#pragma once
// A mirrored copy, asked for in whatever words, has one answer.

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace kempe {

/// What is allowed where a mirror image is asked for, and why.
inline constexpr std::string_view no_mirror =
    "a copy that is scaled and turned: this linkage cannot mirror, since pole, tracer and pen are corners of "
    "a triangle that "
    "stays similar to itself and keeps its sense (clockwise or not); mirror the original instead";

/// True of "mirror", "flip_x", "Reflected" and the like: of a key, a table or a value.
inline bool names_a_mirror(std::string_view word) {
  constexpr std::array<std::string_view, 4> stems{"mirror", "flip", "reflect", "handed"};
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(stems.begin(), stems.end(),
                     [&](std::string_view stem) { return lower.find(stem) != std::string::npos; });
}

}  // namespace kempe
