// Monte Carlo of instruments in their layers: made within their tolerances, with play, on their post, under load and weights. The general solver
// closes what is made; a frame in space (space_frame.hpp) says how it gives way and is lifted, the forces in its sections (section_forces.hpp)
// how it sinks by weight with every pin tilted within its play. The error budget holds them all, in the plane and down.
// The whole: KEMPE_SAMPLES=50 ... --gtest_filter='LayeredInstrument.*' (docs/trust.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "synthesis/loads/gravity.hpp"
#include "synthesis/verification/space_frame.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/loads/sag_case.hpp"
#include "tests/synthesis/loads/soft_case.hpp"

namespace kempe {
namespace {

using section_forces::Structure;
using soft_instrument::drawn_pen;
using soft_instrument::seen_sensitivities;
using soft_instrument::soft_case;
using soft_instrument::SoftCase;
using soft_instrument::worst_flaws;
using wrong_instruments::Flaws;

/// As in one plane, and in up to three layers, with a grip and things to carry, on a table that lies or is tilted.
SoftCase layered_case(wrong_instruments::Chance& chance) {
  SoftCase one = soft_case(chance);
  const auto assignments = layer_assignments(3);
  one.design.layers = assignments[chance.below(assignments.size())];
  Load& load = *one.design.load;
  load.grip = chance.uniform(4, 20);
  load.pen_mass = chance.one_in(2) ? chance.uniform(0, 0.5) : 0;
  load.tracer_mass = chance.one_in(2) ? chance.uniform(0, 0.3) : 0;
  load.tilt = chance.one_in(2) ? chance.uniform(0, 1.4) : 0;
  return one;
}

/// Where a made instrument has its joints.
Pose joints_of_made(const wrong_instruments::MadePose& made) {
  const auto& [VA, VB, ACX, BCY] = made.holes;
  return {.V = VA[0], .A = VA[1], .B = VB[1], .C = ACX[1], .X = ACX[2], .Y = BCY[2]};
}

/// How far the pen is off in the plane, and how far tracer and pen have sunk; mm.
struct Off {
  Point in_plane;
  Eigen::Vector2d down;
};

/// What one instrument suffers beside its flaws.
struct Suffered {
  Point force = Point::Zero();     ///< N, on the pen
  Point downhill = Point::Zero();  ///< along the table, of size 1: weights pull that way on a tilted one
  std::array<Eigen::Vector2d, 6>
      tilts{};  ///< rad, of the links on their pins, in the order of Structure::joins
};

class LayeredInstrument {
 public:
  LayeredInstrument(const SoftCase& one, const Flaws& flaws, const Point& tracer)
      : design_(one.design), roles_(roles_of(design_.linkage.grounding())) {
    const auto made = wrong_instruments::made_pose(design_.linkage, flaws, tracer);
    if (!made) throw std::runtime_error("it does not close");
    pose_ = joints_of_made(*made);
    off_ = pose_[roles_.pen] - drawn_pen(design_.linkage, tracer);
    const Material& stuff = *design_.material;
    const Load& load = *design_.load;
    const double for_each_mm3 = stuff.density * 1e-9, g = sag_case::gravity;
    frame_ = space_frame_response(pose_, roles_,
                                  {.straight = is_straight(design_.linkage.shape()),
                                   .style = design_.style,
                                   .layers = design_.layers,
                                   .E = stuff.E,
                                   .G = stuff.shear_modulus(),
                                   .link_pull = for_each_mm3 * g * std::sin(load.tilt)});
    sags_ = sag_case::structure_of({.k = design_.linkage.k(),
                                    .grounding = design_.linkage.grounding(),
                                    .conditions = {.style = design_.style,
                                                   .layers = design_.layers,
                                                   .E = stuff.E,
                                                   .G = stuff.shear_modulus(),
                                                   .density = stuff.density,
                                                   .pen_mass = load.pen_mass,
                                                   .tracer_mass = load.tracer_mass,
                                                   .tilt = load.tilt},
                                    .VA = design_.linkage.VA(),
                                    .VB = design_.linkage.VB(),
                                    .opening = 1});
    for (const Joint joint : all_joints)
      sags_.places[static_cast<std::size_t>(joint)] = as_complex(pose_[joint]);
  }

  std::size_t pins() const { return sags_.joins.size(); }
  const SpaceFrameResponse& frame() const { return frame_; }

