// Boxes that the proven bound throws away for an obstacle, a body or the table's edge, filled with random designs: each must really
// be hit.
#include "synthesis/bound/obstacles.hpp"

#include <gtest/gtest.h>

#include "geometry/region_reach.hpp"
#include "synthesis/bound/branch.hpp"
#include "synthesis/bound/contact.hpp"
#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/design/assemble.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "workspace/contact/clearance.hpp"

namespace kempe {
namespace {

Spec spec_with_obstacles(test::SpecDice& dice) {
  Spec spec = dice.spec();
  for (int i = 0; i < 3; ++i) spec.obstacles.push_back(dice.obstacle_beside(spec));
  return spec;
}

Spec spec_with_bodies(test::SpecDice& dice) {
  Spec spec = dice.spec();
  spec.links.layers = 4;
  if (dice.one_in(2)) spec.obstacles.push_back(dice.obstacle_beside(spec));
  spec.bodies.push_back(dice.body_beside(spec));
  if (dice.one_in(2)) spec.bodies.push_back(dice.body_beside(spec));
  if (dice.one_in(4)) spec.table = dice.table_about(spec);
  return spec;
}

/// The smallest gap over the region by the map's own clearance search, all that is in the way included; nothing if it is not reached.
std::optional<double> gap_over_region(const Spec& spec, const CopyingLinkage& linkage,
                                      const LayerAssignment& layers) {
  const MapTask task{.linkage = linkage,
                     .style = spec.links.style,
                     .layers = layers,
                     .limits = {.clearance = spec.limits.clearance, .transmission = 0},
                     .obstacles = spec.obstacles,
                     .bodies = spec.bodies,
                     .table = spec.table,
                     .region = spec.region};
  const auto figure = smallest_clearance(task);
  return figure ? std::optional(figure->gap) : std::nullopt;
}

bool keeps_transmission(const Spec& spec, const CopyingLinkage& linkage, const RegionReach& region) {
  const DistanceRange range = region.range(linkage.pole());
  return std::min(linkage.transmission_angle(*linkage.opening_at(range.nearest)),
                  linkage.transmission_angle(*linkage.opening_at(range.farthest))) >=
         spec.limits.transmission;
}

/// All of the region: a body may meet an obstacle with the tracer where a linkage does not get to.
bool reaches(const CopyingLinkage& linkage, const RegionReach& region) {
  const DistanceRange range = region.range(linkage.pole());
  return range.nearest > 0 && linkage.opening_at(range.nearest) && linkage.opening_at(range.farthest);
}

struct ThrownAway {
  int boxes = 0, designs = 0;
};

/// Random boxes of random specs, each with a look at designs of those that are thrown away.
template <typename MakeSpec>
ThrownAway look_into_boxes(test::SpecDice& dice, int specs, const std::vector<LayerAssignment>& layers,
                           const MakeSpec& make_spec) {
  int boxes_hit = 0, designs = 0;
  for (int i = 0; i < specs; ++i) {
    const Spec spec = make_spec(dice);
    const RegionReach region(spec.region);
    const Grounding grounding = all_groundings[static_cast<std::size_t>(i) % 3];
    const auto modes = assembly_modes(shape_of(spec.copy.k(), grounding));
    const AssemblyMode& mode = modes[static_cast<std::size_t>(i) % modes.size()];
    const bounding::Branch branch = bounding::make_branch(
        spec, grounding, mode, bounding::layer_candidates(spec.copy.k(), grounding, 2, {}, {}));
    const bounding::ObstacleTest test(spec, branch.mode, layers);
    for (int j = 0; j < 30; ++j) {
      const double t = dice.log_uniform(0.3, 3), w = dice.log_uniform(5e3, 5e5),
                   grow = std::exp(dice.uniform(0.0005, 0.04));
      const bounding::DesignBox box{{{t / grow, t * grow}, {w / grow, w * grow}},
                                    Point(dice.uniform(-20, 20), dice.uniform(-20, 20)),
                                    dice.uniform(0, 2)};
      bounding::Sight sight;
      const bounding::LayerSet left = test.not_hit(box, bounding::LayerSet::all(layers.size()), sight, false);
      std::vector<std::size_t> gone;
      for (std::size_t one = 0; one < layers.size(); ++one)
        if (!left.has(one)) gone.push_back(one);
      if (gone.empty()) continue;
      if (gone.size() > 3) gone = {gone.front(), gone[gone.size() / 2], gone.back()};
      ++boxes_hit;
      for (int n = 0; n < 12; ++n) {
        const double one_t = dice.log_uniform(box.lengths.t.lower, box.lengths.t.upper);
        const double one_w = dice.log_uniform(box.lengths.w.lower, box.lengths.w.upper);
        const Point pole =
            box.pole + box.radius * as_point(std::polar(dice.uniform(0, 1), dice.uniform(-pi, pi)));
        const auto linkage =
            CopyingLinkage::make(spec.copy.k(), grounding, std::sqrt(one_w / one_t / 2),
                                 std::sqrt(one_w * one_t / 2) * std::abs(branch.mode.s), mode.number, pole);
        if (!linkage || !reaches(*linkage, region) || !keeps_transmission(spec, *linkage, region)) continue;
        for (const std::size_t one : gone) {
          const auto gap = gap_over_region(spec, *linkage, layers[one]);
          if (!gap) continue;  // does not reach the region: no design either
          ++designs;
          EXPECT_LT(*gap, spec.limits.clearance) << "spec " << i << " box " << j;
        }
      }
    }
  }
  return {boxes_hit, designs};
}

/// Every seventh: high and low ones, with gaps and without.
std::vector<LayerAssignment> some_of_four_layers() {
  std::vector<LayerAssignment> layers;
  for (std::size_t i = 0; const LayerAssignment& each : layer_assignments(4))
    if (i++ % 7 == 0) layers.push_back(each);
  return layers;
}

TEST(ProvenBoundObstacles, EveryDesignOfABoxThatIsThrownAwayIsHit) {
  test::SpecDice dice(83);
  const ThrownAway seen =
      look_into_boxes(dice, test::samples(150), layer_assignments(2), spec_with_obstacles);
  EXPECT_GT(seen.boxes, test::expected(100));
  EXPECT_GT(seen.designs, test::expected(200));
}

TEST(ProvenBoundObstacles, EveryDesignOfABoxThatIsThrownAwayForABodyIsHit) {
  test::SpecDice dice(97);
  const ThrownAway seen = look_into_boxes(dice, test::samples(40), some_of_four_layers(), spec_with_bodies);
  EXPECT_GT(seen.boxes, test::expected(60));
  EXPECT_GT(seen.designs, test::expected(100));
}

std::array<Complex, 6> joints_of(const Pose& pose) {
  std::array<Complex, 6> joints;
  for (const Joint joint : all_joints) joints[static_cast<std::size_t>(joint)] = as_complex(pose[joint]);
  return joints;
}

TEST(ProvenBoundObstacles, NoJointOfADesignMovesFartherThanSaidWhileTheTracerGoesAbout) {
  test::SpecDice dice(106);
  Spec spec = dice.spec();
  spec.limits.copy_error.reset();
  int compared = 0, said = 0;
  double tightest = 0;
  for (int i = 0; i < test::samples(2000); ++i) {
    spec.copy = Copy::of(copy_ratio(dice.log_uniform(0.1, 10), dice.uniform(-pi, pi)));
    const Grounding grounding = all_groundings[static_cast<std::size_t>(i) % 3];
    const auto modes = assembly_modes(shape_of(spec.copy.k(), grounding));
    const AssemblyMode& mode = modes[static_cast<std::size_t>(i / 3) % modes.size()];
    const auto linkage =
        CopyingLinkage::make(spec.copy.k(), grounding, dice.log_uniform(30, 300), dice.log_uniform(30, 300),
                             mode.number, Point(dice.uniform(-50, 50), dice.uniform(-50, 50)));
    if (!linkage) continue;
    const bounding::JointMoving moving(bounding::make_branch(spec, grounding, mode, {}).mode);
    const double opening = dice.uniform(mode.openings.lower, mode.openings.upper);
    const Pose middle = linkage->pose_at(opening, dice.uniform(-pi, pi));
    const Point tracer = middle[linkage->tracer_joint()];
    const double radius = (tracer - linkage->pole()).norm() * std::pow(10, dice.uniform(-6, 0));
    for (const Joint from : {linkage->pole_joint(), linkage->tracer_joint(), linkage->pen_joint()}) {
      const bounding::JointMoves moves = moving.beside(linkage->VA(), joints_of(middle), radius, from);
      if (!(moves.front() < infinity)) continue;
      ++said;
      for (int n = 0; n < 12; ++n) {
        const double away = n < 6 ? radius : dice.uniform(0, radius);
        const Point to = tracer + away * as_point(std::polar(1.0, dice.uniform(-pi, pi)));
        const auto pose = linkage->pose_with_tracer_at(to);
        if (!pose) continue;
        for (const Joint joint : all_joints) {
          const double moved = (((*pose)[joint] - (*pose)[from]) - (middle[joint] - middle[from])).norm();
          const double most = moves[static_cast<std::size_t>(joint)];
          ASSERT_LE(moved, most * (1 + 1e-9) + 1e-9) << i;
          if (joint != from) tightest = std::max(tightest, moved / most);
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(said, test::expected(2000));
  EXPECT_GT(compared, test::expected(100'000));
  EXPECT_TRUE(test::shortened() || tightest > 0.9) << tightest;
}

/// With every one of the many places looked at.
bool is_clear_everywhere(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers,
                         const bounding::ObstacleScene& scene) {
  const Reach reach(spec.copy.k(), linkage.grounding(), linkage.assembly_mode().number);
  const JointRoles roles = roles_of(linkage.grounding());
  const auto terms = obstacle_terms(linkage, layers, spec.links.style, bounding::obstructions_of(spec));
  for (const Point& place : scene.many_places) {
    const PlacedJoints joints(reach, roles, {std::log(linkage.VA()), std::log(linkage.VB())}, linkage.pole(),
                              place);
    for (const ObstacleTerm& term : terms)
      if (obstacle_gap(term, scene.shapes[term.obstacle], joints, spec.limits.clearance) <
          spec.limits.clearance)
        return false;
  }
  return true;
}

template <typename MakeSpec>
std::array<int, 2> compare_clearness(test::SpecDice& dice, int specs,
                                     const std::vector<LayerAssignment>& layers, const MakeSpec& make_spec) {
  std::array<int, 2> hit_and_clear{};
  for (int i = 0; i < specs; ++i) {
    const Spec spec = make_spec(dice);
    const RegionReach region(spec.region);
    const auto scene = bounding::obstacle_scene(spec);
    const Grounding grounding = all_groundings[static_cast<std::size_t>(i) % 3];
    const auto modes = assembly_modes(shape_of(spec.copy.k(), grounding));
    const AssemblyMode& mode = modes[static_cast<std::size_t>(i / 3) % modes.size()];
    const bounding::ModeFacts facts = bounding::make_branch(spec, grounding, mode, {}).mode;
    for (int j = 0; j < 40; ++j) {
      const auto linkage =
          CopyingLinkage::make(spec.copy.k(), grounding, dice.log_uniform(60, 500), dice.log_uniform(60, 500),
                               mode.number, Point(dice.uniform(-40, 40), dice.uniform(-40, 40)));
      if (!linkage || !reaches(*linkage, region)) continue;
      const std::size_t one = static_cast<std::size_t>(j) % layers.size();
      bounding::ObstacleTest test(spec, facts, layers, scene, {});
      bounding::LayerSet left = bounding::LayerSet::all(layers.size());
      const bool is_clear = test.is_clear(linkage->VA(), linkage->VB(), linkage->pole(), one, {}, left);
      EXPECT_EQ(is_clear, is_clear_everywhere(spec, *linkage, layers[one], *scene)) << i << " " << j;
      ++hit_and_clear[is_clear ? 1 : 0];
    }
  }
  return hit_and_clear;
}

TEST(ProvenBoundObstacles, ADesignIsClearWhereItIsClearAtEachPlace) {
  test::SpecDice dice(107);
  const auto [hit, clear] =
      compare_clearness(dice, test::samples(100), layer_assignments(2), spec_with_obstacles);
  EXPECT_GT(hit, test::expected(50));
  EXPECT_GT(clear, test::expected(50));
}

TEST(ProvenBoundObstacles, ADesignWithBodiesIsClearWhereItIsClearAtEachPlace) {
  test::SpecDice dice(108);
  const auto [hit, clear] =
      compare_clearness(dice, test::samples(60), some_of_four_layers(), spec_with_bodies);
  EXPECT_GT(hit, test::expected(30));
  EXPECT_GT(clear, test::expected(10));
}

/// A pole free to stand behind the original, and a block beside one of the two sheets, so far away.
Spec spec_with_block(test::SpecDice& dice, bool at_the_copy, double away) {
  Spec spec;
  spec.copy = Copy::of(dice.uniform(0.3, 0.8), 0);
  spec.region = Region::rectangle({-60, 0}, {120, 80});
  spec.links.style = {.width = 15, .pin_diameter = 8, .thickness = 4};
  spec.limits.clearance = dice.uniform(0.2, 3);
  const Point pole(dice.uniform(-30, 30), dice.uniform(200, 300));
  if (at_the_copy)
    spec.pole.place = pole;
  else
    spec.pole.place = Region::rectangle({-100, 150}, {200, 150});
  const Region sheet = at_the_copy ? similar_image(spec.region, spec.copy.k(), pole) : spec.region;
  const Box box = bounding_box(sheet);
  const double height = 0.5 * (box.upper.y() - box.lower.y());
  const Region block = Region::rectangle({box.upper.x() + away, box.lower.y() + 0.5 * height}, {30, height});
  spec.obstacles.push_back({block.polygons.front(), 1, spec.links.layers, "block"});
  return spec;
}

/// True if the block may meet the other sheet too.
bool is_near_original(const Spec& spec) {
  const Box block = bounding_box(Region{{spec.obstacles.front().shape}}), sheet = bounding_box(spec.region);
  constexpr double near = 12;
  return ((block.lower - sheet.upper).array() < near).all() &&
         ((sheet.lower - block.upper).array() < near).all();
}

TEST(ProvenBoundObstacles, WhatTracerOrPenWouldMeetIsProvenAtOnce) {
  test::SpecDice dice(103);
  constexpr std::size_t boxes = 1000;
  int left_open = 0;
  for (int i = 0; i < test::samples(100); ++i) {
    const bool at_the_copy = dice.one_in(2);
    // Half of the width and 0.2 mm of clearance at least are 7.7 mm, half of it and 3 mm at most are 10.5.
    const auto near =
        proven_bound(spec_with_block(dice, at_the_copy, dice.uniform(-20, 7.6)), {.boxes = boxes});
    ASSERT_TRUE(near) << i;
    EXPECT_TRUE(near->no_design) << i << " at the copy " << at_the_copy;
    EXPECT_EQ(near->boxes, 0) << i;
    const Spec far = spec_with_block(dice, at_the_copy, dice.uniform(10.6, 30));
    if (at_the_copy && is_near_original(far)) continue;
    const auto open = proven_bound(far, {.boxes = boxes});
    ASSERT_TRUE(open) << i;
    EXPECT_FALSE(open->no_design) << i;
    ++left_open;
  }
  EXPECT_GT(left_open, test::expected(40));
}

TEST(ProvenBoundObstacles, APostAnywhereInOriginalOrCopyIsProvenAtOnce) {
  test::SpecDice dice(104);
  for (int i = 0; i < test::samples(100); ++i) {
    const bool at_the_copy = dice.one_in(2);
    Spec spec = spec_with_block(dice, at_the_copy, 0);
    Point at(dice.uniform(-60, 60), dice.uniform(0, 80));
    if (at_the_copy) {
      const Point pole = std::get<Point>(spec.pole.place);
      at = pole + as_point(spec.copy.k() * as_complex(at - pole));
    }
    spec.obstacles.front().shape = Region::circle(at, dice.uniform(1, 10)).polygons.front();
    const auto proven = proven_bound(spec, {.boxes = 1000});
    ASSERT_TRUE(proven) << i;
    EXPECT_TRUE(proven->no_design) << i << " at the copy " << at_the_copy;
    EXPECT_EQ(proven->boxes, 0) << i;
  }
}

/// The pole's area is too wide to say so of all of it, but not of a part of it.
TEST(ProvenBoundObstacles, ACopyOffTheTableIsProvenWhereverThePoleStands) {
  test::SpecDice dice(105);
  for (int i = 0; i < test::samples(20); ++i) {
    Spec spec;
    const double scale = dice.uniform(2, 4), half = 60, far = 140;
    spec.copy = Copy::of(scale);
    spec.region = Region{{{{{-40, 60}, {40, 60}, {40, far}, {-40, far}}, {}}}};
    spec.pole.place = Region{{{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, {}}}};
    const double pen = half + scale * (far - half);  // of the farthest corner, at least
    const double edge = pen - dice.uniform(0, 50);
    spec.table = Polygon{{{-900, -900}, {900, -900}, {900, edge}, {-900, edge}}, {}};
    spec.links.longest = 600;
    const auto proven = proven_bound(spec);
    ASSERT_TRUE(proven) << i;
    EXPECT_TRUE(proven->no_design) << i;
  }
}

struct Compared {
  int designs = 0, near = 0;
};

template <typename MakeSpec>
Compared compare_with_designs(test::SpecDice& dice, int specs, const MakeSpec& make_spec) {
  int compared = 0, near = 0;
  for (int i = 0; i < specs; ++i) {
    Spec spec = make_spec(dice);
    spec.pole.place = Point(Point::Zero());
    const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
    const auto bound = proven_bound(spec);
    if (!bound) {
      ADD_FAILURE() << i;
      continue;
    }
    if (const auto* found = std::get_if<FoundDesign>(&outcome)) {
      ++compared;
      EXPECT_FALSE(bound->no_design) << i;
      EXPECT_LE(bound->value, found->value) << i;
      near += bound->value > 0.99 * found->value;
    }
  }
  return {compared, near};
}

TEST(ProvenBoundObstacles, NoDesignIsBelowAndTheBoundIsNear) {
  test::SpecDice dice(89);
  const auto [compared, near] = compare_with_designs(dice, test::samples(20), spec_with_obstacles);
  EXPECT_GT(compared, test::expected(6));
  EXPECT_TRUE(test::shortened() || near > 0.9 * compared) << near << " of " << compared;
}

TEST(ProvenBoundObstacles, NoDesignWithBodiesIsBelowAndTheBoundIsNear) {
  test::SpecDice dice(101);
  const auto [compared, near] = compare_with_designs(dice, test::samples(10), spec_with_bodies);
  EXPECT_GT(compared, test::expected(2));
  EXPECT_TRUE(test::shortened() || near > 0.9 * compared) << near << " of " << compared;
}

}  // namespace
}  // namespace kempe
