#include "specs/linkages/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "specs/key_checks.hpp"
#include "specs/linkages/keys.hpp"

namespace kempe {
namespace {

constexpr double largest_number = 1e9;

std::vector<NameAt> names_in(const toml::array& list) {
  std::vector<NameAt> result;
  for (const toml::node& element : list)
    result.push_back({element.value_or(std::string()), line_of(element)});
  return result;
}

bool is_list_of_names(const toml::node& node) {
  const toml::array* list = node.as_array();
  return list && !list->empty() && std::all_of(list->begin(), list->end(), [](const toml::node& element) {
           return !element.value_or(std::string()).empty();
         });
}

/// Keys of links.* may be the user's own: lengths "A-B" and angles "A-B-C_deg".
bool is_measure(std::string_view rules, std::string_view key) {
  return rules == "links.*" && key.find('-') != std::string_view::npos;
}

}  // namespace

LinkageTable::LinkageTable(const toml::table& table, std::string rules, std::string path,
                           Complaints& complaints)
    : table_(table), rules_(std::move(rules)), path_(std::move(path)), complaints_(complaints) {
  check_keys();
}

void LinkageTable::check_keys() const {
  for (const auto& [key, value] : table_) {
    if (find_linkage_key(rules_, key.str()) || is_measure(rules_, key.str())) continue;
    complaints_.add(static_cast<int>(key.source().begin.line), dotted(key.str()), "an unknown key",
                    known_instead(key.str(), linkage_key_names(rules_)));
  }
}

int LinkageTable::line(std::string_view key) const { return has(key) ? line_of(*find(key)) : line(); }

std::string LinkageTable::dotted(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

std::vector<NameAt> LinkageTable::keys() const {
  std::vector<std::pair<toml::source_position, std::string>> sorted;
  for (const auto& [key, value] : table_) sorted.emplace_back(key.source().begin, std::string(key.str()));
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<NameAt> result;
  for (auto& [place, key] : sorted) result.push_back({std::move(key), static_cast<int>(place.line)});
  return result;
}

std::string LinkageTable::allowed(std::string_view key) const {
  const LinkageKey* rule = find_linkage_key(rules_, key);
  if (!rule && is_measure(rules_, key))
    rule = find_linkage_key(rules_, key.ends_with("_deg") ? "A-B-C_deg" : "A-B");
  return rule ? std::string(rule->allowed) : std::string();
}

void LinkageTable::refuse(std::string_view key, std::string found, std::string what) const {
  complaints_.add(line(key), dotted(key), std::move(found), what.empty() ? allowed(key) : std::move(what));
}

void LinkageTable::missing(std::string_view key) const { refuse(key, "nothing"); }

std::optional<double> LinkageTable::number(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const auto value = finite_number(*node);
  if (value && std::abs(*value) <= largest_number) return value;
  refuse(key, describe(*node), allowed(key) + " (a finite number, at most 1e9)");
  return std::nullopt;
}

std::optional<double> LinkageTable::positive(std::string_view key, double least) const {
  const auto value = number(key);
  if (value && !(*value > 0 && *value >= least)) {
    refuse(key, describe(*find(key)));
    return std::nullopt;
  }
  return value;
}

std::optional<int> LinkageTable::whole(std::string_view key, int lower, int upper) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const auto value = node->is_integer() ? finite_number(*node) : std::nullopt;
  if (value && *value >= lower && *value <= upper) return static_cast<int>(*value);
  refuse(key, describe(*node));
  return std::nullopt;
}

std::optional<std::string> LinkageTable::text(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const auto value = node->value_or(std::string());
  if (node->is_string() && !value.empty()) return value;
  refuse(key, describe(*node));
  return std::nullopt;
}

std::optional<std::string> LinkageTable::one_of(std::string_view key,
                                                const std::vector<std::string_view>& words) const {
  auto value = text(key);
  if (value && std::find(words.begin(), words.end(), *value) == words.end()) {
    refuse(key, describe(*find(key)));
    return std::nullopt;
  }
  return value;
}

bool LinkageTable::truth(std::string_view key) const {
  const toml::node* node = find(key);
  if (node && !node->is_boolean()) refuse(key, describe(*node));
  return node && node->value_or(false);
}

std::optional<Point> LinkageTable::point(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  auto value = finite_point(*node);
  if (value && value->cwiseAbs().maxCoeff() <= largest_number) return value;
  const toml::array* list = node->as_array();
  if (list && list->size() == 2)
    refuse(key, fmt::format("[{}, {}]", describe((*list)[0]), describe((*list)[1])),
           allowed(key) + " (finite numbers, at most 1e9)");
  else
    refuse(key, describe(*node));
  return std::nullopt;
}

std::optional<std::pair<double, double>> LinkageTable::range(std::string_view key) const {
  const auto value = point(key);
  if (!value) return std::nullopt;
  if (value->x() <= value->y()) return std::pair{value->x(), value->y()};
  refuse(key, fmt::format("[{:g}, {:g}]", value->x(), value->y()));
  return std::nullopt;
}

std::vector<double> LinkageTable::numbers(std::string_view key) const {
  std::vector<double> result;
  const toml::node* node = find(key);
  if (!node) return result;
  if (const toml::array* list = node->as_array())
    for (const toml::node& element : *list)
      if (const auto value = finite_number(element); value && std::abs(*value) <= largest_number)
        result.push_back(*value);
  if (!node->is_array() || node->as_array()->empty() || result.size() != node->as_array()->size()) {
    refuse(key, describe(*node));
    result.clear();
  }
  return result;
}

std::vector<NameAt> LinkageTable::names(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return {};
  if (is_list_of_names(*node)) return names_in(*node->as_array());
  refuse(key, describe(*node));
  return {};
}

std::vector<std::vector<NameAt>> LinkageTable::name_lists(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return {};
  std::vector<std::vector<NameAt>> result;
  const toml::array* list = node->as_array();
  if (list)
    for (const toml::node& element : *list)
      if (is_list_of_names(element)) result.push_back(names_in(*element.as_array()));
  if (list && result.size() == list->size()) return result;
  refuse(key, describe(*node));
  return {};
}

std::vector<Point> LinkageTable::points(std::string_view key) const {
  std::vector<Point> result;
  const toml::node* node = find(key);
  if (!node) return result;
  const toml::array* list = node->as_array();
  if (list)
    for (const toml::node& element : *list)
      if (const auto value = finite_point(element); value && value->cwiseAbs().maxCoeff() <= largest_number)
        result.push_back(*value);
  if (list && result.size() == list->size()) return result;
  refuse(key, describe(*node));
  return {};
}

const toml::table* LinkageTable::inner(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  if (const toml::table* table = node->as_table()) return table;
  refuse(key, describe(*node));
  return nullptr;
}

const toml::array* LinkageTable::list(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  if (const toml::array* array = node->as_array()) return array;
  refuse(key, describe(*node));
  return nullptr;
}

}  // namespace kempe
