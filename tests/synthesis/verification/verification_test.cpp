#include "synthesis/verification/verification.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "synthesis/design/assemble.hpp"
#include "tests/random.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using test::uniform;

Region rectangle(const Point& lower, const Point& upper) {
  return {{Polygon{{lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}}, {}}}};
}

/// A task that a linkage fulfils: a sector of its annulus as the region.
VerificationTask task_for(const CopyingLinkage& linkage, double bearing) {
  VerificationTask task;
  const OpeningInterval opening =
      linkage.openings_with_transmission(0.15 * linkage.assembly_mode().openings.width());
  const auto radii = linkage.radii_over(opening);
  Ring ring;
  for (int i = 0; i <= 12; ++i)
    ring.push_back(linkage.pole() +
                   radii.upper * 0.999 * Point(std::cos(bearing + i * 0.05), std::sin(bearing + i * 0.05)));
  for (int i = 12; i >= 0; --i)
    ring.push_back(linkage.pole() +
                   radii.lower * 1.02 * Point(std::cos(bearing + i * 0.05), std::sin(bearing + i * 0.05)));
  task.region.polygons.push_back({ring, {}});
  task.mechanism = {linkage.lengths(),
                    linkage.assembly_mode().sides,
                    linkage.pole_joint(),
                    linkage.tracer_joint(),
                    linkage.pen_joint(),
                    linkage.pole(),
                    opening};
  task.k = linkage.k();
  return task;
}

CopyingLinkage random_linkage(std::mt19937_64& random) {
  for (;;) {
    const Complex k = std::polar(std::exp(uniform(random, -1.5, 1.5)), uniform(random, -pi, pi));
    const auto grounding = all_groundings[static_cast<std::size_t>(random() % 3)];
    const auto count = assembly_modes(shape_of(k, grounding)).size();
    const auto made =
        CopyingLinkage::make(k, grounding, std::exp(uniform(random, 3, 6)), std::exp(uniform(random, 3, 6)),
                             static_cast<int>(random() % count), Point(uniform(random, -90, 90), 20));
    if (!made || made->assembly_mode().openings.width() < radians(40)) continue;
    const auto radii =
        made->radii_over(made->openings_with_transmission(0.15 * made->assembly_mode().openings.width()));
    if (radii.lower * 1.03 < radii.upper && radii.lower > 0.1 * made->VA()) return *made;
  }
}

TEST(Verification, CertifiesEveryExactLinkage) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 60; ++i) {
    const CopyingLinkage linkage = random_linkage(random);
    const Verification found = verify(task_for(linkage, uniform(random, -3, 3)));
    EXPECT_TRUE(found.holds) << found.failure;
    EXPECT_EQ(found.flips, 0);
    EXPECT_GT(found.samples, 300U);
    EXPECT_LT(found.copy_error_max, 1e-9 * linkage.size());
    EXPECT_LT(found.loop_residual_max, 1e-12 * linkage.size());
    EXPECT_NEAR(found.scale, std::abs(linkage.k()), 1e-9 * (1 + std::abs(linkage.k())));
    EXPECT_NEAR(std::remainder(found.rotation - std::arg(linkage.k()), 2 * pi), 0, 1e-9);
  }
}

CopyingLinkage report() {
  return CopyingLinkage::make(copy_ratio(1.4, pi / 2), Grounding::pole, 50, 35, 3).value();
}

TEST(Verification, SeesALengthThatNoLongerCopies) {
  for (int which = 0; which < 8; ++which) {
    VerificationTask task = task_for(report(), 0.3);
    double* length[] = {&task.mechanism.lengths.VA, &task.mechanism.lengths.VB, &task.mechanism.lengths.AC,
                        &task.mechanism.lengths.BC, &task.mechanism.lengths.AX, &task.mechanism.lengths.CX,
                        &task.mechanism.lengths.BY, &task.mechanism.lengths.CY};
    *length[which] += 1e-3;
    const Verification found = verify(task);
    EXPECT_FALSE(found.holds) << LinkLengths::names[static_cast<std::size_t>(which)];
    EXPECT_GT(found.copy_error_max, 1e-5);
  }
}

