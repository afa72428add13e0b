#pragma once
// Long work beside Python: other threads go on, Ctrl-C is obeyed, progress is told to a function of Python.

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace kempe::python {

/// What a piece of work and the thread that waits for it say to each other.
class Hooks {
 public:
  /// For the work: true once it is no longer wanted.
  bool stopped() const { return stop_; }
  /// For the work: the share done, 0..1, and what is being done. The newest replaces what has not been heard.
  void tell(double share, std::string_view what) {
    {
      const std::lock_guard lock(mutex_);
      told_.emplace(share, what);
    }
    changed_.notify_one();
  }

  /// For the one who waits.
  void stop() { stop_ = true; }
  void finish() {
    {
      const std::lock_guard lock(mutex_);
      finished_ = true;
    }
    changed_.notify_one();
  }
  bool finished_within(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, time, [this] { return finished_ || told_; });
    return finished_;
  }
  std::optional<std::pair<double, std::string>> news() {
    const std::lock_guard lock(mutex_);
    return std::exchange(told_, std::nullopt);
  }

 private:
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool finished_ = false;
  std::optional<std::pair<double, std::string>> told_;
};

/// Runs `work(hooks)` in a thread of its own and returns what it returns. The caller holds the interpreter's lock, which is
/// released meanwhile. Signals are looked at twenty times a second and `progress` (None: nobody) is called from the calling
/// thread; where either raises, the work is stopped and, once it has ended, that exception goes on.
template <typename Work>
auto at_work(const pybind11::object& progress, Work work) {
  namespace py = pybind11;
  using Result = decltype(work(std::declval<Hooks&>()));
  constexpr std::chrono::milliseconds patience{50};
  Hooks hooks;
  std::optional<Result> result;
  std::exception_ptr failure;
  std::exception_ptr raised;  // by Python
  std::thread worker([&] {
    try {
      result.emplace(work(hooks));
    } catch (...) {
      failure = std::current_exception();
    }
    hooks.finish();
  });
  {
    const py::gil_scoped_release others_may_run;
    while (!hooks.finished_within(patience)) {
      const auto news = hooks.news();
      if (hooks.stopped()) continue;
      const py::gil_scoped_acquire back;
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (news && !progress.is_none()) progress(news->first, news->second);
      } catch (...) {  // whatever it is, the worker is waited for
        raised = std::current_exception();
        hooks.stop();
      }
    }
    worker.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (failure) std::rethrow_exception(failure);
  if (const auto last = hooks.news(); last && !progress.is_none()) progress(last->first, last->second);
  return std::move(*result);
}

}  // namespace kempe::python
