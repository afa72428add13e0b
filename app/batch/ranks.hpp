#pragma once
// The processes that share a batch: one, or the ranks of an MPI run.

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

namespace kempe::app {

/// This process among those that share the work. Counts the tasks out so that each is taken once.
/// Built with MPI (ranks_mpi.cpp) it joins the run that mpirun started; else it is alone (ranks_alone.cpp).
class Ranks {
 public:
  /// Joins. The error: started by mpirun, but this program was built without MPI.
  static tl::expected<Ranks, std::string> join();
  Ranks(Ranks&& other) noexcept;
  Ranks& operator=(Ranks&&) = delete;
  ~Ranks();  ///< leaves the run

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// The next task's number that no process has taken yet, from 0 upward; `count` or more when all were taken. Rising from
  /// call to call, with gaps for what others took. Safe from several threads.
  std::int64_t next(std::int64_t count);

  /// Returns once every process has come here.
  void wait_for_all() { anyone(false); }

  /// True if any process says true; returns once every process has come here.
  bool anyone(bool mine);

 private:
  Ranks() = default;
  struct State;
  int rank_ = 0, size_ = 1;
  State* state_ = nullptr;
};

}  // namespace kempe::app
