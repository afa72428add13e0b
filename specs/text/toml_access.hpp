#pragma once
// TOML as our readers see it: parsed with the library's traps removed, values with their lines, tables with
// set(). For sources of this and other readers of TOML files; no other header includes it.

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "geometry/region.hpp"
#include "kempe/input_error.hpp"
#include "specs/text/printable.hpp"

namespace kempe {

/// Parses a whole file. The error carries the line; an empty file, noise, invalid UTF-8, repeated keys and
/// nesting deeper than the parser's stack are refused.
tl::expected<toml::table, InputError> parse_toml(std::string_view text, const std::string& file_name);

/// The line where a value stands, from 1; 0 if unknown.
inline int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

/// A value for an error message: `3.5`, `text "abc"`, `a list of 4`, `a table`.
std::string describe(const toml::node& node);

/// The number, if the node is an integer or a finite floating-point number.
std::optional<double> finite_number(const toml::node& node);
/// The point, if the node is a list of exactly two such numbers.
std::optional<Point> finite_point(const toml::node& node);

/// A table whose keys have been checked: absent tables and absent keys change nothing.
class TableView {
 public:
  TableView() = default;
  TableView(const toml::table& table, std::string path) : table_(&table), path_(std::move(path)) {}

  bool present() const { return table_ != nullptr; }
  int line() const { return table_ ? line_of(*table_) : 0; }
  /// The value or null.
  const toml::node* find(std::string_view key) const { return table_ ? table_->get(key) : nullptr; }
  bool has(std::string_view key) const { return find(key) != nullptr; }
  /// The value's line, or the table's if the key is absent.
  int line_of_key(std::string_view key) const;
  /// "links.width_mm"
  std::string dotted(std::string_view key) const { return path_ + "." + std::string(key); }
  const std::string& path() const { return path_; }

  void set(std::string_view key, double& value) const;
  void set(std::string_view key, std::optional<double>& value) const;
  void set(std::string_view key, int& value) const;
  void set(std::string_view key, bool& value) const;
  void set(std::string_view key, std::string& value) const;
  void set(std::string_view key, Point& value) const;

 private:
  const toml::table* table_ = nullptr;
  std::string path_;
};

}  // namespace kempe
