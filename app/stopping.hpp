#pragma once
// When a command shall end early: on Ctrl-C, SIGTERM, or at the end of its time limit.

#include <optional>
#include <string>

#include "app/command.hpp"
#include "app/interrupt.hpp"
#include "kinematics/deadline.hpp"

namespace kempe::app {

/// Notes signals from when it is made: until then, while files are read, Ctrl-C ends the program at once.
class Stopping {
 public:
  explicit Stopping(Deadline deadline = Deadline()) : deadline_(deadline) {}

  /// Set by a signal, or `grace` seconds after the limit.
  StopFlag flag(double grace = 0) const { return deadline_.flag(&interrupt_.requested(), 1, grace); }
  bool interrupted() const { return interrupt_.requested(); }
  /// The limit, s; infinite without one.
  double limit() const { return deadline_.limit(); }
  /// What is left of it, s.
  double left() const { return deadline_.left(); }

  /// The exit code of a command that stopped before it had an answer: `interrupted`, or else `stopped`.
  ExitCode code() const { return interrupted() ? app::interrupted : stopped; }
  /// "interrupted" or "time limit of 5 s".
  std::string reason() const;

 private:
  Interrupt interrupt_;
  Deadline deadline_;
};

/// A positive number of seconds, for --time-limit.
CLI::Option* add_time_limit(CLI::App& command, double& seconds, const std::string& description);

/// Says that a command stopped before an answer and what is known nevertheless; returns the exit code.
int tell_stopped(const Session& session, const Stopping& stopping, const std::string& known,
                 const std::optional<double>& proven_bound = {});

}  // namespace kempe::app
