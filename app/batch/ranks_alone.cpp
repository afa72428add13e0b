// One process does the whole batch.

#include <atomic>
#include <cstdlib>
#include <string_view>

#include "app/batch/ranks.hpp"

namespace kempe::app {

struct Ranks::State {
  std::atomic<std::int64_t> next{0};
};

tl::expected<Ranks, std::string> Ranks::join() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* size = std::getenv(variable);
    if (size != nullptr && std::string_view(size) != "1")
      return tl::unexpected(
          std::string("started by mpirun, but this kempe was built without MPI (install Open MPI, configure "
                      "with -DKEMPE_WITH_MPI=ON)"));
  }
  Ranks alone;
  alone.state_ = new State;
  return alone;
}

Ranks::Ranks(Ranks&& other) noexcept : rank_(other.rank_), size_(other.size_), state_(other.state_) {
  other.state_ = nullptr;
}

Ranks::~Ranks() { delete state_; }

std::int64_t Ranks::next(std::int64_t) { return state_->next.fetch_add(1); }

bool Ranks::anyone(bool mine) { return mine; }

}  // namespace kempe::app
