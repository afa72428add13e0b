// Robust designs against instruments that are built wrong within the tolerances: gaps from segments' distances. No formula of
// check_robust() is used.
#include "synthesis/tolerance/robust.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "synthesis/design/assemble.hpp"
#include "synthesis/search/search.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/shipped_spec.hpp"
#include "tests/synthesis/tolerance/wrong_instruments.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using namespace wrong_instruments;

double point_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
  return (p - a - share * along).norm();
}
double turn_of(const Point& a, const Point& b, const Point& c) {
  return cross(as_complex(b - a), as_complex(c - a));
}
bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return turn_of(a, b, c) * turn_of(a, b, d) < 0 && turn_of(c, d, a) * turn_of(c, d, b) < 0;
}
using Segment = std::pair<Point, Point>;
double segment_distance(const Segment& s, const Segment& t) {
  if (segments_cross(s.first, s.second, t.first, t.second)) return 0;
  return std::min(
      {point_to_segment(s.first, t.first, t.second), point_to_segment(s.second, t.first, t.second),
       point_to_segment(t.first, s.first, s.second), point_to_segment(t.second, s.first, s.second)});
}

/// The outline of a part's axis as segments, one list for each place that it may have.
std::vector<std::vector<Segment>> axes(const Part& part, const CopyingLinkage& linkage, PlateStyle plate,
                                       const MadePose& z) {
  const auto hole = [&](Link link, Joint joint) {
    const LinkJoints joints = joints_of(link);
    for (int i = 0; i < joints.count; ++i)
      if (joints.joints[static_cast<std::size_t>(i)] == joint)
        return z.holes[static_cast<std::size_t>(link)][static_cast<std::size_t>(i)];
    return Point(NAN, NAN);
  };
  if (part.kind == Part::Kind::pole_post) return {{{z.pole, z.pole}}};
  if (part.kind == Part::Kind::tracer_post) return {{{z.tracer, z.tracer}}};
  if (part.kind != Part::Kind::link) {
    std::vector<std::vector<Segment>> all;
    for (const Link link : all_links) {
      if (!has_joint(link, part.joint)) continue;
      if (part.is_post() && part.joint == Joint::V && link != Link::VA) continue;
      all.push_back({{hole(link, part.joint), hole(link, part.joint)}});
    }
    return all;
  }
  std::vector<Segment> outline;
  for (const JointHull& piece : axis_of(part, linkage.shape(), plate))
    for (int i = 0; i < piece.count; ++i)
      outline.push_back({hole(part.link, piece.joints[static_cast<std::size_t>(i)]),
                         hole(part.link, piece.joints[static_cast<std::size_t>((i + 1) % piece.count)])});
  return {outline};
}

double distance_of(const std::vector<Segment>& one, const std::vector<Segment>& other) {
  double least = INFINITY;
  for (const Segment& s : one)
    for (const Segment& t : other) least = std::min(least, segment_distance(s, t));
  return least;
}

double own_gap(const MapTask& task, const MadePose& pose) {
  double least = INFINITY;
  for (const ContactPair& pair : contact_pairs(task.linkage, task.layers))
    for (const auto& one : axes(pair.first, task.linkage, task.style.plate, pose))
      for (const auto& other : axes(pair.second, task.linkage, task.style.plate, pose))
        least = std::min(least, distance_of(one, other) - half_width(pair.first, task.style) -
                                    half_width(pair.second, task.style));
  return least;
}

double obstacle_gap(const MapTask& task, const MadePose& pose) {
  double least = INFINITY;
  for (const Obstacle& obstacle : task.obstacles) {
    std::vector<Segment> outline;
    for (std::size_t i = 0; i < obstacle.shape.outer.size(); ++i)
      outline.push_back(
          {obstacle.shape.outer[i], obstacle.shape.outer[(i + 1) % obstacle.shape.outer.size()]});
    for (const Part& part : parts_of(task.linkage, task.layers))
      if (part.lowest_layer <= obstacle.highest_layer && obstacle.lowest_layer <= part.highest_layer)
        for (const auto& one : axes(part, task.linkage, task.style.plate, pose))
          least = std::min(least, distance_of(one, outline) - half_width(part, task.style));
  }
  return least;
}

std::array<int, 4> turns(const MadePose& z) {
  const auto& [VA, VB, ACX, BCY] = z.holes;
  const auto sign = [](double value) { return value < 0 ? -1 : 1; };
  // Play between two holes: a dyad's triangle is that of its own link's holes.
  return {sign(turn_of(VA[0], VA[1], ACX[2] - (ACX[0] - VA[1]))),
          sign(turn_of(VB[0], VB[1], BCY[1] - (BCY[0] - VB[1]))), sign(turn_of(ACX[0], ACX[1], ACX[2])),
          sign(turn_of(BCY[0], BCY[1], BCY[2]))};
}

