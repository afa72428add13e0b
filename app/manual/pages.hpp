#pragma once
// Manual pages, in the language of man(7).

#include <string>
#include <vector>

#include "app/manual/words.hpp"

namespace kempe::app {

/// kempe.1: the program, a line for each of its commands, exit codes.
std::string program_page(const std::vector<CommandWords>& words, const std::string& version);
/// kempe-COMMAND.1: how it is called, its options, an example.
std::string command_page(const CommandWords& command, const std::string& version);

}  // namespace kempe::app
