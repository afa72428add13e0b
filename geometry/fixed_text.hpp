#pragma once
// Numbers with decimals, as people and drawings read them: never -0.

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

namespace kempe {

/// At a text's end the number with so many decimals; what they show as zero has no minus sign: "0.000" for -0.0001.
inline void append_fixed_text(std::string& to, double value, int decimals) {
  // 309 before the point, at most 400 after it; to fill them first would take longer than the number.
  std::array<char, 720> digits;
  const auto written =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals);
  std::string_view text(digits.data(), static_cast<std::size_t>(written.ptr - digits.data()));
  const bool is_zero = text.find_first_not_of("-0.") == std::string_view::npos;
  if (is_zero && text.starts_with('-')) text.remove_prefix(1);
  to += text;
}

inline std::string fixed_text(double value, int decimals) {
  std::string text;
  append_fixed_text(text, value, decimals);
  return text;
}

/// The same with at most so many decimals: zeros at the end are cut, "12.5", "3", "0".
inline void append_short_text(std::string& to, double value, int decimals) {
  const std::size_t start = to.size();
  append_fixed_text(to, value, decimals);
  if (to.find('.', start) == std::string::npos) return;
  to.erase(to.find_last_not_of('0') + 1);
  if (to.back() == '.') to.pop_back();
}

inline std::string short_text(double value, int decimals) {
  std::string text;
  append_short_text(text, value, decimals);
  return text;
}

/// Rounded to so many digits.
inline double with_digits(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double grain = std::pow(10, std::floor(std::log10(std::abs(value))) - (digits - 1));
  return std::round(value / grain) * grain;
}
inline double with_three_digits(double value) { return with_digits(value, 3); }

/// With three digits and without an exponent: "12300", "4.37", "0.0025".
inline std::string three_digits(double value) {
  if (value == 0 || !std::isfinite(value)) return short_text(value, 0);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  return short_text(with_three_digits(value), decimals > 0 ? decimals : 0);
}

}  // namespace kempe
