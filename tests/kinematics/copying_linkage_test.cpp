// Laws, specimens and published figures of the closed form. Oracles here construct points by circle intersection and
// by finite differences: they share no formula with the library.
#include "kinematics/copying_linkage.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string_view>

#include "tests/random.hpp"

namespace kempe {
namespace {

CopyingLinkage linkage(Complex k, Grounding grounding, double VA, double VB, int assembly_mode,
                       Point pole = Point::Zero()) {
  return CopyingLinkage::make(k, grounding, VA, VB, assembly_mode, pole).value();
}

int assembly_mode_containing(Complex k, Grounding grounding, double opening) {
  for (const AssemblyMode& mode : assembly_modes(shape_of(k, grounding)))
    if (mode.openings.contains(opening)) return mode.number;
  ADD_FAILURE() << "no assembly holds the opening " << opening;
  return 0;
}

struct RandomCase {
  CopyingLinkage linkage;
  double opening, bearing;
};

class RandomCases {
 public:
  explicit RandomCases(unsigned seed) : random_(seed) {}

  double uniform(double lower, double upper) { return test::uniform(random_, lower, upper); }

  RandomCase next() {
    for (;;) {
      const Complex k = std::polar(std::exp(uniform(-2.3, 2.3)), uniform(-pi, pi));
      const auto grounding = all_groundings[static_cast<std::size_t>(random_() % 3)];
      const auto count = assembly_modes(shape_of(k, grounding)).size();
      auto made =
          CopyingLinkage::make(k, grounding, std::exp(uniform(1, 6)), std::exp(uniform(1, 6)),
                               static_cast<int>(random_() % count), Point(uniform(-9, 9), uniform(-9, 9)));
      if (!made) continue;
      const OpeningInterval d = made->assembly_mode().openings;
      return {*made, d.lower + d.width() * uniform(0.02, 0.98), uniform(-pi, pi)};
    }
  }

