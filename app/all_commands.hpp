#pragma once
// Every command of the program, a line each.

#include <span>

namespace CLI {
class App;
}

namespace kempe::app {

struct Session;

void add_init_command(CLI::App& program, Session& session);
void add_synthesize_command(CLI::App& program, Session& session);
void add_workspace_command(CLI::App& program, Session& session);
void add_report_command(CLI::App& program, Session& session);
void add_verify_command(CLI::App& program, Session& session);
void add_trace_command(CLI::App& program, Session& session);
void add_pareto_command(CLI::App& program, Session& session);
void add_studio_command(CLI::App& program, Session& session);
void add_help_command(CLI::App& program, Session& session);
void add_solve_command(CLI::App& program, Session& session);
void add_mobility_command(CLI::App& program, Session& session);
void add_centres_command(CLI::App& program, Session& session);
void add_calibrate_command(CLI::App& program, Session& session);
void add_function_command(CLI::App& program, Session& session);
void add_inversor_command(CLI::App& program, Session& session);
void add_path_command(CLI::App& program, Session& session);
void add_mcp_command(CLI::App& program, Session& session);

using AddCommand = void (*)(CLI::App&, Session&);

// A command a line, so that adding one adds one line.
// clang-format off
/// Those that make and use a design: every program has them, and help.
inline constexpr AddCommand design_commands[] = {
    add_init_command,
    add_synthesize_command,
    add_workspace_command,
    add_report_command,
    add_verify_command,
    add_trace_command,
    add_pareto_command,
    add_studio_command,
};
// clang-format on

/// The others; none in a program that is built with KEMPE_COMMANDS=DESIGN.
std::span<const AddCommand> other_commands();

}  // namespace kempe::app
