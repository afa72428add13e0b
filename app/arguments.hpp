#pragma once
// What is wrong with the words on the command line, for a person or, with --json among them, for a program.

#include <string>
#include <vector>

#include "app/command.hpp"

namespace kempe::app {

/// Tells why the words could not be parsed: "kempe synthesise: no such command; did you mean synthesize?", or which option
/// is missing, unknown or out of range, and of which command. Returns `bad_input`.
int tell_bad_arguments(const CLI::App& program, const std::vector<std::string>& words,
                       const CLI::ParseError& error);

}  // namespace kempe::app
