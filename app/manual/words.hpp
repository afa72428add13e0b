#pragma once
// The program's own description of its commands and options (the same that --help prints), as its manual and the shells'
// completions need it.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace kempe::app {

/// An option or argument of a command.
struct OptionWords {
  std::string name;                                  ///< of an argument, "SPEC"; empty: an option
  std::vector<std::string> long_names, short_names;  ///< "output", "o": without their hyphens
  std::string value;                                 ///< what follows the option, "FILE"; empty for a flag
  std::string meaning;                               ///< a sentence without a full stop
  std::string fallback;                              ///< what it is if it is left out; empty: not stated
  bool required = false;
};

/// A command, or with an empty name the program.
struct CommandWords {
  std::string name, purpose, example;
  std::vector<OptionWords> options;
};

/// The program first, then its commands in the order in which --help lists them; hidden ones (of no group) are left out.
std::vector<CommandWords> words_of_program(const CLI::App& program);

}  // namespace kempe::app
