#pragma once
// What a reader found wrong, collected while it reads on.

#include <optional>
#include <string>

#include "kempe/input_error.hpp"

namespace kempe {

/// Keeps, of all complaints about one file, the one that a person should see first: of the topmost line, and
/// of one line the earliest made. Complaints without a line come last.
class Complaints {
 public:
  explicit Complaints(std::string file) : file_(std::move(file)) {}

  void add(int line, std::string key, std::string found, std::string allowed);
  /// A complaint about another file that this one names.
  void add(InputError about_other_file);

  bool none() const { return !first_; }
  /// There must be one.
  const InputError& first() const { return *first_; }
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::optional<InputError> first_;
};

}  // namespace kempe
