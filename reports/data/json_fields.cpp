#include "reports/data/json_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kempe {
namespace {

using nlohmann::json;

/// A value as it may be shown in a message: on one line and short.
std::string quoted(const json& value) {
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  constexpr std::size_t longest = 60;
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return text;
}

}  // namespace

void JsonField::refuse(const std::string& found, const std::string& allowed) const {
  const auto is_here = [this](const InputError& fault) { return fault.key == path_; };
  if (failed() || std::any_of(log_->faults.begin(), log_->faults.end(), is_here)) return;
  log_->faults.push_back({log_->file, 0, path_, found, allowed});
}

void JsonField::refuse(const std::string& allowed) const {
  if (value_ != nullptr) refuse(quoted(*value_), allowed);
}

JsonField JsonField::operator[](std::string_view key) const {
  const std::string path = path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
  if (value_ == nullptr) return {nullptr, path, *log_};
  if (!value_->is_object()) refuse("an object");
  const auto member = value_->is_object() ? value_->find(std::string(key)) : value_->end();
  if (value_->is_object() && member == value_->end())
    JsonField(nullptr, path, *log_).refuse("nothing", "this key is needed");
  const bool there = value_->is_object() && member != value_->end();
  return {there ? &*member : nullptr, path, *log_};
}

std::optional<JsonField> JsonField::find(std::string_view key) const {
  if (value_ == nullptr || !value_->is_object()) return std::nullopt;
  const auto member = value_->find(std::string(key));
  if (member == value_->end() || member->is_null()) return std::nullopt;
  return (*this)[key];
}

std::vector<std::string> JsonField::unknown_keys(const std::vector<std::string_view>& known) const {
  std::vector<std::string> keys;
  if (value_ == nullptr || !value_->is_object()) return keys;
  for (const auto& [key, value] : value_->items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      keys.push_back(path_.empty() ? key : path_ + "." + key);
  return keys;
}

JsonField::Elements JsonField::elements(std::size_t least, std::size_t most) const {
  if (value_ == nullptr) return {*this, 0};
  if (!value_->is_array() || value_->size() < least || value_->size() > most) {
    refuse(least == most ? fmt::format("an array of {}", least)
                         : fmt::format("an array of at least {}", least));
    return {*this, 0};
  }
  return {*this, value_->size()};
}

JsonField JsonField::Elements::operator[](std::size_t index) const {
  return {&(*array_.value_)[index], fmt::format("{}[{}]", array_.path_, index), *array_.log_};
}

double JsonField::number(double lower, double upper) const {
  const double value = number();
  if (lower <= value && value <= upper) return value;
  refuse(fmt::format("a number from {} to {}", lower, upper));
  return std::clamp(0.0, lower, upper);
}

double JsonField::number() const {
  if (value_ == nullptr) return 0;
  const double value = value_->is_number() ? value_->get<double>() : std::numeric_limits<double>::quiet_NaN();
  if (std::isfinite(value)) return value;
  refuse("a finite number");
  return 0;
}

double JsonField::positive() const {
  const double value = number();
  if (value > 0) return value;
  refuse("a number above 0");
  return 1;
}

std::optional<double> JsonField::number_or_null() const {
  if (value_ == nullptr || value_->is_null()) return std::nullopt;
  return number();
}

std::int64_t JsonField::integer(std::int64_t lower, std::int64_t upper) const {
  if (value_ == nullptr) return lower;
  const bool whole = value_->is_number_integer() &&
                     !(value_->is_number_unsigned() && value_->get<std::uint64_t>() > std::uint64_t{1} << 62);
  const std::int64_t value = whole ? value_->get<std::int64_t>() : lower;
  if (whole && lower <= value && value <= upper) return value;
  refuse(fmt::format("a whole number from {} to {}", lower, upper));
  return lower;
}

std::uint64_t JsonField::natural() const {
  if (value_ == nullptr) return 0;
  if (value_->is_number_unsigned()) return value_->get<std::uint64_t>();
  refuse("a whole number from 0");
  return 0;
}

bool JsonField::boolean() const {
  if (value_ == nullptr) return false;
  if (!value_->is_boolean()) refuse("true or false");
  return value_->is_boolean() && value_->get<bool>();
}

std::string JsonField::text() const {
  if (value_ == nullptr) return {};
  if (!value_->is_string()) refuse("a text in quotes");
  return value_->is_string() ? value_->get<std::string>() : std::string();
}

std::pair<double, double> JsonField::pair() const {
  const auto both = elements(2, 2);
  return both.size() == 2 ? std::pair{both[0].number(), both[1].number()} : std::pair{0.0, 0.0};
}

}  // namespace kempe
