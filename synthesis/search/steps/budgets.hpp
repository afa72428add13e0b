#pragma once
// How much work the search may spend on what: all its numbers in one place.
//
// The design depends on them, so each is a count or a share and none a time: the same budgets give the same design on every
// machine. The exception are the shares of a time limit, which are asked for only where there is one. With these the designs
// of some thousand random specs lay within 0.1 % of their proven bound in 97 of 100 cases (docs/search.md).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "kempe/point.hpp"

namespace kempe {

/// Of the first proof, before the search.
struct ProofBudget {
  /// Boxes of the bound's tree: some tenths of a second at most. Less, and specs without a design are searched in vain.
  std::size_t boxes = 20000;
  /// The same with the limit on the load error, where nothing was found: at worst two seconds.
  std::size_t boxes_under_load = 200'000;
  /// The same before the search, for goals that the tree itself does not search for: some milliseconds.
  std::size_t boxes_at_first_under_load = 2'000;
  /// The same for known lengths, where only the pole is free: a handful are enough nearly always.
  std::size_t boxes_of_locked_lengths = 300;
};

/// Of the search by the bound's tree, among obstacles and under a limit on the load error (tree_search.hpp).
struct TreeBudget {
  std::size_t boxes = 60000;  ///< before the choices are searched one by one
  int trials = 40;            ///< of its designs in the local search
};

/// Of the pole alone, before the problem without contact is solved.
struct PoleBudget {
  int evaluations = 240;  ///< poles that a global search looks at
  int promising = 5;      ///< of them kept as starts, apart from each other
  /// Pairs of lengths tried at each pole, as shares of the ranges of lambda and log m (smooth_reach.hpp).
  std::array<double, 5> lambda_shares{0.0, 0.25, 0.5, 0.75, 1.0};
  std::array<double, 3> m_shares{0.0, 0.5, 1.0};
};

/// Of the search of one choice (choice_search.hpp): a lattice, a global search, and local solutions from the best of both.
struct ChoiceBudget {
  int poles = 12;           ///< looked at by lattice, where the pole is free
  int lattice = 10;         ///< squared: pairs of lengths looked at from each of these poles
  int evaluations = 200;    ///< points that the global search over lengths and poles looks at
  int starts = 6;           ///< local solutions
  int starts_if_none = 16;  ///< local solutions while none is feasible
  /// The same from starts that are known: all of them, if not stated.
  int known_starts_if_none = std::numeric_limits<int>::max();
};

/// What a limit on the load error changes. It makes each local solution longer, the best start is nearly always among the first, and many a
/// choice has no stiff design: few starts tell so.
struct LoadBudget {
  /// At most, without contact: the best design without the limit is known and is the first start.
  int lattice = 10;
  /// Local solutions while none is feasible, without contact: so many from starts that are known, and so many from others.
  int starts_if_none = 6;
  /// Local solutions no better than those before, after which a choice is left; without obstacles.
  int fruitless = 2;
  /// Choices searched one by one before the first group: a design found spares most of the others.
  std::size_t alone = 2;
};

/// The choices' budgets by what makes them hard.
struct ChoiceBudgets {
  /// Without contact. Two unknowns: a fine lattice is the better part of the search. Four: few lengths from each of the
  /// poles, which have been looked at already.
  ChoiceBudget relaxed_fixed_pole{.lattice = 20, .evaluations = 60};
  ChoiceBudget relaxed_free_pole{.lattice = 8, .evaluations = 60};
  /// With contact.
  ChoiceBudget fixed_pole{.lattice = 20};
  ChoiceBudget free_pole{.lattice = 8, .evaluations = 300};
  /// Obstacles divide the designs into islands: more starts.
  ChoiceBudget fixed_pole_obstacles{.lattice = 20, .starts = 10};
  ChoiceBudget free_pole_obstacles{.lattice = 8, .evaluations = 500, .starts = 10};
  /// The footprint takes a thousand times as long to evaluate as a size, and the search begins at a small design.
  ChoiceBudget footprint{.poles = 4, .lattice = 4, .evaluations = 80, .starts = 2, .starts_if_none = 2};
  /// With VA and VB locked to stock lengths only the pole is sought, for thousands of pairs.
  ChoiceBudget locked{.poles = 16, .evaluations = 100, .starts = 3, .starts_if_none = 8};
  ChoiceBudget locked_obstacles{.poles = 16, .evaluations = 60, .starts = 3, .starts_if_none = 8};
  ChoiceBudget locked_footprint{.poles = 4, .evaluations = 40, .starts = 1, .starts_if_none = 1};
  LoadBudget under_load{};

