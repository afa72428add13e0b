#pragma once
// One spec of a batch, from its text to its lines in the results.

#include <string>

#include "app/batch/source.hpp"
#include "synthesis/search/search.hpp"

namespace kempe::app {

/// One line of JSON: name, status ("design"; "no design" if that is proven, else "none found"; "stopped", "bad input",
/// "verification failed"), and for a design its figures. Depends on the task and the seed alone, unless the options' time limit or flag stops the search: then a
/// design has `complete` false, and without one the status is "stopped".
std::string batch_result(const BatchTask& task, const SearchOptions& options);

/// Whether a text from a journal is a line that batch_result() writes: what follows relies on it.
bool is_batch_result(const std::string& line);

/// The status in such a line.
std::string batch_status(const std::string& line);

/// The head of results.csv.
std::string batch_csv_head();
/// The row of such a line.
std::string batch_csv_row(const std::string& line);

}  // namespace kempe::app
