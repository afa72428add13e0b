#include "specs/key_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "specs/spec_keys.hpp"

namespace kempe {
namespace {

/// Edits between two words: insert, delete, replace, swap neighbours (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last, last, row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

constexpr std::array<std::string_view, 16> unit_suffixes{
    "_mm", "_deg",    "_rad",     "_cm",      "_m",   "_in", "_inch", "_um",
    "_ft", "_degree", "_degrees", "_radians", "_mil", "_pt", "_px",   "_percent"};

/// The name without what looks like a unit: "width" of "width_cm".
std::string_view stem_of(std::string_view name) {
  for (const std::string_view suffix : unit_suffixes) {
    if (name.size() > suffix.size() && name.ends_with(suffix))
      return name.substr(0, name.size() - suffix.size());
  }
  return name;
}

std::string unit_sentence(std::string_view name) {
  if (name.ends_with("_mm")) return fmt::format("{}: lengths are in millimetres", name);
  if (name.ends_with("_deg")) return fmt::format("{}: angles are in degrees", name);
  return fmt::format("{}: it has no unit", name);
}

std::vector<std::string_view> names_in(std::string_view table) {
  std::vector<std::string_view> names;
  for (const SpecKey& key : spec_keys()) {
    if (key.table == table) names.push_back(key.name);
  }
  return names;
}

/// Names longer than any of ours are compared and shown by their beginning.
constexpr std::size_t longest_name = 60;

/// The known key of a table with the same name in another unit; empty if there is none.
std::string_view in_another_unit(std::string_view table, std::string_view name) {
  for (const std::string_view known : names_in(table)) {
    if (stem_of(known) == stem_of(name)) return known;
  }
  return {};
}

/// The key of a table that somebody may have meant by an unknown one.
std::string_view key_meant(std::string_view table, std::string_view name) {
  const std::string_view same = in_another_unit(table, name);
  return same.empty() ? nearest(name.substr(0, longest_name), names_in(table)) : same;
}

/// "VA_mm", "AC_mm", ...: the keys that lock a length.
bool locks_a_length(std::string_view key) { return key.ends_with("_mm") && key.size() == 5; }

/// True of "length_mm", "AB_mm" or "VA" in [links].
bool seems_to_lock_a_length(std::string_view table, std::string_view name) {
  return table == "links" && (stem_of(name).size() <= 2 || name.find("length") != std::string_view::npos);
}

std::string lockable_lengths() {
  std::vector<std::string_view> names = names_in("links");
  std::erase_if(names, [](std::string_view name) { return !locks_a_length(name); });
  return fmt::format("{}", fmt::join(names, ", "));
}

/// What somebody who wrote an unknown key may have meant.
std::string hint_for(std::string_view table, std::string_view name) {
  if (const auto same = in_another_unit(table, name); !same.empty()) return unit_sentence(same);
  if (seems_to_lock_a_length(table, name)) return "a length that can be locked: " + lockable_lengths();
  for (const SpecKey& key : spec_keys()) {
    if (key.name == name) return fmt::format("{} in [{}]", name, key.table);
  }
  return fmt::format("{} (the nearest known key)", key_meant(table, name));
}

/// One value against its rule. Every check adds its complaint and the rule's sentence of what is allowed.
class ValueCheck {
 public:
  ValueCheck(const SpecKey& rule, std::string key, Complaints& complaints)
      : rule_(rule), key_(std::move(key)), complaints_(complaints) {}

  void check(const toml::node& value) {
    switch (rule_.kind) {
      case KeyKind::number: return check_number(value);
      case KeyKind::whole_number: return check_whole_number(value);
      case KeyKind::truth: return require(value.is_boolean(), value);
      case KeyKind::choice: return check_choice(value);
      case KeyKind::choices: return check_choices(value);
      case KeyKind::text: return require(!value.value_or(std::string()).empty(), value);
      case KeyKind::numbers: return check_numbers(value);
      case KeyKind::point: return check_point(value);
      case KeyKind::layer_range: return check_layers(value, 2);
      case KeyKind::link_layers: return check_layers(value, 4);
      case KeyKind::rings:
      case KeyKind::pairs: return require(value.is_array(), value);
      case KeyKind::rectangle: return check_inner_table(value, "rectangle_mm");
      case KeyKind::circle: return check_inner_table(value, "circle_mm");
    }
  }

 private:
  void refuse(const toml::node& value, std::string found) {
    complaints_.add(line_of(value), key_, std::move(found), describe_allowed(rule_));
  }
  void require(bool condition, const toml::node& value) {
    if (!condition) refuse(value, describe(value));
  }

  void check_number(const toml::node& value) {
    const auto number = finite_number(value);
    require(number && rule_.range.contains(*number), value);
  }

  bool is_whole_in_range(const toml::node& value) const {
    return value.is_integer() && rule_.range.contains(*finite_number(value));
  }
  void check_whole_number(const toml::node& value) { require(is_whole_in_range(value), value); }

  bool is_word(const toml::node& value) const {
    const auto words = words_of(rule_);
    const auto* text = value.as_string();
    return text && std::find(words.begin(), words.end(), text->get()) != words.end();
  }
  void check_choice(const toml::node& value) { require(is_word(value), value); }

