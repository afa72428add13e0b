#pragma once
// A link's form in one word, as the files name it.

#include <string_view>

#include "workspace/parts.hpp"

namespace kempe {

/// "bar", "bent" or "triangle": as the spec asks for it.
inline std::string_view shape_name(Link link, const LinkStyle& style) {
  if (joints_of(link).count == 2) return "bar";
  return style.plate == PlateStyle::bent ? "bent" : "triangle";
}

/// As it is made: "straight" where a plate's three joints lie on one line.
inline std::string_view shape_as_made(Link link, const LinkStyle& style, Complex shape) {
  return joints_of(link).count == 3 && is_straight(shape) ? "straight" : shape_name(link, style);
}

}  // namespace kempe
