// What the map allows for rounding, against joints computed with eleven bits more (long double).
#include "workspace/contact/contact_scene.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "tests/workspace/random_linkage.hpp"

namespace kempe {
namespace {

using test::Dice;
using Exact = std::complex<long double>;

/// The joints seen from the pole with the tracer at bearing 0, from the definition p, q, p + q, p + q/s, q + s p.
std::array<Exact, 6> exact_joints(const CopyingLinkage& linkage, double opening) {
  const Exact s(linkage.shape().real(), linkage.shape().imag());
  const Exact p(linkage.VA()), q = std::polar<long double>(linkage.VB(), opening);
  std::array<Exact, 6> at;
  const auto put = [&](Joint joint, Exact z) { at[static_cast<std::size_t>(joint)] = z; };
  put(Joint::V, 0);
  put(Joint::A, p);
  put(Joint::B, q);
  put(Joint::C, p + q);
  put(Joint::X, p + q / s);
  put(Joint::Y, q + s * p);
  const Exact ground = at[static_cast<std::size_t>(linkage.pole_joint())];
  const Exact tracer = at[static_cast<std::size_t>(linkage.tracer_joint())] - ground;
  for (Exact& z : at) z = (z - ground) * std::conj(tracer) / std::abs(tracer);
  return at;
}

TEST(ContactScene, ItsSlackHoldsTheRoundingOfJointsNearThePoleToo) {
  Dice dice(77);
  int near = 0;
  for (int i = 0; i < 3000; ++i) {
    const CopyingLinkage some = test::random_linkage(dice);
    // Bars VA and VB/|s| of nearly the same length let the tracer come near the pole.
    const double VB = some.VA() * std::abs(some.shape()) * (1 + std::pow(10, dice.between(-5, -1)));
    const CopyingLinkage linkage = *CopyingLinkage::make(some.k(), some.grounding(), some.VA(), VB,
                                                         some.assembly_mode().number, some.pole());
    const double limit = std::pow(10, dice.between(-4, -0.5));
    const OpeningInterval openings = linkage.openings_with_transmission(limit);
    if (openings.empty()) continue;
    MapTask task{.linkage = linkage,
                 .style = {10, 6, 4, PlateStyle::bent},
                 .layers = test::random_layers(dice),
                 .limits = {.clearance = 1, .transmission = limit}};
    const Point corner = linkage.pole() + Point(10, 10);
    const Ring square{corner, corner + Point(20, 0), corner + Point(20, 20), corner + Point(0, 20)};
    task.obstacles = {{.shape = {square, {}}, .lowest_layer = 1, .highest_layer = 4}};
    const ContactScene scene(task);
    if (scene.obstacles.empty()) continue;
    for (const double opening : {openings.lower, openings.upper, openings.middle()}) {
      const MovingJoints joints = scene.motion.over(opening, 0, 0, 0);
      const auto exact = exact_joints(linkage, opening);
      near += linkage.radius_at(opening) < 0.01 * linkage.size();
      for (std::size_t j = 0; j < 6; ++j)
        ASSERT_LE(std::abs(exact[j] - Exact(joints[j].at.x(), joints[j].at.y())), scene.obstacles[0].slack)
            << i << " joint " << j;
    }
  }
  EXPECT_GT(near, 500);
}

}  // namespace
}  // namespace kempe
