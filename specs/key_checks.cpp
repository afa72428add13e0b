#include "specs/key_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "kempe/links.hpp"
#include "specs/mirror_words.hpp"
#include "specs/spec_keys.hpp"
#include "specs/spec_unit.hpp"
#include "specs/text/ratio.hpp"

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

constexpr std::array<std::string_view, 23> unit_suffixes{
    "_mm", "_deg",    "_rad",     "_cm",      "_m",   "_in",  "_inch", "_um",
    "_ft", "_degree", "_degrees", "_radians", "_mil", "_pt",  "_px",   "_percent",
    "_N",  "_kN",     "_kg",      "_lbf",     "_MPa", "_GPa", "_kg_m3"};

/// What a unit measures: "E_GPa: elasticity is in gigapascals".
struct UnitWords {
  std::string_view suffix, words;
};
constexpr std::array<UnitWords, 6> unit_words_of_keys{{{"_deg", "angles are in degrees"},
                                                       {"_N", "forces are in newtons"},
                                                       {"_kg", "masses are in kilograms"},
                                                       {"_GPa", "elasticity is in gigapascals"},
                                                       {"_MPa", "strength is in megapascals"},
                                                       {"_kg_m3", "density is in kilograms a cubic metre"}}};

/// The name without what looks like a unit: "width" of "width_cm".
std::string_view stem_of(std::string_view name) {
  for (const std::string_view suffix : unit_suffixes) {
    if (name.size() > suffix.size() && name.ends_with(suffix))
      return name.substr(0, name.size() - suffix.size());
  }
  return name;
}

