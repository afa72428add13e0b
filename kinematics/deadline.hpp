#pragma once
// A time limit as a flag that long work looks at.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "kinematics/stop_flag.hpp"

namespace kempe {

/// A limit of wall clock, counted from when it is made. A value: copies count from the same moment.
class Deadline {
 public:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();
  explicit Deadline(double seconds = unlimited) : limit_(seconds), start_(Clock::now()) {}

  bool is_limited() const { return std::isfinite(limit_); }
  /// s, as given.
  double limit() const { return limit_; }
  /// What is left of the limit, s, >= 0.
  double left() const { return std::max(0.0, limit_ - elapsed()); }
  /// Set once `stop` is, or when that share of the limit and `grace` seconds more are over.
  StopFlag flag(StopFlag stop, double share = 1, double grace = 0) const {
    if (!is_limited()) return stop;
    return [stop = std::move(stop), deadline = *this, end = share * limit_ + grace] {
      return stop() || deadline.elapsed() > end;
    };
  }

 private:
  using Clock = std::chrono::steady_clock;
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  double limit_;
  Clock::time_point start_;
};

}  // namespace kempe
