// A search that is told to stop at any moment ends soon, and what it says is true. Soon is counted in polls of the flag,
// not in seconds.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/certificate/proof_tree.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/problem/obstacle_gap.hpp"
#include "synthesis/search/pareto.hpp"
#include "synthesis/search/search.hpp"
#include "synthesis/search/steps/budgets.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/search/steps/obstacle_check.hpp"
#include "synthesis/verification/verification.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "tests/synthesis/shipped_spec.hpp"
#include "workspace/footprint.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// Set at its n-th poll, and counts.
class CountingStop {
 public:
  explicit CountingStop(std::size_t at) : at_(at) {}
  StopFlag flag() {
    return [this] { return ++polls_ >= at_; };
  }
  std::size_t polls() const { return polls_; }
  bool was_set() const { return polls_ >= at_; }
  std::size_t after() const { return was_set() ? polls_ - at_ : 0; }

 private:
  std::size_t at_;
  std::atomic<std::size_t> polls_{0};
};

constexpr std::size_t never = ~std::size_t{0};

/// Specs whose searches are as different as can be: obstacles, four layers, footprint, stock lengths, no design.
std::vector<Spec> specimens() {
  Spec clamped = test::shipped_spec("clamped-plate");
  Spec layers = test::shipped_spec("nameplate");
  layers.links.layers = 4;
  Spec footprint = test::shipped_spec("plagiograph");
  footprint.objective.objective = Objective::footprint;
  Spec stock_lengths = test::shipped_spec("plagiograph");
  stock_lengths.links.stock_lengths.grid = 5;
  Spec impossible = test::shipped_spec("clamped-plate");
  impossible.links.longest = 0.7 * impossible.links.longest;
  impossible.limits.clearance = 4;
  return {clamped, layers, footprint, stock_lengths, impossible, test::shipped_spec("robust-plagiograph")};
}

SearchOutcome outcome_of(const Spec& spec, CountingStop& stop, double time_limit) {
  SearchOptions options;
  options.stop = stop.flag();
  options.time_limit = time_limit;
  return synthesize(spec, options);
}

constexpr double forever = std::numeric_limits<double>::infinity(), very_long = 1e9;

/// A poll or two a choice and phase that is left out: four layers past obstacles make some hundred choices (873 polls of 2.5
/// million were seen).
constexpr std::size_t most_polls_after = 2000;

bool keeps_all_limits(const Spec& spec, const FoundDesign& design) {
  const Requirements limits = requirements_of(spec);
  const DesignCheck check = check_design(spec, limits, design.linkage, design.layers);
  return check.feasible &&
         (spec.obstacles.empty() ||
          check_obstacles(spec, limits, design.linkage, design.layers, check.opening).clear);
}

/// No design can beat it: the whole search's design does not either.
bool holds(double bound, const FoundDesign& best) {
  const double slack = 1e-9 * std::abs(best.value);
  return is_maximized(best.goal) ? best.value <= bound + slack : best.value >= bound - slack;
}

void check_stopped_at(const Spec& spec, std::size_t at, double time_limit, const SearchOutcome& whole) {
  CountingStop stop(at);
  const SearchOutcome outcome = outcome_of(spec, stop, time_limit);
  const auto* best = std::get_if<FoundDesign>(&whole);
  ASSERT_TRUE(stop.was_set());
  EXPECT_LE(stop.after(), most_polls_after) << "of " << stop.polls();
  if (const auto* design = std::get_if<FoundDesign>(&outcome)) {
    EXPECT_FALSE(design->complete);
    ASSERT_TRUE(best);
    EXPECT_TRUE(keeps_all_limits(spec, *design));
    EXPECT_TRUE(!design->proven_bound || holds(*design->proven_bound, *best));
  } else if (const auto* none = std::get_if<NoDesign>(&outcome)) {
    EXPECT_FALSE(best);
    EXPECT_FALSE(none->diagnosed);
  } else if (const auto& bound = std::get<Stopped>(outcome).proven_bound; bound && best) {
    EXPECT_TRUE(holds(*bound, *best));
  }
}

