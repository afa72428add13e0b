// Steps: the best that designs can have of the limit while all others hold (that limit is the goal of its own search); the
// limit moved there, a little further so that rounding does no harm; the spec searched again with it. A limit that can be
// left out is left out where no value is enough.

#include "synthesis/search/diagnosis/relaxed_limits.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/regions/region_algebra.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/search/best/nearby_search.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

RelaxedDesign start_at(const CopyingLinkage& linkage) {
  return {
      linkage.grounding(), linkage.assembly_mode().number, linkage.VA(), linkage.VB(), linkage.pole(), {}};
}

/// A design nearer to what is demanded than `best` by one of the budget's shares, found by a search for the spec's objective.
/// `began`: what was spent when the search for this limit did.
std::optional<FoundDesign> nearer(Questions& questions, const MovableLimit& limit, double demanded,
                                  const FoundDesign& best, std::uint64_t began) {
  const SearchTask& task = questions.task();
  for (const double share : questions.budget().nearer) {
    if (questions.has_had_its_share(began)) break;
    const double value = demanded + share * (best.attained.of(limit.goal) - demanded);
    const Requirements narrowed = with_limit(questions.limits(), limit.goal, value);
    auto found = questions.best(task.with(narrowed, task.goal)).design;
    if (!found) continue;
    if (has_stock_lengths(task.spec())) return found;  // polished lengths are none of the stock
    const SearchResult polished = best_from(start_at(found->linkage), task.with(narrowed, limit.goal), {});
    questions.count(task, polished.evaluations);
    return polished.design ? polished.design : found;
  }
  return std::nullopt;
}

struct BestAttained {
  FoundDesign design;
  bool is_best;  ///< false: the search for a better one was ended
};

/// The best that designs can have of a limit while all others hold. Its own search may miss where the pole wanders far: a
/// search for the spec's objective with the limit nearer to what is demanded finds what it missed.
std::optional<BestAttained> best_attained(Questions& questions, const MovableLimit& limit, double demanded) {
  const std::uint64_t began = questions.spent();
  auto best =
      questions
          .best(questions.task().with(with_limit(questions.limits(), limit.goal, limit.loosest), limit.goal))
          .design;
  for (int rounds = 0; best && rounds < questions.budget().rounds && !questions.has_had_its_share(began);
       ++rounds) {
    auto found = nearer(questions, limit, demanded, *best, began);
    if (!found) break;
    best = std::move(found);
  }
  if (!best) return std::nullopt;
  return BestAttained{*std::move(best), !questions.has_had_its_share(began)};
}

/// The limit moved to where a design attains it; the search of the spec with that value may need it looser still.
Relaxation moved_to(Questions& questions, const MovableLimit& limit, double demanded,
                    const BestAttained& best) {
  const SearchTask& task = questions.task();
  const double possible = possible_value(limit, demanded, best.design.attained.of(limit.goal));
  const auto again =
      questions.best(task.with(with_limit(questions.limits(), limit.goal, possible), task.goal)).design;
  return {.limit = limit.goal,
          .key = limit.key,
          .demanded = demanded,
          .possible = possible,
          .sentence = sentence_of(limit, demanded, possible, questions.unit()),
          .design = again.value_or(best.design),
          .is_least = best.is_best};
}

bool has_loosest(const MovableLimit& limit, double value) {
  return is_maximized(limit.goal) ? value <= limit.loosest : value >= limit.loosest;
}

bool keeps(const MovableLimit& limit, const FoundDesign& design, double demanded) {
  const double attained = design.attained.of(limit.goal);
  return is_maximized(limit.goal) ? attained >= demanded : attained <= demanded;
}

const MovableLimit& limit_of(Goal goal) {
  const MovableLimit* limit = movable_limits.data();
  while (limit->goal != goal) ++limit;
  return *limit;
}

/// "limits.sheets_gap_mm = 5 is in the way; left out, a design exists"
std::string left_out(const char* key, double demanded, SpecUnit unit) {
  return fmt::format("{} = {} is in the way; left out, a design exists", name_in(unit, key),
                     six_digits(demanded, unit));
}

/// The same with ", whose copy overlaps the original" where it does.
std::string without_gap(const Spec& spec, double demanded, const CopyingLinkage& linkage, SpecUnit unit) {
  const bool apart = are_apart(spec.region, similar_image(spec.region, linkage.k(), linkage.pole()), 0);
  return left_out("limits.sheets_gap_mm", demanded, unit) +
         (apart ? "" : ", whose copy overlaps the original");
}

void without_copy_gap(Questions& questions, double demanded) {
  Spec spec = questions.spec();
  spec.limits.copy_gap = std::nullopt;
  const auto design = questions.best_of(spec);
  if (!design) return;
  questions.keep(Relaxation{.limit = Goal::copy_gap,
                            .key = "limits.sheets_gap_mm",
                            .demanded = demanded,
                            .sentence = without_gap(spec, demanded, design->linkage, questions.unit()),
                            .design = *design});
}

