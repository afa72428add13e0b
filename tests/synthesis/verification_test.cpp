#include "synthesis/verification.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace kempe {
namespace {

double uniform(std::mt19937_64& random, double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Region rectangle(const Point& lower, const Point& upper) {
  return {{Polygon{{lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}}, {}}}};
}

/// A task that a linkage fulfils: a sector of its annulus as the region.
VerificationTask task_for(const CopyingLinkage& linkage, double bearing) {
  VerificationTask task;
  const OpeningInterval opening =
      linkage.openings_with_transmission(0.15 * linkage.assembly_interval().width());
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
                    linkage.orientation(),
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
    const auto vertex = all_vertices[static_cast<std::size_t>(random() % 3)];
    const auto count = assemblies(shape_of(k, vertex)).size();
    const auto made =
        CopyingLinkage::make(k, vertex, std::exp(uniform(random, 3, 6)), std::exp(uniform(random, 3, 6)),
                             static_cast<int>(random() % count), Point(uniform(random, -90, 90), 20));
    if (!made || made->assembly_interval().width() < radians(40)) continue;
    const auto radii =
        made->radii_over(made->openings_with_transmission(0.15 * made->assembly_interval().width()));
    if (radii.lower * 1.03 < radii.upper && radii.lower > 0.1 * made->VA()) return *made;
  }
}

TEST(Verification, CertifiesEveryExactLinkage) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 60; ++i) {
    const CopyingLinkage linkage = random_linkage(random);
    const Verification found = verify(task_for(linkage, uniform(random, -3, 3)));
    EXPECT_TRUE(found.certified) << found.failure;
    EXPECT_EQ(found.flips, 0);
    EXPECT_GT(found.samples, 300U);
    EXPECT_LT(found.copy_error_max, 1e-9 * linkage.size());
    EXPECT_LT(found.loop_residual_max, 1e-12 * linkage.size());
    EXPECT_NEAR(found.scale, std::abs(linkage.k()), 1e-9 * (1 + std::abs(linkage.k())));
    EXPECT_NEAR(std::remainder(found.rotation - std::arg(linkage.k()), 2 * pi), 0, 1e-9);
  }
}

CopyingLinkage report() {
  return CopyingLinkage::make(copy_ratio(1.4, pi / 2), Vertex::pole, 50, 35, 3).value();
}

TEST(Verification, SeesALengthThatNoLongerCopies) {
  for (int which = 0; which < 8; ++which) {
    VerificationTask task = task_for(report(), 0.3);
    double* length[] = {&task.mechanism.lengths.VA, &task.mechanism.lengths.VB, &task.mechanism.lengths.AC,
                        &task.mechanism.lengths.BC, &task.mechanism.lengths.AX, &task.mechanism.lengths.CX,
                        &task.mechanism.lengths.BY, &task.mechanism.lengths.CY};
    *length[which] += 1e-3;
    const Verification found = verify(task);
    EXPECT_FALSE(found.certified) << LinkLengths::names[static_cast<std::size_t>(which)];
    EXPECT_GT(found.copy_error_max, 1e-5);
  }
}

TEST(Verification, SeesLengthsThatDoNotClose) {
  VerificationTask task = task_for(report(), 0.3);
  task.mechanism.lengths.CX = 200;
  EXPECT_NE(verify(task).failure.find("triangle"), std::string::npos);
  task = task_for(report(), 0.3);
  task.mechanism.lengths.VA = 500;
  EXPECT_FALSE(verify(task).certified);
  task = task_for(report(), 0.3);
  task.mechanism.lengths.VB = std::nan("");
  EXPECT_FALSE(verify(task).certified);
}

TEST(Verification, SeesTheOtherTurnOfAPlate) {
  VerificationTask task = task_for(report(), 0.3);
  task.mechanism.orientation.plate_BCY *= -1;
  EXPECT_FALSE(verify(task).certified);
}

TEST(Verification, SeesARegionBeyondReach) {
  VerificationTask task = task_for(report(), 0.3);
  task.region = rectangle({60, 0}, {90, 10});
  const Verification found = verify(task);
  EXPECT_FALSE(found.certified);
  EXPECT_NE(found.failure.find("tracer at"), std::string::npos);
  task.region_covered = false;
  task.mechanism.opening = report().assembly_interval();
  EXPECT_TRUE(verify(task).certified) << "the part within reach still copies: " << verify(task).failure;
}

TEST(Verification, SeesALimitThatIsNotKept) {
  VerificationTask task = task_for(report(), 0.3);
  task.transmission = radians(60);
  EXPECT_NE(verify(task).failure.find("transmission"), std::string::npos);
  task = task_for(report(), 0.3);
  task.clearance = 50;
  EXPECT_NE(verify(task).failure.find("apart"), std::string::npos);
  task = task_for(report(), 0.3);
  task.longest = 60;
  EXPECT_NE(verify(task).failure.find("BY"), std::string::npos);
}

TEST(Verification, SeesAnotherRatio) {
  VerificationTask task = task_for(report(), 0.3);
  task.k = copy_ratio(1.4000001, pi / 2);
  EXPECT_FALSE(verify(task).certified);
}

TEST(Verification, CrossesToAPartOfTheRegionOnTheOtherSideOfThePole) {
  VerificationTask task = task_for(report(), 0.3);
  task.region = rectangle({60, -5}, {68, 5});
  task.region.polygons.push_back(rectangle({-68, -5}, {-60, 5}).polygons.front());
  task.mechanism.opening = report().assembly_interval();
  const Verification found = verify(task);
  EXPECT_TRUE(found.certified) << found.failure;
  EXPECT_EQ(found.flips, 0);
}

TEST(Verification, CarriesTheReportsMechanismAsFarAsItsOwnLimits) {
  VerificationTask task = task_for(report(), 0.3);
  task.mechanism.opening = report().assembly_interval();
  task.region = rectangle({56, -1}, {74.9, 1});
  EXPECT_TRUE(verify(task).certified) << verify(task).failure;
  task.region = rectangle({30, -1}, {74.9, 1});  // through the change point
  EXPECT_FALSE(verify(task).certified);
}

}  // namespace
}  // namespace kempe
