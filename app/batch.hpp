#pragma once
// Many specs in one run: resumable, on several threads, on several machines.

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/command.hpp"
#include "synthesis/search/search.hpp"

namespace kempe::app {

struct BatchArguments {
  std::string source;  ///< a folder of *.toml, or a .jsonl file: a spec a line, as a JSON object
  std::string folder;  ///< results.jsonl, results.csv and the journals go here
  int jobs = 1;        ///< threads
  std::uint64_t seed = 1;
  double time_limit = Deadline::unlimited;  ///< s, of each spec
};

struct BatchTask {
  std::string name;  ///< the file's name, or line-N
  tl::expected<std::string, InputError>
      text;                  ///< TOML, or why there is none: that task's failure, not the batch's
  std::string folder;        ///< where the files that it names are looked for
  bool is_one_line = false;  ///< the text was one line of JSON: its own lines mean nothing to a person
};

/// The tasks of a source, in the order of their names or lines.
tl::expected<std::vector<BatchTask>, InputError> batch_tasks(const std::string& source);

/// One line of JSON: name, status ("design", "no design", "stopped", "bad input", "verification failed"), and for a design
/// its figures. Depends on the task and the seed alone, unless the options' time limit or flag stops the search: then a
/// design has `complete` false, and without one the status is "stopped".
std::string batch_result(const BatchTask& task, const SearchOptions& options);

/// Runs what is not yet in the folder's journals, then writes results.jsonl and results.csv in the order of the tasks:
/// the same bytes for any number of threads and processes.
int run_batch(const Session& session, const BatchArguments& arguments);

}  // namespace kempe::app