 private:
  std::mt19937_64 random_;
};

double size_of(const CopyingLinkage& linkage) { return linkage.size(); }

TEST(CopyRatio, IsExactAtQuarterTurnsAndTakesAnyNumber) {
  for (int quarters = -9; quarters <= 9; ++quarters) {
    constexpr std::array<Complex, 4> unit{Complex{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    EXPECT_EQ(copy_ratio(1.5, quarters * (pi / 2)), 1.5 * unit[static_cast<std::size_t>(quarters & 3)]);
  }
  EXPECT_NEAR(std::abs(copy_ratio(2, 5.8e114)), 2, 1e-12);
  EXPECT_FALSE(std::isfinite(copy_ratio(2, std::numeric_limits<double>::quiet_NaN()).real()));
  EXPECT_FALSE(std::isfinite(copy_ratio(2, std::numeric_limits<double>::infinity()).real()));
}

TEST(CopyingLinkage, PenTracesTheSimilarImage) {
  RandomCases cases(1);
  for (int i = 0; i < 2000; ++i) {
    const auto [mechanism, opening, bearing] = cases.next();
    const Pose pose = mechanism.pose_at(opening, bearing);
    const Complex tracer = as_complex(pose[mechanism.tracer_joint()] - mechanism.pole());
    const Complex pen = as_complex(pose[mechanism.pen_joint()] - mechanism.pole());
    EXPECT_LT(std::abs(pen - mechanism.k() * tracer), 1e-12 * size_of(mechanism));
    EXPECT_LT((pose[mechanism.pole_joint()] - mechanism.pole()).norm(), 1e-12 * size_of(mechanism));
  }
}

TEST(CopyingLinkage, KeepsEveryLengthInEveryPose) {
  RandomCases cases(2);
  for (int i = 0; i < 2000; ++i) {
    const auto [mechanism, opening, bearing] = cases.next();
    const Pose z = mechanism.pose_at(opening, bearing);
    const LinkLengths l = mechanism.lengths();
    const std::array<double, 8> seen{(z.A - z.V).norm(), (z.B - z.V).norm(), (z.C - z.A).norm(),
                                     (z.C - z.B).norm(), (z.X - z.A).norm(), (z.X - z.C).norm(),
                                     (z.Y - z.B).norm(), (z.Y - z.C).norm()};
    for (std::size_t j = 0; j < 8; ++j) EXPECT_NEAR(seen[j], l.values()[j], 1e-12 * size_of(mechanism));
  }
}

TEST(CopyingLinkage, TracerToPoseInvertsOpeningToTracer) {
  RandomCases cases(3);
  for (int i = 0; i < 2000; ++i) {
    const auto [mechanism, opening, bearing] = cases.next();
    const Pose there = mechanism.pose_at(opening, bearing);
    const auto back = mechanism.pose_with_tracer_at(mechanism.tracer_at(opening, bearing));
    ASSERT_TRUE(back);
    for (const Joint joint : all_joints)
      EXPECT_LT((there[joint] - (*back)[joint]).norm(), 1e-9 * size_of(mechanism)) << letter(joint);
  }
}

TEST(CopyingLinkage, NeverMixesAssemblies) {
  RandomCases cases(4);
  for (int i = 0; i < 2000; ++i) {
    const auto [mechanism, opening, bearing] = cases.next();
    const auto pose = mechanism.pose_with_tracer_at(mechanism.tracer_at(opening, bearing));
    ASSERT_TRUE(pose);
    const LoopSides wanted = mechanism.assembly_mode().sides;
    EXPECT_EQ(side_of(cross(pose->A - pose->V, pose->B - pose->V)), wanted.parallelogram);
    EXPECT_EQ(side_of(cross(pose->C - pose->A, pose->X - pose->A)), wanted.plate_ACX);
    EXPECT_EQ(side_of(cross(pose->C - pose->B, pose->Y - pose->B)), wanted.plate_BCY);
  }
}

TEST(CopyingLinkage, VelocitiesAndAccelerationsAreTheLimitsOfDifferences) {
  RandomCases cases(5);
  for (int i = 0; i < 500; ++i) {
    const auto [mechanism, opening, bearing] = cases.next();
    if (mechanism.transmission_angle(opening) < 0.15) continue;
    // A speed for which everything changes by about its own size in one second, so that one step h serves all cases.
    const double chain = mechanism.grounding() == Grounding::pen ? 1 / std::abs(mechanism.k()) : 1;
    const double speed = chain * std::min(mechanism.VA(), mechanism.lengths().AX) *
                         std::sin(mechanism.transmission_angle(opening));
    const double h = 1e-4, size = size_of(mechanism);
    const Point start = mechanism.tracer_at(opening, bearing);
    const Point velocity = speed * Point(0.3, -0.2), acceleration = speed * Point(-0.1, 0.4);
    const auto pose_at = [&, &made = mechanism](double t) {  // clang 14 captures no structured binding
      return made.pose_with_tracer_at(start + t * velocity + 0.5 * t * t * acceleration);
    };
    const auto before = pose_at(-h), now = pose_at(0), after = pose_at(h);
    if (!before || !after) continue;
    const auto v = mechanism.velocities(*now, velocity);
    const auto a = mechanism.accelerations(*now, velocity, acceleration);
    const auto v_before = mechanism.velocities(*before, velocity - h * acceleration);
    const auto v_after = mechanism.velocities(*after, velocity + h * acceleration);
    ASSERT_TRUE(v && a && v_before && v_after);
    for (const Joint joint : all_joints) {
      const Point v_seen = ((*after)[joint] - (*before)[joint]) / (2 * h);
      const Point a_seen = ((*v_after)[joint] - (*v_before)[joint]) / (2 * h);
      EXPECT_LT(((*v)[joint] - v_seen).norm(), 1e-6 * size);
      EXPECT_LT(((*a)[joint] - a_seen).norm(), 1e-6 * size);
    }
    const Complex k = mechanism.k();
    EXPECT_LT(std::abs(as_complex((*v)[mechanism.pen_joint()]) - k * as_complex(velocity)), 1e-12 * size);
    EXPECT_LT(std::abs(as_complex((*a)[mechanism.pen_joint()]) - k * as_complex(acceleration)), 1e-11 * size);
  }
}

TEST(CopyingLinkage, RadiusSlopeIsTheLimitOfDifferences) {
  RandomCases cases(6);
  for (int i = 0; i < 500; ++i) {
    const auto [mechanism, opening, bearing] = cases.next();
    const double h = 1e-6;
    const double seen = (mechanism.radius_at(opening + h) - mechanism.radius_at(opening - h)) / (2 * h);
    EXPECT_NEAR(mechanism.radius_slope_at(opening), seen, 1e-6 * size_of(mechanism));
    EXPECT_EQ(mechanism.radius_grows_with_opening(), mechanism.radius_slope_at(opening) > 0);
  }
}

TEST(CopyingLinkage, AssembliesTogetherReachWhatTheChainReaches) {
  RandomCases cases(7);
  for (int i = 0; i < 500; ++i) {
    const CopyingLinkage any = cases.next().linkage;
    const double a = any.VA(), b = any.lengths().AX;
    double lowest = 1e300, highest = 0;
    for (const AssemblyMode& mode : assembly_modes(any.shape())) {
      const auto one = linkage(any.k(), any.grounding(), any.VA(), any.VB(), mode.number);
      const auto range = one.radii_over(one.assembly_mode().openings);
      lowest = std::min(lowest, range.lower);
      highest = std::max(highest, range.upper);
    }
    const double c = any.grounding() == Grounding::pen ? 1 / std::abs(any.k()) : 1;
    EXPECT_NEAR(highest, c * (a + b), 1e-9 * size_of(any));
    EXPECT_NEAR(lowest, c * std::abs(a - b), 1e-7 * size_of(any));
  }
}

TEST(CopyingLinkage, SizeIsTheSumOfHalfPerimeters) {
  const CopyingLinkage report = linkage(copy_ratio(1.4, pi / 2), Grounding::pole, 50, 35, 3);
  const double ACX = 35 + 25 + std::hypot(35, 25), BCY = 50 + 70 + std::hypot(50, 70);
  EXPECT_NEAR(report.size(), 50 + 35 + ACX / 2 + BCY / 2, 1e-12);
}

// Published: MATLAB pantograph (sources: pantograph-matlab), positions recomputed with atan2.
TEST(PublishedFigures, MatlabPantograph) {
  // pole O = X, tracer D = V, pen E = Y; OA = AX = 6, AD = VA = 4, AB = VB = 3; the paper's B is C, its C is B.
  struct Row {
    double theta;
    Point A, B, C, D, E;
  };
  const Row rows[] = {
      {0, {2.05128275, 5.6384607}, {3.07692412, 8.45769105}, {7.02564137, 7.81923035}, {6, 5}, {9, 7.5}},
      {0.1,
       {2.0323711, 5.64530493},
       {3.04855665, 8.46795739},
       {7.01118971, 7.92248588},
       {5.99500417, 5.09983342},
       {8.99250625, 7.64975012}},
      {0.3,
       {1.97257465, 5.66647591},
       {2.95886198, 8.49971387},
       {6.94162381, 8.12875816},
       {5.95533649, 5.29552021},
       {8.93300473, 7.94328031}}};
  int matching = 0;
  for (int assembly_mode = 0; assembly_mode < 2; ++assembly_mode) {
    const auto mechanism = linkage(1.5, Grounding::tracer, 4, 3, assembly_mode);
    EXPECT_NEAR(mechanism.lengths().AX, 6, 1e-12);
    EXPECT_NEAR(mechanism.lengths().BY, 2, 1e-12);
    EXPECT_NEAR(mechanism.radii_over(mechanism.assembly_mode().openings).lower, 2, 1e-12);
    EXPECT_NEAR(mechanism.radii_over(mechanism.assembly_mode().openings).upper, 10, 1e-12);
    const auto first = mechanism.pose_with_tracer_at(rows[0].D);
    ASSERT_TRUE(first);
    if ((first->A - rows[0].A).norm() > 1e-3) continue;
    ++matching;
    for (const Row& row : rows) {
      const Point D = Point(5, 5) + Point(std::cos(row.theta), std::sin(row.theta));
      EXPECT_LT((D - row.D).norm(), 1e-7);
      const Pose pose = mechanism.pose_with_tracer_at(D).value();
      EXPECT_LT((pose.A - row.A).norm(), 1e-7);
      EXPECT_LT((pose.C - row.B).norm(), 1e-7);
      EXPECT_LT((pose.B - row.C).norm(), 1e-7);
      EXPECT_LT((pose.Y - row.E).norm(), 1e-7);
    }
  }
  EXPECT_EQ(matching, 1);
}

// Published: plagiograph report, k = 1.4i, OA = 5, OB = AC = 3.5, AX = 2.5, X = (7, 1).
TEST(PublishedFigures, PlagiographReport) {
  const auto mechanism =
      linkage(copy_ratio(1.4, pi / 2), Grounding::pole, 5, 3.5,
              assembly_mode_containing(copy_ratio(1.4, pi / 2), Grounding::pole, radians(120)));
  EXPECT_NEAR(mechanism.lengths().AX, 2.5, 1e-12);
  EXPECT_NEAR(mechanism.lengths().BY, 7, 1e-12);
  int matching = 0;
  for (int assembly_mode = 0; assembly_mode < 4; ++assembly_mode) {
    const auto pose =
        linkage(copy_ratio(1.4, pi / 2), Grounding::pole, 5, 3.5, assembly_mode).pose_with_tracer_at({7, 1});
    if (!pose || (pose->A - Point(4.64714054, 1.8450162)).norm() > 1e-3) continue;
    ++matching;
    EXPECT_LT((pose->A - Point(4.64714054, 1.8450162)).norm(), 1e-7);
    EXPECT_LT((pose->C - Point(5.83016322, 5.13901944)).norm(), 1e-7);
    EXPECT_LT((pose->B - Point(1.18302268, 3.29400324)).norm(), 1e-7);
    EXPECT_LT((pose->Y - Point(-1.4, 9.8)).norm(), 1e-7);
  }
  EXPECT_EQ(matching, 1);
}

TEST(PublishedFigures, ReportsUsableDistanceRunsFromItsChangePointToItsReach) {
  for (int assembly_mode = 0; assembly_mode < 4; ++assembly_mode) {
    const auto mechanism = linkage(copy_ratio(1.4, pi / 2), Grounding::pole, 5, 3.5, assembly_mode);
    const auto range = mechanism.radii_over(mechanism.assembly_mode().openings);
    const bool outer = std::abs(range.upper - 7.5) < 1e-12;
    EXPECT_NEAR(outer ? range.lower : range.upper, std::sqrt(31.25), 1e-12);
    EXPECT_NEAR(outer ? range.upper : range.lower, outer ? 7.5 : 2.5, 1e-12);
    // The report's "bizarre configurations": reached only by the other assembly.
    EXPECT_EQ(mechanism.pose_with_tracer_at({3, 0}).has_value(), !outer);
    EXPECT_EQ(mechanism.pose_with_tracer_at({4.5, 1}).has_value(), !outer);
    EXPECT_EQ(mechanism.pose_with_tracer_at({7, 1}).has_value(), outer);
  }
}

double width_of_the_widest(Complex k, Grounding grounding) {
  double width = 0;
  for (const AssemblyMode& mode : assembly_modes(shape_of(k, grounding)))
    width = std::max(width, mode.openings.width());
  return width;
}

// The smallest-angle rule: widths 90 / 125.5 / 144.5 degrees for k = 1.4i.
TEST(PublishedFigures, WidestAssemblyOfEachGroundingOfTheReportsRatio) {
  const auto width = [](Grounding grounding) {
    return degrees(width_of_the_widest(copy_ratio(1.4, pi / 2), grounding));
  };
  EXPECT_NEAR(width(Grounding::pole), 90, 1e-9);
  EXPECT_NEAR(width(Grounding::tracer), 180 - degrees(std::atan(1.4)), 1e-9);   // 125.5
  EXPECT_NEAR(width(Grounding::pen), 180 - degrees(std::atan(1 / 1.4)), 1e-9);  // 144.5
}

TEST(SmallestAngleRule, SomeGroundingAlwaysOpensAtLeast120Degrees) {
  RandomCases cases(8);
  for (int i = 0; i < 2000; ++i) {
    const Complex k = std::polar(std::exp(cases.uniform(-4, 4)), cases.uniform(-pi, pi));
    double best = 0;
    for (const Grounding grounding : all_groundings) best = std::max(best, width_of_the_widest(k, grounding));
    // Smallest angle of the triangle pole, tracer, pen by the law of cosines.
    const double a = 1, b = std::abs(k), c = std::abs(k - 1.0);
    const auto angle = [](double opposite, double m, double n) {
      return std::acos(std::clamp((m * m + n * n - opposite * opposite) / (2 * m * n), -1.0, 1.0));
    };
    const double smallest = std::min({angle(a, b, c), angle(b, a, c), angle(c, a, b)});
    EXPECT_NEAR(best, pi - smallest, 1e-6);
    EXPECT_GE(best, radians(120) - 1e-9);
  }
}

TEST(Assemblies, CoverTheWholeTurnWithoutOverlap) {
  RandomCases cases(9);
  for (int i = 0; i < 500; ++i) {
    const auto all = assembly_modes(cases.next().linkage.shape());
    ASSERT_TRUE(all.size() == 2 || all.size() == 4);
    EXPECT_EQ(all.front().openings.lower, -pi);
    EXPECT_EQ(all.back().openings.upper, pi);
    for (std::size_t j = 1; j < all.size(); ++j) EXPECT_EQ(all[j - 1].openings.upper, all[j].openings.lower);
    for (std::size_t j = 0; j < all.size(); ++j) EXPECT_EQ(all[j].number, static_cast<int>(j));
  }
}

TEST(Assemblies, HalfTurnAndNoTurnAreStraightForEveryGrounding) {
  for (const double scale : {1.0 / 3, 0.4, 1.5, 2.5, 200.0})
    for (const double rotation : {0.0, pi, -pi})
      for (const Grounding grounding : all_groundings) {
        const Complex s = shape_of(copy_ratio(scale, rotation), grounding);
        EXPECT_TRUE(is_straight(s));
        EXPECT_EQ(assembly_modes(s).size(), 2U);
      }
}

TEST(CopyRatio, IsExactAtQuarterTurns) {
  EXPECT_EQ(copy_ratio(1.4, pi / 2), Complex(0, 1.4));
  EXPECT_EQ(copy_ratio(1.4, -pi / 2), Complex(0, -1.4));
  EXPECT_EQ(copy_ratio(2, pi), Complex(-2, 0));
  EXPECT_EQ(copy_ratio(2, 0), Complex(2, 0));
  EXPECT_LT(std::abs(copy_ratio(2, pi / 3) - Complex(1, std::sqrt(3.0))), 1e-15);
}

TEST(CopyingLinkage, RefusesWhatIsNoLinkage) {
  const auto fault = [](Complex k, double VA, double VB, int assembly_mode) {
    return CopyingLinkage::make(k, Grounding::pole, VA, VB, assembly_mode).error();
  };
  EXPECT_EQ(fault(0, 1, 1, 0), LinkageFault::ratio_zero);
  EXPECT_EQ(fault(1, 1, 1, 0), LinkageFault::ratio_one);
  EXPECT_EQ(fault(std::nan(""), 1, 1, 0), LinkageFault::ratio_not_finite);
  EXPECT_EQ(fault(2, 0, 1, 0), LinkageFault::length_not_positive);
  EXPECT_EQ(fault(2, 1, -1, 0), LinkageFault::length_not_positive);
  EXPECT_EQ(fault(2, 1, INFINITY, 0), LinkageFault::length_not_positive);
  EXPECT_EQ(fault(2, 1, 1, 2), LinkageFault::no_such_assembly_mode);
  EXPECT_EQ(fault(2, 1, 1, -1), LinkageFault::no_such_assembly_mode);
}

TEST(CopyingLinkage, FaultsAndPlacesOutOfReachHaveSentencesOfTheirOwn) {
  const std::set<std::string_view> sentences{name(LinkageFault::ratio_zero),
                                             name(LinkageFault::ratio_one),
                                             name(LinkageFault::ratio_not_finite),
                                             name(LinkageFault::length_not_positive),
                                             name(LinkageFault::no_such_assembly_mode),
                                             name(Unreachable::too_far),
                                             name(Unreachable::too_near),
                                             name(Unreachable::beyond_change_point)};
  EXPECT_EQ(sentences.size(), 8U);
  EXPECT_FALSE(sentences.contains(""));
}

TEST(CopyingLinkage, SaysWhyATracerIsOutOfReach) {
  const auto mechanism = linkage(copy_ratio(1.4, pi / 2), Grounding::pole, 50, 35, 3);
  EXPECT_EQ(mechanism.pose_with_tracer_at({80, 0}).error(), Unreachable::too_far);
  EXPECT_EQ(mechanism.pose_with_tracer_at({20, 0}).error(), Unreachable::too_near);
  EXPECT_EQ(mechanism.pose_with_tracer_at({0, 0}).error(), Unreachable::too_near);
}

TEST(CopyingLinkage, HasNoVelocityAtADeadPointInsteadOfAHugeOne) {
  const auto mechanism = linkage(2.0, Grounding::pole, 50, 35, 1);
  const Pose stretched = mechanism.pose_at(0, 0.3);
  EXPECT_FALSE(mechanism.velocities(stretched, {1, 0}));
  EXPECT_FALSE(mechanism.accelerations(stretched, {1, 0}, {0, 0}));
}

TEST(CopyingLinkage, KeepsItsDigitsAtLengthRatiosOf1To1000) {
  for (const double ratio : {1e-3, 1.0, 1e3})
    for (const Grounding grounding : all_groundings) {
      const auto mechanism = linkage(std::polar(0.7, 1.1), grounding, 100, 100 * ratio, 3);
      const OpeningInterval d = mechanism.assembly_mode().openings;
      for (const double share : {1e-6, 0.01, 0.5, 0.99, 1 - 1e-6}) {
        const double opening = d.lower + share * d.width();
        const auto pose = mechanism.pose_with_tracer_at(mechanism.tracer_at(opening, 1.0));
        ASSERT_TRUE(pose);
        const Complex tracer = as_complex((*pose)[mechanism.tracer_joint()]);
        const Complex pen = as_complex((*pose)[mechanism.pen_joint()]);
        EXPECT_LT(std::abs(pen - mechanism.k() * tracer), 1e-12 * mechanism.size());
        EXPECT_LT(std::abs(tracer - as_complex(mechanism.tracer_at(opening, 1.0))), 1e-11 * mechanism.size());
      }
    }
}

}  // namespace
}  // namespace kempe
