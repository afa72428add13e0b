// Poses in columns against poses one by one, on random linkages of every grounding and assembly.
#include "kinematics/pose_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/kinematics/planar/random_linkages.hpp"

namespace kempe {
namespace {

using test::Random;

CopyingLinkage random_copying_linkage(Random& random, int i) {
  for (;;) {
    const Complex k =
        copy_ratio(random.logarithmic(0.1, 10), i % 4 == 0 ? pi * random.below(2) : random.uniform(-pi, pi));
    const Grounding grounding = all_groundings[static_cast<std::size_t>(i % 3)];
    const auto count = static_cast<int>(assembly_modes(shape_of(k, grounding)).size());
    const auto linkage =
        CopyingLinkage::make(k, grounding, random.logarithmic(1, 200), random.logarithmic(1, 200),
                             random.below(count), random.point(300));
    if (linkage) return *linkage;
  }
}

/// Tracers from inside the inner reach to beyond the outer one.
struct Tracers {
  std::vector<double> x, y;
  Tracers(Random& random, const CopyingLinkage& linkage, int count) {
    const auto radii = linkage.radii_over(linkage.assembly_mode().openings);
    const double beyond = 0.1 * (radii.upper - radii.lower);
    for (int i = 0; i < count; ++i) {
      const Complex reach = std::polar(
          random.uniform(std::max(0.0, radii.lower - beyond), radii.upper + beyond), random.uniform(-pi, pi));
      x.push_back(linkage.pole().x() + reach.real());
      y.push_back(linkage.pole().y() + reach.imag());
    }
  }
  Point operator[](std::size_t i) const { return {x[i], y[i]}; }
};

double farthest_from_vertex(const Pose& pose) {
  double farthest = 0;
  for (const Joint joint : all_joints) farthest = std::max(farthest, (pose[joint] - pose.V).norm());
  return farthest;
}

/// What rounding of the table's coordinates adds, in units of the last digit stated.
double magnitude(const Pose& pose) {
  double largest = farthest_from_vertex(pose);
  for (const Joint joint : all_joints) largest = std::max(largest, pose[joint].norm());
  return largest;
}

TEST(PoseBatch, EqualsThePosesOneByOne) {
  Random random(11);
  std::size_t poses = 0, apart = 0;
  PoseBatch batch;
  for (int i = 0; i < 600; ++i) {
    const CopyingLinkage linkage = random_copying_linkage(random, i);
    const Tracers tracers(random, linkage, 50);
    poses_with_tracer_at(linkage, tracers.x, tracers.y, batch);
    ASSERT_EQ(batch.size(), tracers.x.size());
    for (std::size_t row = 0; row < batch.size(); ++row) {
      const auto one = linkage.pose_with_tracer_at(tracers[row]);
      const auto other = batch[row];
      if (one.has_value() != other.has_value()) {
        ++apart;  // within rounding of a limit
        continue;
      }
      if (!one) {
        EXPECT_EQ(one.error(), other.error());
        continue;
      }
      ++poses;
      const double opening = *linkage.opening_at((tracers[row] - linkage.pole()).norm());
      const double sine = std::max(1e-6, std::sin(linkage.transmission_angle(opening)));
      for (const Joint joint : all_joints)
        EXPECT_LE(((*one)[joint] - (*other)[joint]).norm(), 4e-14 / (sine * sine) * magnitude(*one))
            << i << ' ' << letter(joint);
    }
  }
  EXPECT_GT(poses, 10000u);
  EXPECT_EQ(apart, 0u);
}

TEST(PoseBatch, KeepsEveryLengthUpToTheDeadPoints) {
  Random random(12);
  PoseBatch batch;
  for (int i = 0; i < 600; ++i) {
    const CopyingLinkage linkage = random_copying_linkage(random, i);
    const auto radii = linkage.radii_over(linkage.assembly_mode().openings);
    std::vector<double> x, y;
    for (const double radius :
         {radii.lower, radii.lower * (1 + 1e-12), radii.upper * (1 - 1e-12), radii.upper}) {
      x.push_back(linkage.pole().x() + radius);
      y.push_back(linkage.pole().y());
    }
    poses_with_tracer_at(linkage, x, y, batch);
    const LinkLengths lengths = linkage.lengths();
    for (std::size_t row = 0; row < batch.size(); ++row) {
      const auto pose = batch[row];
      if (!pose) continue;  // rounded past a limit
      const double tolerance = 4e-14 * magnitude(*pose);
      const auto expect_length = [&](Joint a, Joint b, double length) {
        EXPECT_NEAR(((*pose)[a] - (*pose)[b]).norm(), length, tolerance) << i << letter(a) << letter(b);
      };
      expect_length(Joint::V, Joint::A, lengths.VA);
      expect_length(Joint::V, Joint::B, lengths.VB);
      expect_length(Joint::A, Joint::C, lengths.AC);
      expect_length(Joint::B, Joint::C, lengths.BC);
      expect_length(Joint::A, Joint::X, lengths.AX);
      expect_length(Joint::C, Joint::X, lengths.CX);
      expect_length(Joint::B, Joint::Y, lengths.BY);
      expect_length(Joint::C, Joint::Y, lengths.CY);
    }
  }
}

TEST(PoseBatch, AnUnreachableRowHoldsZerosAndItsReason) {
  const auto linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  const double nan = std::nan("");
  const std::vector<double> x{66, 80, 10, 30, 0, nan, 1e200}, y{0, 0, 0, 0, 0, 0, 0};
  PoseBatch batch;
  poses_with_tracer_at(linkage, x, y, batch);
  EXPECT_EQ(batch.reached(), 1u);
  EXPECT_TRUE(batch[0]);
  EXPECT_EQ(batch[1].error(), Unreachable::too_far);
  EXPECT_EQ(batch[2].error(), Unreachable::too_near);
  EXPECT_EQ(batch[3].error(), Unreachable::beyond_change_point);
  EXPECT_EQ(batch[4].error(), Unreachable::too_near);
  EXPECT_FALSE(batch[5]);
  EXPECT_EQ(batch[6].error(), Unreachable::too_far);
  for (std::size_t row = 1; row < batch.size(); ++row)
    for (const Joint joint : all_joints) {
      EXPECT_EQ(batch.x(joint)[row], 0);
      EXPECT_EQ(batch.y(joint)[row], 0);
    }
}

TEST(PoseBatch, TheBlocksEndsDoNotShow) {
  const auto linkage = *CopyingLinkage::make({0.3, 0.4}, Grounding::pen, 120, 70, 1, {5, -7});
  Random random(13);
  const Tracers tracers(random, linkage, 1000);
  PoseBatch whole, part;
  poses_with_tracer_at(linkage, tracers.x, tracers.y, whole);
  for (const std::size_t count : {0ul, 1ul, 2ul, 255ul, 256ul, 257ul, 999ul}) {
    poses_with_tracer_at(linkage, std::span(tracers.x).first(count), std::span(tracers.y).first(count), part);
    ASSERT_EQ(part.size(), count);
    for (std::size_t row = 0; row < count; ++row)
      for (const Joint joint : all_joints) {
        ASSERT_EQ(part.x(joint)[row], whole.x(joint)[row]);
        ASSERT_EQ(part.y(joint)[row], whole.y(joint)[row]);
      }
  }
}

}  // namespace
}  // namespace kempe