TEST(Verification, SeesLengthsThatDoNotClose) {
  VerificationTask task = task_for(report(), 0.3);
  task.mechanism.lengths.CX = 200;
  EXPECT_NE(verify(task).failure.find("triangle"), std::string::npos);
  task = task_for(report(), 0.3);
  task.mechanism.lengths.VA = 500;
  EXPECT_FALSE(verify(task).holds);
  task = task_for(report(), 0.3);
  task.mechanism.lengths.VB = std::nan("");
  EXPECT_FALSE(verify(task).holds);
}

TEST(Verification, SeesTheOtherTurnOfAPlate) {
  VerificationTask task = task_for(report(), 0.3);
  task.mechanism.sides.plate_BCY = opposite(task.mechanism.sides.plate_BCY);
  EXPECT_FALSE(verify(task).holds);
}

TEST(Verification, SeesARegionBeyondReach) {
  VerificationTask task = task_for(report(), 0.3);
  task.region = rectangle({60, 0}, {90, 10});
  const Verification found = verify(task);
  EXPECT_FALSE(found.holds);
  EXPECT_NE(found.failure.find("tracer at"), std::string::npos);
  task.region_covered = false;
  task.mechanism.opening = report().assembly_mode().openings;
  EXPECT_TRUE(verify(task).holds) << "the part within reach still copies: " << verify(task).failure;
}

TEST(Verification, SeesALimitThatIsNotKept) {
  VerificationTask task = task_for(report(), 0.3);
  task.limits = {.clearance = -HUGE_VAL, .transmission = radians(60)};
  EXPECT_NE(verify(task).failure.find("transmission"), std::string::npos);
  task = task_for(report(), 0.3);
  task.limits = {.clearance = 50, .transmission = 0};
  EXPECT_NE(verify(task).failure.find("apart"), std::string::npos);
  task = task_for(report(), 0.3);
  task.longest = 60;
  EXPECT_NE(verify(task).failure.find("BY"), std::string::npos);
}

TEST(Verification, SeesAnotherRatio) {
  VerificationTask task = task_for(report(), 0.3);
  task.k = copy_ratio(1.4000001, pi / 2);
  EXPECT_FALSE(verify(task).holds);
}

TEST(Verification, CrossesToAPartOfTheRegionOnTheOtherSideOfThePole) {
  VerificationTask task = task_for(report(), 0.3);
  task.region = rectangle({60, -5}, {68, 5});
  task.region.polygons.push_back(rectangle({-68, -5}, {-60, 5}).polygons.front());
  task.mechanism.opening = report().assembly_mode().openings;
  const Verification found = verify(task);
  EXPECT_TRUE(found.holds) << found.failure;
  EXPECT_EQ(found.flips, 0);
}

TEST(Verification, CarriesTheReportsMechanismAsFarAsItsOwnLimits) {
  VerificationTask task = task_for(report(), 0.3);
  task.mechanism.opening = report().assembly_mode().openings;
  task.region = rectangle({56, -1}, {74.9, 1});
  EXPECT_TRUE(verify(task).holds) << verify(task).failure;
  task.region = rectangle({30, -1}, {74.9, 1});  // through the change point
  EXPECT_FALSE(verify(task).holds);
}

/// A linkage whose plates miss a straight line by `bend`, rad.
std::optional<CopyingLinkage> nearly_straight(std::mt19937_64& random, double bend) {
  const double scale = std::exp(uniform(random, -1.5, 1.5));
  const double rotation = (random() % 2 ? pi : 0) + (random() % 2 ? bend : -bend);
  const auto grounding = all_groundings[static_cast<std::size_t>(random() % 3)];
  const double VA = std::exp(uniform(random, 3, 6)), VB = VA * std::exp(uniform(random, -1, 1));
  const Complex k = std::polar(scale, rotation);
  if (std::abs(k - 1.0) < 0.05) return std::nullopt;
  for (std::size_t i = 0; i < assembly_modes(shape_of(k, grounding)).size(); ++i)
    if (const auto made = CopyingLinkage::make(k, grounding, VA, VB, static_cast<int>(i), Point(30, -20));
        made && made->assembly_mode().openings.width() > 3)
      return *made;
  return std::nullopt;
}

