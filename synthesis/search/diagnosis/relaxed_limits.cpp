// Steps: the best that designs can have of the limit while all others hold (that limit is the goal of its own search); the
// limit moved there, a little further so that rounding does no harm; the spec searched again with it. A limit that can be
// left out is left out where no value is enough.

#include "synthesis/search/relaxed_limits.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/regions/region_algebra.hpp"
#include "synthesis/search/nearby_search.hpp"
#include "synthesis/search/relaxation_words.hpp"

namespace kempe {
namespace {

RelaxedDesign start_at(const CopyingLinkage& linkage) {
  return {linkage.grounding(), linkage.assembly_mode(), linkage.VA(), linkage.VB(), linkage.pole(), {}};
}

/// A design nearer to what is demanded than `best` by one of the budget's shares, found by a search for the spec's objective.
std::optional<FoundDesign> nearer(Questions& questions, const MovableLimit& limit, double demanded,
                                  const FoundDesign& best) {
  const SearchTask& task = questions.task();
  for (const double share : questions.budget().nearer) {
    if (questions.stopped()) break;
    const double value = demanded + share * (best.attained.of(limit.goal) - demanded);
    const Requirements narrowed = moved(questions.limits(), limit.goal, value);
    const auto found = questions.best(task.with(narrowed, task.goal)).design;
    if (!found) continue;
    const SearchResult polished = best_from(start_at(found->linkage), task.with(narrowed, limit.goal), {});
    questions.count(polished.evaluations);
    return polished.design ? polished.design : found;
  }
  return std::nullopt;
}

/// The best that designs can have of a limit while all others hold. Its own search may miss where the pole wanders far: a
/// search for the spec's objective with the limit nearer to what is demanded finds what it missed.
std::optional<FoundDesign> best_attained(Questions& questions, const MovableLimit& limit, double demanded) {
  auto best =
      questions.best(questions.task().with(moved(questions.limits(), limit.goal, limit.loosest), limit.goal))
          .design;
  for (int rounds = 0; best && rounds < questions.budget().rounds && !questions.stopped(); ++rounds) {
    auto found = nearer(questions, limit, demanded, *best);
    if (!found) break;
    best = std::move(found);
  }
  return best;
}

/// The limit moved to where a design attains it; the search of the spec with that value may need it looser still.
Relaxation moved_to(Questions& questions, const MovableLimit& limit, double demanded,
                    const FoundDesign& best) {
  const SearchTask& task = questions.task();
  const double possible = possible_value(limit, demanded, best.attained.of(limit.goal));
  const auto again =
      questions.best(task.with(moved(questions.limits(), limit.goal, possible), task.goal)).design;
  return {limit.goal,          limit.key, demanded, possible, sentence_of(limit, demanded, possible),
          again.value_or(best)};
}

bool has_loosest(const MovableLimit& limit, double value) {
  return is_maximized(limit.goal) ? value <= limit.loosest : value >= limit.loosest;
}

const MovableLimit& limit_of(Goal goal) {
  const MovableLimit* limit = movable_limits.data();
  while (limit->goal != goal) ++limit;
  return *limit;
}

/// "; without it a design exists, whose copy overlaps the original"
std::string without_gap(const Spec& spec, double demanded, const CopyingLinkage& linkage) {
  const bool apart = are_apart(spec.region, similar_image(spec.region, linkage.k(), linkage.pole()), 0);
  return fmt::format("limits.sheets_gap_mm = {:.6g} is in the way; left out, a design exists{}", demanded,
                     apart ? "" : ", whose copy overlaps the original");
}

void without_sheets_gap(Questions& questions, double demanded) {
  Spec spec = questions.spec();
  spec.limits.sheets_gap = std::nullopt;
  const auto design = questions.best_of(spec);
  if (!design) return;
  questions.keep(Relaxation{.limit = Goal::sheets_gap,
                            .key = "limits.sheets_gap_mm",
                            .demanded = demanded,
                            .sentence = without_gap(spec, demanded, design->linkage),
                            .design = *design});
}

void without_copy_error(Questions& questions, double demanded) {
  Spec spec = questions.spec();
  spec.limits.copy_error = std::nullopt;
  const auto design = questions.best_of(spec);
  if (!design) return;
  questions.keep(
      Relaxation{.key = "limits.copy_error_mm",
                 .demanded = demanded,
                 .sentence = fmt::format("limits.copy_error_mm = {:.6g} is in the way; left out, a design "
                                         "exists",
                                         demanded),
                 .design = *design});
}

void relax_copy_error(Questions& questions) {
  const auto demanded = questions.limits().copy_error;
  if (!demanded || questions.stopped()) return;
  auto found = relaxed(questions, limit_of(Goal::copy_error));
  if (found) return questions.keep(std::move(found));
  questions.note("limits.copy_error_mm");
  without_copy_error(questions, *demanded);
}

}  // namespace

std::optional<Relaxation> relaxed(Questions& questions, const MovableLimit& limit) {
  const auto demanded = value_of(questions.limits(), questions.spec(), limit.goal);
  if (!demanded || has_loosest(limit, *demanded) || questions.stopped()) return std::nullopt;
  questions.note(limit.key);
  const auto best = best_attained(questions, limit, *demanded);
  if (!best) return std::nullopt;
  return moved_to(questions, limit, *demanded, *best);
}

void relax_sheets_gap(Questions& questions) {
  const auto demanded = questions.limits().sheets_gap;
  if (!demanded || questions.stopped()) return;
  auto found = relaxed(questions, limit_of(Goal::sheets_gap));
  if (found) return questions.keep(std::move(found));
  questions.note("limits.sheets_gap_mm");
  without_sheets_gap(questions, *demanded);
}

void relax_limits(Questions& questions) {
  for (const Goal goal : {Goal::transmission, Goal::clearance, Goal::longest})
    questions.keep(relaxed(questions, limit_of(goal)));
  relax_sheets_gap(questions);
  relax_copy_error(questions);
  questions.keep(relaxed(questions, limit_of(Goal::pole_margin)));
}

}  // namespace kempe
