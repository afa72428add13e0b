// The commands of the whole program beside those that make and use a design.

#include "app/all_commands.hpp"

namespace kempe::app {
namespace {

// A command a line, so that adding one adds one line.
// clang-format off
constexpr AddCommand commands[] = {
    add_solve_command,
    add_mobility_command,
    add_centres_command,
    add_calibrate_command,
    add_function_command,
    add_inversor_command,
    add_path_command,
    add_mcp_command,
};
// clang-format on

}  // namespace

std::span<const AddCommand> other_commands() { return commands; }

}  // namespace kempe::app
