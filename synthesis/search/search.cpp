// pose                     every grounding, assembly mode and layer assignment, with its requirements
// best design              prove, relax, group, search, certify (best_design.cpp)
// search again             from other random numbers, before "no design" is said without a proof
// improve                  while the gap to the proven bound is wide (improve.cpp)
// corners                  where instruments break the copy error's limit: with a lower one (corner_search.cpp)
// sections                 all of this for each of several sections (section_search.hpp)
// robust                   where it is asked for: with limits raised until every instrument keeps them (robust_search.cpp)
// the design, or why there is none (diagnosis.cpp), or that the time was over

#include "synthesis/search/search.hpp"

#include "synthesis/problem/local_frame.hpp"
#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/best/improve.hpp"
#include "synthesis/search/corner_search.hpp"
#include "synthesis/search/diagnosis/diagnosis.hpp"
#include "synthesis/search/diagnosis/plain_reasons.hpp"
#include "synthesis/search/robust_search.hpp"
#include "synthesis/search/section_search.hpp"
#include "synthesis/tolerance/robust.hpp"

namespace kempe {
namespace {

/// The search's design as the outcome tells it.
FoundDesign finished(const SearchTask& task, SearchResult&& found) {
  const bool complete = found.design->complete;
  found = improved(task, std::move(found));
  found.design->evaluations = found.evaluations;
  found.design->complete = complete && !task.stopped();
  return *std::move(found.design);
}

/// The time that a robust design is to leave for its rounds.
SearchTask nominal_task(const SearchTask& task) {
  if (!asks_for_robust(task.spec()) || !task.control.has_time_limit()) return task;
  return task.with(task.control.part_of_time(task.budgets().time.nominal));
}

/// Of a search with a design. `nominal`: the task without what robust designs need beyond it.
SearchOutcome told(const SearchTask& whole, const SearchTask& nominal, SearchResult found) {
  const FoundDesign design = kept_at_corners(nominal, finished(nominal, std::move(found)));
  if (!asks_for_robust(whole.spec())) return design;
  return make_robust(whole, design);
}

/// `origin`: of the spec's coordinates, on the table.
SearchOutcome synthesize_here(const Spec& spec, const Point& origin, const SearchOptions& options) {
  const SearchTask whole = pose(spec, SearchControl(options)), task = nominal_task(whole);
  SearchResult found = best_design(task);
  const std::optional<double> bound = has_stock_lengths(spec) ? std::nullopt : found.bound;
  if (!found.design && !found.proven_none) found = searched_again(task, std::move(found), has_design);
  if (found.design) return told(whole, task, std::move(found));
  if (found.stopped && !found.proven_none) return Stopped{found.evaluations, bound};
  Diagnosis diagnosis = diagnose(whole, found, origin);
  if (diagnosis.permitted && !found.proven_none) {
    found.design = std::move(diagnosis.permitted);
    found.evaluations = diagnosis.none.evaluations;
    return told(whole, task, std::move(found));
  }
  return asks_for_robust(spec) ? told_without_robust(std::move(diagnosis.none)) : std::move(diagnosis.none);
}

SearchOutcome back_to_the_table(SearchOutcome outcome, const Point& origin) {
  if (auto* found = std::get_if<FoundDesign>(&outcome)) return shifted(std::move(*found), origin);
  if (auto* none = std::get_if<NoDesign>(&outcome)) return shifted(std::move(*none), origin);
  return outcome;
}

/// A plain reason with what helps against it.
NoDesign diagnosed(const Spec& spec, NoDesign reason, const SearchOptions& options) {
  const Point origin = local_origin(spec);
  const Spec here = shifted(spec, -origin);
  return shifted(diagnose_plain(pose(here, SearchControl(options)), std::move(reason), origin), origin);
}

}  // namespace

namespace {

/// Of a spec with one section.
SearchOutcome synthesize_with_its_section(const Spec& spec, const SearchOptions& options) {
  const JointHardware& hardware = spec.links.hardware;
  if (auto none = plainly_impossible(spec, options.unit))
    return claiming_no_more(diagnosed(spec, *std::move(none), options), hardware);
  const Point origin = local_origin(spec);
  if (origin.isZero(0)) return claiming_no_more(synthesize_here(spec, origin, options), hardware);
  return claiming_no_more(back_to_the_table(synthesize_here(shifted(spec, -origin), origin, options), origin),
                          hardware);
}

}  // namespace

SearchOutcome synthesize(const Spec& spec, const SearchOptions& options) {
  if (spec.links.sections.size() < 2) return synthesize_with_its_section(spec, options);
  return best_of_sections(spec, options, synthesize_with_its_section);
}

}  // namespace kempe
