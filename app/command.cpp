#include "app/command.hpp"

#include <cstdio>

namespace kempe::app {

CLI::App* add_command(CLI::App& program, Session& session, const std::string& name,
                      const std::string& description, const std::string& example) {
  CLI::App* command = program.add_subcommand(name, description);
  command->add_flag("--json", session.json, "Print one JSON object instead of text");
  command->add_flag("--quiet", session.quiet, "No progress on stderr");
  command->footer("Example:\n  " + example);
  return command;
}

int fail(ExitCode code, const std::string& message) {
  std::fprintf(stderr, "kempe: %s\n", message.c_str());
  return code;
}

int fail(const InputError& error) { return fail(bad_input, error.message()); }

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

}  // namespace kempe::app
