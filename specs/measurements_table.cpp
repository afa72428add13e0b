#include "specs/measurements_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "specs/key_checks.hpp"

namespace kempe {

bool check_known_keys(const toml::table& table, const std::string& path,
                      const std::vector<std::string_view>& known, Complaints& complaints) {
  constexpr std::size_t longest_shown = 60;
  bool all_known = true;
  for (const auto& [key, value] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    all_known = false;
    const std::string word = printable(key.str(), longest_shown);
    complaints.add(static_cast<int>(key.source().begin.line), path.empty() ? word : path + "." + word,
                   "an unknown key", known_instead(key.str().substr(0, longest_shown), known));
  }
  return all_known;
}

std::optional<MeasurementTable> MeasurementTable::of(const toml::node& node, const std::string& path,
                                                     const std::vector<std::string_view>& known,
                                                     Complaints& complaints) {
  const toml::table* table = node.as_table();
  if (!table) {
    complaints.add(line_of(node), path, describe(node), "a table");
    return std::nullopt;
  }
  const bool all_known = check_known_keys(*table, path, known, complaints);
  return MeasurementTable(*table, path, all_known, complaints);
}

int MeasurementTable::line(std::string_view key) const {
  const toml::node* node = find(key);
  return line_of(node ? *node : static_cast<const toml::node&>(*table_));
}

void MeasurementTable::refuse(std::string_view key, std::string found, std::string allowed) const {
  complaints_->add(line(key), dotted(key), std::move(found), std::move(allowed));
}

void MeasurementTable::missing(std::string_view key, std::string allowed) const {
  if (all_known_) complaints_->add(line_of(*table_), dotted(key), "no such key", std::move(allowed));
}

std::optional<double> MeasurementTable::number(std::string_view key, double lower, double upper,
                                               std::string_view meaning) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const auto value = finite_number(*node);
  if (value && *value >= lower && *value <= upper) return value;
  refuse(key, describe(*node), fmt::format("a number from {} to {}{}", lower, upper, meaning));
  return std::nullopt;
}

std::optional<int> MeasurementTable::whole(std::string_view key, int lower, int upper) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const auto value = node->value_exact<std::int64_t>();
  if (value && *value >= lower && *value <= upper) return static_cast<int>(*value);
  refuse(key, describe(*node), fmt::format("a whole number from {} to {}", lower, upper));
  return std::nullopt;
}

std::optional<std::string> MeasurementTable::text(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  auto value = node->value_exact<std::string>();
  if (value && !value->empty()) return value;
  refuse(key, describe(*node), "text between quotation marks");
  return std::nullopt;
}

std::optional<std::string> MeasurementTable::word(std::string_view key,
                                                  const std::vector<std::string_view>& words) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  auto value = node->value_exact<std::string>();
  if (value && std::find(words.begin(), words.end(), *value) != words.end()) return value;
  refuse(key, describe(*node), fmt::format("one of \"{}\"", fmt::join(words, "\", \"")));
  return std::nullopt;
}

std::vector<std::string> MeasurementTable::words(std::string_view key,
                                                 const std::vector<std::string_view>& allowed) const {
  const toml::array* all = list(key);
  std::vector<std::string> found;
  if (!all) return found;
  const std::string rule =
      fmt::format("a list of one or more of \"{}\", each once", fmt::join(allowed, "\", \""));
  if (all->empty()) refuse(key, "an empty list", rule);
  for (const toml::node& one : *all) {
    const auto word = one.value_exact<std::string>();
    const bool known = word && std::find(allowed.begin(), allowed.end(), *word) != allowed.end();
    const bool twice = known && std::find(found.begin(), found.end(), *word) != found.end();
    if (!known || twice) {
      refuse(key, describe(one) + (twice ? " twice" : ""), rule);
      return {};
    }
    found.push_back(*word);
  }
  return found;
}

bool MeasurementTable::truth(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return false;
  const auto value = node->value_exact<bool>();
  if (!value) refuse(key, describe(*node), "true or false");
  return value.value_or(false);
}

std::optional<Point> MeasurementTable::point(std::string_view key, double farthest) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  auto value = finite_point(*node);
  if (value && value->cwiseAbs().maxCoeff() <= farthest) return value;
  refuse(key, describe(*node), fmt::format("[x, y], numbers from {} to {}", -farthest, farthest));
  return std::nullopt;
}

const toml::array* MeasurementTable::list(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  if (!node->is_array()) refuse(key, describe(*node), "a list");
  return node->as_array();
}

}  // namespace kempe
