#include "specs/unit_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace kempe {

std::string name_in(SpecUnit unit, std::string_view dotted_name) {
  std::string name(dotted_name);
  if (unit == SpecUnit::mm) return name;
  for (std::size_t at = name.find("_mm"); at != std::string::npos; at = name.find("_mm", at + 1))
    if (at + 3 == name.size() || name[at + 3] == '.') name.replace(at, 3, "_in");
  return name;
}

std::string keys_in(SpecUnit unit, std::string_view sentence) {
  if (unit == SpecUnit::mm) return std::string(sentence);
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::string text;
  for (auto from = sentence.begin(); from != sentence.end();) {
    const auto to =
        std::find_if(from, sentence.end(), [&](char c) { return is_letter(c) != is_letter(*from); });
    const std::string_view word(&*from, static_cast<std::size_t>(to - from));
    const bool is_key =
        word.ends_with("_mm") && std::any_of(spec_keys().begin(), spec_keys().end(),
                                             [&](const SpecKey& key) { return key.name == word; });
    text += is_key ? name_in(unit, word) : std::string(word);
    from = to;
  }
  return text;
}

std::string number_in(SpecUnit unit, double length) {
  if (unit == SpecUnit::mm) return fmt::format("{}", length);
  constexpr int every_double = 17;
  std::string text;
  for (int digits = 6; digits <= every_double; ++digits) {
    text = fmt::format("{:.{}g}", length / in_mm(unit), digits);
    double number = 0;  // not by stod: it obeys the locale's decimal comma
    std::from_chars(text.data(), text.data() + text.size(), number);
    if (in_mm(unit) * number == length) break;
  }
  return text;
}

std::string length_in(SpecUnit unit, double length) {
  return fmt::format("{} {}", number_in(unit, length), name(unit));
}

}  // namespace kempe
