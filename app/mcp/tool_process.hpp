#pragma once
// A command run in a process of its own, so that whatever it does ends at its limits and leaves the server as it was.

#include <poll.h>
#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <tl/expected.hpp>

namespace kempe::app {

/// What a command left behind.
struct ToolOutput {
  std::string object, text;  ///< stdout and stderr
  bool object_cut = false, text_cut = false;
  int code = 0;    ///< the exit code; with `signal` nothing
  int signal = 0;  ///< that ended it; 0: none
  bool late = false;
};

class ToolProcess {
 public:
  /// Runs `work`, whose result is the exit code, beside this process: its own memory, at most 4 GB of it, files of at most 256 MB, no
  /// stdin. After `seconds` it is asked to end, and three seconds later ended. The error is a sentence. The caller has no threads.
  static tl::expected<ToolProcess, std::string> start(const std::function<int()>& work, double seconds);
  ToolProcess(ToolProcess&& other) noexcept;
  ToolProcess& operator=(ToolProcess&&) = delete;
  ~ToolProcess();  ///< ends it

  /// True until both its streams are closed.
  bool runs() const { return out_ >= 0 || error_ >= 0; }
  /// What to wait for, besides read().
  pollfd output() const { return {out_, POLLIN, 0}; }
  pollfd errors() const { return {error_, POLLIN, 0}; }
  /// How long to wait at most, ms.
  int patience() const;
  /// Takes what is there, without waiting; ends what is over its time.
  void read();
  /// Asks it to end.
  void stop();
  /// Waits for its end; to be called once, when it runs no more.
  ToolOutput finish();

 private:
  using Clock = std::chrono::steady_clock;
  ToolProcess() = default;

  pid_t id_ = -1;
  int out_ = -1, error_ = -1;
  Clock::time_point end_;
  bool asked_ = false;
  ToolOutput output_;
};

}  // namespace kempe::app