TEST(Stopping, AtAnyPollTheSearchEndsSoonAndTellsTheTruth) {
  for (const Spec& spec : specimens())
    for (const double time_limit : {very_long, forever}) {
      CountingStop none(never);
      const SearchOutcome whole = outcome_of(spec, none, time_limit);
      ASSERT_GT(none.polls(), 500U);
      for (const double share : time_limit < forever ? std::vector{1e-9, 0.05, 0.4} : std::vector{0.2, 0.9}) {
        const auto at = 1 + static_cast<std::size_t>(share * static_cast<double>(none.polls()));
        check_stopped_at(spec, at, time_limit, whole);
      }
    }
}

TEST(Stopping, ATimeLimitThatIsNotReachedChangesNothing) {
  for (const Spec& spec : specimens()) {
    CountingStop one(never), other(never);
    const SearchOutcome without = outcome_of(spec, one, forever), with = outcome_of(spec, other, very_long);
    ASSERT_EQ(without.index(), with.index());
    const auto *a = std::get_if<FoundDesign>(&without), *b = std::get_if<FoundDesign>(&with);
    if (!a) continue;
    EXPECT_EQ(a->linkage, b->linkage);
    EXPECT_EQ(a->layers, b->layers);
    EXPECT_EQ(a->value, b->value);
    EXPECT_EQ(a->proven_bound, b->proven_bound);
    EXPECT_EQ(a->evaluations, b->evaluations);
    EXPECT_TRUE(b->complete);
  }
}

/// Where the limit is just the time of the whole search, as counted in polls.
TEST(Stopping, UnderATimeLimitADesignIsFoundWithinItsShare) {
  const double share = SearchBudgets{}.time.first_design;
  for (const std::string name : {"clamped-plate", "plagiograph"}) {
    const Spec spec = test::shipped_spec(name);
    CountingStop none(never);
    outcome_of(spec, none, very_long);
    CountingStop early(static_cast<std::size_t>(share * static_cast<double>(none.polls())));
    const SearchOutcome outcome = outcome_of(spec, early, very_long);
    EXPECT_TRUE(std::holds_alternative<FoundDesign>(outcome)) << name;
  }
}

/// Stock lengths that keep no ratio: the smallest design that was found first is handed out, measured by its footprint.
TEST(Stopping, AmongFootprintsWithAnotherRatioTheQuickDesignIsKept) {
  Spec spec = test::shipped_spec("plagiograph");
  spec.copy = Copy::of(Complex{0, std::sqrt(1.9)});
  spec.objective.objective = Objective::footprint;
  spec.links.stock_lengths.grid = 5;
  CountingStop none(never);
  const SearchOutcome whole = outcome_of(spec, none, forever);
  const auto* best = std::get_if<FoundDesign>(&whole);
  ASSERT_TRUE(best);
  CountingStop late(none.polls() - none.polls() / 50);
  const SearchOutcome outcome = outcome_of(spec, late, forever);
  const auto* design = std::get_if<FoundDesign>(&outcome);
  ASSERT_TRUE(design);
  EXPECT_FALSE(design->complete);
  EXPECT_EQ(design->goal, Goal::footprint);
  EXPECT_EQ(design->value, footprint(design->linkage, spec.links.style, spec.region).area);
  EXPECT_GE(design->value, best->value * (1 - 1e-9));
}

TEST(Stopping, ABoundStoppedEarlyIsABound) {
  test::SpecDice dice(31);
  int stopped = 0;
  for (int n = 0; n < test::samples(40); ++n) {
    Spec spec = dice.spec();
    if (n % 2 == 0) spec.obstacles.push_back(dice.obstacle_beside(spec));
    CountingStop none(never);
    const auto whole = proven_bound(spec, Objective::size, {.boxes = 4000, .stop = none.flag()});
    ASSERT_TRUE(whole);
    EXPECT_GE(4 * none.polls(), whole->boxes);
    if (whole->no_design || !whole->relaxation) continue;
    for (const double share : {0.0, 0.1, 0.5, 0.9}) {
      CountingStop stop(1 + static_cast<std::size_t>(share * static_cast<double>(none.polls())));
      const auto early = proven_bound(spec, Objective::size, {.boxes = 4000, .stop = stop.flag()});
      EXPECT_LE(stop.after(), 300U);
      if (!early) continue;
      ++stopped;
      EXPECT_FALSE(early->no_design);
      EXPECT_LE(early->value, *whole->relaxation * (1 + 1e-12));
    }
  }
  EXPECT_GT(stopped, test::expected(20));
}

