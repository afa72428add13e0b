#pragma once
// Every command of the program, a line each.

#include "app/command.hpp"

namespace kempe::app {

using AddCommand = void (*)(CLI::App&, Session&);

inline constexpr AddCommand all_commands[] = {
    nullptr,
};

}  // namespace kempe::app
