#include "specs/text/ratio.hpp"

#include <charconv>
#include <cmath>

namespace kempe {

std::optional<double> parse_ratio(std::string_view text) {
  const auto number = [](std::string_view part) -> std::optional<double> {
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    const bool whole = error == std::errc() && end == part.data() + part.size();
    return whole && std::isfinite(value) && value > 0 ? std::optional(value) : std::nullopt;
  };
  const std::size_t bar = text.find_first_of(":/");
  if (bar == std::string_view::npos) return number(text);
  const auto over = number(text.substr(0, bar)), under = number(text.substr(bar + 1));
  return over && under ? std::optional(*over / *under) : std::nullopt;
}

}  // namespace kempe
