// Links above empty layers: the search and the bound against random mechanisms in every tuple of layers, each judged by
// the map's own clearance search in the layers it is given.
#include <gtest/gtest.h>

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/verification/verification.hpp"
#include "tests/every_layers.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// A bar across the way from the pole to the region.
Obstacle bar_before(const Spec& spec, test::SpecDice& dice) {
  Point middle = Point::Zero();
  for (const Point& corner : spec.region.polygons[0].outer) middle += corner;
  middle /= static_cast<double>(spec.region.polygons[0].outer.size());
  const double share = dice.uniform(0.1, 0.5), length = dice.uniform(0.3, 2),
               thick = dice.uniform(0.01, 0.05);
  const Point across(-middle.y(), middle.x());
  const Point along = 0.5 * thick * middle, aside = 0.5 * length * across;
  const Point at = share * middle;
  return {
      {{at - along - aside, at + along - aside, at + along + aside, at - along + aside}, {}}, 1, 1, "bar"};
}

/// Bars and blocks of one or two layers beside and before the region, in three or four layers.
Spec spec_with_low_obstacles(test::SpecDice& dice) {
  Spec spec = dice.spec();
  spec.pole.place = Point(Point::Zero());
  spec.links.layers = dice.one_in(3) ? 4 : 3;
  const bool two = dice.one_in(2), three = dice.one_in(2);
  const int count = 1 + two + three;
  for (int i = 0; i < count; ++i) {
    Obstacle obstacle = i == 0 ? bar_before(spec, dice) : dice.obstacle_beside(spec);
    obstacle.lowest_layer = dice.one_in(4) ? 2 : 1;
    obstacle.highest_layer = dice.one_in(4) ? 2 : obstacle.lowest_layer;
    spec.obstacles.push_back(obstacle);
  }
  return spec;
}

bool reaches_with_transmission(const Spec& spec, const CopyingLinkage& linkage) {
  for (const double length : linkage.lengths().values())
    if (length < spec.links.shortest || length > spec.links.longest) return false;
  const auto needed = openings_over(linkage, spec.region);
  if (!needed) return false;
  for (int i = 0; i <= 40; ++i)
    if (linkage.transmission_angle(needed->lower + i / 40.0 * needed->width()) < spec.limits.transmission)
      return false;
  return true;
}

bool keeps_clearance(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers) {
  const auto needed = openings_over(linkage, spec.region);
  if (smallest_gap_over(linkage, spec.links.style, layers, *needed).gap < spec.limits.clearance) return false;
  const MapTask task{.linkage = linkage,
                     .style = spec.links.style,
                     .layers = layers,
                     .limits = spec.limits,
                     .obstacles = spec.obstacles,
                     .region = spec.region};
  const auto figure = smallest_clearance(task);
  return figure && figure->gap >= spec.limits.clearance;
}

Design given(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers) {
  Spec with_layers = spec;
  with_layers.mechanism = MechanismSpec{};
  with_layers.mechanism->layers = layers.of;
  MapOptions map;
  map.largest_sheets = false;
  return assemble_given(with_layers, linkage, map);
}

struct Rival {
  CopyingLinkage linkage;
  LayerAssignment layers;
};

/// The smallest of many random mechanisms that keep all limits in some tuple of layers.
std::optional<Rival> best_rival(const Spec& spec, const std::optional<FoundDesign>& found,
                                test::SpecDice& dice, int tries) {
  std::optional<Rival> best;
  const auto tuples = test::every_layers(spec.links.layers);
  for (int i = 0; i < tries; ++i) {
    const Grounding grounding = all_groundings[static_cast<std::size_t>(i) % 3];
    const int count = static_cast<int>(assembly_modes(shape_of(spec.copy.k(), grounding)).size());
    const int assembly_mode = i / 3 % count;
    double VA = dice.log_uniform(5, 2000);
    double VB = dice.log_uniform(5, 2000);
    if (found && i % 2 == 0) {
      VA = found->linkage.VA() * dice.log_uniform(0.7, 1.3);
      VB = found->linkage.VB() * dice.log_uniform(0.7, 1.3);
    }
    const auto linkage = CopyingLinkage::make(spec.copy.k(), grounding, VA, VB, assembly_mode, Point::Zero());
    if (!linkage || (best && linkage->size() >= best->linkage.size())) continue;
    if (!reaches_with_transmission(spec, *linkage)) continue;
    for (const LayerAssignment& layers : tuples)
      if (keeps_clearance(spec, *linkage, layers)) {
        best = Rival{*linkage, layers};
        break;
      }
  }
  return best;
}

