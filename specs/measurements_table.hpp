#pragma once
// One table of a measurements file: known keys only, each value asked for by kind; whatever is wrong goes to
// the complaints. For sources of the measurements reader only.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "specs/text/complaints.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// Complains about every key that is not known, with the nearest that is; true if all are. `path` is the
/// table's, empty for the file.
bool check_known_keys(const toml::table& table, const std::string& path,
                      const std::vector<std::string_view>& known, Complaints& complaints);

class MeasurementTable {
 public:
  /// Nothing (and a complaint) if the node is no table. Checks its keys.
  static std::optional<MeasurementTable> of(const toml::node& node, const std::string& path,
                                            const std::vector<std::string_view>& known,
                                            Complaints& complaints);

  bool has(std::string_view key) const { return find(key) != nullptr; }
  const toml::node* find(std::string_view key) const { return table_->get(key); }
  int line(std::string_view key) const;

  /// The value, or nothing if the key is absent or its value wrong (then with a complaint).
  std::optional<double> number(std::string_view key, double lower, double upper,
                               std::string_view meaning) const;
  std::optional<int> whole(std::string_view key, int lower, int upper) const;
  std::optional<std::string> text(std::string_view key) const;
  std::optional<std::string> word(std::string_view key, const std::vector<std::string_view>& words) const;
  /// Different words; empty if absent.
  std::vector<std::string> words(std::string_view key, const std::vector<std::string_view>& allowed) const;
  bool truth(std::string_view key) const;  ///< false if absent
  /// Each coordinate within -farthest .. farthest.
  std::optional<Point> point(std::string_view key, double farthest) const;
  const toml::array* list(std::string_view key) const;

  void refuse(std::string_view key, std::string found, std::string allowed) const;
  /// Silent where a key was unknown: that is the misspelt one.
  void missing(std::string_view key, std::string allowed) const;

 private:
  MeasurementTable(const toml::table& table, std::string path, bool all_known, Complaints& complaints)
      : table_(&table), path_(std::move(path)), all_known_(all_known), complaints_(&complaints) {}
  std::string dotted(std::string_view key) const { return path_ + "." + std::string(key); }

  const toml::table* table_;
  std::string path_;
  bool all_known_;
  Complaints* complaints_;
};

}  // namespace kempe