VerificationTask with_shape(const CopyingLinkage& linkage) {
  VerificationTask task = task_for(linkage, 0.3);
  task.mechanism.shape = linkage.shape();
  return task;
}

TEST(Verification, CertifiesPlatesHoweverNearToStraight) {
  std::mt19937_64 random(31);
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    const double bend = i % 20 == 0 ? 0 : std::pow(10, uniform(random, -15, -0.5));
    const auto linkage = nearly_straight(random, bend);
    if (!linkage) continue;
    ++seen;
    const Verification found = verify(with_shape(*linkage), {.outline_samples = 60, .hatch_lines = 2});
    EXPECT_TRUE(found.holds) << bend << " " << found.failure;
    EXPECT_LT(found.copy_error_max, 1e-11 * linkage->size()) << bend;
  }
  EXPECT_GT(seen, 200);
}

TEST(Verification, SeesALengthOrAShapeOfANearlyStraightPlateThatNoLongerCopies) {
  std::mt19937_64 random(32);
  for (int i = 0; i < 300; ++i) {
    const auto linkage = nearly_straight(random, std::pow(10, uniform(random, -10, -1)));
    if (!linkage) continue;
    VerificationTask task = with_shape(*linkage);
    LinkLengths& l = task.mechanism.lengths;
    double* length[] = {&l.VA, &l.VB, &l.AC, &l.BC, &l.AX, &l.CX, &l.BY, &l.CY};
    const std::size_t which = random() % 9;
    if (which < 8)
      *length[which] += (random() % 2 ? 1e-6 : -1e-6) * linkage->size();
    else
      *task.mechanism.shape *= std::polar(1.0, 1e-6);
    EXPECT_FALSE(verify(task, {.outline_samples = 60, .hatch_lines = 2}).holds) << which;
  }
}

TEST(Verification, SeesTheOtherTurnOfANearlyStraightPlate) {
  std::mt19937_64 random(33);
  for (int i = 0; i < 50; ++i) {
    const auto linkage = nearly_straight(random, std::pow(10, uniform(random, -11, -1)));
    if (!linkage) continue;
    VerificationTask task = with_shape(*linkage);
    Side& turned = i % 2 ? task.mechanism.sides.plate_ACX : task.mechanism.sides.plate_BCY;
    turned = opposite(turned);
    EXPECT_FALSE(verify(task).holds);
  }
}

TEST(Verification, LosesNoDigitFarFromTheTablesOrigin) {
  std::mt19937_64 random(34);
  for (int i = 0; i < 60; ++i) {
    const CopyingLinkage near = random_linkage(random);
    const double x = uniform(random, -1e7, 1e7), y = uniform(random, -1e7, 1e7);
    const auto far = CopyingLinkage::make(near.k(), near.grounding(), near.VA(), near.VB(),
                                          near.assembly_mode().number, Point(x, y));
    const Verification found = verify(task_for(*far, uniform(random, -3, 3)));
    EXPECT_TRUE(found.holds) << found.failure;
    EXPECT_LT(found.copy_error_max, 1e-11 * near.size());
  }
}

TEST(Verification, KnowsNoSize) {
  std::mt19937_64 random(35);
  for (int i = 0; i < 60; ++i) {
    const CopyingLinkage one = random_linkage(random);
    const double factor = std::pow(10, uniform(random, -8, 4));
    const auto other = CopyingLinkage::make(one.k(), one.grounding(), factor * one.VA(), factor * one.VB(),
                                            one.assembly_mode().number, factor * one.pole());
    VerificationTask task = task_for(*other, uniform(random, -3, 3));
    EXPECT_TRUE(verify(task).holds) << factor << verify(task).failure;
    task.mechanism.lengths.CX *= 1 + 1e-5;
    EXPECT_FALSE(verify(task).holds) << factor;
  }
}

