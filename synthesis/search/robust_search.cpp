// For a limit on clearance raised by x the search's best design D(x) loses l(x) to the tolerances, and is robust if
// x >= l(x). As l changes little with x, x = l(x) is found by setting x to what the last design lacked, kept between the
// largest x known to be too small and the smallest known to do. Where some instrument does not close, the limit on the
// transmission angle is raised first: a dead or change point farther away than the tolerances reach.

#include "synthesis/search/robust_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/best/improve.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/steps/slack.hpp"
#include "synthesis/tolerance/robust.hpp"

namespace kempe {
namespace {

/// A design with what its instruments keep.
struct Tried {
  FoundDesign design;
  RobustCheck check;
};

RobustCheck check_of(const Spec& spec, const FoundDesign& found) {
  return check_robust(map_task(found.linkage, found.layers, spec), CopyTolerance::uniform(*spec.tolerance));
}

class RobustSearch {
 public:
  explicit RobustSearch(const SearchTask& task, const Spec& spec) : task_(task), spec_(spec) {}

  /// From a design for the spec's own limits.
  void begin_with(const FoundDesign& nominal) {
    evaluations_ = 0;
    tried_ = Tried{nominal, check_of(spec_, nominal)};
    take_tried();
  }

  /// Rounds of search with the transmission limit (rad) and raised clearances.
  void search(double transmission) {
    Spec raised = spec_;
    raised.limits.transmission = transmission;
    double too_small = 0, enough = INFINITY, raise = 0;
    const auto& budget = task_.budgets().robust;
    bool begun = transmission > spec_.limits.transmission;  // the design at hand has other limits
    for (int round = 0; round < budget.rounds && !task_.stopped(); ++round) {
      if (begun) {
        raised.limits.clearance = spec_.limits.clearance + raise;
        if (!try_with(raised)) return;
      }
      begun = true;
      const RobustCheck& check = tried_->check;
      if (!check.closes) {
        raised.limits.transmission =
            std::max(budget.more_transmission * raised.limits.transmission, budget.least_transmission);
        if (raised.limits.transmission > budget.most_transmission) return;
        continue;
      }
      const double lacking = least_clearance() - check.clearance;
      (lacking > 0 ? too_small : enough) = raise;
      if (lacking <= 0 && (raise == 0 || -lacking <= budget.waste * raise)) return;
      if (std::isfinite(enough) && enough - too_small <= budget.waste * enough) return;
      raise = next(raise, lacking, too_small, enough);
    }
  }

  const std::optional<FoundDesign>& best() const { return best_; }
  const std::optional<Tried>& last() const { return tried_; }
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  /// With room for the rounding of another frame.
  double least_clearance() const {
    return spec_.limits.clearance + slack::robust_rounding * tried_->design.linkage.size();
  }
  double next(double raise, double lacking, double too_small, double enough) const {
    const double towards =
        raise + lacking + (lacking > 0 ? 0.25 : 0.5) * task_.budgets().robust.waste * raise;
    if (towards > too_small && towards < enough) return towards;
    return std::isfinite(enough) ? 0.5 * (too_small + enough) : 2 * raise + lacking;
  }
  bool try_with(const Spec& raised) {
    const SearchTask again = pose(raised, task_.control.silent_part());
    SearchResult found = best_design(again);
    evaluations_ += found.evaluations;
    if (!found.design) return false;
    const std::uint64_t so_far = found.evaluations;
    found = improved(again, std::move(found));
    evaluations_ += found.evaluations - so_far;
    tried_ = Tried{*found.design, check_of(spec_, *found.design)};
    take_tried();
    return true;
  }
  void take_tried() {
    if (!tried_->check.keeps(least_clearance())) return;
    keep_better(task_.goal, tried_->design, best_);
  }

  const SearchTask& task_;
  const Spec& spec_;
  std::optional<Tried> tried_;
  std::optional<FoundDesign> best_;
  std::uint64_t evaluations_ = 0;
};

/// The best robust design for a spec, which may have other tolerances than the task's.
RobustSearch searched(const SearchTask& task, const Spec& spec, const FoundDesign& nominal) {
  RobustSearch search(task, spec);
  search.begin_with(nominal);
  if (search.best()) return search;
  search.search(spec.limits.transmission);
  const double comfortable = task.budgets().robust.comfortable_transmission;
  if (nominal.attained.transmission < comfortable && spec.limits.transmission < comfortable)
    search.search(comfortable);
  return search;
}

/// The largest share of the tolerances, halved again and again, with which there is a robust design.
std::optional<Relaxation> closer_tolerances(const SearchTask& task, const FoundDesign& nominal,
                                            std::uint64_t& evaluations) {
  Spec spec = task.spec();
  for (int i = 0; i < task.budgets().robust.halvings && !task.stopped(); ++i) {
    spec.tolerance->length /= 2;
    spec.tolerance->play /= 2;
    const RobustSearch search = searched(task, spec, nominal);
    evaluations += search.evaluations();
    if (!search.best()) continue;
    const Tolerance& asked = *task.spec().tolerance;
    const SpecUnit unit = task.control.options().unit;
    return Relaxation{.key = asked.length > 0 ? "tolerance.length_mm" : "tolerance.play_mm",
                      .demanded = asked.length > 0 ? asked.length : asked.play,
                      .possible = asked.length > 0 ? spec.tolerance->length : spec.tolerance->play,
                      .sentence = fmt::format("{} = {} and {} = {} are in the way; {} and {} would do",
                                              name_in(unit, "length_mm"), six_digits(asked.length, unit),
                                              name_in(unit, "play_mm"), six_digits(asked.play, unit),
                                              six_digits(spec.tolerance->length, unit),
                                              six_digits(spec.tolerance->play, unit)),
                      .design = *search.best()};
  }
  return std::nullopt;
}

NoDesign no_robust_design(const SearchTask& task, const FoundDesign& nominal, const RobustSearch& search) {
  NoDesign none{.requirement = "tolerance.robust",
                .sentence = "there are designs, but no robust one was found: of the last one tried " +
                            robust_fault(search.last()->check, task.spec().limits.clearance),
                .evaluations = search.evaluations()};
  if (!task.control.options().diagnose) return none;
  if (auto closer = closer_tolerances(task, nominal, none.evaluations))
    none.relaxations.push_back(*std::move(closer));
  none.relaxations.push_back({.key = "tolerance.robust",
                              .sentence = "robust = true is in the way; without it a design exists",
                              .design = nominal});
  none.diagnosed = !task.stopped();
  return none;
}

}  // namespace

SearchOutcome make_robust(const SearchTask& task, const FoundDesign& nominal) {
  const RobustSearch search = searched(task, task.spec(), nominal);
  const std::uint64_t evaluations = nominal.evaluations + search.evaluations();
  if (search.best()) {
    FoundDesign design = *search.best();
    design.proven_bound = nominal.proven_bound;
    design.nominal_value = nominal.value;
    design.evaluations = evaluations;
    design.seed = nominal.seed;
    design.complete = nominal.complete && !task.stopped();
    return design;
  }
  if (task.stopped()) return Stopped{evaluations, nominal.proven_bound};
  NoDesign none = no_robust_design(task, nominal, search);
  none.evaluations += nominal.evaluations;
  return none;
}

NoDesign told_without_robust(NoDesign none) {
  for (Relaxation& relaxation : none.relaxations) relaxation.sentence += ", though perhaps no robust one";
  return none;
}

}  // namespace kempe
