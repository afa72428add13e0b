#pragma once
// Independent jobs on several threads.

#include <cstddef>
#include <functional>

namespace kempe {

/// Calls job(0) .. job(count - 1), each once, on up to `threads` threads; returns when all are done. Which
/// thread runs which job is not determined: a job must write only to its own place. What a job throws is thrown on once all threads have
/// ended; no job begins after it.
void run_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& job);

}  // namespace kempe
