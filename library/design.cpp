// design() and map() of kempe/design.hpp, front() of kempe/design.hpp.

#include "kempe/design.hpp"

#include <algorithm>
#include <string>
#include <variant>

#include "kempe/validate.hpp"
#include "kinematics/deadline.hpp"
#include "library/workings.hpp"
#include "specs/spec_check.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/diagnosis/plain_reasons.hpp"
#include "synthesis/search/pareto.hpp"
#include "synthesis/search/search.hpp"
#include "synthesis/search/search_faults.hpp"

namespace kempe {
namespace {

Deadline deadline_of(const Options& options) {
  return Deadline(options.time_limit.value_or(Deadline::unlimited));
}

StopFlag wish_to_stop(const Options& options) { return options.stop ? StopFlag(options.stop) : StopFlag(); }

SearchOptions search_options(const Options& options, const Deadline& deadline) {
  SearchOptions search;
  search.seed = options.seed;
  search.threads = std::max(1, options.threads);
  search.time_limit = deadline.left();
  search.stop = deadline.flag(wish_to_stop(options));
  search.progress = options.progress;
  search.diagnose = options.diagnose;
  return search;
}

MapOptions map_options(const Options& options, StopFlag stop) {
  MapOptions map{.map_tolerance = std::clamp(options.map_tolerance, 1e-5, 0.5),
                 .largest_sheets = options.largest_sheets,
                 .stop = std::move(stop)};
  if (options.progress)
    map.progress = [progress = options.progress](double share) { progress(share, "mapping"); };
  return map;
}

Outcome design_checked(const Spec& spec, const Options& options) {
  const Deadline deadline = deadline_of(options);
  const SearchOutcome found = synthesize(spec, search_options(options, deadline));
  if (const auto* stopped = std::get_if<Stopped>(&found)) return Workings::outcome(*stopped);
  if (const auto* none = std::get_if<NoDesign>(&found)) return Workings::outcome(*none);
  const StopFlag to_map = deadline.flag(wish_to_stop(options), 1, time_to_map(deadline.limit()));
  auto design = certified_design(spec, std::get<FoundDesign>(found), map_options(options, to_map));
  if (!design) return Workings::uncertified(std::move(design.error()));
  return Workings::outcome(Workings::finished(std::move(*design), toml_text(spec)));
}

Outcome map_checked(const Spec& spec, const Options& options) {
  const Deadline deadline = deadline_of(options);
  const auto linkage = given_linkage(spec, "");
  if (!linkage) return Workings::outcome(linkage.error());
  if (const auto none = pole_blocked(spec)) return Workings::outcome(*none);
  Design design = assemble_given(spec, *linkage, map_options(options, deadline.flag(wish_to_stop(options))));
  return Workings::outcome(Workings::finished(std::move(design), toml_text(spec)));
}

/// What is wrong with what is asked for beside the spec.
std::optional<InputError> front_question_fault(const Spec& spec, Objective first, Objective second,
                                               int points) {
  if (first == second)
    return InputError{"", 0, "between", std::string(name(first)) + " twice", "two objectives"};
  if (points < 2 || points > 200) return InputError{"", 0, "points", std::to_string(points), "2 to 200"};
  return front_fault(spec, first, second);
}

}  // namespace

Outcome design(const Spec& spec, const Options& options) {
  const auto checked = check_spec(spec);
  if (!checked) return Workings::outcome(checked.error());
  if (auto fault = search_fault(*checked)) return Workings::outcome(*std::move(fault));
  return design_checked(*checked, options);
}

Outcome map(const Spec& spec, const Options& options) {
  const auto checked = check_spec(spec);
  return checked ? map_checked(*checked, options) : Workings::outcome(checked.error());
}

std::variant<Front, Outcome> front(const Spec& spec, Objective first, Objective second, int points,
                                   const Options& options) {
  const auto checked = check_spec(spec);
  if (!checked) return Workings::outcome(checked.error());
  if (auto fault = front_question_fault(*checked, first, second, points))
    return Workings::outcome(std::move(*fault));
  const Deadline deadline = deadline_of(options);
  const SearchOptions search = search_options(options, deadline);
  const auto found = pareto_front(*checked, first, second, points, search);
  if (!found) return Workings::outcome(found.error());
  const bool stopped = search.stop();
  if (found->empty() && stopped) return Workings::outcome(Stopped{});
  if (found->empty()) return Workings::uncertified("no design was found");
  const StopFlag to_map = deadline.flag(wish_to_stop(options), 1, time_to_map(deadline.limit()));
  const std::string text = toml_text(*checked);
  Front front{.points = {}, .complete = !stopped, .first = first, .second = second};
  for (const ParetoPoint& point : *found) {
    Design design = assemble_design(*checked, point.design, map_options(options, to_map));
    design.quality.proven_bound.reset();  // a bound of the spec's objective, not of this point's
    front.complete = front.complete && design.map.complete;
    front.points.push_back({point.a, point.b, Workings::finished(std::move(design), text)});
  }
  return front;
}

}  // namespace kempe
