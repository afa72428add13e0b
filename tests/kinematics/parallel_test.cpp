// Jobs on several threads: each once, and what one of them throws is thrown on.
#include "kinematics/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace kempe {
namespace {

TEST(RunParallel, DoesEachJobOnce) {
  for (const int threads : {-1, 0, 1, 2, 7}) {
    std::vector<int> done(100);
    run_parallel(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(100, 1)) << threads;
  }
}

TEST(RunParallel, ThrowsOnWhatAJobThrows) {
  for (const int threads : {1, 2, 7}) {
    std::atomic<int> begun = 0;
    const auto job = [&](std::size_t i) {
      ++begun;
      if (i == 3) throw std::runtime_error("the fourth");
    };
    EXPECT_THROW(run_parallel(10'000, threads, job), std::runtime_error) << threads;
    if (threads == 1) {
      EXPECT_EQ(begun, 4);
    }
  }
}

}  // namespace
}  // namespace kempe
