#pragma once
// A link's form in one word, as the files name it.

#include <string_view>

#include "workspace/parts.hpp"

namespace kempe {

/// "bar", "bent" or "triangle".
inline std::string_view shape_name(Link link, const LinkStyle& style) {
  if (joints_of(link).count == 2) return "bar";
  return style.plate == PlateStyle::bent ? "bent" : "triangle";
}

}  // namespace kempe