TEST(Stopping, AMapStoppedEarlyCallsNothingFreeThatIsNot) {
  const Spec spec = test::shipped_spec("clamped-plate");
  SearchOptions options;
  options.diagnose = false;
  const auto found = std::get<FoundDesign>(synthesize(spec, options));
  CountingStop none(never);
  const Design whole = assemble_design(spec, found, {.stop = none.flag()});
  EXPECT_TRUE(whole.map.complete);
  for (const double share : {0.0, 0.2, 0.6}) {
    CountingStop stop(1 + static_cast<std::size_t>(share * static_cast<double>(none.polls())));
    const Design early = assemble_design(spec, found, {.stop = stop.flag()});
    EXPECT_FALSE(early.map.complete);
    EXPECT_TRUE(early.map.coverage.covered);  // as the search certified it
    if (std::isfinite(early.map.clearance_min)) {
      EXPECT_EQ(early.map.clearance_min, whole.map.clearance_min);
    } else {
      EXPECT_TRUE(early.map.clearance_min_parts.empty());
    }
    EXPECT_LE(stop.after(), 10000U);  // a poll a cell that stays as it is
    EXPECT_LE(area(early.map.collision_free), area(whole.map.collision_free) + area(whole.map.uncertain));
    EXPECT_GE(area(early.map.collision_free) + area(early.map.uncertain),
              area(whole.map.collision_free) * (1 - 1e-9));
  }
}

TEST(Stopping, WithoutTimeEveryPhaseAfterTheSearchEndsAtOnceAndSaysSo) {
  const Spec spec = test::shipped_spec("clamped-plate");
  CountingStop stop(1);
  const auto linkage = given_linkage(spec, "");
  ASSERT_TRUE(linkage);
  const Design design = assemble_given(spec, *linkage, {.stop = stop.flag()});
  EXPECT_FALSE(design.map.complete);
  EXPECT_FALSE(design.map.coverage.covered);
  EXPECT_TRUE(design.map.coverage.uncertain);
  EXPECT_NE(design.map.coverage.why_not.find("stopped early"), std::string::npos);
  EXPECT_TRUE(std::isinf(design.quality.footprint));
  EXPECT_TRUE(design.footprint.polygons.empty());
  EXPECT_LE(stop.polls(), 600U);
}

TEST(Stopping, WithoutTimeNoProofIsBegunAndNoOutlineIsTakenApart) {
  Spec spec = test::shipped_spec("clamped-plate");
  CountingStop proof(1), shapes(1);
  const auto log =
      certificate::prove(spec, Objective::size, std::nullopt, {.lines = 1000, .stop = proof.flag()});
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error(), certificate::NoLog::stopped);
  EXPECT_EQ(proof.polls(), 1U);
  EXPECT_TRUE(obstacle_shapes(obstructions_of(spec.obstacles, {}, {}), shapes.flag()).empty());
  EXPECT_EQ(shapes.polls(), 1U);
}

TEST(Stopping, WithoutTimeFewPlacesAreDrivenTo) {
  const Spec spec = test::shipped_spec("clamped-plate");
  SearchOptions options;
  options.diagnose = false;
  const auto found = std::get<FoundDesign>(synthesize(spec, options));
  CountingStop stop(1);
  const VerificationRun run =
      run_verification(verification_task(assemble_design(spec, found, {})), {.stop = stop.flag()});
  EXPECT_FALSE(run.complete);
  EXPECT_LE(run.found.samples, 20U);
}

TEST(Stopping, AFrontStoppedEarlyIsWhatThereWas) {
  const Spec spec = test::shipped_spec("plagiograph");
  CountingStop none(never);
  SearchOptions options;
  options.stop = none.flag();
  const auto whole = pareto_front(spec, Objective::size, Objective::transmission, 6, options);
  ASSERT_TRUE(whole);
  for (const double share : {0.0, 0.3, 0.8}) {
    CountingStop stop(1 + static_cast<std::size_t>(share * static_cast<double>(none.polls())));
    options.stop = stop.flag();
    const auto early = pareto_front(spec, Objective::size, Objective::transmission, 6, options);
    EXPECT_LE(stop.after(), 600U);
    if (!early) continue;
    for (const ParetoPoint& point : *early) EXPECT_TRUE(keeps_all_limits(spec, point.design));
  }
}

}  // namespace
}  // namespace kempe
