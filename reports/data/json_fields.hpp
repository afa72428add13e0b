#pragma once
// Hostile JSON as values: every field is asked for by key and type, and all that is wrong is remembered.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kempe/input_error.hpp"

namespace kempe {

/// A place in a parsed file. Asking for what is not there notes an error in the file's log and returns a
/// harmless value, so that a reader reads as a list of fields; look at the log once at the end.
class JsonField {
 public:
  /// The faults of a file in the order in which they were met, one a place, at most `most`.
  struct Log {
    static constexpr std::size_t most = 100;
    std::string file;
    std::vector<InputError> faults{};
  };

  JsonField(const nlohmann::json& root, Log& log) : JsonField(&root, "", log) {}

  /// The member `key`, which must be there; `this` must be an object.
  JsonField operator[](std::string_view key) const;
  /// The member `key` if it is there and not null.
  std::optional<JsonField> find(std::string_view key) const;
  /// The elements of an array of `least` to `most` entries, none after an error.
  class Elements;
  Elements elements(std::size_t least, std::size_t most) const;

  /// The members of an object that are not among `known`, dotted, in the order of the alphabet.
  std::vector<std::string> unknown_keys(const std::vector<std::string_view>& known) const;

  bool is_null() const { return value_ != nullptr && value_->is_null(); }
  bool is_object() const { return value_ != nullptr && value_->is_object(); }
  /// A finite number in [lower, upper].
  double number(double lower, double upper) const;
  double number() const;
  double positive() const;
  /// A finite number; nothing for null.
  std::optional<double> number_or_null() const;
  std::int64_t integer(std::int64_t lower, std::int64_t upper) const;
  /// A whole number that is not negative, up to the largest of 64 bits.
  std::uint64_t natural() const;
  bool boolean() const;
  std::string text() const;
  /// [x, y]
  std::pair<double, double> pair() const;

  /// Notes that this field is wrong; what stands there is quoted.
  void refuse(const std::string& allowed) const;
  void refuse(const std::string& found, const std::string& allowed) const;
  /// How many faults the file has so far.
  std::size_t faults() const { return log_->faults.size(); }
  /// True once there is no room for another fault: there is no use in reading on.
  bool failed() const { return faults() >= Log::most; }

 private:
  JsonField(const nlohmann::json* value, std::string path, Log& log)
      : value_(value), path_(std::move(path)), log_(&log) {}

  const nlohmann::json* value_;  ///< null after an error
  std::string path_;
  Log* log_;
};

/// Elements by place, made as they are asked for: a million at once would take more memory than the file.
class JsonField::Elements {
 public:
  class Iterator {
   public:
    Iterator(const Elements& elements, std::size_t index) : elements_(&elements), index_(index) {}
    JsonField operator*() const { return (*elements_)[index_]; }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return index_ != other.index_; }

   private:
    const Elements* elements_;
    std::size_t index_;
  };

  Elements(JsonField array, std::size_t size) : array_(std::move(array)), size_(size) {}
  std::size_t size() const { return size_; }
  JsonField operator[](std::size_t index) const;
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

 private:
  JsonField array_;
  std::size_t size_;
};

}  // namespace kempe
