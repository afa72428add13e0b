#include "reports/pictures/html_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/fixed_text.hpp"
#include "geometry/point.hpp"
#include "reports/pictures/round_step.hpp"

namespace kempe {
namespace {

constexpr std::string_view no_break_space = "\u00a0";
constexpr std::string_view narrow_space = "\u202f";
constexpr std::string_view replacement = "\ufffd";

std::string_view reference_of(char c) {
  switch (c) {
    case '&': return "&amp;";
    case '<': return "&lt;";
    case '>': return "&gt;";
    case '"': return "&quot;";
    case '\'': return "&#39;";
    default: return {};
  }
}

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f;
}

std::string superscript(int exponent) {
  static constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size() + text.size() / 8);
  std::size_t copied = 0;  // of the text; pieces without anything to escape are copied whole
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto reference = reference_of(c);
    if (reference.empty() && !is_control(c)) continue;
    escaped += text.substr(copied, i - copied);
    if (!reference.empty())
      escaped += reference;
    else if (c != '\r')
      escaped += replacement;
    copied = i + 1;
  }
  escaped += text.substr(copied);
  return escaped;
}

std::string script_escaped(std::string_view json) {
  std::string escaped;
  escaped.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      escaped += "\\u003c";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (j < count ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) text += j <= count ? digits[group >> (18 - 6 * j) & 63u] : '=';
  }
  return text;
}

void append_coordinate(std::string& to, double value, int decimals) {
  append_short_text(to, value, decimals);
}

std::string coordinate(double value, int decimals) {
  std::string text;
  append_coordinate(text, value, decimals);
  return text;
}

std::size_t characters_in(std::string_view text) {
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins));
}

std::string number_text(double value, int decimals) {
  std::string text = coordinate(value, decimals);
  if (text.front() == '-') text.replace(0, 1, "\u2212");
  return text;
}

std::string figure_text(double value, int decimals) {
  constexpr double noise = 1e-9;  // mm or N: what rounding leaves
  const bool hides_it = std::abs(value) > noise && std::abs(value) < 0.5 * std::pow(10, -decimals);
  return hides_it ? fmt::format("{:.2g}", value) : number_text(value, decimals);
}

std::string multiple_text(double value, double step, int decimals) {
  const int needed = decimals_of_step(step);
  if (needed <= decimals || value == 0) return number_text(value, decimals);
  const int digits = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9)) + needed + 1;
  return fmt::format("{:.{}g}", value, std::max(1, digits));
}

std::string length_text(double length, int decimals) {
  return fmt::format("{}{}mm", figure_text(length, decimals), no_break_space);
}

std::string error_text(double length) {
  if (std::abs(length) >= 0.1 || length == 0) return number_text(length, 3);
  return std::abs(length) >= 1e-5 ? three_digits(length) : fmt::format("{:.3g}", length);
}

std::string error_length(double length) { return fmt::format("{}{}mm", error_text(length), no_break_space); }

std::string limit_text(double length) { return fmt::format("{:.6g}{}mm", length, no_break_space); }

std::string force_text(double force, int decimals) {
  return fmt::format("{}{}N", figure_text(force, decimals), no_break_space);
}

std::string angle_text(double angle, int decimals) { return number_text(degrees(angle), decimals) + "°"; }

AreaUnit::AreaUnit(double largest)
    : unit_(std::abs(largest) < 100    ? Unit{"mm²", 1, 1}
            : std::abs(largest) < 10e6 ? Unit{"cm²", 100, 2}
                                       : Unit{"m²", 1e6, 4}) {}

std::string AreaUnit::text(double area) const {
  const double value = area / unit_.in_mm2;
  const double size = std::abs(value);
  const int decimals = size >= 100 ? 1 : size >= 1 ? std::min(2, unit_.decimals) : unit_.decimals;
  const double least = std::pow(10, -decimals);
  const bool tiny = value > 0 && value < 0.5 * least;
  return fmt::format("{}{}{}{}", tiny ? "< " : "", number_text(tiny ? least : value, decimals),
                     no_break_space, unit_.name);
}

std::string area_text(double area) { return AreaUnit(area).text(area); }

std::string residual_text(double length) {
  if (length == 0) return fmt::format("0{}mm", no_break_space);
  if (std::abs(length) >= 1e-3) return length_text(length);
  const std::string text = fmt::format("{:.1e}", length);  // rounds before the exponent is chosen
  const std::size_t e = text.find('e');
  double mantissa = 0;  // not by stod: it obeys the locale's decimal comma
  std::from_chars(text.data(), text.data() + e, mantissa);
  return fmt::format("{}·10{}{}mm", number_text(mantissa, 1), superscript(std::stoi(text.substr(e + 1))),
                     no_break_space);
}

std::string count_text(unsigned long long count) {
  std::string text = std::to_string(count);
  for (auto end = static_cast<std::ptrdiff_t>(text.size()) - 3; end > 0; end -= 3)
    text.insert(static_cast<std::size_t>(end), narrow_space);
  return text;
}

}  // namespace kempe