/// A limit relaxed or, where no value that it may have is enough, left out; `limit`: of the spec.
void relax_or_leave_out(Questions& questions, Goal goal, std::optional<double> Limits::*limit) {
  const MovableLimit& moved = limit_of(goal);
  const auto demanded = value_of(questions.limits(), questions.spec(), goal);
  if (!demanded || questions.stopped()) return;
  auto found = relaxed(questions, moved);
  if (found) return questions.keep(std::move(found));
  questions.note(moved.key);
  Spec spec = questions.spec();
  spec.limits.*limit = std::nullopt;
  const auto design = questions.best_of(spec);
  if (!design || questions.permits(*design)) return;
  questions.keep(Relaxation{.key = moved.key,
                            .demanded = *demanded,
                            .sentence = left_out(moved.key, *demanded, questions.unit()),
                            .design = *design});
}

struct Sagging {
  double sag;  ///< mm, rounded up: a limit that the design keeps
  FoundDesign design;
};

/// The best design with a limit on the sag, or with none.
std::optional<Sagging> with_sag(Questions& questions, std::optional<double> limit) {
  Spec spec = questions.spec();
  spec.limits.sag = limit;
  auto design = questions.best_of(spec);
  const auto openings = design ? openings_over(design->linkage, spec.region) : std::nullopt;
  if (!openings) return std::nullopt;
  const double sag = largest_sag(design->linkage, sag_conditions(spec, design->layers), *openings).sag.most();
  if (!std::isfinite(sag)) return std::nullopt;
  return Sagging{rounded_up(sag, questions.unit()), *std::move(design)};
}

}  // namespace

std::optional<Relaxation> relaxed(Questions& questions, const MovableLimit& in_mm_or_degrees) {
  const MovableLimit limit = stated_in(questions.unit(), in_mm_or_degrees);
  const auto demanded = value_of(questions.limits(), questions.spec(), limit.goal);
  if (!demanded || has_loosest(limit, *demanded) || questions.stopped()) return std::nullopt;
  questions.note(limit.key);
  const auto best = best_attained(questions, limit, *demanded);
  // A limit that is kept is not in the way.
  if (!best || questions.permits(best->design) || keeps(limit, best->design, *demanded)) return std::nullopt;
  return moved_to(questions, limit, *demanded, *best);
}

/// No search makes the sag small: the design without the limit tells what would do, and designs with limits halfway there what less would.
void relax_sag(Questions& questions) {
  const auto demanded = questions.limits().sag;
  if (!demanded || questions.stopped()) return;
  questions.note("limits.sag_mm");
  const std::uint64_t began = questions.spent();
  auto enough = with_sag(questions, std::nullopt);
  double too_little = *demanded;
  for (int i = 0; enough && i < questions.budget().halvings_of_sag && !questions.has_had_its_share(began);
       ++i) {
    if (questions.permits(enough->design)) return;
    const double middle = rounded_up(0.5 * (too_little + enough->sag), questions.unit());
    if (middle >= enough->sag) break;
    if (auto less = with_sag(questions, middle))
      enough = std::move(less);
    else
      too_little = middle;
  }
  if (!enough || questions.permits(enough->design)) return;
  questions.keep(
      Relaxation{.key = "limits.sag_mm",
                 .demanded = *demanded,
                 .possible = enough->sag,
                 .sentence = length_would_do("limits.sag_mm", *demanded, enough->sag, questions.unit()),
                 .design = enough->design,
                 .is_least = false});
}

void relax_copy_gap(Questions& questions) {
  const auto demanded = questions.limits().copy_gap;
  if (!demanded || questions.stopped()) return;
  auto found = relaxed(questions, limit_of(Goal::copy_gap));
  if (found) return questions.keep(std::move(found));
  questions.note("limits.sheets_gap_mm");
  without_copy_gap(questions, *demanded);
}

namespace {

/// A longer strip, as far as longest_mm lets links use it.
std::optional<Relaxation> longer_strip(Questions& questions) {
  const Spec& spec = questions.spec();
  const MovableLimit limit{Goal::longest, "limits.longest_strip_mm", 1, spec.links.longest};
  auto found = relaxed(questions, limit);
  if (!found) return std::nullopt;
  found->sentence = length_would_do(limit.key, *spec.limits.longest_strip,
                                    rounded_up(*found->possible + spec.links.style.width, questions.unit()),
                                    questions.unit());
  return found;
}

/// Of longest_mm and longest_strip_mm the one that holds links back.
void relax_longest(Questions& questions) {
  questions.keep(strip_is_shorter(questions.spec()) ? longer_strip(questions)
                                                    : relaxed(questions, limit_of(Goal::longest)));
}

}  // namespace

/// First the limits that take longest to evaluate: a search without them is quick.
void relax_limits(Questions& questions) {
  relax_sag(questions);
  relax_or_leave_out(questions, Goal::load_error, &Limits::load_error);
  for (const Goal goal : {Goal::transmission, Goal::clearance})
    questions.keep(relaxed(questions, limit_of(goal)));
  relax_longest(questions);
  relax_copy_gap(questions);
  relax_or_leave_out(questions, Goal::copy_error, &Limits::copy_error);
  questions.keep(relaxed(questions, limit_of(Goal::pole_margin)));
}

}  // namespace kempe
