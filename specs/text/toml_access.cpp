#include "specs/text/toml_access.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <vector>

namespace kempe {
namespace {

/// The parser and its destructors recurse once per part of a dotted key: a.a.a. ... overflows the stack. No
/// file of ours nests keys deeper than this.
constexpr int deepest_dotted_key = 16;

bool may_stand_in_a_key(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == ' ' || c == '\t';
}

/// Where the string that opens at `start` has ended; strings that never close end with the text or, if of one
/// line, with the line.
std::size_t after_string(std::string_view text, std::size_t start) {
  const char quote = text[start];
  const bool long_string = text.substr(start, 3) == std::string(3, quote);
  const std::string close(long_string ? 3 : 1, quote);
  for (std::size_t i = start + close.size(); i < text.size(); ++i) {
    if (text.substr(i, close.size()) == close) return i + close.size();
    if (text[i] == '\n' && !long_string) return i;
    if (text[i] == '\\' && quote == '"') ++i;
  }
  return text.size();
}

/// The place of a run of more dots than any key of ours has, or nothing. Strings and comments may hold any.
std::optional<std::size_t> find_deep_key(std::string_view text) {
  int dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '#') {
      i = std::min(text.find('\n', i), text.size() - 1);
      dots = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      i = after_string(text, i) - 1;
    } else if (text[i] == '.') {
      if (++dots > deepest_dotted_key) return i;
    } else if (!may_stand_in_a_key(text[i])) {
      dots = 0;
    }
  }
  return std::nullopt;
}

int line_at(std::string_view text, std::size_t place) {
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

/// The line of a text, from 1; empty beyond its end.
std::string_view line_of_text(std::string_view text, int number) {
  for (; number > 1 && !text.empty(); --number)
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

/// Whether a line says "key = 0,5".
bool has_decimal_comma(std::string_view line) {
  static const std::regex form(R"(^[^#"'=]*=\s*[-+]?\d*,\d+\s*(#.*)?\r?$)");
  return line.size() < 200 && std::regex_match(line.begin(), line.end(), form);
}

/// "Error while parsing value: X" in the words of our messages.
std::string cause_of(std::string_view description) {
  constexpr std::string_view preface = "Error while parsing ";
  std::string text = printable(description, 200);
  const std::size_t colon = text.find(": ");
  if (!text.starts_with(preface) || colon == std::string::npos) return text;
  return "a " + text.substr(preface.size(), colon - preface.size()) +
         " that cannot be read: " + text.substr(colon + 2);
}

/// "[1, nan]" of a few plain values, else "a list of 7".
std::string describe_list(const toml::array& list) {
  constexpr std::size_t few = 4;
  if (list.empty()) return "an empty list";
  const bool plain = std::all_of(list.begin(), list.end(), [](const auto& one) { return one.is_value(); });
  if (!plain || list.size() > few) return fmt::format("a list of {}", list.size());
  std::vector<std::string> values;
  for (const toml::node& one : list) values.push_back(describe(one));
  return fmt::format("[{}]", fmt::join(values, ", "));
}

}  // namespace

tl::expected<toml::table, InputError> parse_toml(std::string_view text, const std::string& file_name) {
  const auto refuse = [&](int line, std::string found, std::string allowed) {
    return tl::unexpected(InputError{file_name, line, "", std::move(found), std::move(allowed)});
  };
  if (text.empty()) return refuse(0, "an empty file", "a TOML file");
  if (const auto place = find_deep_key(text)) {
    return refuse(line_at(text, *place), "a key of too many parts",
                  fmt::format("keys of at most {} parts", deepest_dotted_key + 1));
  }
  try {
    return toml::parse(text, std::string_view(file_name));
  } catch (const toml::parse_error& error) {
    const int line = static_cast<int>(error.source().begin.line);
    return refuse(
        line, cause_of(error.description()),
        has_decimal_comma(line_of_text(text, line)) ? "TOML 1.0 (decimals take a point: 0.5)" : "TOML 1.0");
  }
}

std::string describe(const toml::node& node) {
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (const auto* text = node.as_string()) return fmt::format("text \"{}\"", printable(text->get(), 40));
  if (const auto* list = node.as_array()) return describe_list(*list);
  return node.is_table() ? "a table" : "a date or time";
}

std::optional<double> finite_number(const toml::node& node) {
  if (const auto* number = node.as_integer()) return static_cast<double>(number->get());
  const auto* number = node.as_floating_point();
  return number && std::isfinite(number->get()) ? std::optional(number->get()) : std::nullopt;
}

std::optional<Point> finite_point(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list || list->size() != 2) return std::nullopt;
  const auto x = finite_number((*list)[0]), y = finite_number((*list)[1]);
  return x && y ? std::optional(Point(*x, *y)) : std::nullopt;
}

int TableView::line_of_key(std::string_view key) const {
  const toml::node* node = find(key);
  return node ? line_of(*node) : line();
}

void TableView::set(std::string_view key, double& value) const {
  if (const toml::node* node = find(key)) value = finite_number(*node).value_or(value);
}

void TableView::set(std::string_view key, std::optional<double>& value) const {
  if (const toml::node* node = find(key)) value = finite_number(*node);
}

void TableView::set(std::string_view key, int& value) const {
  if (const toml::node* node = find(key)) value = static_cast<int>(node->value_or(std::int64_t{value}));
}

void TableView::set(std::string_view key, bool& value) const {
  if (const toml::node* node = find(key)) value = node->value<bool>().value_or(value);
}

void TableView::set(std::string_view key, std::string& value) const {
  if (const toml::node* node = find(key)) value = node->value_or(value);
}

void TableView::set(std::string_view key, Point& value) const {
  if (const toml::node* node = find(key)) value = finite_point(*node).value_or(value);
}

}  // namespace kempe
