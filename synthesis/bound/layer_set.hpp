#pragma once
// A set of layer assignments by their number. The proven bound keeps one in every box: up to 64 take one word.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kempe::bounding {

/// Any number of assignments; numbers start at 0.
class LayerSet {
 public:
  LayerSet() = default;
  /// All of 0 .. count - 1.
  static LayerSet all(std::size_t count) {
    LayerSet set;
    for (std::size_t i = 0; i < count; ++i) set.add(i);
    return set;
  }

  bool empty() const {
    return first_ == 0 && std::all_of(more_.begin(), more_.end(), [](auto word) { return word == 0; });
  }
  /// The least number in it; it must not be empty.
  std::size_t first() const {
    std::size_t i = 0;
    while (!has(i)) ++i;
    return i;
  }
  bool has(std::size_t i) const { return i / bits <= more_.size() && (word(i) >> i % bits & 1) != 0; }
  bool meets(const LayerSet& other) const {
    bool met = (first_ & other.first_) != 0;
    for (std::size_t i = 0; i < std::min(more_.size(), other.more_.size()) && !met; ++i)
      met = (more_[i] & other.more_[i]) != 0;
    return met;
  }

  void add(std::size_t i) {
    if (i / bits > more_.size()) more_.resize(i / bits, 0);
    word(i) |= one(i);
  }
  void add(const LayerSet& others) {
    first_ |= others.first_;
    more_.resize(std::max(more_.size(), others.more_.size()), 0);
    for (std::size_t i = 0; i < others.more_.size(); ++i) more_[i] |= others.more_[i];
  }
  void remove(std::size_t i) {
    if (has(i)) word(i) &= ~one(i);
  }
  void remove(const LayerSet& others) {
    first_ &= ~others.first_;
    for (std::size_t i = 0; i < std::min(more_.size(), others.more_.size()); ++i)
      more_[i] &= ~others.more_[i];
  }

 private:
  static constexpr std::size_t bits = 64;
  static std::uint64_t one(std::size_t i) { return std::uint64_t{1} << i % bits; }
  std::uint64_t word(std::size_t i) const { return i < bits ? first_ : more_[i / bits - 1]; }
  std::uint64_t& word(std::size_t i) { return i < bits ? first_ : more_[i / bits - 1]; }

  std::uint64_t first_ = 0;
  std::vector<std::uint64_t> more_;  ///< of the numbers from 64 on
};

}  // namespace kempe::bounding
