// The ranks of an MPI run draw tasks from one counter, which rank 0 holds: whoever is free asks for the next ones, so that slow
// specs hold nobody up. A rank takes several at once while many are left: a 4n-th of them with n ranks, at most 16, and one by
// one at the end (guided self-scheduling, Polychronopoulos and Kuck, IEEE Trans. Computers C-36, 1987).
//
// Messages of both sides and no remote access to memory: without hardware for it, MPI serves that only when rank 0 calls MPI,
// which a search does not. A thread of rank 0 looks for questions instead, twice a millisecond. It shares MPI with the others
// under one lock, which nobody holds while waiting for another rank that may itself wait for an answer.

#include <mpi.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "app/batch/ranks.hpp"

namespace kempe::app {

struct Ranks::State {
  static constexpr int question = 1, reply = 2;  ///< the messages' tags
  static constexpr auto pause = std::chrono::microseconds(500);

  bool joined = false;
  std::int64_t counter = 0;        ///< tasks that were taken; rank 0's counts
  std::int64_t next = 0, end = 0;  ///< what this process has taken and not handed out
  std::mutex mutex;                ///< of what stands above, and of MPI
  std::atomic<bool> leaving{false};
  std::thread answering;

  std::int64_t take(std::int64_t some) { return std::exchange(counter, counter + some); }

  /// Rank 0: every rank that has asked is told its first task.
  void answer() {
    for (;;) {
      int is_there = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, question, MPI_COMM_WORLD, &is_there, &status);
      if (is_there == 0) return;
      std::int64_t some = 0;
      MPI_Recv(&some, 1, MPI_INT64_T, status.MPI_SOURCE, question, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      const std::int64_t first = take(some);
      MPI_Send(&first, 1, MPI_INT64_T, status.MPI_SOURCE, reply, MPI_COMM_WORLD);
    }
  }

  void answer_until_leaving() {
    for (; !leaving; std::this_thread::sleep_for(pause)) {
      const std::lock_guard lock(mutex);
      answer();
    }
  }

  void begin_to_answer() {
    try {
      answering = std::thread([this] { answer_until_leaving(); });
    } catch (const std::system_error&) {
      // The system gives no more threads: rank 0 answers between two specs.
    }
  }

  /// Another rank's question.
  static std::int64_t ask(std::int64_t some) {
    std::int64_t first = 0;
    MPI_Sendrecv(&some, 1, MPI_INT64_T, 0, question, &first, 1, MPI_INT64_T, 0, reply, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
    return first;
  }
};

tl::expected<Ranks, std::string> Ranks::join() {
  Ranks ranks;
  ranks.state_ = new State;
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMI_SIZE") == nullptr) return ranks;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &ranks.rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks.size_);
  ranks.state_->joined = true;
  if (ranks.rank_ == 0 && ranks.size_ > 1 && provided >= MPI_THREAD_SERIALIZED)
    ranks.state_->begin_to_answer();
  return ranks;
}

Ranks::Ranks(Ranks&& other) noexcept : rank_(other.rank_), size_(other.size_), state_(other.state_) {
  other.state_ = nullptr;
}

Ranks::~Ranks() {
  if (state_ != nullptr && state_->joined) {
    state_->leaving = true;
    if (state_->answering.joinable()) state_->answering.join();
    MPI_Finalize();
  }
  delete state_;
}

std::int64_t Ranks::next(std::int64_t count) {
  const std::lock_guard lock(state_->mutex);
  if (rank_ == 0 && size_ > 1) state_->answer();
  if (state_->next == state_->end) {
    constexpr std::int64_t most = 16;
    const std::int64_t left = count - state_->end;  // no more than that: others have taken some meanwhile
    const std::int64_t some = std::clamp<std::int64_t>(left / (4 * size_), 1, most);
    state_->next = rank_ == 0 ? state_->take(some) : State::ask(some);
    state_->end = state_->next + some;
  }
  return state_->next++;
}

bool Ranks::anyone(bool mine) {
  int any = mine ? 1 : 0, is_done = 0;
  if (!state_->joined) return mine;
  MPI_Request request{};
  {
    const std::lock_guard lock(state_->mutex);
    MPI_Iallreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_LOR, MPI_COMM_WORLD, &request);
  }
  for (;; std::this_thread::sleep_for(State::pause)) {
    const std::lock_guard lock(state_->mutex);
    if (rank_ == 0) state_->answer();
    MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
    if (is_done != 0) return any != 0;
  }
}

}  // namespace kempe::app
