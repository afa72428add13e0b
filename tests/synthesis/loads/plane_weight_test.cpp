// The links' own weight along a tilted table: the closed form against the plane frame and the frame in space of synthesis/verification/, which
// share no formula with it, and laws.
// The whole: KEMPE_SAMPLES=10 ... --gtest_filter='PlaneWeight.*' (docs/trust.md).
#include "synthesis/loads/plane_weight.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "geometry/chance.hpp"
#include "kinematics/assembly_mode.hpp"
#include "kinematics/copying_linkage.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/hand_work.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/link_arms.hpp"
#include "synthesis/loads/moving_masses.hpp"
#include "synthesis/verification/frame.hpp"
#include "synthesis/verification/space_frame.hpp"
#include "tests/samples.hpp"
#include "workspace/contact/layer_demands.hpp"

namespace kempe {
namespace {

struct WeighedCase {
  CopyingLinkage linkage;
  LinkStyle style;
  Material material;
  double tilt, opening, hole;
  BarLengths lengths() const { return {linkage.VA(), linkage.VB()}; }
  bool straight() const { return is_straight(linkage.shape()); }
  double pull() const { return standard_gravity * std::sin(tilt) * material.density * 1e-9; }
  PlaneWeight weight() const { return {linkage.k(), linkage.grounding(), style, material, tilt}; }
};

/// Of any grounding, straight, bent or with triangles, away from change points and dead points.
WeighedCase random_weighed(Chance& chance) {
  for (;;) {
    const bool straight = chance.share() < 0.33;
    const double rotation =
        straight ? (chance.share() < 0.5 ? 0 : pi) : chance.uniform(radians(10), radians(170));
    const Complex k = copy_ratio(std::exp(chance.uniform(-1.4, 1.4)), rotation);
    if (std::abs(k - 1.0) < 0.1) continue;
    const Grounding grounding = all_groundings[static_cast<std::size_t>(3 * chance.share())];
    const auto modes = assembly_modes(shape_of(k, grounding));
    const auto& mode = modes[static_cast<std::size_t>(static_cast<double>(modes.size()) * chance.share())];
    const auto linkage =
        CopyingLinkage::make(k, grounding, chance.uniform(20, 400), chance.uniform(20, 400), mode.number);
    if (!linkage || mode.openings.width() < 0.5) continue;
    WeighedCase one{*linkage,
                    {},
                    {"some", std::exp(chance.uniform(7, 12)), chance.uniform(500, 9000), 100},
                    chance.uniform(0.05, pi / 2),
                    chance.uniform(mode.openings.lower + 0.2, mode.openings.upper - 0.2),
                    0};
    one.style = {.width = chance.uniform(5, 30), .thickness = chance.uniform(2, 10)};
    one.style.plate = chance.share() < 0.3 ? PlateStyle::triangle : PlateStyle::bent;
    one.hole = 0.4 * one.style.width;
    return one;
  }
}

double apart(double one, double other) { return std::abs(one - other) / other; }

TEST(PlaneWeight, AgreesWithThePlaneFrame) {
  Chance chance(71);
  double most = 0, moved = 0, pins = 0, stress = 0;
  for (int i = 0; i < test::samples(400); ++i) {
    SCOPED_TRACE(i);
    const WeighedCase one = random_weighed(chance);
    const Pose pose = one.linkage.pose_at(one.opening, chance.uniform(-pi, pi));
    const FrameUnderWeight frame = frame_under_weight(pose, roles_of(one.linkage.grounding()), one.straight(),
                                                      one.style, one.material, one.hole, one.pull());
    const PlaneWeight closed = one.weight();
    most = std::max(most, apart(closed.most(one.lengths(), one.opening), frame.most));
    // Any direction of gravity, on the table.
    const Complex along = as_complex((pose.A - pose.V).normalized()),
                  gravity = std::polar(1.0, chance.uniform(-pi, pi));
    const Point here = closed.give(one.lengths(), one.opening) * as_point(std::conj(along) * gravity);
    moved = std::max(
        moved,
        std::abs(along * as_complex(here) - as_complex(Point(frame.moved * as_point(gravity)))) / frame.most);
    const PinForces forces = closed.pin_forces(one.lengths(), one.opening);
    const std::array<double, 4> stated{forces.A, forces.B, forces.C, forces.pole};
    const double largest = *std::max_element(frame.pins.begin(), frame.pins.end());
    for (std::size_t pin = 0; pin < stated.size(); ++pin)
      pins = std::max(pins, std::abs(stated[pin] - frame.pins[pin]) / largest);
    const LinkStresses stresses = closed.stresses(one.lengths(), one.opening, one.hole);
    const std::array<double, 4> links{stresses.VA, stresses.VB, stresses.ACX, stresses.BCY};
    for (std::size_t link = 0; link < links.size(); ++link)
      stress = std::max(stress, apart(links[link], frame.stresses[link]));
  }
  EXPECT_LT(most, 1e-6);
  EXPECT_LT(moved, 1e-6);
  EXPECT_LT(pins, 1e-6);
  EXPECT_LT(stress, 1e-4);  // either search may miss a top between the directions that it looks at
  std::printf("largest relative differences: most %.2g, in one direction %.2g, pins %.2g, stress %.2g\n",
              most, moved, pins, stress);
}

/// What a hand sees whose instrument weighs something, beside one that weighs nothing.
TEST(PlaneWeight, LetsThePenOfATracedDrawingDownhill) {
  Chance chance(78);
  double apart = 0;
  for (int i = 0; i < test::samples(100); ++i) {
    SCOPED_TRACE(i);
    const WeighedCase one = random_weighed(chance);
    const Pose pose = one.linkage.pose_at(one.opening, chance.uniform(-pi, pi));
    const Material weightless{"", one.material.E, 0, 0};
    const Load load{.pen_force = 1, .tilt = one.tilt};
    const auto heavy = HandWork(one.linkage, one.style, {}, one.material, load).at(pose, {1, 0}),
               light = HandWork(one.linkage, one.style, {}, weightless, load).at(pose, {1, 0});
    ASSERT_TRUE(heavy && light);
    const FrameUnderWeight frame = frame_under_weight(pose, roles_of(one.linkage.grounding()), one.straight(),
                                                      one.style, one.material, one.hole, one.pull());
    apart = std::max(apart, (heavy->give - light->give + frame.moved * Point(0, 1)).norm() /
                                (light->give.norm() + frame.most));
  }
  EXPECT_LT(apart, 1e-6);
}

/// Straight and bent links with half discs at their ends.
double weight_of(const WeighedCase& one, Link link) {
  const Pose pose = one.linkage.pose_at(one.opening, 0);
  double area = pi * one.style.width * one.style.width / 4;
  for (const LinkArm& arm : arms_of(link, one.linkage.shape()))
    area += one.style.width * (pose[arm.to] - pose[arm.from]).norm();
  return area * one.style.thickness * one.pull();
}

/// Every plate is at rest under its pins, the hand or the pen at its end and its weight; and so is the whole. The hand's force comes from the
/// ratio and from the slope of the potential.
TEST(PlaneWeight, PinsHoldEveryPlateWhileTheHandDraws) {
  Chance chance(80);
  double level = 0, plates = 0;
  for (int i = 0; i < test::samples(400); ++i) {
    SCOPED_TRACE(i);
    WeighedCase one = random_weighed(chance);
    one.style.plate = PlateStyle::bent;
    const Pose pose = one.linkage.pose_at(one.opening, chance.uniform(-pi, pi));
    const Point heading = as_point(std::polar(1.0, chance.uniform(-pi, pi)));
    Load load{.pen_force = chance.uniform(0, 50), .tilt = one.tilt};
    const auto drawn = HandWork(one.linkage, one.style, {}, one.material, load).at(pose, heading);
    ASSERT_TRUE(drawn);
    const Complex pen = as_complex(drawn->pen_force),
                  hand = as_complex(drawn->hand - drawn->friction * heading);
    const auto down = [&](Link link) { return Complex(0, -weight_of(one, link)); };
    const auto from_outside = [&](Joint joint) {
      const JointRoles roles = roles_of(one.linkage.grounding());
      return joint == roles.pen ? pen : joint == roles.tracer ? hand : drawn->pins.post;
    };
    const PinPulls& by = drawn->pins;
    const Complex all = down(Link::VA) + down(Link::VB) + down(Link::ACX) + down(Link::BCY);
    const double size = std::abs(by.A) + std::abs(by.B) + std::abs(by.C) + std::abs(by.post);
    for (const Complex rest :
         {by.C - by.A + from_outside(Joint::X) + down(Link::ACX),
          -by.C - by.B + from_outside(Joint::Y) + down(Link::BCY), by.B + by.V + down(Link::VB),
          by.A + by.VA_at_V + down(Link::VA), pen + hand + by.post + all})
      plates = std::max(plates, std::abs(rest) / size);
    load.tilt = 0;
    const auto flat = HandWork(one.linkage, one.style, {}, one.material, load).at(pose, heading);
    const PinLoads known = pin_loads(one.linkage, pose, flat->pen_force);
    const PinFriction rubbing(load.friction, one.style, {});
    const double lost = friction_loss(one.linkage, pose, flat->pen_force, heading, rubbing);
    EXPECT_NEAR(flat->friction, lost, 1e-9 * (1 + lost));
    for (const auto& [pull, stated] : {std::pair(flat->pins.A, known.A), std::pair(flat->pins.B, known.B),
                                       std::pair(flat->pins.C, known.C), std::pair(flat->pins.V, known.V)})
      level = std::max(level, std::abs(std::abs(pull) - stated) / (1e-9 + load.pen_force));
  }
  EXPECT_LT(plates, 1e-10);
  EXPECT_LT(level, 1e-8);
  std::printf("largest shares left over: plates %.2g, pins on a level table %.2g\n", plates, level);
}

/// A frame in space with bar VA along x, of links in three layers.
TEST(PlaneWeight, AgreesWithAFrameInSpaceWherePinsAndLayersGive) {
  Chance chance(72);
  double give = 0, rise = 0, stress = 0, drawn = 0, part = 0;
  const auto assignments = layer_assignments(3);
  for (int i = 0; i < test::samples(200); ++i) {
    SCOPED_TRACE(i);
    WeighedCase one = random_weighed(chance);
    one.style.pin_diameter = chance.uniform(4, 9);
    const CopyingLinkage& linkage = one.linkage;
    const double opening = one.opening;
    SagConditions made{
        .style = one.style,
        .layers =
            assignments[static_cast<std::size_t>(static_cast<double>(assignments.size()) * chance.share())],
        .E = one.material.E,
        .G = one.material.E / 2.5,
        .density = one.material.density,
        .tilt = one.tilt,
        .grip = 5};
    made.tracer_rests = i % 3 == 1;
    made.pen_rests = i % 5 == 1;
    const Point VA = linkage.pose_at(opening, 0).A - linkage.pose_at(opening, 0).V;
    const SpaceFrameResponse frame = space_frame_response(
        linkage.pose_at(opening, -std::atan2(VA.y(), VA.x())), roles_of(linkage.grounding()),
        {.straight = one.straight(),
         .style = one.style,
         .layers = made.layers,
         .E = made.E,
         .G = made.G,
         .link_pull = one.pull()});
    const MostByPull seen = most_by_pull(
        frame, {.tracer_rests = made.tracer_rests, .pen_rests = made.pen_rests}, one.style, one.hole);
    const LayeredErrorProfile profile(linkage.k(), linkage.grounding(), made, 1);
    const LayeredErrorAt stated = profile.by_weight(one.lengths(), opening);
    give = std::max(give, apart(stated.in_plane, seen.give));
    rise = std::max(rise, std::abs(stated.rise - seen.rise) / std::max(seen.rise, 1e-3 * seen.give));
    const LinkStresses stresses = profile.stresses_by_weight(one.lengths(), opening, one.hole);
    const std::array<double, 4> links{stresses.VA, stresses.VB, stresses.ACX, stresses.BCY};
    for (std::size_t link = 0; link < links.size(); ++link)
      stress = std::max(stress, apart(links[link], seen.stress[link]));
    part = std::max(part, stated.in_plane / one.weight().most(one.lengths(), opening) - 1);
    if (made.tracer_rests || made.pen_rests) continue;
    const Point direction = as_point(std::polar(1.0, chance.uniform(-pi, pi)));
    drawn = std::max(drawn, (profile.give_by_weight(one.lengths(), opening, direction) -
                             frame.in_plane_by_pull * direction)
                                    .norm() /
                                seen.give);
  }
  EXPECT_LT(give, 1e-6);
  EXPECT_LT(rise, 1e-6);
  EXPECT_LT(stress, 1e-4);  // either search may miss a top between the directions that it looks at
  EXPECT_LT(drawn, 1e-6);
  EXPECT_GT(part, 0.05);
  std::printf(
      "largest relative differences: in the plane %.2g, rise %.2g, stress %.2g, in one direction %.2g; pins "
      "and layers add up to %.3g of the links\n",
      give, rise, stress, drawn, part);
}

/// Of all turns none moves the pen by more, and one by as much.
TEST(PlaneWeight, IsTheMostOverAllTurns) {
  Chance chance(73);
  for (int i = 0; i < test::samples(50); ++i) {
    const WeighedCase one = random_weighed(chance);
    const Eigen::Matrix2d give = one.weight().give(one.lengths(), one.opening);
    double most = 0;
    for (int turn = 0; turn < 3600; ++turn)
      most = std::max(most, (give * as_point(std::polar(1.0, turn * pi / 1800))).norm());
    const double stated = one.weight().most(one.lengths(), one.opening);
    EXPECT_LE(most, stated * (1 + 1e-12));
    EXPECT_GT(most, stated * (1 - 1e-5));
  }
}

/// The hand holds the slope of the links' potential (moving_masses.hpp), which knows no force in a link.
TEST(PlaneWeight, TheHandHoldsTheSlopeOfThePotential) {
  Chance chance(74);
  for (int i = 0; i < test::samples(200); ++i) {
    SCOPED_TRACE(i);
    WeighedCase one = random_weighed(chance);
    if (one.style.plate == PlateStyle::triangle) continue;
    const Pose pose = one.linkage.pose_at(one.opening, chance.uniform(-pi, pi));
    const auto points = mass_points(one.linkage, {one.style, one.material.density, 0, 0});
    const auto slope = hand_force_of_weight(one.linkage, mass_moments(one.linkage, points), pose, one.tilt);
    ASSERT_TRUE(slope);
    const Complex along = as_complex((pose.A - pose.V).normalized());
    const Complex hand =
        along * one.weight().under(one.lengths(), one.opening, std::conj(along) * Complex(0, -1)).hand;
    EXPECT_LT(std::abs(hand - as_complex(*slope)), 1e-9 * (1 + slope->norm()));
  }
}

TEST(PlaneWeight, GrowsWithDensityAndWithTheSquareOfTheSize) {
  Chance chance(75);
  for (int i = 0; i < test::samples(100); ++i) {
    const WeighedCase one = random_weighed(chance);
    const double most = one.weight().most(one.lengths(), one.opening);
    WeighedCase denser = one;
    denser.material.density *= 2;
    EXPECT_NEAR(denser.weight().most(one.lengths(), one.opening), 2 * most, 1e-12 * most);
    WeighedCase upright = one;
    upright.tilt = pi / 2;
    EXPECT_NEAR(upright.weight().most(one.lengths(), one.opening) * std::sin(one.tilt), most, 1e-12 * most);
    // Lengths, widths and thicknesses twice as large: eight times the weight on links that are twice as stiff.
    WeighedCase larger = one;
    larger.style.width *= 2;
    larger.style.thickness *= 2;
    const BarLengths twice{2 * one.linkage.VA(), 2 * one.linkage.VB()};
    EXPECT_NEAR(larger.weight().most(twice, one.opening), 4 * most, 1e-9 * most);
    // Thicker links are as much stiffer as they are heavier.
    WeighedCase thicker = one;
    thicker.style.thickness *= 3;
    EXPECT_NEAR(thicker.weight().most(one.lengths(), one.opening), most, 1e-9 * most);
  }
}

/// Slender links bend far more than they stretch, and by the fourth power of their length.
TEST(PlaneWeight, OfSlenderLinksGrowsWithTheFourthPowerOfTheLength) {
  const Complex k = copy_ratio(0.5, radians(90));
  const Material steel{"steel", 200000, 7850, 235};
  const LinkStyle style{.width = 1, .thickness = 1};
  const PlaneWeight weight(k, Grounding::pole, style, steel, pi / 2);
  const double opening = radians(60);
  EXPECT_NEAR(weight.most({4000, 3000}, opening) / weight.most({2000, 1500}, opening), 16, 0.02);
}

TEST(PlaneWeight, IsNothingOnALevelTable) {
  Chance chance(76);
  WeighedCase one = random_weighed(chance);
  one.tilt = 0;
  EXPECT_FALSE(one.weight().weighs());
  EXPECT_EQ(one.weight().most(one.lengths(), one.opening), 0);
  EXPECT_EQ(one.weight().pin_forces(one.lengths(), one.opening).largest(), 0);
  EXPECT_EQ(one.weight().stresses(one.lengths(), one.opening, one.hole).largest(), 0);
}

TEST(PlaneWeight, IsTheSameInTheMirror) {
  Chance chance(77);
  for (int i = 0; i < test::samples(100); ++i) {
    const WeighedCase one = random_weighed(chance);
    const PlaneWeight mirrored(std::conj(one.linkage.k()), one.linkage.grounding(), one.style, one.material,
                               one.tilt);
    const double most = one.weight().most(one.lengths(), one.opening);
    EXPECT_NEAR(mirrored.most(one.lengths(), -one.opening), most, 1e-12 * most);
  }
}

}  // namespace
}  // namespace kempe
