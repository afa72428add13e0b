// What is said of boxes of designs by contact or an obstruction together with the load error and the goal, against designs of the box.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/segment_distance.hpp"
#include "kinematics/links.hpp"
#include "synthesis/bound/contact.hpp"
#include "synthesis/bound/touch_figures.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/bound/design_in_a_box.hpp"

namespace kempe {
namespace {

using test::DesignAtDistances;
using test::DesignInABox;
using test::DesignInside;
using test::designs_in;
using test::given;
using test::LoadedBranch;
using test::Wanted;

/// A point between two joints of one link.
struct PointOfLink {
  explicit PointOfLink(test::SpecDice& dice) : share(dice.uniform(0, 1)) {
    link = all_links[static_cast<std::size_t>(dice.uniform(0, 4))];
    const LinkJoints of = joints_of(link);
    const auto first = static_cast<std::size_t>(dice.uniform(0, of.count));
    joints = {of.joints[first], of.joints[(first + 1) % static_cast<std::size_t>(of.count)]};
  }
  Point in(const Pose& pose) const { return (1 - share) * pose[joints[0]] + share * pose[joints[1]]; }
  bounding::MaterialPoint material(Complex s) const {
    const auto from = bounding::material_point(joints[0], s), to = bounding::material_point(joints[1], s);
    return {(1 - share) * from.of_a + share * to.of_a, (1 - share) * from.of_b + share * to.of_b};
  }

  Link link{};
  std::array<Joint, 2> joints{};
  double share;
};

std::optional<Pose> pose_at(const CopyingLinkage& linkage, const Point& place) {
  const auto pose = linkage.pose_with_tracer_at(place);
  return pose ? std::optional(*pose) : std::nullopt;
}

/// Two points of the linkage, which a design has at some distance.
struct Contact {
  Contact(const LoadedBranch& one, const DesignInABox& in, test::SpecDice& dice)
      : first(dice), second(dice), branch(one.branch), places(in.places) {
    using At = bounding::ContactTouch::At;
    touch.at = dice.one_in(3) ? At::psi : dice.one_in(2) ? At::near : At::far;
    const double near = psi_at(in.linkage, in.places.near), far = psi_at(in.linkage, in.places.far);
    touch.psi = dice.uniform(far, near);
    touch.first = first.material(one.branch.mode.s), touch.second = second.material(one.branch.mode.s);
  }

  double psi_at(const CopyingLinkage& linkage, const Point& place) const {
    return branch.psi_of(*linkage.opening_at((place - linkage.pole()).norm()));
  }
  /// Nothing for a design that need not come by.
  std::optional<double> distance_in(const CopyingLinkage& linkage) const {
    using At = bounding::ContactTouch::At;
    if (touch.at == At::psi &&
        (touch.psi < psi_at(linkage, places.far) || touch.psi > psi_at(linkage, places.near)))
      return std::nullopt;
    const auto pose = touch.at == At::psi ? std::optional(linkage.pose_at(branch.opening_of(touch.psi), 0))
                                          : pose_at(linkage, touch.at == At::near ? places.near : places.far);
    return pose ? std::optional((first.in(*pose) - second.in(*pose)).norm()) : std::nullopt;
  }

  PointOfLink first, second;
  const bounding::Branch& branch;
  bounding::ReachedPlaces places;
  bounding::ContactTouch touch;
};

/// A corner or edge of a link and one of an obstruction, about `needed` apart in a design.
struct Obstruction {
  Obstruction(const DesignInABox& in, double needed, test::SpecDice& dice) : part(dice) {
    const Point from_pole = (1 - share_) * in.places.near + share_ * in.places.far - in.pole;
    const double nearest = (in.places.near - in.pole).norm(), farthest = (in.places.far - in.pole).norm();
    touch.place = in.pole + dice.uniform(nearest, farthest) * from_pole.normalized();
    touch.corner_is_of_part = dice.one_in(2);
    touch.is_edge = !touch.corner_is_of_part || dice.one_in(2);
    touch.joints = part.joints;
    if (dice.one_in(4)) touch.seen_from = all_joints[static_cast<std::size_t>(dice.uniform(0, 6))];
    const auto pose = pose_at(in.linkage, touch.place);
    if (!pose) return;
    const Point from = place_of(touch.joints[0], *pose), to = place_of(touch.joints[1], *pose);
    if (touch.corner_is_of_part) {
      const Point away = as_point(std::polar(needed, dice.uniform(-pi, pi)));
      const Point across(-away.y(), away.x());
      touch.fixed = {as_complex(from + away - dice.uniform(2, 9) * across),
                     as_complex(from + away + dice.uniform(2, 9) * across)};
      if (!touch.is_edge) touch.fixed[0] = as_complex(from + away);
      touch.side = cross(across, -away) > 0 ? 1 : -1;
    } else {
      const Point along = (to - from).normalized(), across(-along.y(), along.x());
      touch.side = dice.one_in(2) ? 1 : -1;
      touch.fixed[0] = as_complex(from + dice.uniform(0.1, 0.9) * (to - from) + touch.side * needed * across);
    }
  }

