// Laws of the copying linkage itself: the copy is similar, links keep their lengths, assembly modes never mix.
#include <array>

#include "tests/laws/law.hpp"

namespace kempe::laws {
namespace {

std::array<double, 8> distances(const Pose& z) {
  return {(z.A - z.V).norm(), (z.B - z.V).norm(), (z.C - z.A).norm(), (z.C - z.B).norm(),
          (z.X - z.A).norm(), (z.X - z.C).norm(), (z.Y - z.B).norm(), (z.Y - z.C).norm()};
}

LoopSides sides_of(const Pose& z) {
  return {side_of(cross(z.A - z.V, z.B - z.V)), side_of(cross(z.C - z.A, z.X - z.A)),
          side_of(cross(z.C - z.B, z.Y - z.B))};
}

/// Positions carry the rounding of the pole's place too.
double rounding(const CopyingLinkage& linkage) { return 1e-13 * (linkage.size() + linkage.pole().norm()); }

TEST(CopyingLaws, ThePenTracesTheSimilarImageForAnyRatioAndLengths) {
  law(5000, [] {
    const CopyingLinkage linkage = draw_linkage();
    const Pose pose = linkage.pose_at(draw_opening(linkage, 0), *angle());
    const Complex tracer = as_complex(pose[linkage.tracer_joint()] - linkage.pole());
    const Complex pen = as_complex(pose[linkage.pen_joint()] - linkage.pole());
    RC_ASSERT(std::abs(pen - linkage.k() * tracer) <= 20 * rounding(linkage));
  });
}

TEST(CopyingLaws, EveryLinkKeepsItsLengthsInEveryPose) {
  law(5000, [] {
    const CopyingLinkage linkage = draw_linkage();
    const auto seen = distances(linkage.pose_at(draw_opening(linkage, 0), *angle()));
    const auto wanted = linkage.lengths().values();
    for (std::size_t i = 0; i < seen.size(); ++i)
      RC_ASSERT(std::abs(seen[i] - wanted[i]) <= 20 * rounding(linkage));
  });
}

TEST(CopyingLaws, ThePoseOfATracerPlaceIsThePoseThatPutTheTracerThere) {
  law(5000, [] {
    const CopyingLinkage linkage = draw_linkage(20);
    const double opening = draw_opening(linkage), bearing = *angle();
    const auto pose = linkage.pose_with_tracer_at(linkage.tracer_at(opening, bearing));
    RC_ASSERT(pose.has_value());
    const Pose wanted = linkage.pose_at(opening, bearing);
    // The opening of a place is the worse conditioned the nearer the serial dead point is.
    const double weak = std::abs(linkage.radius_slope_at(opening)) / linkage.radius_at(opening);
    for (const Joint joint : all_joints)
      RC_ASSERT(((*pose)[joint] - wanted[joint]).norm() <= 1000 * rounding(linkage) * (1 + 1 / weak));
  });
}

TEST(CopyingLaws, AssembliesNeverMixWhereverTheTracerGoes) {
  law(2000, [] {
    const CopyingLinkage linkage = draw_linkage(20);
    for (int place = 0; place < 8; ++place) {
      const Point tracer = linkage.tracer_at(draw_opening(linkage), *between(-pi, pi));
      const auto pose = linkage.pose_with_tracer_at(tracer);
      RC_ASSERT(pose.has_value());
      LoopSides seen = sides_of(*pose);
      if (is_straight(linkage.shape())) seen.plate_ACX = seen.plate_BCY = Side::on_line;
      RC_ASSERT(seen == linkage.assembly_mode().sides);
    }
  });
}

TEST(CopyingLaws, APlaceReachedByTwoAssembliesIsReachedInTwoDifferentPoses) {
  law(2000, [] {
    const CopyingLinkage one = draw_linkage(20);
    const Point tracer = one.tracer_at(draw_opening(one, 0.05), *angle());
    for (const AssemblyMode& mode : assembly_modes(one.shape())) {
      if (mode == one.assembly_mode()) continue;
      const auto other =
          CopyingLinkage::make(one.k(), one.grounding(), one.VA(), one.VB(), mode.number, one.pole());
      RC_ASSERT(other.has_value());
      const auto pose = other->pose_with_tracer_at(tracer);
      if (!pose) continue;
      const auto mine = one.pose_with_tracer_at(tracer);
      RC_ASSERT(mine.has_value());
      double apart = 0;
      for (const Joint joint : all_joints) apart = std::max(apart, ((*pose)[joint] - (*mine)[joint]).norm());
      RC_ASSERT(apart > 1e-6 * one.size());
    }
  });
}

TEST(CopyingLaws, TheRadiusIsMonotoneOverAnAssembly) {
  law(3000, [] {
    const CopyingLinkage linkage = draw_linkage(20);
    double lower = draw_opening(linkage), upper = draw_opening(linkage);
    if (lower > upper) std::swap(lower, upper);
    const double change = linkage.radius_at(upper) - linkage.radius_at(lower);
    RC_ASSERT((linkage.radius_grows_with_opening() ? change : -change) >= -rounding(linkage));
  });
}

TEST(CopyingLaws, OnlyFiniteRatiosAndPositiveLengthsMakeALinkage) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  law(2000, [=] {
    const auto any = rc::gen::element(0.0, -0.0, 1.0, -1.0, 1e-320, 1e300, -1e300, inf, -inf, nan, 0.5, 7.0);
    const Complex k(*any, *any);
    const double VA = *any, VB = *any;
    const int assembly_mode = *whole(-2, 6);
    const auto made = CopyingLinkage::make(k, Grounding::tracer, VA, VB, assembly_mode);
    if (!made) return;
    RC_ASSERT(std::isfinite(k.real()) && std::isfinite(k.imag()) && k != Complex(0) && k != Complex(1));
    RC_ASSERT(std::isfinite(VA) && VA > 0 && std::isfinite(VB) && VB > 0 && assembly_mode >= 0 &&
              assembly_mode < 4);
  });
}

}  // namespace
}  // namespace kempe::laws
