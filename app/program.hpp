#pragma once
// The program as one call: its commands, and the run that the words of a command line choose.

#include <memory>
#include <string>
#include <vector>

#include "app/command.hpp"

namespace kempe::app {

/// The program without commands.
std::unique_ptr<CLI::App> bare_program();
/// Adds every command.
void add_commands(CLI::App& program, Session& session);

/// Runs what the words say, the program's name first; returns the exit code. Nothing is thrown. What was printed may wait in
/// stdout's buffer.
int run_program(const std::vector<std::string>& words, Session& session);

}  // namespace kempe::app
