#pragma once
// Tasks as unlike each other as docs/spec.md allows: extreme ratios, regions and obstacles of every shape on round numbers,
// low clamps to lift over, layers, far frames, straight and nearly straight plates, all objectives.

#include <cstdint>
#include <optional>
#include <random>

#include "tests/metamorphic/task.hpp"

namespace kempe::metamorphic {

/// Random numbers that are the same with every library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  int whole(int lowest, int highest) { return lowest + below(highest - lowest + 1); }
  bool percent(int share) { return below(100) < share; }
  double uniform(double lower, double upper);
  double log_uniform(double lower, double upper);
  template <class T>
  T one_of(std::initializer_list<T> list) {
    return list.begin()[below(static_cast<int>(list.size()))];
  }
  std::mt19937_64& engine() { return random_; }

 private:
  std::mt19937_64 random_;
};

/// A task that the reader takes; the same for the same number.
Task draw_task(Dice& dice);

/// The task with an obstacle beside or in the way of a linkage that does it: one that matters.
std::optional<Task> with_obstacle_in_the_way(const Task& task, const CopyingLinkage& linkage, Dice& dice);

}  // namespace kempe::metamorphic
