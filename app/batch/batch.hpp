#pragma once
// Many specs in one run: resumable, on several threads, on several machines, of any number.

#include <cstdint>
#include <string>

#include "app/command.hpp"
#include "synthesis/search/search.hpp"

namespace kempe::app {

struct BatchArguments {
  std::string source;  ///< what BatchSource opens
  std::string folder;  ///< results.jsonl, results.csv and the journals go here
  int jobs = 1;        ///< threads
  std::uint64_t seed = 1;
  double time_limit = Deadline::unlimited;  ///< s, of each spec
};

/// Runs what is not yet in the folder's journals, then writes results.jsonl and results.csv in the order of the tasks:
/// the same bytes for any number of threads and processes. Neither specs nor results are kept in memory: a task is read when
/// it is taken, its result goes to the journal, and the results are copied from the journals one by one at the end.
int run_batch(const Session& session, const BatchArguments& arguments);

}  // namespace kempe::app
