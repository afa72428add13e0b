// Drawn larger or smaller, a linkage stays the same linkage: one law for everything the general solver says.
#include <gtest/gtest.h>

#include "kinematics/overloaded.hpp"
#include "kinematics/planar/assemblies.hpp"
#include "kinematics/planar/instant_centres.hpp"
#include "kinematics/planar/mobility.hpp"
#include "kinematics/planar/rates.hpp"
#include "kinematics/planar/run.hpp"
#include "tests/kinematics/planar/random_linkages.hpp"
#include "tests/samples.hpp"

namespace kempe {
namespace {

using test::Random;

/// A linkage with its motion and a first guess.
struct Machine {
  std::string name;
  PlanarLinkage linkage;
  DriveSchedule schedule;
  PlanarPosition guess;
};

DriveSchedule ranges(std::vector<DriverRange> all) {
  DriveSchedule schedule;
  for (const DriverRange& range : all) schedule.motions.emplace_back(range);
  return schedule;
}

Machine turned_four_bar(Random& random) {
  const double a = random.logarithmic(0.3, 3), b = random.logarithmic(0.5, 4), c = random.logarithmic(0.5, 4),
               d = random.logarithmic(0.5, 4), from = random.uniform(-pi, pi);
  PlanarLinkage linkage = test::four_bar(d, a, b, c);
  return {"four-bar", std::move(linkage), ranges({{from, from + 2 * pi, {}}}),
          test::random_position(random, 4, 3)};
}

/// A crank whose pin slides in a turning slot that passes its own pivot at a distance.
Machine turning_slot(Random& random) {
  PlanarLinkage linkage;
  const int crank = linkage.add_body("crank"), slot = linkage.add_body("slot");
  const double ground = random.uniform(1, 5), arm = random.uniform(0.5, 3), offset = random.uniform(-1, 1);
  const double tilt = random.uniform(-pi, pi), from = random.uniform(-pi, pi);
  linkage.add(Revolute{{0, Point(0, 0)}, {crank, Point(0, 0)}}, "O");
  linkage.add(Revolute{{0, Point(ground, 0)}, {slot, Point(0, 0)}}, "D");
  linkage.add(
      Coordinate{{crank, Point(arm, 0)}, {slot, Point(0, offset)}, Point(std::cos(tilt), std::sin(tilt)), 0},
      "pin");
  linkage.drive(RelativeAngle{crank, 0, 0}, "crank");
  return {"slot", std::move(linkage), ranges({{from, from + 2 * pi, {}}}),
          test::random_position(random, 3, 3)};
}

/// A five-bar whose cranks mesh, with teeth of any number.
Machine geared_five_bar(Random& random) {
  PlanarLinkage linkage;
  const int first = linkage.add_body("first"), second = linkage.add_body("second"),
            left = linkage.add_body("left"), right = linkage.add_body("right");
  const double ground = random.uniform(2, 4), a = random.uniform(0.4, 0.9), b = random.uniform(0.4, 0.9);
  const double c = random.uniform(2.8, 4), d = random.uniform(2.8, 4);
  linkage.add(Revolute{{0, Point(0, 0)}, {first, Point(0, 0)}}, "O");
  linkage.add(Revolute{{0, Point(ground, 0)}, {second, Point(0, 0)}}, "D");
  linkage.add(Revolute{{first, Point(a, 0)}, {left, Point(0, 0)}}, "A");
  linkage.add(Revolute{{second, Point(b, 0)}, {right, Point(0, 0)}}, "B");
  linkage.add(Revolute{{left, Point(c, 0)}, {right, Point(d, 0)}}, "P");
  const double teeth = 10 + random.below(30), more = random.below(2) == 0 ? 20 : -30;
  linkage.add(GearPair{first, second, 0, teeth, more, teeth * random.uniform(-pi, pi)}, "gears");
  linkage.drive(RelativeAngle{first, 0, 0}, "first");
  return {"gears", std::move(linkage), ranges({{0.3, 0.3 + 4 * pi, {}}}),
          test::random_position(random, 5, 3)};
}

/// A rack that slides on the ground, its pinion turned.
Machine rack(Random& random) {
  PlanarLinkage linkage;
  const int pinion = linkage.add_body("pinion"), slide = linkage.add_body("slide"),
            rod = linkage.add_body("rod");
  const double radius = random.uniform(0.2, 1), length = random.uniform(4, 6);
  linkage.add(Revolute{{0, Point(0, -radius)}, {pinion, Point(0, 0)}}, "bearing");
  linkage.add(Coordinate{{slide, Point(0, 0)}, {0, Point(0, 0)}, Point(0, 1), 0}, "slide");
  linkage.add(RelativeAngle{slide, 0, 0}, "slide does not turn");
  linkage.add(RackAndPinion{{pinion, Point(0, 0)}, {slide, Point(0, 0)}, Point(1, 0), -radius, 0}, "rack");
  linkage.add(Revolute{{slide, Point(0, 0)}, {rod, Point(0, 0)}}, "X");
  linkage.add(Coordinate{{rod, Point(length, 0)}, {0, Point(0, 0)}, Point(1, 0), 0}, "upright");
  linkage.drive(RelativeAngle{pinion, 0, 0}, "pinion");
  return {"rack", std::move(linkage), ranges({{1, random.uniform(-12, 2), {}}}),
          test::random_position(random, 4, 3)};
}

/// A strut between crank and rocker drives by its length.
Machine strut(Random& random) {
  const double a = random.uniform(0.5, 3), b = random.uniform(2, 4), c = random.uniform(2, 4),
               d = random.uniform(2, 4), from = random.uniform(1, 4), to = random.uniform(1, 5);
  PlanarLinkage linkage = test::four_bar(d, a, b, c).undriven();
  linkage.drive(Distance{{0, Point(0, 0)}, {3, Point(c, 0)}, from}, "strut");
  return {"strut", std::move(linkage), ranges({{from, to, {}}}), test::random_position(random, 4, 3)};
}

Machine random_machine(Random& random, int kind) {
  switch (kind % 5) {
    case 0: return turned_four_bar(random);
    case 1: return turning_slot(random);
    case 2: return geared_five_bar(random);
    case 3: return rack(random);
    default: return strut(random);
  }
}

Constraint scaled(Constraint constraint, double by) {
  const auto point = [by](BodyPoint& p) { p.local *= by; };
  std::visit(Overloaded{[&](Revolute& c) { point(c.a), point(c.b); },
                        [&](Coordinate& c) { point(c.point), point(c.origin), c.value *= by; },
                        [&](Distance& c) { point(c.a), point(c.b), c.value *= by; }, [&](RelativeAngle&) {},
                        [&](GearPair&) {},
                        [&](RackAndPinion& c) {
                          point(c.centre), point(c.rack_origin);
                          c.radius *= by;
                          c.value *= by;
                        }},
             constraint);
  return constraint;
}

Machine scaled(const Machine& machine, double by) {
  Machine result{machine.name, {}, machine.schedule, machine.guess};
  const PlanarLinkage& linkage = machine.linkage;
  for (int body = 1; body < linkage.body_count(); ++body) result.linkage.add_body(linkage.body_name(body));
  for (int i = 0; i < static_cast<int>(linkage.constraints().size()); ++i) {
    const auto& [name, constraint] = linkage.constraints()[static_cast<std::size_t>(i)];
    if (linkage.is_driver(i))
      result.linkage.drive(scaled(constraint, by), name);
    else
      result.linkage.add(scaled(constraint, by), name);
  }
  for (std::size_t i = 0; i < linkage.drivers().size(); ++i) {
    const auto& driven = linkage.constraints()[static_cast<std::size_t>(linkage.drivers()[i])].constraint;
    if (std::holds_alternative<RelativeAngle>(driven)) continue;
    auto& range = std::get<DriverRange>(result.schedule.motions[i]);
    range.from *= by;
    range.to *= by;
  }
  for (BodyPlacement& body : result.guess) body.at *= by;
  return result;
}

/// Everything that the solver says of a machine.
struct Told {
  std::optional<PlanarRun> run;
  std::optional<Missing> missing;
  Mobility mobility;
  std::vector<InstantCentre> centres;
};

Told told_of(const Machine& machine) {
  Told told;
  const auto start = machine.schedule.values_at(0);
  const auto found = search_assembly_modes(machine.linkage, machine.guess, start, {12, 1, 1, {}});
  if (found.assembly_modes.empty()) {
    told.missing = missing_at(machine.linkage, found.nearest.value(), start);
    return told;
  }
  told.mobility = mobility_of(machine.linkage, found.assembly_modes.front());
  if (auto run = run_motion(machine.linkage, found.assembly_modes.front(), machine.schedule, 12)) {
    const RunFrame& frame = run->frames.front();
    told.centres = instant_centres(machine.linkage, frame.position, frame.rate);
    told.run = std::move(*run);
  }
  return told;
}

/// |a / scale - b| of two vectors of unknowns: places over the scale, angles as they are.
double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double scale) {
  double largest = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] / (i % 3 == 2 ? 1 : scale) - b[i]));
  return largest;
}

