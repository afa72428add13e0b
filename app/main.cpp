// kempe: the command line. Parses, runs the chosen command, chooses the exit code.

#include <cstdio>
#include <exception>

#include "app/all_commands.hpp"
#include "app/command.hpp"

int main(int argc, char** argv) {
  using namespace kempe::app;
  CLI::App program{"Kempe designs copying linkages: pantographs, plagiographs and their kin.", "kempe"};
  program.set_version_flag("--version", KEMPE_VERSION);
  program.require_subcommand(1);
  Session session;
  for (const AddCommand add : all_commands)
    if (add != nullptr) add(program, session);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? done : bad_input;
  }
  int code = failed;
  try {
    code = session.chosen();
  } catch (const std::exception& error) {
    return fail(failed, std::string("internal error: ") + error.what());
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return fail(cannot_write, "stdout cannot be written");
  return code;
}
