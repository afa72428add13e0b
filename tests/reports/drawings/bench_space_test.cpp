#include "reports/drawings/bench_space.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "tests/reports/sample_designs.hpp"
#include "workspace/footprint.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {
namespace {

/// Bodies on tracer and pen that keep their direction or turn: with the tracer at every corner of the region none leaves the box, and
/// those that keep their direction touch each side that they define.
TEST(BenchSpace, HoldsWhatBodiesSweep) {
  const Polygon slab{{{-5, -80}, {60, -80}, {60, 10}, {-5, 10}}, {}};
  for (const Carrier carrier : {Carrier::tracer, Carrier::pen})
    for (const bool turns : {false, true})
      for (const std::variant<Disc, Polygon>& shape :
           {std::variant<Disc, Polygon>(Disc{{20, 0}, 300}), std::variant<Disc, Polygon>(slab)}) {
        Design design = testing::plagiograph();
        const Joint joint = joint_of(carrier, design.linkage);
        Body body{.at = carrier, .shape = shape, .lowest_layer = 5, .highest_layer = 8};
        if (turns) body.turns_with = has_joint(Link::ACX, joint) ? Link::ACX : Link::BCY;
        design.footprint = footprint(design.linkage, design.style, design.region).outline;
        const Box without = *swept_box(design);
        design.bodies = {body};
        const Box swept = *swept_box(design);
        EXPECT_TRUE((swept.lower.array() <= without.lower.array()).all());
        EXPECT_TRUE((swept.upper.array() >= without.upper.array()).all());
        Box met = without;
        for (const Point& corner : design.region.polygons[0].outer) {
          const auto pose = design.linkage.pose_with_tracer_at(corner);
          ASSERT_TRUE(pose);
          const auto there = placed(body, design.linkage, *pose);
          const auto* disc = std::get_if<Disc>(&there);
          const Box box = disc != nullptr ? Box{disc->centre - Point::Constant(disc->radius),
                                                disc->centre + Point::Constant(disc->radius)}
                                          : bounding_box(Region{{std::get<Polygon>(there)}});
          met.lower = met.lower.cwiseMin(box.lower);
          met.upper = met.upper.cwiseMax(box.upper);
        }
        for (int i = 0; i < 2; ++i) {
          EXPECT_LE(swept.lower[i], met.lower[i] + 1e-9);
          EXPECT_GE(swept.upper[i], met.upper[i] - 1e-9);
          if (turns) continue;
          EXPECT_NEAR(swept.lower[i], met.lower[i], 1e-6);
          EXPECT_NEAR(swept.upper[i], met.upper[i], 1e-6);
        }
      }
}

}  // namespace
}  // namespace kempe
