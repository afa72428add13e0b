// The program that is built soonest (KEMPE_COMMANDS=DESIGN) has no other commands.

#include "app/all_commands.hpp"

namespace kempe::app {

std::span<const AddCommand> other_commands() { return {}; }

}  // namespace kempe::app
