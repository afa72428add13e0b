// What is written of the hand's force where there is none: at a dead point.
#include "reports/drawings/trace_forces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace kempe {
namespace {

TEST(TraceForces, SayWhereThePoseIsADeadPoint) {
  const auto linkage = *CopyingLinkage::make(-2, Grounding::pole, 60, 40, 0);
  const HandWork work(linkage, {.width = 12, .thickness = 4}, {}, {"steel", 200e3, 7850, 235},
                      {.pen_force = 10});
  Trace trace;
  const double middle = linkage.assembly_mode().openings.middle();
  trace.poses = {{0, {1, 2}, linkage.pose_at(middle, 0), {1, 0}}, {0, {3, 4}, linkage.pose_at(0, 0), {1, 0}}};
  trace.drawn.push_back({0, {{0, 0}, {1, 1}, {2, 2}}, false, {3, infinity, 5}});
  const std::string csv = forces_csv(trace, work);
  EXPECT_NE(csv.find("\n0,3,4,,,,,,,,,,,,\n"), std::string::npos) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), ','), 3 * 14);
  const HandForces forces = hand_forces(trace);
  EXPECT_EQ(forces.least, 3);
  EXPECT_EQ(forces.most, 5);
  EXPECT_EQ(forces.dead_points, 1U);
  EXPECT_FALSE(hand_forces(Trace()).any());
}

}  // namespace
}  // namespace kempe
