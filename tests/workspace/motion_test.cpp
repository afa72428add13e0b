// The bounds that the map's proofs stand on, against random motions.

#include <gtest/gtest.h>

#include "geometry/segment_distance.hpp"
#include "tests/workspace/random_linkage.hpp"
#include "workspace/contact/gap_bounds.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

using test::Dice;

struct Patch {
  double opening, half_opening, bearing, half_bearing;
};

Patch random_patch(Dice& dice, const OpeningInterval& all) {
  const double scale = std::pow(10, dice.between(-4, -0.3));
  const double half = std::min(scale * dice.between(0.1, 1), 0.49 * all.width());
  return {dice.between(all.lower + half, all.upper - half), half, dice.between(-pi, pi),
          scale * dice.between(0.1, 1)};
}

TEST(LinkageMotion, JointsStandWhereTheClosedFormPutsThem) {
  Dice dice(31);
  for (int i = 0; i < 500; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const OpeningInterval& all = linkage.assembly_mode().openings;
    const double opening = dice.between(all.lower, all.upper), bearing = dice.between(-pi, pi);
    const MovingJoints joints = LinkageMotion(linkage).over(opening, 0, bearing, 0);
    const Pose pose = linkage.pose_at(opening, bearing);
    for (const Joint joint : all_joints)
      EXPECT_LT((joints[static_cast<std::size_t>(joint)].at + linkage.pole() - pose[joint]).norm(), 1e-9)
          << letter(joint);
  }
}

TEST(LinkageMotion, VelocityIsTheDifferenceQuotient) {
  Dice dice(32);
  for (int i = 0; i < 300; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const OpeningInterval middle = shrink(linkage.assembly_mode().openings, 0.05);
    if (middle.empty()) continue;
    const double opening = dice.between(middle.lower, middle.upper), bearing = dice.between(-pi, pi),
                 h = 1e-6;
    const MovingJoints joints = LinkageMotion(linkage).over(opening, 0, bearing, 0);
    const Pose before = linkage.pose_at(opening - h, bearing), after = linkage.pose_at(opening + h, bearing);
    for (const Joint joint : all_joints) {
      const Point quotient = (after[joint] - before[joint]) / (2 * h);
      EXPECT_LT((joints[static_cast<std::size_t>(joint)].by_opening - quotient).norm(),
                1e-4 * (1 + quotient.norm()));
    }
  }
}

TEST(LinkageMotion, JointsStayWithinTheirBoundsAllOverTheRectangle) {
  Dice dice(33);
  for (int i = 0; i < 2000; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const Patch patch = random_patch(dice, linkage.assembly_mode().openings);
    const MovingJoints joints =
        LinkageMotion(linkage).over(patch.opening, patch.half_opening, patch.bearing, patch.half_bearing);
    for (int sample = 0; sample < 10; ++sample) {
      const double u = sample < 4 ? (sample & 1 ? 1 : -1) : dice.between(-1, 1);
      const double v = sample < 4 ? (sample & 2 ? 1 : -1) : dice.between(-1, 1);
      const Pose pose =
          linkage.pose_at(patch.opening + u * patch.half_opening, patch.bearing + v * patch.half_bearing);
      for (const Joint joint : all_joints) {
        const MovingJoint& moving = joints[static_cast<std::size_t>(joint)];
        const Point place = pose[joint] - linkage.pole();
        const Point turned(-moving.at.y(), moving.at.x());
        const Point linear =
            moving.at + u * patch.half_opening * moving.by_opening + v * patch.half_bearing * turned;
        EXPECT_LE((place - moving.at).norm(), moving.reach + 1e-9);
        EXPECT_LE((place - linear).norm(), moving.rest + 1e-9);
      }
    }
  }
}

TEST(LinkageMotion, SeenFromALinkJointsAndPlatesStayWithinTheirBoundsWhateverTheBearing) {
  Dice dice(35);
  for (int i = 0; i < 600; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const Patch patch = random_patch(dice, linkage.assembly_mode().openings);
    const Link link = all_links[static_cast<std::size_t>(dice.below(4))];
    const Link other = all_links[static_cast<std::size_t>(dice.below(4))];
    const Complex corner(dice.between(-60, 60), dice.between(-60, 60));
    const LinkageMotion motion(linkage, link, {point_on_link(corner, other, linkage)});
    const MovingJoints joints = motion.over(patch.opening, patch.half_opening, patch.bearing, 1);
    // A link's axes in a pose: from its end to the nearest of its other joints.
    const auto axis_of_link = [&](Link of, const Pose& pose) {
      const Joint end = has_joint(of, Joint::V) ? Joint::V : has_joint(of, Joint::X) ? Joint::X : Joint::Y;
      Complex near(1e300);
      for (const Joint joint : {Joint::A, Joint::B, Joint::C}) {
        const Complex way = as_complex(pose[joint] - pose[end]);
        if (has_joint(of, joint) && std::abs(way) < (1 - 1e-9) * std::abs(near)) near = way;
      }
      return std::pair(as_complex(pose[end]), near / std::abs(near));
    };
    for (int sample = 0; sample < 10; ++sample) {
      const double u = sample < 2 ? 2 * sample - 1 : dice.between(-1, 1);
      const Pose pose = linkage.pose_at(patch.opening + u * patch.half_opening, dice.between(-3, 3));
      const auto [origin, axis] = axis_of_link(link, pose);
      const auto [end, beside] = axis_of_link(other, pose);
      for (std::size_t number = 0; number <= all_joints.size(); ++number) {
        const Complex at =
            number < all_joints.size() ? as_complex(pose[all_joints[number]]) : end + beside * corner;
        const Point place = as_point((at - origin) * std::conj(axis));
        const MovingJoint& moving = joints.of(number);
        const Point linear = moving.at + u * patch.half_opening * moving.by_opening;
        EXPECT_LE((place - moving.at).norm(), moving.reach + 1e-9) << i << ' ' << number;
        EXPECT_LE((place - linear).norm(), moving.rest + 1e-9) << i << ' ' << number;
        EXPECT_LE(place.norm(), motion.farthest(number) + 1e-9);
      }
    }
  }
}

