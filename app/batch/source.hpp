#pragma once
// The specs of a batch, handed out one by one: what a source holds is read when it is asked for and not kept, so that a batch
// may be longer than the memory.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kempe/input_error.hpp"

namespace kempe::app {

/// One spec of a batch.
struct BatchTask {
  std::string name;  ///< the file's name, line-N, or cell-I-J-...
  /// As the source holds it, or why there is none: that task's failure, not the batch's.
  tl::expected<std::string, InputError> text;
  std::string file;      ///< that holds it
  std::string folder;    ///< where the files that it names are looked for
  bool is_json = false;  ///< the text is one line of JSON; else TOML
};

/// A source of tasks: numbered from 0, in the order of their names, lines or cells.
class BatchSource {
 public:
  /// Opens a folder (of *.toml), a sweep (a file whose name ends in .json) or a file with a spec a line, as a JSON object.
  /// The error: there is no such thing, or the sweep is none.
  static tl::expected<std::unique_ptr<BatchSource>, InputError> open(const std::string& source);

  virtual ~BatchSource() = default;
  BatchSource(const BatchSource&) = delete;
  BatchSource& operator=(const BatchSource&) = delete;

  /// How many tasks there are; of a file, as it was when it was opened.
  virtual std::int64_t size() const = 0;
  /// The task of this number. Cheapest in rising order. Not for several threads at once.
  virtual BatchTask task(std::int64_t number) = 0;
  /// The task of this name; nothing where there is none.
  virtual std::optional<BatchTask> named(const std::string& name) = 0;
  /// The files that the tasks come from.
  virtual std::vector<std::filesystem::path> inputs() const = 0;

 protected:
  BatchSource() = default;
};

}  // namespace kempe::app