  Point place_of(Joint joint, const Pose& pose) const {
    return touch.seen_from ? Point(pose[joint] - pose[*touch.seen_from]) : pose[joint];
  }
  std::optional<double> distance_in(const CopyingLinkage& linkage) const {
    const auto pose = pose_at(linkage, touch.place);
    if (!pose) return std::nullopt;
    const Point from = place_of(touch.joints[0], *pose), to = place_of(touch.joints[1], *pose);
    const Point one = as_point(touch.fixed[0]), other = as_point(touch.fixed[1]);
    if (!touch.corner_is_of_part) return distance(one, from, to);
    return touch.is_edge ? distance(from, one, other) : (from - one).norm();
  }
  /// True if the corner lies behind the edge.
  bool is_behind_in(const CopyingLinkage& linkage) const {
    const auto pose = pose_at(linkage, touch.place);
    const Point from = place_of(touch.joints[0], *pose), to = place_of(touch.joints[1], *pose);
    const Point one = as_point(touch.fixed[0]), other = as_point(touch.fixed[1]);
    const double left =
        touch.corner_is_of_part ? cross(other - one, from - one) : cross(to - from, one - from);
    return touch.is_edge && touch.side * left < 0;
  }

  PointOfLink part;
  bounding::ObstacleTouch touch;

