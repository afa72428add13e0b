// Every row and every goal of the search's problem against differences of its own values, on random specs of every kind.
#include "synthesis/problem/design_problem.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "synthesis/problem/choices.hpp"
#include "synthesis/solvers/gradient_check.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

constexpr std::array goals{Goal::size,       Goal::transmission, Goal::copy_error, Goal::clearance,
                           Goal::shortest,   Goal::longest,      Goal::copy_gap,   Goal::pole_margin,
                           Goal::load_error, Goal::mass};

/// A spec with everything in it: obstacles, bodies, some of which turn with a link (in every grounding: rows do not ask whether that
/// has their point), a table, sheets, tolerance.
Spec full_spec(test::SpecDice& dice) {
  Spec spec = dice.spec();
  spec.tolerance = Tolerance{0.05, 0.02};
  spec.material = Material{"PLA", 3000, 1240, 26};
  spec.load = Load{dice.uniform(1, 50)};
  spec.limits.load_error = dice.uniform(0.01, 1);
  if (dice.uniform(0, 1) < 0.5) spec.links.style.plate = PlateStyle::triangle;
  spec.limits.copy_gap = dice.uniform(0, 10);
  for (int i = 0; i < 3; ++i) spec.obstacles.push_back(dice.obstacle_beside(spec));
  spec.bodies.push_back({Carrier::pen, Polygon{{{-8, -8}, {8, -8}, {8, 8}, {-8, 8}}, {}}, 1, 8, "router"});
  spec.bodies.push_back({Carrier::tracer, Polygon{{{-5, -4}, {6, -4}, {4, 7}}, {}}, 1, 8, "hand"});
  Body holder{Carrier::pen, Polygon{{{-6, -5}, {14, -5}, {9, 8}, {2, 3}}, {}}, 1, 8, "holder"};
  holder.turns_with = dice.uniform(0, 1) < 0.5 ? Link::BCY : Link::VA;
  Body grip{Carrier::tracer, Disc{{7, 4}, 5}, 1, 8, "grip"};
  grip.turns_with = dice.uniform(0, 1) < 0.5 ? Link::ACX : Link::VB;
  spec.bodies.push_back(holder);
  spec.bodies.push_back(grip);
  const Box around = bounding_box(spec.region);
  spec.table = Region::rectangle(around.lower - Point(90, 120), around.upper - around.lower + Point(200, 220))
                   .polygons.front();
  return spec;
}

struct Tally {
  int seen = 0, kinks = 0, rough = 0;  // rough: a second derivative whose own differences meet a kink
  double gradient = 0, hessian = 0;    // largest deviations, relative to 1 + |derivative|
};

/// False where the linkage is too short or too long for the row's place of the tracer: there the opening is clamped, and the
/// row is only a value.
bool is_reached(const DesignProblem& problem, const SearchSpace& space, const Row& row,
                const DesignVector& x) {
  if (row.kind != Row::Kind::obstacle) return true;
  const DesignPoint point = problem.point_of(x);
  const double distance = (space.tracer_places()[row.place] - point.pole).norm();
  const double opening = problem.reach().opening_at(point.lengths, distance);
  const LinkageJet radius = problem.reach().radius(point.lengths, opening);
  return std::abs(radius.value - distance) < 1e-9 * distance &&
         std::abs(radius.gradient[2]) > 1e-3 * distance;
}

RowJet row_at(const DesignProblem& problem, const Row* row, const DesignVector& x) {
  return row ? problem.row(*row, x) : problem.objective(x);
}

/// One row, or the goal, by central differences. Where the nearest features change within a step there is a kink: the
/// gradient changes by more than its own derivative says.
void compare(const DesignProblem& problem, const Row* row, const DesignVector& x, Tally& tally) {
  constexpr double step = 1e-6;
  const RowJet here = row_at(problem, row, x);
  ASSERT_TRUE(std::isfinite(here.value) && here.gradient.allFinite() && here.hessian.allFinite());
  ++tally.seen;
  double off_gradient = 0, off_hessian = 0;
  for (int i = 0; i < x.size(); ++i) {
    DesignVector ahead = x, behind = x;
    ahead[i] += step;
    behind[i] -= step;
    const RowJet after = row_at(problem, row, ahead), before = row_at(problem, row, behind);
    const double jump = (after.gradient - here.gradient).norm() + (here.gradient - before.gradient).norm();
    if (jump > 1e-7 * (1 + here.gradient.norm()) + 3 * step * here.hessian.norm()) {
      ++tally.kinks;
      return;
    }
    // Of two steps, one half the other, so that what bends the third time falls out (Richardson).
    DesignVector half_ahead = x, half_behind = x;
    half_ahead[i] += step / 2;
    half_behind[i] -= step / 2;
    const double coarse = (after.value - before.value) / (2 * step);
    const double fine =
        (row_at(problem, row, half_ahead).value - row_at(problem, row, half_behind).value) / step;
    const double slope = (4 * fine - coarse) / 3;
    off_gradient = std::max(off_gradient, std::abs(slope - here.gradient[i]) / (1 + std::abs(slope)));
    const DesignVector bend = (after.gradient - before.gradient) / (2 * step);
    off_hessian = std::max(off_hessian, (bend - here.hessian.col(i)).norm() / (1 + bend.norm()));
  }
  tally.gradient = std::max(tally.gradient, off_gradient);
  const bool by_differences = row && (row->kind == Row::Kind::obstacle ||
                                      row->kind == Row::Kind::copy_error || row->kind == Row::Kind::sag);
  if (by_differences)
    tally.rough += off_hessian > 1e-2;
  else
    tally.hessian = std::max(tally.hessian, off_hessian);
}

