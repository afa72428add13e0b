#include "app/program.hpp"

#include <exception>
#include <memory>
#include <sstream>
#include <utility>

#include "app/all_commands.hpp"
#include "app/arguments.hpp"
#include "app/command.hpp"

namespace kempe::app {
namespace {

std::unique_ptr<CLI::App> bare_program() {
  auto program = std::make_unique<CLI::App>(
      "Kempe designs copying linkages: pantographs, plagiographs and similar linkages.", "kempe");
  program->set_version_flag("-v,--version", KEMPE_VERSION);
  program->require_subcommand(1);
  return program;
}

void add_commands(CLI::App& program, Session& session) {
  for (const AddCommand add : design_commands) add(program, session);
  for (const AddCommand add : other_commands()) add(program, session);
  add_help_command(program, session);
  if (other_commands().empty())
    program.footer(
        "This program only makes and uses designs; scripts/build makes the one with all commands.");
}

}  // namespace

int run_program(const std::vector<std::string>& words, Session& session) {
  const auto program = bare_program();
  add_commands(*program, session);
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());  // as CLI11 takes them
    if (!reversed.empty()) reversed.pop_back();                       // the program's name
    program->parse(std::move(reversed));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return tell_bad_arguments(*program, words, error);
    std::ostringstream help;
    program->exit(error, help, help);
    print(help.str());
    return done;
  }
  try {
    return session.chosen();
  } catch (const std::exception& error) {
    return fail(session, failed, std::string("internal error: ") + error.what());
  }
}

}  // namespace kempe::app