  void check_choices(const toml::node& value) {
    const toml::array* list = value.as_array();
    if (!list || list->empty()) return refuse(value, describe(value));
    std::set<std::string> seen;
    for (const toml::node& element : *list) {
      if (!is_word(element)) return refuse(element, describe(element));
      if (!seen.insert(element.value_or(std::string())).second)
        return refuse(element, describe(element) + " twice");
    }
  }

  void check_numbers(const toml::node& value) {
    const toml::array* list = value.as_array();
    if (!list || list->empty()) return refuse(value, describe(value));
    for (const toml::node& element : *list) check_number(element);
  }

  void check_point(const toml::node& value) {
    const toml::array* list = value.as_array();
    if (!list || list->size() != 2) return refuse(value, describe(value));
    for (const toml::node& element : *list) check_number(element);
  }

  void check_layers(const toml::node& value, std::size_t count) {
    const toml::array* list = value.as_array();
    if (!list || list->size() != count) return refuse(value, describe(value));
    for (const toml::node& element : *list) {
      if (!is_whole_in_range(element)) return refuse(element, describe(element));
    }
    if (rule_.kind != KeyKind::layer_range) return;
    const auto lowest = (*list)[0].value_or(std::int64_t{0}), highest = (*list)[1].value_or(std::int64_t{0});
    if (lowest > highest) refuse(value, fmt::format("[{}, {}]", lowest, highest));
  }

  void check_inner_table(const toml::node& value, std::string_view rules) {
    if (const toml::table* table = value.as_table()) return check_table(*table, rules, key_, complaints_);
    refuse(value, describe(value));
  }

  const SpecKey& rule_;
  std::string key_;
  Complaints& complaints_;
};

void check_top_level(const toml::node& value, std::string_view name, Complaints& complaints) {
  if (name == "obstacles") {
    const toml::array* list = value.as_array();
    const bool of_tables =
        list && std::all_of(list->begin(), list->end(), [](const auto& e) { return e.is_table(); });
    if (!of_tables)
      return complaints.add(line_of(value), "obstacles", describe(value), "tables [[obstacles]]");
    for (const toml::node& element : *list) check_table(*element.as_table(), name, "obstacles", complaints);
  } else if (const toml::table* table = value.as_table()) {
    check_table(*table, name, std::string(name), complaints);
  } else {
    complaints.add(line_of(value), std::string(name), describe(value), fmt::format("a table [{}]", name));
  }
}

/// The table that has a key of this name; empty if none has.
std::string_view table_with(std::string_view key_name) {
  for (const SpecKey& key : spec_keys()) {
    if (key.name == key_name) return key.table;
  }
  return {};
}

std::string_view nearest_table(std::string_view name) {
  const auto tables = spec_tables();
  return nearest(name.substr(0, longest_name), {tables.begin(), tables.end()});
}

/// A key without a table, or a table that is not known.
std::string hint_for_top_level(std::string_view name) {
  if (const auto table = table_with(name); !table.empty()) return fmt::format("{} in [{}]", name, table);
  return fmt::format("[{}] (the nearest known table)", nearest_table(name));
}

bool is_known_table(std::string_view name) {
  const auto tables = spec_tables();
  return std::find(tables.begin(), tables.end(), name) != tables.end();
}

}  // namespace

void check_table(const toml::table& table, std::string_view rules, const std::string& path,
                 Complaints& complaints) {
  std::set<std::string_view> meant;  // by keys that are unknown: one mistake is told once
  for (const auto& [key, value] : table) {
    const std::string dotted = path + "." + printable(key.str(), longest_name);
    if (const SpecKey* rule = find_spec_key(rules, key.str())) {
      ValueCheck(*rule, dotted, complaints).check(value);
    } else {
      complaints.add(static_cast<int>(key.source().begin.line), dotted, "an unknown key",
                     hint_for(rules, key.str()));
      meant.insert(key_meant(rules, key.str()));
    }
  }
  for (const SpecKey& key : spec_keys()) {
    if (key.table != rules || !key.required || table.contains(key.name) || meant.contains(key.name)) continue;
    complaints.add(line_of(table), path + "." + std::string(key.name), "nothing", describe_allowed(key));
  }
}

void check_keys(const toml::table& spec, Complaints& complaints) {
  for (const auto& [key, value] : spec) {
    if (is_known_table(key.str())) {
      check_top_level(value, key.str(), complaints);
    } else {
      complaints.add(static_cast<int>(key.source().begin.line), printable(key.str(), longest_name),
                     value.is_table() ? "an unknown table" : "an unknown key", hint_for_top_level(key.str()));
    }
  }
}

bool is_meant(const toml::table& spec, std::string_view table) {
  for (const auto& [key, value] : spec) {
    if (is_known_table(key.str())) continue;
    const std::string_view holder = table_with(key.str());
    if ((holder.empty() ? nearest_table(key.str()) : holder) == table) return true;
  }
  return false;
}

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
  return *std::min_element(candidates.begin(), candidates.end(), [&](std::string_view a, std::string_view b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
}

}  // namespace kempe