TEST(LiftedLayers, NoRandomMechanismInAnyLayersIsBetter) {
  test::SpecDice dice(307);
  int compared = 0, lifted = 0;
  for (int i = 0; i < test::samples(12); ++i) {
    const Spec spec = spec_with_low_obstacles(dice);
    const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
    const auto* found = std::get_if<FoundDesign>(&outcome);
    const auto bound = proven_bound(spec);
    ASSERT_TRUE(bound);
    const auto rival = best_rival(spec, found ? std::optional(*found) : std::nullopt, dice, 1500);
    if (rival) {
      ASSERT_TRUE(found) << "spec " << i << ": a mechanism of " << rival->linkage.size() << " exists";
      EXPECT_FALSE(bound->no_design) << i;
      EXPECT_LE(bound->value, rival->linkage.size()) << i;
      EXPECT_LE(found->value, rival->linkage.size() * (1 + 1e-9)) << i;
    }
    if (!found) continue;
    EXPECT_FALSE(bound->no_design) << i;
    EXPECT_LE(bound->value, found->value * (1 + 1e-12)) << i;
    const Design design = given(spec, found->linkage, found->layers);
    EXPECT_TRUE(design.map.coverage.covered) << i << design.map.coverage.why_not;
    const Verification verified = verify(verification_task(design));
    EXPECT_TRUE(verified.holds) << i << verified.failure;
    compared += rival.has_value();
    lifted += !found->layers.is_stacked();
  }
  EXPECT_GT(compared, test::expected(8));
  EXPECT_GT(lifted, test::expected(0));
}

/// Two rails across everything the links could sweep, in layer 1: only links above pass.
Spec rails() {
  Spec spec;
  spec.copy = Copy::of(0.5, pi);
  spec.region.polygons = {{{{60, -30}, {120, -30}, {120, 30}, {60, 30}}, {}}};
  spec.pole.place = Point(Point::Zero());
  spec.links.style = {15, 6, 4, PlateStyle::bent};
  spec.links.layers = 3;
  spec.links.longest = 150;
  spec.limits.clearance = 1;
  spec.limits.transmission = radians(30);
  spec.obstacles = {{{{{6, -200}, {14, -200}, {14, 200}, {6, 200}}, {}}, 1, 1, "rail"},
                    {{{{-14, -200}, {-6, -200}, {-6, 200}, {-14, 200}}, {}}, 1, 1, "rail"}};
  return spec;
}

TEST(LiftedLayers, RailsCostNothingWhereTheLinksPassAbove) {
  Spec spec = rails();
  const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
  const auto* found = std::get_if<FoundDesign>(&outcome);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->layers.has_links_in(1));
  Spec free = spec;
  free.obstacles.clear();
  const SearchOutcome without = synthesize(free, {.diagnose = false});
  ASSERT_TRUE(std::get_if<FoundDesign>(&without));
  EXPECT_NEAR(found->value, std::get<FoundDesign>(without).value, 1e-6 * found->value);
  ASSERT_TRUE(found->proven_bound);
  EXPECT_LE(*found->proven_bound, found->value);
}

TEST(LiftedLayers, ASpareLayerMakesNothingWorse) {
  test::SpecDice dice(311);
  for (int i = 0; i < test::samples(12); ++i) {
    Spec spec = spec_with_low_obstacles(dice);
    std::optional<double> before;
    for (int layers = 2; layers <= 5; ++layers) {
      spec.links.layers = layers;
      const SearchOutcome outcome = synthesize(spec, {.diagnose = false});
      const auto* found = std::get_if<FoundDesign>(&outcome);
      if (before) {
        ASSERT_TRUE(found) << i << " in " << layers << " layers";
        EXPECT_LE(found->value, *before * (1 + 1e-6)) << i << " in " << layers << " layers";
      }
      if (found) before = found->value;
    }
  }
}

TEST(LiftedLayers, AGivenMechanismIsLiftedOverWhatStandsInItsWay) {
  const Spec spec = rails();
  const auto linkage =
      CopyingLinkage::make(spec.copy.k(), Grounding::pole, 37.692723253, 44.803065224, 0, Point::Zero());
  ASSERT_TRUE(linkage);
  MapOptions map;
  map.largest_sheets = false;
  const Design design = assemble_given(spec, *linkage, map);
  EXPECT_FALSE(design.layers.has_links_in(1));
  EXPECT_TRUE(design.map.coverage.covered) << design.map.coverage.why_not;
  ASSERT_FALSE(design.why_not_fewer_layers.empty());
  EXPECT_NE(design.why_not_fewer_layers[0].find("2 layers are not enough"), std::string::npos);
}

}  // namespace
}  // namespace kempe
