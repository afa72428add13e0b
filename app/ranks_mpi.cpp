// The ranks of an MPI run share one counter of tasks, held by rank 0 and read by remote access: whoever is free takes
// the next task, so that slow specs hold nobody up.

#include <mpi.h>

#include <cstdlib>
#include <mutex>

#include "app/ranks.hpp"

namespace kempe::app {

struct Ranks::State {
  MPI_Win window{};
  long* counter = nullptr;
  long local = 0;  // used by a process that mpirun did not start
  bool joined = false;
  std::mutex mutex;
};

tl::expected<Ranks, std::string> Ranks::join() {
  Ranks ranks;
  ranks.state_ = new State;
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMI_SIZE") == nullptr) return ranks;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &ranks.rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks.size_);
  const MPI_Aint bytes = ranks.rank_ == 0 ? sizeof(long) : 0;
  MPI_Win_allocate(bytes, sizeof(long), MPI_INFO_NULL, MPI_COMM_WORLD, &ranks.state_->counter,
                   &ranks.state_->window);
  if (ranks.rank_ == 0) *ranks.state_->counter = 0;
  ranks.state_->joined = true;
  MPI_Barrier(MPI_COMM_WORLD);
  return ranks;
}

Ranks::Ranks(Ranks&& other) noexcept : rank_(other.rank_), size_(other.size_), state_(other.state_) {
  other.state_ = nullptr;
}

Ranks::~Ranks() {
  if (state_ != nullptr && state_->joined) {
    MPI_Win_free(&state_->window);
    MPI_Finalize();
  }
  delete state_;
}

long Ranks::next() {
  const std::lock_guard lock(state_->mutex);
  if (!state_->joined) return state_->local++;
  const long one = 1;
  long taken = 0;
  MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, state_->window);
  MPI_Fetch_and_op(&one, &taken, MPI_LONG, 0, 0, MPI_SUM, state_->window);
  MPI_Win_unlock(0, state_->window);
  return taken;
}

bool Ranks::anyone(bool mine) {
  const std::lock_guard lock(state_->mutex);
  int any = mine ? 1 : 0;
  if (state_->joined) MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_LOR, MPI_COMM_WORLD);
  return any != 0;
}

}  // namespace kempe::app
