#pragma once
// A request to end long work early, by a person or by a clock.

#include <atomic>
#include <functional>
#include <type_traits>
#include <utility>

namespace kempe {

/// True once the work shall end. Every loop whose length depends on the input asks it at each turn that may last longer
/// than some microseconds. Default: never. Once true it must stay true; it may be asked from several threads.
class StopFlag {
 public:
  StopFlag() = default;
  template <typename Asked>
  requires std::is_invocable_r_v<bool, const Asked&> StopFlag(Asked asked) : asked_(std::move(asked)) {}
  /// `flag` must outlive this.
  StopFlag(const std::atomic<bool>* flag) : StopFlag([flag] { return flag->load(); }) {}

  bool operator()() const { return asked_ && asked_(); }

 private:
  std::function<bool()> asked_{};
};

}  // namespace kempe
