#pragma once
// What a batch has finished, line by line on disk, so that a killed run goes on where it stopped.

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <tl/expected.hpp>

namespace kempe::app {

/// A journal of finished specs. Each line holds a spec's key and its result; a line counts only if it is whole.
///
/// Guarantees: a result recorded is on disk when record() returns; a line cut short by a crash is ignored and done again;
/// several journals in one folder (one a process) are read together.
class BatchJournal {
 public:
  /// Opens `folder/journal-NAME.jsonl` for appending and reads every journal of the folder.
  static tl::expected<BatchJournal, std::string> open(const std::filesystem::path& folder,
                                                      const std::string& name);

  BatchJournal(BatchJournal&& other) noexcept;
  BatchJournal& operator=(BatchJournal&&) = delete;
  ~BatchJournal();

  /// The result line of a spec that was finished earlier, or nullptr.
  const std::string* result(const std::string& key) const;

  /// Records a result (one line of JSON). Safe from several threads.
  tl::expected<void, std::string> record(const std::string& key, const std::string& result);

  /// All results by key, those recorded since opening included.
  const std::map<std::string, std::string>& results() const { return results_; }

  /// Reads the folder's journals again: what other processes have finished meanwhile.
  void read_all();

 private:
  BatchJournal(std::filesystem::path folder, int file) : folder_(std::move(folder)), file_(file) {}

  std::filesystem::path folder_;
  int file_ = -1;
  std::map<std::string, std::string> results_;
  std::mutex mutex_;
};

/// A key that changes whenever the text does: 16 hexadecimal digits (FNV-1a, 64 bit).
std::string text_key(const std::string& text);

}  // namespace kempe::app
