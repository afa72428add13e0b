#include "synthesis/search/steps/search_control.hpp"

#include <utility>

namespace kempe {

SearchControl::SearchControl(SearchOptions options)
    : deadline_(options.time_limit), options_(std::move(options)), stop_(after_share(1)) {}

StopFlag SearchControl::after_share(double share) const { return deadline_.flag(options_.stop, share); }

SearchControl SearchControl::part() const {
  SearchOptions options = options_;
  options.stop = stop_;
  options.time_limit = Deadline::unlimited;
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

SearchControl SearchControl::silent() const {
  SearchControl control = *this;
  control.options_.progress = nullptr;
  return control;
}

SearchControl SearchControl::part_of_time(double share) const {
  SearchOptions options = options_;
  options.time_limit = share * deadline_.left();
  return SearchControl(std::move(options));
}

void SearchControl::report(double share, std::string_view what) const {
  if (options_.progress) options_.progress(share, what);
}

std::function<void(double share)> SearchControl::progress_of(std::string_view what) const {
  if (!options_.progress) return {};
  return [progress = options_.progress, what](double share) { progress(share, what); };
}

}  // namespace kempe
