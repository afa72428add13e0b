#include "app/manual/words.hpp"

namespace kempe::app {
namespace {

OptionWords words_of(const CLI::Option& option) {
  OptionWords words;
  words.name = option.get_positional() ? option.get_name(true) : "";
  words.long_names = option.get_lnames();
  words.short_names = option.get_snames();
  if (!option.get_positional() && option.get_items_expected_max() > 0) words.value = option.get_type_name();
  words.meaning = option.get_description();
  words.fallback = option.get_default_str();
  words.required = option.get_required();
  return words;
}

/// What stands below "Example:" in a command's --help.
std::string example_of(const CLI::App& command) {
  const std::string footer = command.get_footer(), head = "Example:\n  ";
  return footer.starts_with(head) ? footer.substr(head.size()) : footer;
}

CommandWords words_of(const CLI::App& command) {
  CommandWords words{command.get_name(), command.get_description(), example_of(command), {}};
  for (const CLI::Option* option : command.get_options()) words.options.push_back(words_of(*option));
  return words;
}

}  // namespace

std::vector<CommandWords> words_of_program(const CLI::App& program) {
  std::vector<CommandWords> all{words_of(program)};
  all.front().name.clear();
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) all.push_back(words_of(*command));
  return all;
}

}  // namespace kempe::app
