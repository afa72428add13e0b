#include "app/interrupt.hpp"

#include <csignal>

namespace kempe::app {
namespace {

// A signal handler can reach nothing but a variable of the program.
std::atomic<bool> was_signalled{false};

extern "C" void note_interrupt(int signal) {
  was_signalled.store(true);
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() {
  was_signalled.store(false);
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
}

Interrupt::~Interrupt() { let_signals_end(); }

void let_signals_end() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& Interrupt::requested() const { return was_signalled; }

}  // namespace kempe::app
