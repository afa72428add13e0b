#include "synthesis/search/steps/search_control.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kempe {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

SearchControl::SearchControl(SearchOptions options)
    : start_(Clock::now()), options_(std::move(options)), stop_(after_share(1)) {}

bool SearchControl::has_time_limit() const { return std::isfinite(options_.time_limit); }

double SearchControl::seconds() const { return seconds_since(start_); }

StopFlag SearchControl::after_share(double share) const {
  if (!has_time_limit()) return options_.stop;
  return [stop = options_.stop, start = start_, limit = share * options_.time_limit] {
    return stop() || seconds_since(start) > limit;
  };
}

SearchControl SearchControl::part() const {
  SearchOptions options = options_;
  options.stop = stop_;
  options.time_limit = std::numeric_limits<double>::infinity();
  return SearchControl(std::move(options));
}

SearchControl SearchControl::part_with_seed(std::uint64_t seed) const {
  SearchControl control = part();
  control.options_.seed = seed;
  return control;
}

SearchControl SearchControl::silent_part() const {
  SearchControl control = part();
  control.options_.progress = nullptr;
  return control;
}

SearchControl SearchControl::part_of_time(double share) const {
  SearchOptions options = options_;
  options.time_limit = share * std::max(0.0, options_.time_limit - seconds());
  return SearchControl(std::move(options));
}

void SearchControl::report(double share, std::string_view what) const {
  if (options_.progress) options_.progress(share, what);
}

}  // namespace kempe
