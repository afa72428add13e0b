#include "app/command.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "specs/text/printable.hpp"

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
  say(message);
  return code;
}

void say(const std::string& message) {
  std::fprintf(stderr, "kempe: %s\n", printable_lines(message).c_str());
}

int fail(const InputError& error) { return fail(bad_input, error.message()); }

CLI::Validator number_between(double lowest, double highest) {
  const auto check = [lowest, highest](std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= lowest && value <= highest)
      return {};  // NaN is neither
    return fmt::format("found {}; allowed: a number from {:g} to {:g}", text, lowest, highest);
  };
  return {check, fmt::format("FLOAT in [{:g} .. {:g}]", lowest, highest)};
}

void print(const std::string& text) {
  const std::string shown = printable_lines(text);
  std::fwrite(shown.data(), 1, shown.size(), stdout);
}

}  // namespace kempe::app