  Off under(const Suffered& suffered) const {
    const Load& load = *design_.load;
    const Point force =
        suffered.force + load.pen_mass * sag_case::gravity * std::sin(load.tilt) * suffered.downhill;
    Structure sags = sags_;
    for (std::size_t i = 0; i < pins(); ++i) sags.joins[i].tilt = suffered.tilts[i];
    // With the pole at V both bars turn on the post: the second join is from bar to bar.
    if (roles_.pole == Joint::V) sags.joins[1].tilt -= suffered.tilts[0];
    const auto sunk = [&](Joint joint) {
      return section_forces::LeastEnergy(sags).drop(static_cast<int>(joint));
    };
    return {off_ + frame_.in_plane * force + frame_.in_plane_by_pull * suffered.downhill,
            Eigen::Vector2d(sunk(roles_.tracer), sunk(roles_.pen)) - frame_.rises * force -
                frame_.rises_by_pull * suffered.downhill};
  }

  /// Tilts of this size with which a point sinks most.
  std::array<Eigen::Vector2d, 6> worst_tilts(double size, int point) const {
    std::array<Eigen::Vector2d, 6> worst{};
    const double level = under({}).down[point];
    for (std::size_t i = 0; i < pins(); ++i) {
      Eigen::Vector2d slope;
      for (const int axis : {0, 1}) {
        Suffered suffered;
        suffered.tilts[i][axis] = 1;
        slope[axis] = under(suffered).down[point] - level;
      }
      if (slope.norm() > 0) worst[i] = size * slope.normalized();
    }
    return worst;
  }

 private:
  const Design& design_;
  JointRoles roles_;
  Pose pose_{};
  Point off_;
  SpaceFrameResponse frame_;
  Structure sags_;
};

/// The direction, of size 1, in which this moves the pen farthest along `way`.
Point farthest(const Eigen::Matrix2d& moves, const Point& way) {
  const Point slope = moves.transpose() * way;
  return slope.norm() > 0 ? Point(slope.normalized()) : Point(1, 0);
}

TEST(LayeredInstrument, TheBudgetHoldsEveryMadeAndLoadedOne) {
  constexpr int instruments = 20;
  wrong_instruments::Chance chance(54);
  Eigen::Vector2d random = Eigen::Vector2d::Zero(), worst = random;  // of the budget: in the plane, down
  int made = 0, designs = 0;
  for (int i = 0; i < test::samples(40); ++i) {
    SCOPED_TRACE(i);
    const SoftCase one = layered_case(chance);
    const Tolerance& tolerance = *one.design.tolerance;
    const Load& load = *one.design.load;
    const auto budget = error_budget(one.design);
    ASSERT_TRUE(budget);
    ASSERT_TRUE(budget->states_layers);
    ++designs;
    for (int n = 0; n < instruments; ++n) {
      const Point tracer = one.middle + one.half * Point(chance.uniform(-1, 1), chance.uniform(-1, 1));
      const double tilt = tolerance.play / *load.grip;
      Flaws flaws;
      Suffered suffered;
      const bool is_worst = n % 5 == 0;
      if (is_worst) {
        // Everything that can go one way goes it: the pen in the plane by turns with one of the two points down.
        const LayeredInstrument right(one, {}, tracer);
        const int point = static_cast<int>(chance.below(2));
        if (n % 10 == 0) {
          const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(right.frame().in_plane);
          const Point way = chance.sign() * axes.eigenvectors().col(1);
          suffered.force = load.pen_force * farthest(right.frame().in_plane, way);
          suffered.downhill = farthest(right.frame().in_plane_by_pull, way);
          const auto seen = seen_sensitivities(one, tracer);
          ASSERT_TRUE(seen);
          flaws = worst_flaws(*seen, tolerance, way);
        } else {
          const Point lifts = -right.frame().rises.row(point).transpose();
          suffered.force = load.pen_force * lifts.normalized();
          suffered.downhill = lifts.normalized();
        }
        suffered.tilts = right.worst_tilts(tilt, point);
      } else {
        for (double& length : flaws.length) length = tolerance.length * chance.sign();
        for (Point& pin : flaws.pin) pin = chance.in_disc(0.5 * tolerance.play);
        for (Eigen::Vector2d& each : suffered.tilts) each = chance.on_circle(tilt);
        suffered.force = chance.on_circle(load.pen_force);
        suffered.downhill = chance.on_circle(1);
      }
      const Off off = LayeredInstrument(one, flaws, tracer).under(suffered);
      ++made;
      const Eigen::Vector2d share(off.in_plane.norm() / budget->sum(true),
                                  off.down.maxCoeff() / budget->sum(false));
      Eigen::Vector2d& most = is_worst ? worst : random;
      most = most.cwiseMax(share);
      EXPECT_LT(share[0], 1) << n;
      EXPECT_LT(share[1], 1) << n;
    }
  }
  EXPECT_GT(worst.minCoeff(), test::shortened() ? 0 : 0.9);
  std::printf(
      "%d instruments of %d designs: of the budget in the plane random ones reach %.4g, the worst ones %.4g; "
      "down %.4g and %.4g\n",
      made, designs, random[0], worst[0], random[1], worst[1]);
}

}  // namespace
}  // namespace kempe