/// What numbers are zero for Eigen's reflections: squares below the least normal number.
constexpr double nothing = 1e-150;

/// Compares all that is told, to `tolerance` of the linkage's size; 0 asks for the same bits.
void expect_same(const Told& large, const Told& small, double scale, double tolerance) {
  ASSERT_EQ(large.missing.has_value(), small.missing.has_value());
  if (small.missing) {
    EXPECT_EQ(large.missing->constraint, small.missing->constraint);
    EXPECT_EQ(large.missing->gap.is_angle, small.missing->gap.is_angle);
    const double gap = large.missing->gap.amount / (large.missing->gap.is_angle ? 1 : scale);
    EXPECT_NEAR(gap, small.missing->gap.amount, 1e3 * tolerance);
  }
  EXPECT_EQ(large.mobility.mobility, small.mobility.mobility);
  EXPECT_EQ(large.mobility.rank, small.mobility.rank);
  EXPECT_EQ(large.mobility.rank_here, small.mobility.rank_here);
  EXPECT_EQ(large.mobility.redundant, small.mobility.redundant);
  ASSERT_EQ(large.centres.size(), small.centres.size());
  for (std::size_t i = 0; i < small.centres.size(); ++i) {
    EXPECT_EQ(large.centres[i].kind, small.centres[i].kind);
    EXPECT_EQ(large.centres[i].source, small.centres[i].source);
    const double away = 1 + small.centres[i].at.norm();
    EXPECT_LE((large.centres[i].at / scale - small.centres[i].at).norm(),
              1e3 * tolerance * away * away + nothing);
  }
  ASSERT_EQ(large.run.has_value(), small.run.has_value());
  if (!small.run) return;
  ASSERT_EQ(large.run->frames.size(), small.run->frames.size());
  ASSERT_EQ(large.run->stop.has_value(), small.run->stop.has_value());
  if (small.run->stop) {
    EXPECT_EQ(large.run->stop->end, small.run->stop->end);
    EXPECT_EQ(large.run->stop->sentences, small.run->stop->sentences);
    EXPECT_NEAR(large.run->stop->share, small.run->stop->share, 1e3 * tolerance);
  }
  for (std::size_t i = 0; i < small.run->frames.size(); ++i) {
    const RunFrame &a = large.run->frames[i], &b = small.run->frames[i];
    if (b.rate.size() == 0) continue;  // at a stop angles go with the root of the driver
    ASSERT_EQ(a.rate.size(), b.rate.size());
    const double fast = 1 + b.rate.norm();
    EXPECT_LE(difference(unknowns_of(a.position), unknowns_of(b.position), scale),
              tolerance * fast + nothing);
    EXPECT_LE(difference(a.rate, b.rate, scale), 10 * tolerance * fast * fast * fast + nothing);
    EXPECT_LE(difference(a.second, b.second, scale), 100 * tolerance * std::pow(fast, 5) + nothing);
  }
}

