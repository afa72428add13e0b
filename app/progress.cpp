#include "app/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace kempe::app {

using namespace std::chrono_literals;

Progress::Progress(bool quiet)
    : wanted_(!quiet && ::isatty(STDERR_FILENO) == 1), start_(std::chrono::steady_clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(double share, std::string_view what) {
  const auto now = std::chrono::steady_clock::now();
  if (!wanted_ || now - start_ < 1s || now - last_ < 100ms) return;
  last_ = now;
  shown_ = true;
  std::fprintf(stderr, "\r\033[K%3d %%  %.*s", static_cast<int>(100 * std::clamp(share, 0.0, 1.0)),
               static_cast<int>(what.size()), what.data());
  std::fflush(stderr);
}

}  // namespace kempe::app
