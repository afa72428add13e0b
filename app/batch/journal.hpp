#pragma once
// What a batch has finished, line by line on disk, so that a killed run goes on where it stopped.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/batch/index.hpp"
#include "kempe/input_error.hpp"

namespace kempe::app {

/// A journal of finished specs. Each line holds the version that wrote it, a spec's key, its result and a checksum of these.
///
/// Guarantees:
///  1. a result recorded outlives this process from when record() returns, and a fall of the machine from some milliseconds later,
///     which nobody waits for: a thread synchronises the file as long as there is something to synchronise. When flush()
///     returns all is on disk;
///  2. a line counts only if it is whole, its checksum is right and its result is one that `is_result` accepts: what else
///     stands there, cut short by a crash, damaged or written by somebody else, is passed over and done again;
///  3. a line of another version never counts: its figures may mean something else. foreign_line() names it;
///  4. several journals in one folder (one a process) are read together; only regular files are journals, links are not;
///  5. no line is kept in memory: what was found is told with its place, and read again from there.
class BatchJournal {
 public:
  /// Whether a text is what record() would be given.
  using IsResult = bool (*)(const std::string& result);
  /// Told of a line that counts.
  using Found = std::function<void(std::uint64_t key, const JournalPlace& place)>;

  /// Opens `folder/journal-NAME.jsonl` for appending. `program` is the program's version; the journal's own is added.
  static tl::expected<BatchJournal, std::string> open(const std::filesystem::path& folder,
                                                      const std::string& name, std::string_view program,
                                                      IsResult is_result);

  BatchJournal(BatchJournal&& other) noexcept;
  BatchJournal& operator=(BatchJournal&&) = delete;
  ~BatchJournal();

  /// Reads every journal of the folder on from where it was read last, in the order of their names.
  void read_on(const Found& found);

  /// The result of a line that was told of; nothing if it is no longer there.
  std::optional<std::string> result_at(const JournalPlace& place, std::uint64_t key);

  /// Records a result (one line of JSON). Safe from several threads. The error may be that of an earlier line.
  tl::expected<void, std::string> record(std::uint64_t key, const std::string& result);

  /// Waits until what was recorded is on disk.
  tl::expected<void, std::string> flush();

  /// The first line that was passed over, as "FILE:LINE", and how many there are.
  const std::string& first_passed_over() const { return first_passed_over_; }
  int passed_over() const { return passed_over_; }

  /// A whole line that another version wrote; nothing if there is none.
  const std::optional<InputError>& foreign_line() const { return foreign_line_; }

 private:
  /// A journal and how far it was read.
  struct Reading {
    std::filesystem::path path;
    std::int64_t offset = 0;
    int line = 0;
  };

  class Writer;
  BatchJournal(std::filesystem::path folder, std::unique_ptr<Writer> writer, std::string version,
               IsResult is_result);
  void read_on(int journal, const Found& found);
  void judge(const std::string& line, const Reading& at, int journal, const Found& found);
  int opened(int journal);
  std::string failure(int error) const;

  std::filesystem::path folder_;
  std::unique_ptr<Writer> writer_;
  std::string version_;
  IsResult is_result_;
  std::vector<Reading> readings_;
  std::map<int, int> opened_;  ///< files by the journals' numbers
  std::optional<InputError> foreign_line_;
  std::string first_passed_over_;
  int passed_over_ = 0;
};

/// A key that changes whenever the text does (FNV-1a, 64 bit).
std::uint64_t text_key(std::string_view text);

}  // namespace kempe::app
