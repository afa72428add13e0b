// The closed forms of synthesis/loads/ and the frame of synthesis/verification/, which share no formula, on random linkages of all groundings.
// The whole: KEMPE_SAMPLES=10 ... --gtest_filter='Frame.*' (docs/trust.md).
#include "synthesis/verification/frame.hpp"

#include <gtest/gtest.h>

#include "geometry/chance.hpp"
#include "kinematics/assembly_mode.hpp"
#include "kinematics/copying_linkage.hpp"
#include "synthesis/loads/strength.hpp"
#include "tests/samples.hpp"

namespace kempe {
namespace {

TEST(Frame, AgreesWithTheClosedForms) {
  Chance chance(1);
  const Material steel{"steel", 200000, 7850, 235};
  double deflection = 0, pins = 0, hand = 0, stress = 0;
  for (int i = 0; i < test::samples(300);) {
    const bool straight = chance.share() < 0.33;
    const double rotation =
        straight ? (chance.share() < 0.5 ? 0 : pi) : chance.uniform(radians(10), radians(170));
    const Complex k = copy_ratio(std::exp(chance.uniform(-1.4, 1.4)), rotation);
    if (std::abs(k - 1.0) < 0.1) continue;
    const Grounding grounding = all_groundings[static_cast<std::size_t>(3 * chance.share())];
    const auto modes = assembly_modes(shape_of(k, grounding));
    const auto& mode = modes[static_cast<std::size_t>(static_cast<double>(modes.size()) * chance.share())];
    const double VA = chance.uniform(20, 400), VB = chance.uniform(20, 400);
    const auto linkage = CopyingLinkage::make(k, grounding, VA, VB, mode.number);
    if (!linkage || mode.openings.width() < 0.5) continue;
    ++i;
    const double opening = chance.uniform(mode.openings.lower + 0.2, mode.openings.upper - 0.2);
    const LinkStyle style{.width = chance.uniform(5, 30), .thickness = chance.uniform(2, 10)};
    const double hole = 0.4 * style.width;
    const FrameResponse frame =
        frame_response(linkage->pose_at(opening, chance.uniform(-pi, pi)), roles_of(grounding),
                       is_straight(linkage->shape()), style, steel, hole);
    const LoadErrorAt closed = LoadErrorProfile(k, grounding, style, steel, 1).at({VA, VB}, opening);
    const auto apart = [](double one, double other) { return std::abs(one - other) / other; };
    deflection = std::max(
        {deflection, apart(closed.worst, frame.worst), std::abs(closed.least - frame.least) / frame.worst});
    pins = std::max(pins, apart(pin_forces(k, grounding, opening).largest(), frame.pin_force));
    hand = std::max(hand, apart(hand_force(k), frame.hand_force));
    stress = std::max(
        stress, apart(link_stresses(k, grounding, style, hole, {VA, VB}, opening).largest(), frame.stress));
  }
  EXPECT_LT(deflection, 1e-6);
  EXPECT_LT(pins, 1e-6);
  EXPECT_LT(hand, 1e-6);
  EXPECT_LT(stress, 1e-6);
  RecordProperty("deflection", std::to_string(deflection));
  std::printf("largest relative differences: deflection %.2g, pins %.2g, hand %.2g, stress %.2g\n",
              deflection, pins, hand, stress);
}

}  // namespace
}  // namespace kempe