TEST(GapBounds, HoldTheDistanceAllOverTheRectangle) {
  Dice dice(34);
  for (int i = 0; i < 3000; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    const LinkStyle style = test::random_style(dice);
    const Patch patch = random_patch(dice, linkage.assembly_mode().openings);
    const Link link = all_links[static_cast<std::size_t>(dice.below(4))];
    const auto hulls = axis_of({Part::Kind::link, link}, linkage.shape(), style.plate);
    const JointHull& hull = hulls[static_cast<std::size_t>(dice.below(static_cast<int>(hulls.size())))];
    const Point somewhere = linkage.pose_at(patch.opening, patch.bearing)[hull.joints[0]] - linkage.pole();
    const auto near = [&] { return Point(somewhere + Point(dice.between(-40, 40), dice.between(-40, 40))); };
    const Point from_here = near();
    const EdgeTree::Edge edge{
        from_here, i % 2 == 0 ? near() : Point(from_here + Point(dice.between(-1, 1), dice.between(-1, 1)))};
    const MovingJoints joints =
        LinkageMotion(linkage).over(patch.opening, patch.half_opening, patch.bearing, patch.half_bearing);
    const MovingHull moving(joints, hull, {patch.half_opening, patch.half_bearing});
    const GapBounds bounds = bounds_to_edge(moving, edge);
    EXPECT_EQ(distance_to_edge(moving, edge), bounds.middle);
    const double below = bounds.middle + dice.between(-20, 20), from = below + dice.between(0, 10);
    const GapBounds looser = bounds_to_edge(moving, edge, {below, from});
    EXPECT_EQ(looser.upper < below, bounds.upper < below) << i;
    EXPECT_EQ(looser.lower >= from, bounds.lower >= from) << i;
    EXPECT_GE(looser.upper, bounds.upper) << i;
    EXPECT_LE(looser.lower, bounds.lower) << i;
    const Box box{edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to)};
    EXPECT_LE(distance_from_box(moving, box), bounds.middle + 1e-9);
    for (int sample = 0; sample < 10; ++sample) {
      const Pose pose = linkage.pose_at(patch.opening + patch.half_opening * dice.between(-1, 1),
                                        patch.bearing + patch.half_bearing * dice.between(-1, 1));
      Hull there{{}, hull.count};
      for (std::size_t corner = 0; corner < 3; ++corner)
        there.at[corner] = pose[hull.joints[corner]] - linkage.pole();
      const double here = distance(there, Hull{{edge.from, edge.to, edge.to}, 2});
      EXPECT_GE(here, bounds.lower - 1e-9) << i;
      EXPECT_LE(here, bounds.upper + 1e-9) << i;
    }
  }
}

TEST(GapBounds, CloseOnTheDistanceAsTheRectangleShrinks) {
  const CopyingLinkage linkage = *CopyingLinkage::make({0, 1.4}, Grounding::pole, 50, 35, 2);
  const JointHull hull{{Joint::A, Joint::X, Joint::X}, 2};
  for (const double half : {1e-2, 1e-3, 1e-4}) {
    const MovingJoints joints = LinkageMotion(linkage).over(0.8, half, 0.3, half);
    const GapBounds bounds = bounds_to_edge({joints, hull, {half, half}}, {{80, 10}, {80, 40}});
    EXPECT_LT(bounds.upper - bounds.lower, 400 * half);
  }
}

/// A plate that turns about the pole swings past a post with the side between two of its joints: it comes no nearer, to first order.
TEST(GapBounds, OfASideThatSwingsPastAreOfSecondOrder) {
  Dice dice(35);
  int sides = 0;
  double most = 0;
  for (int i = 0; i < 2000; ++i) {
    const CopyingLinkage linkage = test::random_linkage(dice);
    if (linkage.pole_joint() == Joint::V) continue;
    const OpeningInterval middle = shrink(linkage.assembly_mode().openings, 0.1);
    if (middle.empty()) continue;
    const double opening = dice.between(middle.lower, middle.upper), bearing = dice.between(-pi, pi);
    const Pose pose = linkage.pose_at(opening, bearing);
    const Joint one = linkage.pole_joint() == Joint::X ? Joint::A : Joint::B;
    const Point from = pose[one] - linkage.pole(), to = pose[Joint::C] - linkage.pole();
    const double share = nearest_share(Point::Zero(), from, to);
    const Point foot = from + share * (to - from);
    if (share < 0.1 || share > 0.9 || foot.norm() < 1) continue;
    const Point post = foot * (1 + dice.between(1, 10) / foot.norm()),
                along = 0.01 * (to - from).normalized();
    ++sides;
    for (const double half : {1e-2, 1e-3, 1e-4}) {
      const MovingJoints joints = LinkageMotion(linkage).over(opening, half, bearing, half);
      const MovingHull moving(joints, JointHull{{one, Joint::C, Joint::C}, 2}, {half, half});
      const GapBounds bounds = bounds_to_edge(moving, {post - along, post + along});
      most = std::max(most, (bounds.middle - bounds.lower) /
                                (moving.reach() * (half + moving.reach() / (post - foot).norm())));
    }
  }
  EXPECT_GT(sides, 50);
  EXPECT_LT(most, 10);
}

}  // namespace
}  // namespace kempe
