// kempe help: what --help says, by the name of a command; and the same as manual pages and completions.

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/manual/completion.hpp"
#include "app/manual/pages.hpp"
#include "reports/data/atomic_file.hpp"
#include "specs/key_checks.hpp"
#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

struct HelpArguments {
  std::string command, folder;
};

InputError no_such_command(const CLI::App& program, const std::string& word) {
  constexpr std::size_t longest = 60;
  std::vector<std::string> names;
  for (const CommandWords& one : words_of_program(program))
    if (!one.name.empty()) names.push_back(one.name);
  return {"", 0, "COMMAND", printable(word, longest),
          known_instead(std::string_view(word).substr(0, longest), {names.begin(), names.end()}, "command")};
}

/// Below the folder where share/ of an installation lies.
int write_manual(const Session& session, const CLI::App& program, const std::string& folder) {
  const std::vector<CommandWords> words = words_of_program(program);
  std::vector<OutputFile> pages{{"kempe.1", program_page(words, KEMPE_VERSION)}};
  for (std::size_t i = 1; i < words.size(); ++i)
    pages.push_back({"kempe-" + words[i].name + ".1", command_page(words[i], KEMPE_VERSION)});
  const std::filesystem::path share(folder);
  const std::pair<std::filesystem::path, std::vector<OutputFile>> folders[] = {
      {share / "man/man1", pages},
      {share / "bash-completion/completions", {{"kempe", bash_completion(words)}}},
      {share / "zsh/site-functions", {{"_kempe", zsh_completion(words)}}},
      {share / "fish/vendor_completions.d", {{"kempe.fish", fish_completion(words)}}}};
  for (const auto& [place, files] : folders)
    if (const auto written = write_whole(place, files); !written)
      return fail(session, cannot_write, written.error());
  return done;
}

/// What --help prints of the program; its own help() is that of the command which was parsed.
std::string help_of_program(const CLI::App& program) {
  return program.get_formatter()->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal);
}

const CLI::App* command_named(const CLI::App& program, const std::string& name) {
  const auto found =
      program.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
  return found.empty() ? nullptr : found.front();
}

int run(const Session& session, const CLI::App& program, const HelpArguments& arguments) {
  if (!arguments.folder.empty()) return write_manual(session, program, arguments.folder);
  const CLI::App* command = command_named(program, arguments.command);
  if (command == nullptr && !arguments.command.empty())
    return fail(session, no_such_command(program, arguments.command));
  const std::string text = command != nullptr ? command->help(program.get_name()) : help_of_program(program);
  print(session.json ? json_text({{"help", text}}) : text);
  return done;
}

}  // namespace

void add_help_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "help", "Show the help of the program or of a command",
                                  "kempe help synthesize");
  auto arguments = std::make_shared<HelpArguments>();
  command->add_option("COMMAND", arguments->command, "The command; left out: the program");
  command->add_option(
      "--write", arguments->folder,
      "Write the manual pages and the completions of bash, zsh and fish below this folder instead");
  command->callback([&program, &session, arguments] {
    session.chosen = [&program, &session, arguments] { return run(session, program, *arguments); };
  });
}

}  // namespace kempe::app
