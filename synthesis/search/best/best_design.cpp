// tree                  among obstacles, beside bodies and under a limit on the load error: the bound's tree as the search (tree_search.hpp);
//                       where it leaves nothing, that is all; where the limit counts pins and layers too, if its design keeps it so
// prove                 the bound's tree: it proves that there is no design, or gives places to start from
// relax                 every choice without contact: an order, and what to prune by; at first without a limit on the load error, too;
//                       where none that is left keeps it, a proof is asked for that no design does
// for group in order    of fixed size, so that threads change nothing
//   search              in parallel; a choice that cannot beat what earlier groups found is left out
//   certify             every limit anew; a miss adds a place or tightens a limit, then again; the best is kept
// finish                the best by the second solver
//
// Under a time limit all this comes after a first look: a share of the limit goes to a proof as far as it comes and to a first
// design, which are kept for the case that the time runs out. Where there are stock lengths, the best design with any
// lengths leads to those.

#include "synthesis/search/best/best_design.hpp"

#include <fmt/format.h>

#include <span>

#include "kinematics/parallel.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/search/best/lowered_limit.hpp"
#include "synthesis/search/steps/prove.hpp"
#include "synthesis/search/strategies/stock_lengths.hpp"
#include "synthesis/search/strategies/strategy.hpp"
#include "synthesis/search/strategies/tree_search.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

std::vector<ChoiceResult> search_group(const Strategy& strategy, const SearchTask& task,
                                       std::span<const Prospect> group, const ChoiceResult& best) {
  std::vector<ChoiceResult> found(group.size(), no_result());
  run_parallel(group.size(), task.control.options().threads,
               [&](std::size_t i) { found[i] = strategy.search(task, group[i], best); });
  return found;
}

void report(const SearchTask& task, std::size_t searched, std::size_t all) {
  const std::size_t left_out = task.problem->obstacles_out_of_reach();
  task.control.report(static_cast<double>(searched) / static_cast<double>(all),
                      left_out == 0
                          ? "searching"
                          : fmt::format("searching; {} obstacles out of reach are left out", left_out));
}

/// The next choices that are searched at once, after `searched` others. Under a limit on the load error, which makes each search long, the
/// most promising ones come alone, as with what they found most of the others are left out; and none that has yet to be relaxed under it,
/// unless it comes first.
std::span<Prospect> next_group(const SearchTask& task, std::span<Prospect> rest, std::size_t searched,
                               const ChoiceResult& best) {
  const SearchBudgets& budgets = task.budgets();
  const bool alone = task.limits.load_error && searched < budgets.choice.under_load.alone;
  const std::size_t most = alone ? 1 : budgets.group;
  std::size_t size = 1;
  while (size < std::min(most, rest.size()) && !(rest[size].lacks_load_limit && may_beat(rest[size], best)))
    ++size;
  return rest.first(size);
}

bool has_any(const Incumbent& best) { return best.result.feasible || best.design; }

/// `asks_for_proof`: that no design keeps the limit on the load error. A little is spent on it at first, where the tree has not been asked
/// already; where nothing is found, more, once, as soon as no choice that is left keeps the limit without contact. `relaxed` becomes all
/// choices as they were relaxed.
SearchResult best_by(const Strategy& strategy, const SearchTask& task,
                     const std::vector<RelaxedDesign>& known, bool asks_for_proof,
                     std::vector<Prospect>& relaxed) {
  const ProofBudget& proof = task.budgets().proof;
  if (asks_for_proof && !suits_tree_search(task) && none_keeps_loads(task, proof.boxes_at_first_under_load))
    return {.proven_none = true};
  Incumbent best;
  std::vector<Prospect>& order = relaxed = strategy.relax(task, known, best);
  std::size_t searched = 0;
  while (searched < order.size() && !task.stopped()) {
    const std::span<Prospect> rest = std::span(order).subspan(searched);
    best.evaluations += relax_under_load(task, rest, best.result);
    if (asks_for_proof && !has_any(best) && !rest.front().relaxed.feasible) {
      asks_for_proof = false;
      if (none_keeps_loads(task, proof.boxes_under_load))
        return {.proven_none = true, .evaluations = best.evaluations};
    }
    const std::span<Prospect> group = next_group(task, rest, searched, best.result);
    const std::vector<ChoiceResult> found = search_group(strategy, task, group, best.result);
    for (std::size_t i = 0; i < group.size(); ++i) strategy.certify(task, group[i], found[i], best);
    report(task, searched += group.size(), order.size());
  }
  strategy.finish(task, best);
  const bool proven_none =
      asks_for_proof && !best.design && !task.stopped() && none_keeps_loads(task, proof.boxes_under_load);
  return {.design = best.design,
          .stopped = task.stopped(),
          .proven_none = proven_none,
          .evaluations = best.evaluations};
}

