#pragma once
// Values that several parts of a stored design have.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kempe/point.hpp"
#include "kinematics/grounding.hpp"
#include "reports/data/json_fields.hpp"

namespace kempe::stored {

/// mm; ten kilometres: beyond it squares lose the micrometre.
inline constexpr double largest_coordinate = 1e7;
/// More entries than any array of a file may have.
inline constexpr std::size_t many = 10'000'000;

/// The value of the word that stands there; the first one if none of the words does.
template <class Value>
Value one_of(const JsonField& field, const std::vector<std::pair<std::string, Value>>& choices) {
  const std::string text = field.text();
  std::string allowed;
  for (const auto& [word, value] : choices) {
    if (text == word) return value;
    allowed += (allowed.empty() ? "\"" : ", \"") + word + "\"";
  }
  field.refuse(allowed);
  return choices.front().second;
}

double coordinate(const JsonField& field);
/// mm, above 0.
double length(const JsonField& field);
/// A length that may be absent.
std::optional<double> perhaps_length(const JsonField& field, std::string_view key);
Point point(const JsonField& field);
Region region(const JsonField& field);
Polygon one_polygon(const JsonField& field);
Joint joint(const JsonField& field);
Grounding grounding(const JsonField& field);

}  // namespace kempe::stored