/// Any ratio and grounding, one in four with straight plates, a few near a dead or change point.
MapTask random_task(Chance& dice, bool near_the_end) {
  for (;;) {
    const double rotation = dice.one_in(4) ? (dice.one_in(2) ? pi : 0) : dice.uniform(-pi, pi);
    const Complex k = copy_ratio(std::exp(dice.uniform(-1.2, 1.2)), rotation);
    if (std::abs(k - 1.0) < 0.25) continue;
    const Grounding grounding = all_groundings[dice.below(3)];
    const auto modes = assembly_modes(shape_of(k, grounding));
    const std::size_t mode = dice.below(modes.size());
    const double away = radians(near_the_end ? dice.uniform(0.5, 8) : 20);
    if (modes[mode].openings.width() < 2 * away + radians(20)) continue;
    const auto linkage =
        CopyingLinkage::make(k, grounding, dice.uniform(60, 200), dice.uniform(60, 200),
                             static_cast<int>(mode), {dice.uniform(-50, 50), dice.uniform(-50, 50)});
    const double opening =
        near_the_end ? modes[mode].openings.lower + away
                     : dice.uniform(modes[mode].openings.lower + away, modes[mode].openings.upper - away);
    const Point tracer = linkage->tracer_at(opening, dice.uniform(-pi, pi));
    MapTask task{.linkage = *linkage, .style = {}, .layers = {}};
    task.style.width = dice.uniform(0.5, 8);
    task.style.pin_diameter = task.style.width * dice.uniform(0.3, 0.8);
    task.style.plate = dice.one_in(2) ? PlateStyle::bent : PlateStyle::triangle;
    const auto layers = layer_assignments(2 + static_cast<int>(dice.below(3)));
    task.layers = layers[dice.below(layers.size())];
    const double half = near_the_end ? dice.uniform(0.01, 0.5) : dice.uniform(0.5, 10);
    task.region = square_about(tracer, half);
    bool reached = true;
    for (const Point& corner : task.region.polygons[0].outer)
      reached &= linkage->pose_with_tracer_at(corner).has_value();
    if (reached) return task;
  }
}

Flaws random_flaws(Chance& dice, const Tolerance& tolerance) {
  Flaws flaws;
  const bool at_limits = dice.one_in(2);
  for (double& each : flaws.length) each = tolerance.length * (at_limits ? dice.sign() : dice.uniform(-1, 1));
  for (Point& each : flaws.pin)
    each = at_limits ? dice.on_circle(0.5 * tolerance.play) : dice.in_disc(0.5 * tolerance.play);
  return flaws;
}

Point place_in(Chance& dice, const Region& region) {
  const Ring& corners = region.polygons[0].outer;
  if (dice.one_in(3)) return corners[dice.below(4)];
  return {dice.uniform(corners[0].x(), corners[2].x()), dice.uniform(corners[0].y(), corners[2].y())};
}

/// The instrument with the smallest gap that changing one flaw at a time comes to.
Flaws flaws_of_least_gap(Chance& dice, const Tolerance& tolerance,
                         const std::function<double(const Flaws&)>& gap) {
  Flaws worst = random_flaws(dice, tolerance);
  for (double& each : worst.length) each = std::copysign(tolerance.length, each);
  double least = gap(worst);
  const auto offer = [&](const Flaws& flaws) {
    if (const double here = gap(flaws); here < least) least = here, worst = flaws;
  };
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < 8; ++i) {
      Flaws flaws = worst;
      flaws.length[i] = -flaws.length[i];
      offer(flaws);
    }
    for (std::size_t i = 0; i < 5; ++i)
      for (int k = 0; k < 8; ++k) {
        Flaws flaws = worst;
        flaws.pin[i] = as_point(std::polar(0.5 * tolerance.play, pi / 4 * k));
        offer(flaws);
      }
  }
  return worst;
}