TEST(DesignProblem, EveryDerivativeIsThatOfItsValue) {
  test::SpecDice dice(71);
  std::map<Row::Kind, Tally> rows;
  Tally objectives;
  for (int i = 0; i < 640; ++i) {
    const Spec spec = full_spec(dice);
    const Goal goal = goals[static_cast<std::size_t>(i) % goals.size()];
    Requirements limits = requirements_of(spec);
    limits.size = 5000;
    limits.mass = 2;
    if (i % 64 == 0) limits.sag = 10 * *limits.load_error;  // few: its rows take much time
    const SearchSpace space(spec);
    const auto choices = choices_of(spec);
    ASSERT_FALSE(choices.empty());
    const ContactChoice& choice = choices[static_cast<std::size_t>(i) % choices.size()];
    const Reach reach(spec.copy.k(), choice.choice.grounding, choice.choice.assembly_mode);
    DesignProblem problem(space, choice.choice, limits, goal,
                          openings_with_transmission(reach, limits.transmission), choice.terms);
    if (!problem.possible()) continue;
    const std::array<double, 4> z{dice.uniform(0.1, 0.9), dice.uniform(0.1, 0.9), dice.uniform(0.1, 0.9),
                                  dice.uniform(0.1, 0.9)};
    const DesignPoint point =
        problem.unit_point(std::span(z).first(static_cast<std::size_t>(problem.cube_dimensions())));
    problem.set_room(point.pole);
    DesignVector x = problem.vector_of(point);
    // Away from the corners that unit_point() likes; the openings stay inside the assembly mode's interval.
    for (int j = 0; j < x.size(); ++j) x[j] += dice.uniform(-0.01, 0.01);
    for (const Row& row : problem.rows_at(x))
      if (is_reached(problem, space, row, x)) compare(problem, &row, x, rows[row.kind]);
    compare(problem, nullptr, x, objectives);
  }
  for (const auto& [kind, tally] : rows) {
    SCOPED_TRACE(static_cast<int>(kind));
    EXPECT_GT(tally.seen, 10);
    // A contact's rows stand at its worst opening, and a gap of two axes that cross has its kink right there.
    EXPECT_LT(tally.kinks, (kind == Row::Kind::contact ? 0.2 : 0.05) * tally.seen + 3);
    EXPECT_LT(tally.rough, 0.05 * tally.seen + 3);
    // Near a dead point an obstacle's row bends so much that the differences themselves are off by 1e-5.
    EXPECT_LT(tally.gradient, kind == Row::Kind::obstacle ? 2e-5 : 5e-6);
    EXPECT_LT(tally.hessian, 2e-4);
  }
  EXPECT_EQ(rows.size(), 16U) << "a kind of row was never met";
  EXPECT_LT(objectives.gradient, 1e-7);
  EXPECT_LT(objectives.hessian, 1e-6);
}

/// A random choice of a spec without load, at a random design.
struct Posed {
  Spec spec;
  Requirements limits;
  std::unique_ptr<SearchSpace> space;
  std::vector<ContactChoice> choices;
  std::size_t chosen = 0;
  OpeningInterval allowed{};

  explicit Posed(test::SpecDice& dice)
      : spec(dice.spec()), limits(requirements_of(spec)), space(std::make_unique<SearchSpace>(spec)),
        choices(choices_of(spec)) {
    chosen = static_cast<std::size_t>(dice.uniform(0, 0.999) * static_cast<double>(choices.size()));
    const Choice& choice = choices[chosen].choice;
    allowed = openings_with_transmission(Reach(spec.copy.k(), choice.grounding, choice.assembly_mode),
                                         limits.transmission);
  }
  DesignProblem problem(Goal goal) const {
    return {*space, choices[chosen].choice, limits, goal, allowed, choices[chosen].terms};
  }
  const std::vector<GapTerm>& gaps() const { return choices[chosen].terms.gaps; }
};

