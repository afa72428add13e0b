#pragma once
// When a command shall end early: on Ctrl-C, SIGTERM, or at the end of its time limit.

#include <chrono>
#include <limits>
#include <optional>
#include <string>

#include "app/command.hpp"
#include "app/interrupt.hpp"
#include "kinematics/stop_flag.hpp"

namespace kempe::app {

/// Counts the time from when it is made.
class Stopping {
 public:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();
  explicit Stopping(double seconds = unlimited);

  /// Set by a signal, or `grace` seconds after the limit. Must not outlive this.
  StopFlag flag(double grace = 0) const;
  bool interrupted() const { return interrupt_.requested(); }
  /// What is left of the limit, s, above 0.
  double left() const;

  /// The exit code of a command that stopped before it had an answer: `interrupted`, or else `stopped`.
  ExitCode code() const { return interrupted() ? app::interrupted : stopped; }
  /// "interrupted" or "time limit of 5 s".
  std::string reason() const;

 private:
  double elapsed() const;

  Interrupt interrupt_;
  double seconds_;
  std::chrono::steady_clock::time_point start_;
};

/// A positive number of seconds, for --time-limit.
CLI::Option* add_time_limit(CLI::App& command, double& seconds, const std::string& description);

/// Says that a command stopped before an answer and what is known nevertheless; returns the exit code.
int tell_stopped(const Session& session, const Stopping& stopping, const std::string& known,
                 const std::optional<double>& proven_bound = {});

}  // namespace kempe::app
