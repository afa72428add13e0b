// design() and map() of kempe/design.hpp.

#include <algorithm>
#include <chrono>
#include <variant>

#include "kempe/validate.hpp"
#include "library/workings.hpp"
#include "specs/spec_check.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/plain_reasons.hpp"
#include "synthesis/search/search.hpp"

namespace kempe {
namespace {

/// The caller's wish to stop and the time limit, counted from when this is made. Flags must not outlive it.
class Patience {
 public:
  explicit Patience(const Options& options) : options_(options), start_(Clock::now()) {}

  StopFlag flag(double grace = 0) const {
    return [this, grace] {
      return (options_.stop && options_.stop()) ||
             (options_.time_limit && elapsed() > *options_.time_limit + grace);
    };
  }

  /// s, above 0; nothing without a limit.
  std::optional<double> left() const {
    constexpr double least = 1e-9;
    if (!options_.time_limit) return std::nullopt;
    return std::max(least, *options_.time_limit - elapsed());
  }

 private:
  using Clock = std::chrono::steady_clock;
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  const Options& options_;
  Clock::time_point start_;
};

SearchOptions search_options(const Options& options, const Patience& patience) {
  SearchOptions search;
  search.seed = options.seed;
  search.threads = std::max(1, options.threads);
  if (const auto left = patience.left()) search.time_limit = *left;
  search.stop = patience.flag();
  search.progress = options.progress;
  search.diagnose = options.diagnose;
  return search;
}

MapOptions map_options(const Options& options, StopFlag stop) {
  return {.map_tolerance = std::clamp(options.map_tolerance, 1e-5, 0.5),
          .largest_sheets = options.largest_sheets,
          .stop = std::move(stop)};
}

Outcome design_checked(const Spec& spec, const Options& options) {
  const Patience patience(options);
  const SearchOutcome found = synthesize(spec, search_options(options, patience));
  if (const auto* stopped = std::get_if<Stopped>(&found)) return Workings::outcome(*stopped);
  if (const auto* none = std::get_if<NoDesign>(&found)) return Workings::outcome(*none);
  auto design =
      certified_design(spec, std::get<FoundDesign>(found), map_options(options, patience.flag(time_to_map)));
  if (!design) return Workings::uncertified(std::move(design.error()));
  return Workings::outcome(Workings::finished(std::move(*design), toml_text(spec)));
}

Outcome map_checked(const Spec& spec, const Options& options) {
  const Patience patience(options);
  const auto linkage = given_linkage(spec, "");
  if (!linkage) return Workings::outcome(linkage.error());
  if (const auto none = plainly_impossible(spec); none && none->requirement == "obstacles")
    return Workings::outcome(*none);
  Design design = assemble_given(spec, *linkage, map_options(options, patience.flag()));
  return Workings::outcome(Workings::finished(std::move(design), toml_text(spec)));
}

}  // namespace

Outcome design(const Spec& spec, const Options& options) {
  const auto checked = check_spec(spec);
  return checked ? design_checked(*checked, options) : Workings::outcome(checked.error());
}

Outcome map(const Spec& spec, const Options& options) {
  const auto checked = check_spec(spec);
  return checked ? map_checked(*checked, options) : Workings::outcome(checked.error());
}

}  // namespace kempe
