#pragma once
// What a reader found wrong, collected while it reads on.

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kempe/input_error.hpp"

namespace kempe {

enum class SpecUnit;  // specs/spec_keys.hpp

/// All complaints about one file, at most `most` of them. Their order is the file's: of the topmost line first, of one line
/// as they were made; complaints without a line come last, those about another file that this one names after them.
class Complaints {
 public:
  static constexpr std::size_t most = 100;

  explicit Complaints(std::string file) : file_(std::move(file)) {}

  void add(int line, std::string key, std::string found, std::string allowed);
  /// From now on add() takes keys as a reader calls them, and notes them as a file with lengths in `unit` does.
  void state_in(SpecUnit unit, std::function<std::string(const std::string&)> as_in_file) {
    unit_ = unit;
    as_in_file_ = std::move(as_in_file);
  }
  /// In which whoever complains states lengths, and names other keys; mm unless state_in() says otherwise.
  SpecUnit unit() const { return unit_; }
  /// A complaint about another file that this one names.
  void add(InputError about_other_file);

  bool none() const { return made_.empty(); }
  /// True if no complaint is about this table or one of its keys ("links", "links.width_mm").
  bool none_about(std::string_view table) const;
  /// The first in order, with the others. There must be one.
  InputError all() const;
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  SpecUnit unit_{};
  std::function<std::string(const std::string&)> as_in_file_;  ///< empty: as they are
  std::vector<InputError> made_;
};

}  // namespace kempe
