// kempe mcp: the commands as tools of the Model Context Protocol, over stdin and stdout.

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <memory>
#include <system_error>
#include <thread>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/mcp/server.hpp"
#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

struct McpArguments {
  std::string folder;
  double seconds = 60;
  int threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
};

int run(const Session& session, CLI::App& program, const McpArguments& arguments) {
  std::error_code error;
  if (!std::filesystem::is_directory(arguments.folder, error))
    return fail(session,
                InputError{"", 0, "--folder", printable(arguments.folder, 200), "a folder that is there"});
  std::filesystem::current_path(arguments.folder, error);
  if (error)
    return fail(session, InputError{"", 0, "--folder", error.message(), "a folder that can be entered"});
  std::signal(SIGPIPE, SIG_IGN);  // a closed stdout is an error of writing
  const int code = Server(program, arguments.seconds, arguments.threads).run();
  return code == done ? done : fail_told(cannot_write, "stdout cannot be written");
}

}  // namespace

void add_mcp_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(
      program, session, "mcp",
      "Serve language models: design, map, explain, verify, trace and calibrate as tools (docs/mcp.md)",
      "kempe mcp --folder out");
  auto arguments = std::make_shared<McpArguments>();
  command->add_option("--folder", arguments->folder, "The only folder whose files tools read and write")
      ->required();
  command->add_option("--time-limit", arguments->seconds, "Seconds that a call may take")
      ->check(number_between(0.1, 86400))
      ->capture_default_str();
  add_threads_option(*command, arguments->threads);
  command->callback([&program, &session, arguments] {
    session.chosen = [&program, &session, arguments] { return run(session, program, *arguments); };
  });
}

}  // namespace kempe::app