/// The best with any lengths. Among obstacles, where there are stock lengths to come, by the tree if it closes. `relaxed` as in best_by; empty
/// where the tree closes, or time ran out.
SearchResult best_of_any_lengths(const SearchTask& task, const std::vector<RelaxedDesign>& known,
                                 bool asks_for_proof, std::vector<Prospect>& relaxed) {
  if (!has_stock_lengths(task.spec()))
    return best_by(strategy_for(task.goal), task, known, asks_for_proof, relaxed);
  const SearchTask in_part = task.control.has_time_limit()
                                 ? task.with(task.control.part_of_time(task.budgets().time.any_lengths))
                                 : task;
  Spec spec = task.spec();
  spec.links.stock_lengths = {};
  const SearchTask any{std::make_shared<const SearchProblem>(spec, task.limits), in_part.control, task.limits,
                       task.goal};
  // Without obstacles the tree's bound, which is not told beside stock lengths, takes longer than what the tree spares.
  const bool by_tree_first = suits_tree_search(any) && !any.space().obstacles().empty();
  SearchResult by_tree = by_tree_first ? best_by_tree(any) : SearchResult{};
  if (by_tree.exhausted || by_tree.proven_none) return by_tree;
  SearchResult found = best_by(strategy_for(task.goal), in_part, known, asks_for_proof, relaxed);
  if (in_part.stopped()) relaxed.clear();  // some were not relaxed to the end
  keep_better(task.goal, by_tree.design, found.design);
  found.evaluations += by_tree.evaluations;
  return found;
}

/// What no design can beat, of goals that the bound's tree knows.
std::optional<double> bound_of(Goal goal, const FirstLook& look, const std::optional<ProvenBound>& proof) {
  if (goal != Goal::size && goal != Goal::transmission) return std::nullopt;
  std::optional<double> bound;
  for (const auto& one : {look.proof, proof})
    if (one) bound = tighter_bound(goal, bound, one->value);
  return bound;
}

/// After a first look, which may be empty. `asks_for_proof`: of the limit on the load error, as in best_by.
SearchResult best_by_choices(const SearchTask& task, const FirstLook& look, bool asks_for_proof) {
  const auto proof = look.proof_is_whole ? look.proof : prove(task, task.stop());
  if (proof && proof->no_design) return {.proven_none = true};
  std::vector<Prospect> relaxed;
  SearchResult found = best_of_any_lengths(task, starts_of(proof), asks_for_proof, relaxed);
  if (found.proven_none) return {.proven_none = true, .evaluations = found.evaluations};
  const bool stopped = found.stopped;
  if (found.design && has_stock_lengths(task.spec())) {
    found = best_with_stock_lengths(task, found, std::move(relaxed));
    found.none_in_stock = !found.design;
  }
  found.stopped = found.stopped || stopped;
  if (found.stopped) keep_better(task.goal, look.design, found.design);
  found.bound = bound_of(task.goal, look, proof);
  if (found.design) {
    found.design->evaluations = found.evaluations;
    found.design->complete = !found.stopped;
  }
  return found;
}

/// mm, how far the pen of a design gives way with pins and layers; infinite where it cannot be stated.
double in_all(const Spec& spec, const FoundDesign& design) {
  const auto openings = openings_over(design.linkage, spec.region);
  return openings ? give_in_all(spec, design.linkage, design.layers, *openings) : infinity;
}

/// Under a limit on the load error that counts pins and layers: the tree's search with one of the links alone. If its design keeps the limit
/// in all, or if it leaves none, that is all; else the best of the designs found with lower limits of the links that keeps it, if any.
SearchResult best_by_trees_of_links(const SearchTask& task) {
  Spec spec = task.spec();
  Requirements limits = task.limits;
  spec.limits.load_error_in_all = limits.load_error_in_all = false;
  const SearchTask links{std::make_shared<const SearchProblem>(spec, limits), task.control, limits,
                         task.goal};
  if (!suits_tree_search(links)) return {};
  SearchResult result = best_by_tree(links);
  if (!result.design) return result;
  const double told = in_all(spec, *result.design);
  if (told > *limits.load_error) {
    const auto found_with = [&](double lower) {
      Requirements lowered = limits;
      lowered.load_error = lower;
      SearchResult found = best_by_tree(links.with(lowered, task.goal));
      result.evaluations += found.evaluations;
      return std::move(found.design);
    };
    result.design =
        best_of_lowered(task, *limits.load_error, result.design->attained.load_error, told, found_with,
                        [&](const FoundDesign& design) { return in_all(spec, design); });
    result.exhausted = false;
    result.stopped = task.stopped();
  }
  if (result.design) result.design->attained.load_error = in_all(spec, *result.design);
  return result;
}

/// The better of a search's design and one known before it.
SearchResult with_known(const SearchTask& task, SearchResult found, const SearchResult& known) {
  keep_better(task.goal, known.design, found.design);
  found.evaluations += known.evaluations;
  if (found.design) {
    found.design->evaluations = found.evaluations;
    found.design->complete = !found.stopped;
  }
  return found;
}

}  // namespace

SearchResult best_by_choices(const SearchTask& asked) {
  const SearchTask task = posed_for_its_limits(asked);
  return best_by_choices(task, first_look(task), false);
}

SearchResult best_design(const SearchTask& asked) {
  const SearchTask task = posed_for_its_limits(asked);
  const FirstLook look = first_look(task);
  if (look.proof && look.proof->no_design) return best_by_choices(task, look, true);
  if (task.limits.load_error && task.limits.load_error_in_all) {
    SearchResult by_links = best_by_trees_of_links(task);
    // Among obstacles the search of every choice takes a hundred times as long.
    const bool is_enough = by_links.design && !task.space().obstacles().empty();
    if (by_links.exhausted || by_links.proven_none || is_enough) return by_links;
    return with_known(task, best_by_choices(task, look, !by_links.design), by_links);
  }
  if (!suits_tree_search(task)) return best_by_choices(task, look, true);
  SearchResult by_tree = best_by_tree(task);
  if (by_tree.exhausted || by_tree.proven_none) return by_tree;
  return with_known(task, best_by_choices(task, look, !by_tree.design), by_tree);
}

}  // namespace kempe
