#pragma once
// Access to one table of a linkage file: known keys only, each value asked for by kind; whatever is wrong
// goes to the complaints, and a harmless value comes back so that reading goes on. For sources of the linkage
// reader only.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "specs/text/complaints.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// A name with the line it stands on.
struct NameAt {
  std::string name;
  int line = 0;
};

class LinkageTable {
 public:
  /// `rules` is the table's name in linkage_keys(); `path` how its keys are called in complaints.
  LinkageTable(const toml::table& table, std::string rules, std::string path, Complaints& complaints);

  bool has(std::string_view key) const { return table_.contains(key); }
  int line() const { return line_of(table_); }
  int line(std::string_view key) const;
  std::string dotted(std::string_view key) const;
  Complaints& complaints() const { return complaints_; }
  /// Keys in the order of the file.
  std::vector<NameAt> keys() const;

  /// A finite number in [-1e9, 1e9]; nothing if absent or wrong.
  std::optional<double> number(std::string_view key) const;
  /// A number > 0 and at least `least`.
  std::optional<double> positive(std::string_view key, double least = 0) const;
  std::optional<int> whole(std::string_view key, int lower, int upper) const;
  std::optional<std::string> text(std::string_view key) const;
  std::optional<std::string> one_of(std::string_view key, const std::vector<std::string_view>& words) const;
  bool truth(std::string_view key) const;  ///< false if absent
  std::optional<Point> point(std::string_view key) const;
  std::optional<std::pair<double, double>> range(std::string_view key) const;  ///< rising
  std::vector<double> numbers(std::string_view key) const;
  std::vector<NameAt> names(std::string_view key) const;
  std::vector<std::vector<NameAt>> name_lists(std::string_view key) const;
  std::vector<Point> points(std::string_view key) const;
  const toml::table* inner(std::string_view key) const;
  const toml::array* list(std::string_view key) const;
  bool is_text(std::string_view key) const { return has(key) && find(key)->is_string(); }

  /// Adds a complaint about a key; `allowed` is the key's rule if left out.
  void refuse(std::string_view key, std::string found, std::string allowed = {}) const;
  /// Complains that a key is missing.
  void missing(std::string_view key) const;

 private:
  const toml::node* find(std::string_view key) const { return table_.get(key); }
  std::string allowed(std::string_view key) const;
  void check_keys() const;

  const toml::table& table_;
  std::string rules_, path_;
  Complaints& complaints_;
};

}  // namespace kempe
