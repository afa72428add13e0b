#pragma once
// What a batch has finished, line by line on disk, so that a killed run goes on where it stopped.

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "kempe/input_error.hpp"

namespace kempe::app {

/// A journal of finished specs. Each line holds the version that wrote it, a spec's key, its result and a checksum of these.
///
/// Guarantees:
///  1. a result recorded is on disk when record() returns;
///  2. a line counts only if it is whole, its checksum is right and its result is one that `is_result` accepts: what else
///     stands there, cut short by a crash, damaged or written by somebody else, is passed over and done again;
///  3. a line of another version never counts: its figures may mean something else. foreign_line() names it;
///  4. several journals in one folder (one a process) are read together; only regular files are journals, links are not.
class BatchJournal {
 public:
  /// Whether a text is what record() would be given.
  using IsResult = bool (*)(const std::string& result);

  /// Opens `folder/journal-NAME.jsonl` for appending and reads every journal of the folder. `program` is the program's
  /// version; the journal's own is added.
  static tl::expected<BatchJournal, std::string> open(const std::filesystem::path& folder,
                                                      const std::string& name, std::string_view program,
                                                      IsResult is_result);

  BatchJournal(BatchJournal&& other) noexcept;
  BatchJournal& operator=(BatchJournal&&) = delete;
  ~BatchJournal();

  /// The result line of a spec that was finished earlier, or nullptr.
  const std::string* result(const std::string& key) const;

  /// Records a result (one line of JSON). Safe from several threads.
  tl::expected<void, std::string> record(const std::string& key, const std::string& result);

  /// All results by key, those recorded since opening included.
  const std::map<std::string, std::string>& results() const { return results_; }

  /// Lines that were passed over, as "FILE:LINE".
  const std::vector<std::string>& passed_over() const { return passed_over_; }

  /// A whole line that another version wrote; nothing if there is none.
  const std::optional<InputError>& foreign_line() const { return foreign_line_; }

  /// Reads the folder's journals again: what other processes have finished meanwhile.
  void read_all();

 private:
  BatchJournal(std::filesystem::path folder, int file, std::string version, IsResult is_result)
      : folder_(std::move(folder)), file_(file), version_(std::move(version)), is_result_(is_result) {}
  void read_line(const std::string& line, const std::string& file, int number);

  std::filesystem::path folder_;
  int file_ = -1;
  std::string version_;
  IsResult is_result_;
  std::optional<InputError> foreign_line_;
  std::vector<std::string> passed_over_;
  std::map<std::string, std::string> results_;
  std::mutex mutex_;
};

/// A key that changes whenever the text does: 16 hexadecimal digits (FNV-1a, 64 bit).
std::string text_key(const std::string& text);

}  // namespace kempe::app
