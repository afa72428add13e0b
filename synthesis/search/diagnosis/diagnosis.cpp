#include "synthesis/search/diagnosis/diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "specs/unit_words.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/problem/obstacle_reach.hpp"
#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/diagnosis/relaxations.hpp"
#include "synthesis/search/steps/slack.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// The share of itself by which a limit has to give; 1 for what is left out, moved elsewhere or taken away.
double give(const Relaxation& r) {
  return r.possible ? std::abs(*r.possible - r.demanded) / std::max(std::abs(r.demanded), slack::least_demand)
                    : 1;
}

/// First what costs a limit little, and another place of the pole, which often costs nothing but a hole in the table; then, where
/// that is in vain, what else restricts designs; then all of it from other random numbers.
Questions asked(const SearchTask& task, const Point& origin, bool thorough) {
  Questions questions(task, origin, thorough);
  relax_limits(questions);
  relax_support(questions);
  relax_stiffness(questions);
  relax_joints(questions);
  relax_obstacles(questions);
  relax_bodies(questions);
  relax_pole(questions);
  for (const auto relax : {relax_stock_lengths, relax_parts})
    if (questions.found().empty()) relax(questions);
  return questions;
}

Questions asked_of_plain(const SearchTask& task, const std::string& requirement, const Point& origin,
                         bool thorough) {
  Questions questions(task, origin, thorough);
  if (requirement == "limits.sheets_gap_mm") relax_copy_gap(questions);
  if (requirement == "limits.sag_mm") {
    relax_sag(questions);
    relax_support(questions);
  }
  if (requirement == "obstacles") relax_obstacles(questions);
  if (requirement == "table") relax_bodies(questions);
  if (task.spec().pole.is_fixed() && !requirement.starts_with("links.")) relax_pole(questions);
  return questions;
}

/// Once more, thoroughly, where nothing was found.
template <typename Ask>
Questions asked_twice(const Ask& ask) {
  Questions questions = ask(false);
  if (!questions.found().empty() || questions.stopped()) return questions;
  Questions again = ask(true);
  again.add_earlier(questions.evaluations());
  return again;
}

void take_answers(const Questions& questions, NoDesign& none) {
  none.relaxations = questions.found();
  none.evaluations += questions.evaluations();
  none.diagnosed = !questions.stopped();
  std::stable_sort(none.relaxations.begin(), none.relaxations.end(),
                   [](const Relaxation& a, const Relaxation& b) { return give(a) < give(b); });
}

/// Limits on load error and sag of which each alone is in vain: what both would have to be for the best design without the two.
std::string both_of_loads(const SearchTask& task) {
  const Spec& spec = task.spec();
  if (!spec.limits.load_error || !spec.limits.sag || task.stopped()) return "";
  Spec other = spec;
  other.limits.load_error = other.limits.sag = std::nullopt;
  const auto design = best_design(pose(other, task.control.silent_part())).design;
  const auto openings = design ? openings_over(design->linkage, spec.region) : std::nullopt;
  if (!openings) return "";
  const double give = design->attained.load_error,
               sag = largest_sag(design->linkage, sag_conditions(spec, design->layers), *openings).sag.most();
  if (!(give > *spec.limits.load_error) || !(sag > *spec.limits.sag) || !std::isfinite(give + sag)) return "";
  const SpecUnit unit = task.control.options().unit;
  const auto text = [&](double length) { return six_digits(length, unit); };
  return fmt::format("; {} = {} and {} = {} are both in the way, {} and {} together would do",
                     name_in(unit, "limits.load_error_mm"), text(*spec.limits.load_error),
                     name_in(unit, "limits.sag_mm"), text(*spec.limits.sag), text(rounded_up(give, unit)),
                     text(rounded_up(sag, unit)));
}

/// What was changed in vain.
std::string in_vain(const NoDesign& none, const Questions& questions) {
  if (!none.diagnosed) return "; the diagnosis ended before it was known which limit to relax";
  if (questions.noted().empty()) return "";
  std::vector<std::string> keys;
  for (const std::string& key : questions.noted()) keys.push_back(name_in(questions.unit(), key));
  return fmt::format("; none was found with one of these alone relaxed: {}", fmt::join(keys, ", "));
}

}  // namespace

Diagnosis diagnose(const SearchTask& task, const SearchResult& nothing, const Point& origin) {
  NoDesign none{.requirement = "limits",
                .sentence = nothing.proven_none ? "no design keeps all limits together"
                                                : "the search found none that keeps all limits together",
                .relaxations = {},
                .proven = nothing.proven_none,
                .obstacles_out_of_reach = names_out_of_reach(task.spec()),
                .evaluations = nothing.evaluations};
  if (!task.control.options().diagnose) return {std::move(none)};
  const Questions questions = asked_twice([&](bool thorough) { return asked(task, origin, thorough); });
  take_answers(questions, none);
  if (none.relaxations.empty()) {
    none.sentence += both_of_loads(task) + in_vain(none, questions);
  } else {
    none.sentence = none.relaxations.front().sentence;
    none.requirement = none.relaxations.front().key;
  }
  return {std::move(none), questions.permitted()};
}

NoDesign diagnose_plain(const SearchTask& task, NoDesign reason, const Point& origin) {
  if (!task.control.options().diagnose) return reason;
  const Questions questions =
      asked_twice([&](bool thorough) { return asked_of_plain(task, reason.requirement, origin, thorough); });
  take_answers(questions, reason);
  if (reason.relaxations.empty()) reason.sentence += both_of_loads(task) + in_vain(reason, questions);
  return reason;
}

}  // namespace kempe
