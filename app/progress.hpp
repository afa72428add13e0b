#pragma once
// One line of progress on stderr, for people at a terminal only.

#include <chrono>
#include <string_view>

namespace kempe::app {

/// Shows nothing unless stderr is a terminal, progress is wanted, and the work has lasted a second.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();  ///< clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// share in 0..1
  void show(double share, std::string_view what);

 private:
  bool wanted_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace kempe::app