/// How a key that is known is written, of one written with another unit or none.
std::string unit_sentence(std::string_view known, std::string_view written, SpecUnit unit) {
  if (known.ends_with("_mm") && unit == SpecUnit::inch)
    return fmt::format("{}: with units = \"in\" all lengths are in inches", name_in(unit, known));
  const bool meant_inches = written.ends_with("_in") || written.ends_with("_inch");
  if (known.ends_with("_mm"))
    return fmt::format("{}: lengths are in millimetres{}", known,
                       meant_inches ? ", or all of them in inches with units = \"in\" at the top" : "");
  for (const UnitWords& unit_words : unit_words_of_keys)
    if (known.ends_with(unit_words.suffix)) return fmt::format("{}: {}", known, unit_words.words);
  return fmt::format("{}: it has no unit", known);
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

/// The key of a table that somebody may have meant by an unknown one; empty if there is none.
std::string_view key_meant(std::string_view table, std::string_view name) {
  const std::string_view same = in_another_unit(table, name);
  return same.empty() ? nearest(name.substr(0, longest_name), names_in(table)).value_or("") : same;
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

/// "scale in [copy]"
std::string place_of(const SpecKey& key) {
  return key.table.empty() ? fmt::format("{} at the top of the file", key.name)
                           : fmt::format("{} in [{}]", key.name, key.table);
}

/// What somebody who wrote an unknown key may have meant.
std::string hint_for(std::string_view table, std::string_view name, SpecUnit unit) {
  if (names_a_mirror(name)) return std::string(no_mirror);
  if (const auto same = in_another_unit(table, name); !same.empty()) return unit_sentence(same, name, unit);
  if (seems_to_lock_a_length(table, name)) return "a length that can be locked: " + lockable_lengths();
  for (const SpecKey& key : spec_keys()) {
    if (key.name == name) return place_of(key);
  }
  return known_instead(name.substr(0, longest_name), names_in(table));
}

/// One value against its rule. Every check adds its complaint and the rule's sentence of what is allowed.
class ValueCheck {
 public:
  ValueCheck(const SpecKey& rule, std::string key, SpecUnit unit, Complaints& complaints)
      : rule_(rule), key_(std::move(key)), unit_(unit), complaints_(complaints) {}

  void check(const toml::node& value) {
    switch (rule_.kind) {
      case KeyKind::number: return check_number(value);
      case KeyKind::ratio: return check_ratio(value);
      case KeyKind::whole_number: return check_whole_number(value);
      case KeyKind::truth: return require(value.is_boolean(), value);
      case KeyKind::choice: return check_choice(value);
      case KeyKind::choices: return check_choices(value);
      case KeyKind::joint_choices: return check_joint_choices(value);
      case KeyKind::text: return require(!value.value_or(std::string()).empty(), value);
      case KeyKind::numbers: return check_numbers(value);
      case KeyKind::point: return check_point(value);
      case KeyKind::sections: return check_sections(value);
      case KeyKind::layer_range: return check_layers(value, 2);
      case KeyKind::link_layers: return check_layers(value, 4);
      case KeyKind::rings:
      case KeyKind::pairs: return require(value.is_array(), value);
      case KeyKind::rectangle: return check_figure(value, "rectangle_mm", {"at", "at", "size", "size"});
      case KeyKind::circle: return check_figure(value, "circle_mm", {"centre", "centre", "radius"});
    }
  }

 private:
  void refuse(const toml::node& value, std::string found) {
    complaints_.add(line_of(value), key_, std::move(found), describe_allowed(rule_, unit_));
  }
  void refuse_mirror(const toml::node& value) {
    complaints_.add(line_of(value), key_, describe(value),
                    fmt::format("{}; {}", describe_allowed(rule_, unit_), no_mirror));
  }
  void require(bool condition, const toml::node& value) {
    if (!condition) refuse(value, describe(value));
  }

  bool in_range(const SpecKey& rule, const toml::node& value) const {
    const auto number = finite_number(value);
    return number && rule.range.contains(is_length(rule) ? in_mm(unit_) * *number : *number);
  }
  void check_number(const toml::node& value) {
    if (in_range(rule_, value)) return;
    if (names_a_mirror(value.value_or(std::string()))) return refuse_mirror(value);
    refuse(value, describe(value));
  }

  /// A scale below 0, or one for each axis, may be meant to mirror.
  void check_ratio(const toml::node& value) {
    const std::string text = value.value_or(std::string());
    const auto ratio = value.is_string() ? parse_ratio(text) : std::nullopt;
    if (ratio && rule_.range.contains(*ratio)) return;
    if (finite_number(value).value_or(0) < 0 || value.is_array() || text.starts_with("-"))
      return refuse_mirror(value);
    check_number(value);
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

  /// Of each entry that is wrong, by its own line and key.
  void check_joint_choices(const toml::node& value) {
    const toml::table* table = value.as_table();
    if (table == nullptr) return check_choice(value);
    if (table->empty()) return refuse(value, "an empty table");
    const std::vector<std::string_view> known{"default", "V", "A", "B", "C", "X", "Y"};
    const std::string words = fmt::format("one of \"{}\"", fmt::join(words_of(rule_), "\", \""));
    for (const auto& [key, name] : *table) {
      const std::string dotted = key_ + "." + printable(key.str(), longest_name);
      if (std::find(known.begin(), known.end(), key.str()) == known.end())
        complaints_.add(
            static_cast<int>(key.source().begin.line), dotted, "an unknown key",
            fmt::format("default, or a joint: {}", fmt::join(known.begin() + 1, known.end(), ", ")));
      else if (!is_word(name))
        complaints_.add(line_of(name), dotted, describe(name), words);
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

  void check_sections(const toml::node& value) {
    const toml::array* list = value.as_array();
    if (!list || list->empty()) return refuse(value, describe(value));
    if (list->size() > most_sections) return refuse(value, fmt::format("{} sections", list->size()));
    for (const toml::node& element : *list) check_point(element);
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

  /// A table by the rules of its own, or the list of its numbers, each by the rule of one of `names`.
  void check_figure(const toml::node& value, std::string_view rules,
                    const std::vector<std::string_view>& names) {
    if (const toml::table* table = value.as_table())
      return check_table(*table, rules, key_, complaints_, unit_);
    const toml::array* list = value.as_array();
    if (!list || list->size() != names.size()) return refuse(value, describe(value));
    for (std::size_t i = 0; i < names.size(); ++i) {
      const SpecKey& rule = *find_spec_key(rules, names[i]);
      if (in_range(rule, (*list)[i])) continue;
      const double share = 1 / in_mm(unit_);
      complaints_.add(
          line_of((*list)[i]), key_, fmt::format("{} in place {}", describe((*list)[i]), i + 1),
          fmt::format("{}, the {} {}", describe_allowed(rule_, unit_), names[i], rule.range.describe(share)));
    }
  }

  const SpecKey& rule_;
  std::string key_;
  SpecUnit unit_;
  Complaints& complaints_;
};

void check_top_level(const toml::node& value, std::string_view name, SpecUnit unit, Complaints& complaints) {
  if (const SpecKey* rule = find_spec_key("", name)) {
    ValueCheck(*rule, std::string(name), unit, complaints).check(value);
  } else if (name == "obstacles" || name == "bodies") {
    const toml::array* list = value.as_array();
    const bool of_tables =
        list && std::all_of(list->begin(), list->end(), [](const auto& e) { return e.is_table(); });
    if (!of_tables)
      return complaints.add(line_of(value), std::string(name), describe(value),
                            fmt::format("tables [[{}]]", name));
    for (const toml::node& element : *list)
      check_table(*element.as_table(), name, std::string(name), complaints, unit);
  } else if (const toml::table* table = value.as_table()) {
    check_table(*table, name, std::string(name), complaints, unit);
  } else {
    complaints.add(line_of(value), std::string(name), describe(value), fmt::format("a table [{}]", name));
  }
}

/// The key of this name, whatever its table; null if there is none.
const SpecKey* key_named(std::string_view name) {
  for (const SpecKey& key : spec_keys()) {
    if (key.name == name) return &key;
  }
  return nullptr;
}

/// The table that somebody may have meant by an unknown one.
std::optional<std::string_view> nearest_table(std::string_view name) {
  const auto tables = spec_tables();
  return nearest(name.substr(0, longest_name), {tables.begin(), tables.end()});
}

/// A key without a table, or a table that is not known.
std::string hint_for_top_level(std::string_view name) {
  if (names_a_mirror(name)) return std::string(no_mirror);
  if (const SpecKey* key = key_named(name)) return place_of(*key);
  if (const auto table = nearest_table(name)) return fmt::format("[{}] (the nearest known table)", *table);
  if (const auto key = nearest(name.substr(0, longest_name), names_in("")))
    return fmt::format("{} (the nearest known key)", *key);
  return fmt::format("one of the tables [{}]", fmt::join(spec_tables(), "], ["));
}

/// A table, or a key at the top.
bool is_known(std::string_view name) {
  const auto tables = spec_tables();
  return std::find(tables.begin(), tables.end(), name) != tables.end() || find_spec_key("", name) != nullptr;
}

}  // namespace

void check_table(const toml::table& table, std::string_view rules, const std::string& path,
                 Complaints& complaints, SpecUnit unit) {
  std::set<std::string_view> meant;  // by keys that are unknown: one mistake is told once
  for (const auto& [key, value] : table) {
    const std::string dotted = path + "." + printable(key.str(), longest_name);
    const SpecKey* rule = find_spec_key(rules, name_in_mm(key.str(), unit));
    const bool in_unit = rule != nullptr && (unit == SpecUnit::mm || !key.str().ends_with("_mm"));
    if (in_unit) {
      ValueCheck(*rule, dotted, unit, complaints).check(value);
      meant.insert(rule->name);
    } else {
      complaints.add(static_cast<int>(key.source().begin.line), dotted,
                     rule != nullptr ? "millimetres in a spec in inches" : "an unknown key",
                     hint_for(rules, key.str(), unit));
      meant.insert(key_meant(rules, key.str()));
    }
  }
  for (const SpecKey& key : spec_keys()) {
    if (key.table != rules || !key.required || meant.contains(key.name)) continue;
    complaints.add(line_of(table), name_in(unit, path + "." + std::string(key.name)), "nothing",
                   describe_allowed(key, unit));
  }
}

void check_keys(const toml::table& spec, Complaints& complaints) {
  const SpecUnit unit = spec_unit_of(spec);
  for (const auto& [key, value] : spec) {
    if (is_known(key.str())) {
      check_top_level(value, key.str(), unit, complaints);
    } else {
      complaints.add(static_cast<int>(key.source().begin.line), printable(key.str(), longest_name),
                     value.is_table() ? "an unknown table" : "an unknown key", hint_for_top_level(key.str()));
    }
  }
}

bool is_meant(const toml::table& spec, std::string_view table) {
  for (const auto& [key, value] : spec) {
    if (is_known(key.str())) continue;
    const SpecKey* known = key_named(key.str());
    if ((known ? known->table : nearest_table(key.str()).value_or("")) == table) return true;
  }
  return false;
}

std::optional<std::string_view> nearest(std::string_view word,
                                        const std::vector<std::string_view>& candidates) {
  constexpr std::size_t most_edits = 2;
  std::optional<std::string_view> best;
  std::size_t fewest = most_edits + 1;
  for (const std::string_view candidate : candidates) {
    const std::size_t edits = edit_distance(word, candidate);
    if (edits >= fewest || 2 * edits > std::max(word.size(), candidate.size())) continue;
    best = candidate;
    fewest = edits;
  }
  return best;
}

std::string known_instead(std::string_view word, const std::vector<std::string_view>& candidates,
                          std::string_view kind) {
  if (candidates.empty()) return fmt::format("no {}", kind);
  const auto meant = nearest(word, candidates);
  return meant ? fmt::format("{} (the nearest known {})", *meant, kind)
               : fmt::format("one of the {}s {}", kind, fmt::join(candidates, ", "));
}

}  // namespace kempe
