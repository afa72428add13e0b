#pragma once
// Figures and counts in what the commands print.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace kempe::app {

/// "1 position", "2 positions".
inline std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// Decimals that show lengths of something of that size (mm) to their thousandths of a millimetre, or to five digits if it is small.
inline int decimals_of_size(double size) {
  return std::max(3, 4 - static_cast<int>(std::floor(std::log10(size))));
}

/// With so many decimals; of what they would round to 0 two digits.
inline std::string shown(double value, int decimals) {
  const bool hides_it = value != 0 && std::abs(value) < 0.5 * std::pow(10, -decimals);
  return hides_it ? fmt::format("{:.2g}", value) : fmt::format("{:.{}f}", value, decimals);
}

}  // namespace kempe::app
