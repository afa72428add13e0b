#pragma once
// Ctrl-C as a flag that long work looks at.

#include <atomic>

namespace kempe::app {

/// While it lives, SIGINT and SIGTERM set `requested` instead of ending the program; a second signal ends it at once.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  const std::atomic<bool>& requested() const;
};

/// From here on SIGINT and SIGTERM end the program at once: for work that looks at no flag and has written nothing yet.
void let_signals_end();

}  // namespace kempe::app