TEST(Scale, APowerOfTwoChangesNoBit) {
  Random random(101);
  int moved = 0;
  for (int i = 0; i < test::samples(150); ++i) {
    const Machine machine = random_machine(random, i);
    SCOPED_TRACE(machine.name + " " + std::to_string(i));
    const Told small = told_of(machine);
    moved += small.run ? 1 : 0;
    for (const double scale : {0x1p-20, 0x1p20, 0x1p-3})
      expect_same(told_of(scaled(machine, scale)), small, scale, 0);
    if (HasFailure()) return;
  }
  EXPECT_GT(moved, test::expected(80));
}

TEST(Scale, AnySizeFromAMillionthToAMillionGivesTheSameAnswer) {
  Random random(102);
  for (int i = 0; i < test::samples(150); ++i) {
    const Machine machine = random_machine(random, i);
    SCOPED_TRACE(machine.name + " " + std::to_string(i));
    const Told small = told_of(machine);
    for (const double scale : {1e-6, 25.4, 1e3, 1e6})
      expect_same(told_of(scaled(machine, scale)), small, scale, 1e-10);
    if (HasFailure()) return;
  }
}

TEST(Scale, OfGearsOnlyTheRatioOfTheTeethCounts) {
  Random random(103);
  for (int i = 0; i < test::samples(60); ++i) {
    const Machine machine = geared_five_bar(random);
    const Told small = told_of(machine);
    for (const double more : {0.5, 1e3, 1e6, 1e-6}) {
      Machine other{machine.name, {}, machine.schedule, machine.guess};
      for (int body = 1; body < machine.linkage.body_count(); ++body)
        other.linkage.add_body(machine.linkage.body_name(body));
      for (const auto& [name, constraint] : machine.linkage.constraints()) {
        if (const auto* gears = std::get_if<GearPair>(&constraint)) {
          GearPair finer = *gears;
          finer.first_radius *= more, finer.second_radius *= more, finer.value *= more;
          other.linkage.add(finer, name);
        } else if (std::holds_alternative<RelativeAngle>(constraint)) {
          other.linkage.drive(constraint, name);
        } else {
          other.linkage.add(constraint, name);
        }
      }
      expect_same(told_of(other), small, 1, 1e-10);
    }
    if (HasFailure()) return;
  }
}

