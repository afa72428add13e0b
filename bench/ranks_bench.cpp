// What it costs to share tasks among the ranks of an MPI run: every rank takes tasks that last a given time.
//
// usage: [mpirun -n N] kempe_ranks_bench TASKS MICROSECONDS
// Every rank prints, as JSON, how many tasks it took and how long it waited for each on average.

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "app/batch/ranks.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double microseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

/// Busy, as a search is: it does not look after the other ranks.
void work_for(double microseconds) {
  const auto begin = Clock::now();
  while (microseconds > 0 && microseconds_since(begin) < microseconds) {
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::int64_t tasks = std::atoll(argv[1]);
  const double each = std::atof(argv[2]);
  auto ranks = kempe::app::Ranks::join();
  if (!ranks) return 1;
  ranks->wait_for_all();
  const auto begin = Clock::now();
  double waited = 0;
  std::int64_t taken = -1;
  for (bool left = true; left; work_for(each)) {
    const auto asked = Clock::now();
    left = ranks->next(tasks) < tasks;
    waited += microseconds_since(asked);
    ++taken;
  }
  ranks->wait_for_all();
  fmt::print(
      "{{\"rank\": {}, \"of\": {}, \"task_us\": {}, \"wall_s\": {:.6f}, \"tasks\": {}, \"waited_us_a_task\": "
      "{:.4f}}}\n",
      ranks->rank(), ranks->size(), each, 1e-6 * microseconds_since(begin), taken,
      waited / static_cast<double>(taken + 1));
  return 0;
}
