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

}  // namespace kempe::app
