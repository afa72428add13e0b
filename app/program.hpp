#pragma once
// The program as one call.

#include <string>
#include <vector>

namespace kempe::app {

struct Session;

/// Runs what the words say, the program's name first; returns the exit code. Nothing is thrown. What was printed may wait in
/// stdout's buffer.
int run_program(const std::vector<std::string>& words, Session& session);

}  // namespace kempe::app