 private:
  static constexpr double share_ = 0.4;
};

/// How often none is told, and how often there is something to say or some design for which it would be wrong.
struct Told {
  int none = 0, known = 0, with = 0;
};

/// Boxes round random designs about `wide` times as wide as they, and of each what is told without a touch, and by `asked(one, in, room)`: a
/// touch with the distance that designs miss or keep. `room`: a factor about 1.
template <typename Make>
Told tell(double least_width, double most_width, int samples, unsigned seed, const Make& make) {
  test::SpecDice dice(seed);
  Told told;
  for (int i = 0; i < samples; ++i) {
    LoadedBranch one = test::random_branch(dice);
    const DesignAtDistances design(one, dice);
    if (!design.linkage) continue;
    const double wide = dice.log_uniform(least_width, most_width);
    const DesignInABox in(one, design, wide, dice);
    const auto has = given(*in.profile, in.linkage, in.pole, in.places);
    if (!has) continue;
    const auto about = [&](double figure) { return figure * (1 + wide * dice.uniform(-0.6, 0.3)); };
    const Wanted wanted{has->load * (1 + wide * dice.uniform(-0.3, 0.6)), about(has->transmission),
                        about(has->size)};
    one.spec.limits.load_error = wanted.load;
    auto touching = make(one, in, dice);
    const auto distance = touching.distance_in(in.linkage);
    if (!distance || *distance < 1e-3) continue;
    touching.touch.needed = *distance * (1 + wide * dice.uniform(-0.3, 0.6));
    const bounding::LoadTrade trade(one.spec, one.branch.mode);
    const bounding::BoxTrade box(trade, in.places, in.box, {wanted.transmission, wanted.size});
    const bool has_none = box.none_better_without(touching.touch);
    told.none += has_none && !box.none_better();
    const auto is_better = [&](const CopyingLinkage& linkage, const test::Given& of, double room) {
      const auto apart = touching.distance_in(linkage);
      return apart && *apart * room >= touching.touch.needed && wanted.is_kept_by(of, room);
    };
    bool any = is_better(in.linkage, *has, 1), any_nearly = any;
    for (const DesignInside& other : designs_in(one, in, 100, dice)) {
      any = any || is_better(other.linkage, other.has, 1);
      any_nearly = any_nearly || is_better(other.linkage, other.has, 1 + 0.2 * wide);
    }
    EXPECT_FALSE(has_none && any) << i;
    told.with += any;
    told.known += !any_nearly && !box.none_better();
  }
  return told;
}

const auto contact = [](const LoadedBranch& one, const DesignInABox& in, test::SpecDice& dice) {
  return Contact(one, in, dice);
};
const auto obstruction = [](const LoadedBranch&, const DesignInABox& in, test::SpecDice& dice) {
  return Obstruction(in, dice.log_uniform(2, 30), dice);
};

/// What a figure is at least for a design of the box.
double least_for(const bounding::FirstOrder& figure, const bounding::BoxMiddle& middle, const Complex& s,
                 const CopyingLinkage& linkage) {
  const double a = linkage.VA(), b = linkage.VB() / std::abs(s);
  const auto steps = [&](double from_middle, const bounding::FirstOrder& coordinate, std::size_t i) {
    return middle.has_width(i) ? Interval(from_middle) / coordinate.along[i] : Interval(0);
  };
  const Interval sum = figure.middle + figure.off +
                       steps(std::log(b / a / middle.t), middle.log_t(), 0) * figure.along[0] +
                       steps(std::log(2 * a * b / middle.w), middle.log_w(), 1) * figure.along[1] +
                       steps(linkage.pole().x() - middle.pole.x(), middle.pole_x(), 2) * figure.along[2] +
                       steps(linkage.pole().y() - middle.pole.y(), middle.pole_y(), 3) * figure.along[3];
  return sum.inf();
}

/// How many figures were looked at. `missed(touching, linkage, share)`: what they are of, by the share of the distance needed that a
/// design has.
template <typename Make, typename FigureOf, typename Missed>
int look_at_figures(unsigned seed, const Make& make, const FigureOf& figure_of, const Missed& missed) {
  test::SpecDice dice(seed);
  int seen = 0;
  for (int i = 0; i < test::samples(4000); ++i) {
    const LoadedBranch one = test::random_branch(dice);
    const DesignAtDistances design(one, dice);
    if (!design.linkage) continue;
    const DesignInABox in(one, design, dice.log_uniform(1e-4, 0.5), dice);
    if (!given(*in.profile, in.linkage, in.pole, in.places)) continue;
    auto touching = make(one, in, dice);
    const auto distance = touching.distance_in(in.linkage);
    if (!distance || *distance < 1e-3) continue;
    touching.touch.needed = *distance * dice.uniform(0.5, 2);
    const OutwardRounding rounding;
    const bounding::BoxMiddle middle(one.branch.mode, in.box, in.places.rounding, 0);
    const auto figure = figure_of(middle, touching, in);
    if (!figure) continue;
    ++seen;
    std::vector<DesignInside> designs;
    {
      const NearestRounding nearest;
      designs = designs_in(one, in, 30, dice);
    }
    for (const DesignInside& each : designs) {
      const double least = least_for(*figure, middle, one.branch.mode.s, each.linkage);
      const NearestRounding nearest;
      const auto apart = touching.distance_in(each.linkage);
      if (!apart) continue;
      EXPECT_LE(least, missed(touching, each.linkage, *apart / touching.touch.needed) + 1e-9) << i;
    }
  }
  return seen;
}

TEST(TouchFigures, AreNowhereAboveWhatDesignsMiss) {
  const int contacts = look_at_figures(
      436, contact,
      [](const auto& middle, const Contact& touching, const DesignInABox& in) {
        return bounding::contact_figure(middle, touching.touch, in.places.near, in.places.far);
      },
      [](const Contact&, const CopyingLinkage&, double share) { return 1 - share * share; });
  EXPECT_GT(contacts, test::expected(1000));
  const int obstructions = look_at_figures(
      437, obstruction,
      [](const auto& middle, const Obstruction& touching, const DesignInABox&) {
        return bounding::obstacle_figure(middle, touching.touch);
      },
      [](const Obstruction& touching, const CopyingLinkage& linkage, double share) {
        return touching.is_behind_in(linkage) ? 1 + share : 1 - share;
      });
  EXPECT_GT(obstructions, test::expected(500));
}

TEST(TouchTrade, NoBoxWithABetterDesignIsSaidToHaveNone) {
  const Told by_contact = tell(1e-6, 0.3, test::samples(12000), 432, contact);
  EXPECT_GT(by_contact.none, test::expected(100));
  EXPECT_GT(by_contact.with, test::expected(500));
  const Told by_obstruction = tell(1e-6, 0.3, test::samples(12000), 433, obstruction);
  EXPECT_GT(by_obstruction.none, test::expected(100));
  EXPECT_GT(by_obstruction.with, test::expected(500));
}

/// Of small boxes, whose designs all miss something by a fifth of the width, that load error and goal alone do not tell.
TEST(TouchTrade, SmallBoxesWithoutABetterDesignAreTold) {
  const Told by_contact = tell(1e-4, 1e-4, test::samples(6000), 434, contact);
  EXPECT_GT(by_contact.known, test::expected(100));
  EXPECT_GT(by_contact.none, 0.7 * by_contact.known);
  const Told by_obstruction = tell(1e-4, 1e-4, test::samples(6000), 435, obstruction);
  EXPECT_GT(by_obstruction.known, test::expected(100));
  EXPECT_GT(by_obstruction.none, 0.7 * by_obstruction.known);
}

}  // namespace
}  // namespace kempe