TEST(Robust, EveryInstrumentClosesOnItsAssemblyAndKeepsTheStatedClearance) {
  Chance dice(1);
  int proven = 0;
  int measured = 0;
  double most = 0, sum = 0;
  for (int n = 0; n < test::samples(150); ++n) {
    const MapTask task = random_task(dice, dice.one_in(4));
    const Tolerance tolerance{dice.one_in(8) ? 0 : dice.uniform(0.005, 0.2),
                              dice.one_in(8) ? 0.05 : dice.uniform(0, 0.2)};
    const RobustCheck check = check_robust(task, CopyTolerance::uniform(tolerance));
    if (!check.closes) continue;
    ++proven;
    const auto drawn = made_pose(task.linkage, {}, task.region.polygons[0].outer[0]);
    ASSERT_TRUE(drawn);
    const bool flat = is_flat(task.linkage.shape());
    double nominal = INFINITY, least = INFINITY;
    const auto look = [&](const Flaws& flaws, const Point& tracer) {
      const auto pose = made_pose(task.linkage, flaws, tracer);
      EXPECT_TRUE(pose) << n;
      if (!pose) return double(INFINITY);
      const double gap = own_gap(task, *pose);
      EXPECT_GE(gap, check.clearance - 1e-9) << n << " " << check.parts;
      if (task.linkage.grounding() != Grounding::pen) {
        EXPECT_EQ(turns(*pose)[0], turns(*drawn)[0]) << n;
        EXPECT_EQ(turns(*pose)[1], turns(*drawn)[1]) << n;
      }
      if (!flat) {
        EXPECT_EQ(turns(*pose)[2], turns(*drawn)[2]) << n;
        EXPECT_EQ(turns(*pose)[3], turns(*drawn)[3]) << n;
      }
      least = std::min(least, gap);
      return gap;
    };
    Point tightest = task.region.polygons[0].outer[0];
    for (int m = 0; m < 12; ++m) {
      const Point tracer =
          m < 4 ? task.region.polygons[0].outer[static_cast<std::size_t>(m)] : place_in(dice, task.region);
      if (const double gap = look({}, tracer); gap < nominal) nominal = gap, tightest = tracer;
    }
    for (int m = 0; m < 10; ++m) look(random_flaws(dice, tolerance), place_in(dice, task.region));
    flaws_of_least_gap(dice, tolerance, [&](const Flaws& flaws) { return look(flaws, tightest); });
    if (nominal < 0.5 || check.clearance < 0) continue;  // they touch as drawn: nothing is measured
    const double share = (nominal - least) / (nominal - check.clearance);
    most = std::max(most, share);
    sum += share;
    ++measured;
  }
  EXPECT_GT(proven, test::expected(100));
  if (!test::shortened()) {
    EXPECT_GT(most, 0.8);
    EXPECT_GT(sum / measured, 0.3);
  }
  RecordProperty("most_of_the_stated_loss_reached", std::to_string(most));
}

TEST(Robust, NoToleranceIsTheDrawnInstrument) {
  Chance dice(2);
  for (int n = 0; n < test::samples(60); ++n) {
    const MapTask task = random_task(dice, false);
    const RobustCheck check = check_robust(task, {});
    ASSERT_TRUE(check.closes) << n;
    double least = INFINITY;
    const DistanceRange range = distance_range(task.region, task.linkage.pole());
    for (int i = 0; i <= 200; ++i) {
      const double r = range.nearest + (range.farthest - range.nearest) * i / 200;
      least = std::min(least, own_gap(task, *made_pose(task.linkage, {}, task.linkage.pole() + Point(r, 0))));
    }
    EXPECT_LE(check.clearance, least + 1e-9) << n;
    if (least > 0) {
      EXPECT_GT(check.clearance, least - 0.05) << n;
    }
  }
}

TEST(Robust, ToleratesLessWhereMoreIsAllowed) {
  Chance dice(3);
  for (int n = 0; n < test::samples(40); ++n) {
    const MapTask task = random_task(dice, dice.one_in(3));
    double before = INFINITY;
    for (const double tolerance : {0.01, 0.05, 0.2, 1.0, 9.0}) {
      const RobustCheck check = check_robust(task, CopyTolerance::uniform({tolerance, tolerance}));
      const double now = check.closes ? check.clearance : -INFINITY;
      EXPECT_LE(now, before + check.sharpness) << n << " " << tolerance;
      before = now;
    }
  }
}

TEST(Robust, InstrumentsKeepTheStatedClearanceToObstacles) {
  Chance dice(4);
  int looked_at = 0;
  for (int n = 0; n < test::samples(60); ++n) {
    MapTask task = random_task(dice, false);
    task.style.width = 1;
    const Point place = task.linkage.pole() + dice.in_disc(2 * reachable_annulus(task.linkage).outer);
    const double half = dice.uniform(1, 15);
    task.obstacles = {
        {square_about(place, half).polygons[0], 1, 1 + static_cast<int>(dice.below(3)), "block"}};
    const Tolerance tolerance{dice.uniform(0.005, 0.1), dice.uniform(0, 0.1)};
    const RobustCheck check = check_robust(task, CopyTolerance::uniform(tolerance));
    if (!check.closes || check.clearance < 0) continue;
    ++looked_at;
    for (int m = 0; m < 40; ++m) {
      const auto pose = made_pose(task.linkage, random_flaws(dice, tolerance), place_in(dice, task.region));
      ASSERT_TRUE(pose);
      EXPECT_GE(obstacle_gap(task, *pose), check.clearance - 1e-9) << n;
    }
  }
  EXPECT_GT(looked_at, test::expected(10));
}