TEST(DesignProblem, EachContactThatIsNearAtSomeOpeningIsARow) {
  test::SpecDice dice(5113);
  int near = 0, missed = 0;
  for (int i = 0; i < test::samples(3000); ++i) {
    const Posed posed(dice);
    const DesignProblem problem = posed.problem(Goal::size);
    if (!problem.possible()) continue;
    const std::array<double, 4> z{dice.uniform(0, 1), dice.uniform(0, 1), dice.uniform(0, 1),
                                  dice.uniform(0, 1)};
    const DesignPoint point =
        problem.unit_point(std::span(z).first(static_cast<std::size_t>(problem.cube_dimensions())));
    const DesignVector x = problem.vector_of(point);
    const double from = x[DesignLayout::near_opening], to = x[DesignLayout::far_opening];
    const auto gap_at = [&](std::size_t term, double share) {
      return gap_value(posed.gaps()[term],
                       JointFrame(problem.reach().shape(), std::exp(x[DesignLayout::log_VA]),
                                  std::exp(x[DesignLayout::log_VB]), from + share * (to - from)));
    };
    const std::vector<Row> rows = problem.rows_at(x);
    for (std::size_t term = 0; term < posed.gaps().size(); ++term) {
      double least = infinity;
      for (int j = 0; j <= 1000; ++j) least = std::min(least, gap_at(term, j / 1000.0));
      if (least - posed.limits.clearance > 0.049 * posed.space->layout().unit) continue;
      ++near;
      missed += std::none_of(rows.begin(), rows.end(), [&](const Row& row) {
        return row.kind == Row::Kind::contact && row.index == term &&
               gap_at(term, row.share) < least + 1e-3 * posed.space->layout().unit;
      });
    }
  }
  EXPECT_GT(near, test::expected(1000));
  EXPECT_EQ(missed, 0) << "of " << near;
}

TEST(DesignProblem, LengthsLockedForOneProblemAreThoseOfASpecThatLocksThem) {
  test::SpecDice dice(5209);
  int compared = 0;
  for (int i = 0; i < test::samples(200); ++i) {
    Posed posed(dice);
    const DesignProblem free = posed.problem(Goal::size);
    if (!free.possible()) continue;
    const std::array<double, 4> z{dice.uniform(0, 1), dice.uniform(0, 1), dice.uniform(0, 1),
                                  dice.uniform(0, 1)};
    const DesignPoint at =
        free.unit_point(std::span(z).first(static_cast<std::size_t>(free.cube_dimensions())));
    StockLengths locked;
    locked.locked[0] = std::exp(at.lengths.u);
    locked.locked[1] = std::exp(at.lengths.v);
    const ContactChoice& choice = posed.choices[posed.chosen];
    const DesignProblem here(*posed.space, choice.choice, posed.limits, Goal::size, posed.allowed,
                             choice.terms, locked);
    Spec spec = posed.spec;
    spec.links.stock_lengths = locked;
    const SearchSpace other(spec);
    const DesignProblem there(other, choice.choice, posed.limits, Goal::size, posed.allowed, choice.terms);
    ASSERT_EQ(here.possible(), there.possible()) << i;
    if (!here.possible()) continue;
    ASSERT_TRUE(here.lengths_are_locked() && there.lengths_are_locked()) << i;
    const auto places = std::span(z).first(static_cast<std::size_t>(here.cube_dimensions()));
    const DesignPoint one = here.unit_point(places), same = there.unit_point(places);
    EXPECT_EQ(one.lengths.u, same.lengths.u);
    EXPECT_EQ(one.lengths.v, same.lengths.v);
    EXPECT_EQ(one.pole, same.pole);
    EXPECT_EQ(here.rows_at(here.vector_of(one)), there.rows_at(there.vector_of(same)));
    EXPECT_EQ(here.assess(one, 33).violation, there.assess(same, 33).violation);
    ++compared;
  }
  EXPECT_GT(compared, test::expected(100));
}

TEST(DesignProblem, TheProductsOwnCheckFindsAWrongDerivative) {
  SmoothProgram program;
  program.lower = DesignVector::Constant(2, -1);
  program.upper = DesignVector::Constant(2, 1);
  program.objective = [](const DesignVector& x, DesignVector* gradient) {
    if (gradient) *gradient = DesignVector::Zero(2), (*gradient)[0] = 2 * x[0], (*gradient)[1] = 1;
    return x[0] * x[0] + 3 * x[1];  // the second derivative given is 1 and not 3
  };
  program.hessian = [](const DesignVector&, double factor, const Eigen::VectorXd&) {
    DesignMatrix h = DesignMatrix::Zero(2, 2);
    h(0, 0) = 2 * factor;
    return h;
  };
  const DesignVector x = DesignVector::Constant(2, 0.3);
  const DerivativeDeviation deviation = check_derivatives(program, x, Eigen::VectorXd());
  EXPECT_NEAR(deviation.objective_gradient, 2.0 / (1 + 1), 1.1);
  EXPECT_GT(deviation.objective_gradient, 0.4);
  EXPECT_LT(deviation.hessian, 1e-6);
}

}  // namespace
}  // namespace kempe
