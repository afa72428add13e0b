#include "app/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "specs/key_checks.hpp"
#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// Longer words are shown and compared by their beginning.
constexpr std::size_t longest_word = 60;

/// A word where a command should stand; the program's footer says what it was built without.
InputError unknown_command(const std::string& word, const std::vector<std::string>& commands,
                           const std::string& footer) {
  const auto meant =
      nearest(std::string_view(word).substr(0, longest_word), {commands.begin(), commands.end()});
  return {
      "", 0, printable(word, longest_word), "no such command",
      meant ? fmt::format("did you mean {}?", *meant)
            : fmt::format("there are {}{}{}", fmt::join(commands, ", "), footer.empty() ? "" : ". ", footer)};
}

InputError bad_option(const std::string& command, const CLI::ParseError& error) {
  return {"", 0, command, error.what(), fmt::format("see kempe {} --help", command)};
}

InputError fault_of(const CLI::App& program, const std::vector<std::string>& words,
                    const CLI::ParseError& error) {
  const std::vector<std::string> commands = command_names(program);
  if (words.size() < 2) return {"", 0, "", "no command", "see kempe --help"};
  if (words[1].starts_with("-")) return {"", 0, words[1], "no such option", "see kempe --help"};
  const bool known = std::find(commands.begin(), commands.end(), words[1]) != commands.end();
  return known ? bad_option(words[1], error) : unknown_command(words[1], commands, program.get_footer());
}

}  // namespace

int tell_bad_arguments(const CLI::App& program, const std::vector<std::string>& words,
                       const CLI::ParseError& error) {
  const InputError fault = fault_of(program, words, error);
  const std::string command = fault.key.empty() ? "" : " " + fault.key;
  std::fputs(printable_lines(fmt::format("kempe{}: {}; {}\n", command, fault.found, fault.allowed)).c_str(),
             stderr);
  if (std::find(words.begin(), words.end(), "--json") != words.end()) print(faults_json(fault));
  return bad_input;
}

}  // namespace kempe::app