TEST(Robust, IsTheSameWhereverTheLinkageStands) {
  Chance dice(5);
  for (int n = 0; n < test::samples(30); ++n) {
    const MapTask task = random_task(dice, false);
    const CopyTolerance tolerance = CopyTolerance::uniform({0.05, 0.02});
    const RobustCheck here = check_robust(task, tolerance);
    MapTask other = task;
    const Point by(dice.uniform(-300, 300), 70);
    other.linkage =
        CopyingLinkage::make(task.linkage.k(), task.linkage.grounding(), task.linkage.VA(), task.linkage.VB(),
                             task.linkage.assembly_mode().number, task.linkage.pole() + by)
            .value();
    for (Point& corner : other.region.polygons[0].outer) corner += by;
    const RobustCheck there = check_robust(other, tolerance);
    ASSERT_EQ(here.closes, there.closes);
    if (here.closes) {
      EXPECT_NEAR(here.clearance, there.clearance, here.sharpness + 1e-9);
    }
  }
}

SearchOptions quick(int threads = 1) {
  SearchOptions options;
  options.threads = threads;
  return options;
}

/// Wide strips, so that the clearance is what limits the optimum.
Spec plagiograph(const Tolerance& tolerance) {
  Spec spec = test::shipped_spec("robust-plagiograph");
  spec.tolerance = tolerance;
  return spec;
}

RobustCheck check_of(const Spec& spec, const FoundDesign& found) {
  return check_robust(map_task(found.linkage, found.layers, spec), CopyTolerance::uniform(*spec.tolerance));
}

TEST(RobustSearch, MakesTheOptimumRobustAndTellsWhatThatCosts) {
  const Spec nominal_spec = plagiograph({0.05, 0.02, false}), spec = plagiograph({0.05, 0.02, true});
  const SearchOutcome nominal_outcome = synthesize(nominal_spec, quick()),
                      outcome = synthesize(spec, quick());
  const auto* nominal = std::get_if<FoundDesign>(&nominal_outcome);
  const auto* robust = std::get_if<FoundDesign>(&outcome);
  ASSERT_TRUE(nominal && robust);
  EXPECT_FALSE(check_of(spec, *nominal).keeps(spec.limits.clearance));
  const RobustCheck check = check_of(spec, *robust);
  EXPECT_TRUE(check.keeps(spec.limits.clearance));
  EXPECT_LT(check.clearance, spec.limits.clearance * 1.1);
  EXPECT_GT(robust->value, nominal->value);
  EXPECT_EQ(robust->nominal_value, nominal->value);
  EXPECT_EQ(robust->proven_bound, nominal->proven_bound);
  EXPECT_FALSE(nominal->nominal_value);
  const auto design = certified_design(spec, *robust, {});
  ASSERT_TRUE(design) << design.error();
  ASSERT_TRUE(design->quality.robust);
  EXPECT_TRUE(design->quality.robust->holds);
  EXPECT_NEAR(design->quality.robust->clearance + design->quality.robust->clearance_loss,
              design->quality.clearance_min, 1e-9);
  EXPECT_FALSE(certified_design(spec, *nominal, {}));
}

TEST(RobustSearch, GivesTheSameDesignOnAnyNumberOfThreads) {
  const Spec spec = plagiograph({0.05, 0.02, true});
  const SearchOutcome one = synthesize(spec, quick(1)), three = synthesize(spec, quick(3));
  ASSERT_TRUE(std::holds_alternative<FoundDesign>(one) && std::holds_alternative<FoundDesign>(three));
  EXPECT_EQ(std::get<FoundDesign>(one).linkage, std::get<FoundDesign>(three).linkage);
}

TEST(RobustSearch, LeavesARobustOptimumAsItIs) {
  const Spec nominal_spec = plagiograph({1e-9, 0, false}), spec = plagiograph({1e-9, 0, true});
  const SearchOutcome nominal = synthesize(nominal_spec, quick()), robust = synthesize(spec, quick());
  ASSERT_TRUE(std::holds_alternative<FoundDesign>(nominal) && std::holds_alternative<FoundDesign>(robust));
  EXPECT_NEAR(std::get<FoundDesign>(nominal).value, std::get<FoundDesign>(robust).value, 1e-6);
}

TEST(RobustSearch, SaysThatNoneWasFoundWhereTolerancesAreHuge) {
  const SearchOutcome outcome = synthesize(plagiograph({9, 5, true}), quick());
  const auto* none = std::get_if<NoDesign>(&outcome);
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->proven);
  EXPECT_EQ(none->requirement, "tolerance.robust");
  ASSERT_FALSE(none->relaxations.empty());
  EXPECT_EQ(none->relaxations.back().key, "tolerance.robust");
  for (const Relaxation& relaxation : none->relaxations) EXPECT_FALSE(relaxation.sentence.empty());
}

}  // namespace
}  // namespace kempe