TEST(Scale, AWheelTurnsAsItsTeethSayOverManyTurns) {
  // Against the closed form: second = (value - a first) / b, P where the circles about the crank pins meet.
  Random random(104);
  for (int i = 0; i < test::samples(40); ++i) {
    Machine machine = geared_five_bar(random);
    machine.schedule = ranges({{0.3, 0.3 + 200 * pi, {}}});
    const auto& gears = std::get<GearPair>(machine.linkage.constraints()[5].constraint);
    const auto found = find_assembly_modes(machine.linkage, machine.guess, {0.3}, {40, 1, 1, {}});
    if (found.empty()) continue;
    const auto run = run_motion(machine.linkage, found[0], machine.schedule, 7);
    ASSERT_TRUE(run);
    if (run->stop) continue;
    const RunFrame& last = run->frames.back();
    const double second = (gears.value - gears.first_radius * (0.3 + 200 * pi)) / gears.second_radius;
    EXPECT_NEAR(last.position[2].angle, second, 1e-9);
    const auto point = [&](std::size_t joint) {
      return place(last.position, std::get<Revolute>(machine.linkage.constraints()[joint].constraint).a);
    };
    const auto& first_rod = std::get<Revolute>(machine.linkage.constraints()[4].constraint);
    const Point left = test::meet(point(2), first_rod.a.local.x(), point(3), first_rod.b.local.x(), 1);
    const Point right = test::meet(point(2), first_rod.a.local.x(), point(3), first_rod.b.local.x(), -1);
    EXPECT_LT(std::min((point(4) - left).norm(), (point(4) - right).norm()), 1e-9);
  }
}

TEST(Scale, AStrutGrowsAHundredThousandfold) {
  // Two legs as long as the strut at its longest; its length from 1e-3 to 100.
  PlanarLinkage linkage;
  const int a = linkage.add_body("a"), b = linkage.add_body("b");
  linkage.add(Revolute{{0, Point(0, 0)}, {a, Point(0, 0)}}, "O");
  linkage.add(Revolute{{a, Point(60, 0)}, {b, Point(0, 0)}}, "A");
  linkage.add(RelativeAngle{a, 0, 0}, "a stands");
  linkage.drive(Distance{{0, Point(0, 0)}, {b, Point(60, 0)}, 1e-3}, "strut");
  const DriveSchedule schedule = ranges({{1e-3, 100, {}}});
  const double opening = 2 * std::asin(1e-3 / 120);
  const auto run = run_motion(linkage, {{}, {Point(0, 0), 0}, {Point(60, 0), pi - opening}}, schedule, 10);
  ASSERT_TRUE(run);
  EXPECT_FALSE(run->stop);
  for (const RunFrame& frame : run->frames)
    EXPECT_NEAR(std::abs(std::remainder(frame.position[2].angle - pi, 2 * pi)),
                2 * std::asin(frame.values[0] / 120), 1e-9);
}

}  // namespace
}  // namespace kempe
