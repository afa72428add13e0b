#pragma once
// Where in the journals the results of a batch stand, by the keys of its specs.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>

namespace kempe::app {

/// A line of a journal.
struct JournalPlace {
  int journal = 0;          ///< its number among those that a BatchJournal knows
  std::int64_t offset = 0;  ///< of the line's first byte
};

/// A table from keys to places, kept in a file without a name: 32 to 64 bytes of disk a spec and no memory, whatever the batch's length.
///
/// A hash table with open addressing, at most half full: key k is looked for from slot k mod 2^n onwards, up to the first empty
/// slot, 1.5 slots on average where it is there (Knuth, The Art of Computer Programming 3, 6.4). Keys are hashes already.
/// Not for several threads at once.
class BatchIndex {
 public:
  /// A table for `count` keys, in a file in `folder`, which goes with the object. The error is a sentence.
  static tl::expected<BatchIndex, std::string> make(const std::filesystem::path& folder, std::int64_t count);

  BatchIndex(BatchIndex&& other) noexcept;
  BatchIndex& operator=(BatchIndex&&) = delete;
  ~BatchIndex();

  /// Adds a key, without a place. A key that is there keeps its place.
  void add(std::uint64_t key);
  /// Sets a key's place; nothing happens if the key was not added.
  void set(std::uint64_t key, const JournalPlace& place);
  /// A key's place, if one was set.
  std::optional<JournalPlace> place(std::uint64_t key) const;

  /// Why the file could not be read or written; then what place() says is worth nothing.
  const std::optional<std::string>& failure() const { return failure_; }

 private:
  struct Slot;
  BatchIndex(std::filesystem::path folder, int file, std::uint64_t slots)
      : folder_(std::move(folder)), file_(file), slots_(slots) {}
  std::optional<std::uint64_t> slot_of(std::uint64_t key, Slot& found) const;
  void write(std::uint64_t slot, const Slot& contents);

  std::filesystem::path folder_;
  int file_;
  std::uint64_t slots_;  ///< a power of two
  mutable std::optional<std::string> failure_;
};

}  // namespace kempe::app