  ChoiceBudget without_contact(bool pole_is_free) const {
    return pole_is_free ? relaxed_free_pole : relaxed_fixed_pole;
  }
  ChoiceBudget without_contact_under_load(bool pole_is_free) const {
    ChoiceBudget budget = without_contact(pole_is_free);
    budget.lattice = std::min(budget.lattice, under_load.lattice);
    budget.starts_if_none = budget.known_starts_if_none = under_load.starts_if_none;
    return budget;
  }
  ChoiceBudget with_contact(bool pole_is_free, bool has_obstacles) const {
    if (has_obstacles) return pole_is_free ? free_pole_obstacles : fixed_pole_obstacles;
    return pole_is_free ? free_pole : fixed_pole;
  }
  /// Where another choice has a stiff design, fewer starts are enough.
  ChoiceBudget beside_a_stiff_design(bool pole_is_free, bool has_obstacles) const {
    ChoiceBudget budget = with_contact(pole_is_free, has_obstacles);
    budget.starts_if_none = budget.starts;
    return budget;
  }
  const ChoiceBudget& with_locked_lengths(bool of_footprint, bool has_obstacles) const {
    if (of_footprint) return locked_footprint;
    return has_obstacles ? locked_obstacles : locked;
  }
};

/// Of one local solution, and of how starts are told apart.
struct LocalBudget {
  int openings = 9;          ///< at which contact is looked at for a first impression
  int final_openings = 129;  ///< the same for a result, before it is certified in closed form
  int exchanges = 10;        ///< rounds of the exchange method
  int evaluations = 120;     ///< of the local solver in one round
  int halvings =
      16;  ///< of the way from a start that keeps a limit without a row to a solution that does not
  /// Starts differ at least by so much in the unit square of lengths, or by so much of the task's size in the pole's place:
  /// nearer ones lead to the same solution.
  double lengths_apart = 0.15, poles_apart = 0.6;
  /// Promising poles, and starts with locked lengths, differ by so much of the task's size: kinks of the region's distances
  /// lie close together.
  double locked_poles_apart = 0.06;
};

/// Of the way from a solution to a design that is certain.
struct CertifyBudget {
  /// Steps: places of the region in contact with an obstacle that are added, and limits that are demanded more strictly,
  /// before a choice is given up.
  int repairs = 12;
};

/// Of the search around a design that is farther from its bound than `near`.
struct ImproveBudget {
  double near = 0.004;  ///< share of the bound
  /// Boxes of the tree that keeps the limit on the load error, some tens of milliseconds at most: much less than the searches that a
  /// closed tree spares.
  std::size_t boxes_under_load = 10'000;
  int hops = 24;         ///< random places around the design (basin hopping)
  int hops_at_once = 8;  ///< solved in parallel from one centre; fixed, so that threads change nothing
  /// How far the first hops go: share of the lengths, and half that of the task's size
  double first_reach = 0.6;
  /// Factor of the reach from one pair of hops to the next, and from one round to the next
  double nearer = 0.6;
  int searches = 3;  ///< whole searches from other random numbers, there and where nothing was found
  /// Once so many are spent no other whole search begins: among obstacles in four layers one search takes as many, half a minute.
  std::uint64_t evaluations = 500'000;
};

/// Of stock lengths (stock_lengths.hpp).
struct StockBudget {
  std::size_t candidates = 4000;  ///< pairs of lengths in the order of size before the search gives up
  std::size_t near_one_shape = 400, near_all_shapes = 1000;  ///< pairs next to the best of any lengths
  /// Pairs that work, after which the best of them is taken: where small ones are good ones, and elsewhere.
  std::size_t enough_by_size = 4, enough = 8;
  /// Pairs searched in parallel: as many as are enough, within these
  std::size_t least_group = 4, largest_group = 16;
  int more_layers = 4;             ///< choices of layers tried after one that works
  int ratios = 48;                 ///< inexact ratios of each grounding
  int found_ratios = 24;           ///< designs with an inexact ratio before the best of them is taken
  int found_ratios_obstacles = 4;  ///< the same where obstacles make each of them slow
  /// Factor: an inexact ratio will do if its goal is no more worse than with any lengths
  double worse_for_ratio = 1.25;
  /// Factor of the size without contact where it was found for a ratio next to the one meant: it is no bound there.
  double neighbouring_size = 0.98;
};

/// Of why there is no design (diagnosis.hpp).
struct DiagnosisBudget {
  /// Evaluations of all questions of one round: once they are spent no other search begins.
  std::uint64_t evaluations = 1'700'000;
  /// What takes several times as long counts as so many: an evaluation beside obstacles, bodies or a table, one with a limit on the sag, and
  /// one with both as their sum. So a round takes a minute of one core at most, whatever the spec.
  std::uint64_t among_obstacles = 3, of_sag = 3;
  /// Share of them that the search for the least change of one limit may have: the other limits are to have their turn.
  double one_limit = 0.3;
  /// A search counts as at least so many: its proof takes about their time, and is often all that there is of it.
  std::uint64_t least_of_search = 20'000;
  int rounds = 8;  ///< of looking for a design nearer to what is demanded
  /// Of the way from what is demanded to what is attained: where such a design is looked for, the nearest first.
  std::array<double, 3> nearer{0.5, 0.9, 0.98};
  int halvings = 10;  ///< of what pins or links may have to give: to a thousandth
  /// Of the way from a part's own size to the thinnest: what is tried under a limit that asks for stiff parts, where the thinnest
  /// is of no avail.
  std::array<double, 4> thinner{0.05, 0.2, 0.4, 0.7};
  int halvings_of_sag = 3;  ///< of what a limit on the sag has to give: to an eighth
  /// Times the size that links are estimated to need under a limit that asks for stiff ones: the first with a design is taken.
  std::array<double, 4> stiffer{0.98, 1.12, 1.35, 1.8};
  double largest_section = 4;  ///< times the size given: no larger one is estimated
  double firmer = 8;           ///< times the grip given, or the play that is looked for: no more is estimated
  int pole_digits = 4;         ///< grids that a pole's place is rounded to, each ten times finer
  std::size_t single_obstacles = 12;  ///< looked at one by one; more of them only all together
};

/// Of designs that keep a limit in another figure than the search's (lowered_limit.hpp).
struct LoweredLimitBudget {
  int rounds = 8;      ///< searches with a lower limit
  double step = 0.7;   ///< share of the way, in the limit's logarithm, of one search to the next
  double near = 0.01;  ///< share of the limit: a design whose figure comes so near to it will do
};

/// Of robust designs (robust_search.hpp).
struct RobustBudget {
  int rounds = 10;      ///< searches with raised limits, of one transmission limit
  double waste = 0.04;  ///< share of what the clearance is raised by: so much more than needed will do
  /// Factor of the transmission limit, and the least and largest limit, rad: until every instrument closes.
  double more_transmission = 1.5, least_transmission = 3 * degree, most_transmission = 60 * degree;
  /// rad: a design nearer to a dead or change point is compared with one that is not. Errors grow with 1 / sin of it.
  double comfortable_transmission = 20 * degree;
  int halvings = 4;  ///< of the tolerances, where no design is robust within them
};

/// Shares of a time limit.
struct TimeShares {
  double proof = 0.2;         ///< when the first proof must end: then the search goes on without it
  double first_design = 0.6;  ///< when the search for a first design must
  /// Of what is left: the search with any lengths, where there are stock lengths
  double any_lengths = 0.4;
  /// Of what is left: the design that need not be robust, where a robust one is asked for
  double nominal = 0.4;
};

struct SearchBudgets {
  /// Group size: choices searched in parallel. Pruning uses the results of earlier groups only, so it is fixed and not the
  /// number of threads.
  std::size_t group = 4;
  ProofBudget proof{};
  TreeBudget tree{};
  PoleBudget pole{};
  ChoiceBudgets choice{};
  LocalBudget local{};
  CertifyBudget certify{};
  ImproveBudget improve{};
  StockBudget stock{};
  DiagnosisBudget diagnosis{};
  LoweredLimitBudget lowered{};
  RobustBudget robust{};
  TimeShares time{};
};

}  // namespace kempe