/// Rings from end to end of what may be used: the tracer stands a thousandth of a degree from dead and change points.
TEST(Verification, DrivesAsNearToDeadAndChangePointsAsADesignMayStand) {
  std::mt19937_64 random(36);
  for (int i = 0; i < 60; ++i) {
    const CopyingLinkage linkage = random_linkage(random);
    VerificationTask task = with_shape(linkage);
    task.mechanism.opening = linkage.openings_with_transmission(0);
    task.limits = {.clearance = -HUGE_VAL, .transmission = least_usable_angle};
    task.region = flattened(as_region(usable_annulus(linkage, 0)), 1e-3 * linkage.size(), Flatten::shrinks);
    const auto radii = linkage.radii_over(task.mechanism.opening);
    const double bearing = uniform(random, -pi, pi);
    const auto at = [&](double radius, double aside) {
      return Point(linkage.pole() + as_point(std::polar(radius, bearing + aside)));
    };
    task.region.polygons.push_back(
        {{at(radii.lower, 0), at(radii.upper, 0), at(0.5 * (radii.lower + radii.upper), 1e-3)}, {}});
    const Verification found = verify(task, {.outline_samples = 20, .hatch_lines = 1});
    EXPECT_TRUE(found.holds) << i << " " << found.failure;
    EXPECT_EQ(found.flips, 0);
  }
}

TEST(Verification, StoppedEarlyItDrivesToFewPlacesAllOver) {
  const VerificationTask task = task_for(report(), 0.3);
  const VerificationRun whole = run_verification(task, {});
  EXPECT_TRUE(whole.complete);
  const VerificationRun run = run_verification(task, {.stop = StopFlag([] { return true; })});
  EXPECT_FALSE(run.complete);
  EXPECT_TRUE(run.found.holds) << run.found.failure;
  EXPECT_GE(run.found.samples, 10U);
  EXPECT_LE(run.found.samples, 20U);
  EXPECT_LT(run.found.samples, whole.found.samples);
  EXPECT_NEAR(run.found.scale, whole.found.scale, 1e-9);
}

TEST(Verification, DrivesOverTheFreeWorkspaceWhereThereIsNoRegion) {
  test::SpecDice dice(37);
  std::mt19937_64 random(38);
  int driven = 0;
  for (int i = 0; i < 40; ++i) {
    const CopyingLinkage linkage = random_linkage(random);
    Spec spec = dice.spec();
    if (i % 2) spec.obstacles.push_back(dice.obstacle_beside(spec));
    spec.region = {};
    spec.limits.transmission = radians(10);
    const Design design = assemble_given(spec, linkage, {.largest_sheets = false});
    const Verification found = verify(verification_task(design));
    EXPECT_TRUE(found.holds) << i << " " << found.failure;
    EXPECT_TRUE(found.over_workspace);
    driven += found.samples > 200;
  }
  EXPECT_GT(driven, 20);
}

TEST(Verification, DrivesOverTheFreeWorkspaceWhereTheRegionIsCoveredInPart) {
  test::SpecDice dice(41);
  std::mt19937_64 random(42);
  int in_part = 0;
  for (int i = 0; i < 40; ++i) {
    const CopyingLinkage linkage = random_linkage(random);
    Spec spec = dice.spec();
    if (i % 2) spec.obstacles.push_back(dice.obstacle_beside(spec));
    spec.limits.transmission = radians(10);
    const auto reach = linkage.radii_over(linkage.assembly_mode().openings);
    const double middle = 0.5 * (reach.lower + reach.upper), half = 0.6 * (reach.upper - reach.lower);
    spec.region = rectangle(linkage.pole() + Point(middle - half, -0.2 * half),
                            linkage.pole() + Point(middle + half, 0.2 * half));
    const Design design = assemble_given(spec, linkage, {.largest_sheets = false});
    ASSERT_FALSE(design.map.coverage.covered) << i;
    const Verification found = verify(verification_task(design));
    EXPECT_TRUE(found.holds) << i << " " << found.failure;
    in_part += found.over_workspace && found.samples > 200;
  }
  EXPECT_GT(in_part, 20);
}

TEST(Verification, DrivesOverTheFreeWorkspaceWhereNothingOfTheRegionIsReached) {
  Spec spec;
  spec.copy = Copy::of(report().k());
  spec.region = rectangle({500, 500}, {510, 510});
  const Design design = assemble_given(spec, report(), {.largest_sheets = false});
  ASSERT_FALSE(design.map.coverage.covered);
  const Verification found = verify(verification_task(design));
  EXPECT_TRUE(found.holds) << found.failure;
  EXPECT_TRUE(found.over_workspace);
}

}  // namespace
}  // namespace kempe
