// Sketches as a program uses them.
#include <gtest/gtest.h>

#include "kempe/kempe.hpp"

namespace kempe {
namespace {

Spec plagiograph() {
  Spec spec;
  spec.copy = Copy::of(1.4, 90 * degree);
  spec.region = Region::rectangle({62, -5}, {8, 10});
  return spec;
}

TEST(PublicSketch, FollowsAHandle) {
  const Outcome start = design(plagiograph());
  ASSERT_TRUE(start);
  Sketch last(*start);
  EXPECT_EQ(last.value(), *start->value());
  for (int step = 1; step <= 20; ++step) {
    Spec spec = plagiograph();
    spec.region = Region::rectangle({62 + 0.2 * step, -5}, {8, 10});
    last = sketch(spec, last);
    ASSERT_TRUE(last) << step;
    ASSERT_TRUE(last.proven_bound()) << step;
    EXPECT_LE(*last.proven_bound(), last.value() * (1 + 1e-9));
    EXPECT_GE(last.transmission_min(), spec.limits.transmission - 1e-7);
    for (const Point& corner : spec.region.polygons.front().outer) {
      const auto pose = last.pose_with_tracer_at(corner);
      ASSERT_TRUE(std::holds_alternative<Pose>(pose)) << step;
      const Pose& at = std::get<Pose>(pose);
      const Point pen = last.grounding() == Grounding::pen ? at.V : at.Y;
      EXPECT_LT((pen - 1.4 * Point(-corner.y(), corner.x())).norm(), 1e-9) << step;  // the pole is the origin
    }
  }
  const Outcome best = design([] {
    Spec spec = plagiograph();
    spec.region = Region::rectangle({66, -5}, {8, 10});
    return spec;
  }());
  ASSERT_TRUE(best);
  EXPECT_LE(last.value(), *best->value() * 1.02);
}

TEST(PublicSketch, TellsWhatIsWrongWithASpecAndGoesOn) {
  const Outcome start = design(plagiograph());
  ASSERT_TRUE(start);
  Spec wrong = plagiograph();
  wrong.links.layers = 0;
  const Sketch none = sketch(wrong, Sketch(*start));
  EXPECT_FALSE(none);
  ASSERT_TRUE(none.fault());
  EXPECT_EQ(none.fault()->key, "links.layers");
  EXPECT_TRUE(sketch(plagiograph(), none));
}

}  // namespace
}  // namespace kempe
