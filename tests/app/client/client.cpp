// What a program does that uses the installed library: one pose of the report's plagiograph.
#include <cstdio>

#include "kinematics/copying_linkage.hpp"

int main() {
  const auto linkage =
      kempe::CopyingLinkage::make(kempe::copy_ratio(1.4, kempe::pi / 2), kempe::Grounding::pole, 50, 35, 3);
  const auto pose = linkage->pose_with_tracer_at({70, 10});
  if (!pose) return 1;
  std::printf("pen at (%.3f, %.3f)\n", pose->Y.x(), pose->Y.y());
  return std::abs(pose->Y.x() + 14) < 1e-9 && std::abs(pose->Y.y() - 98) < 1e-9 ? 0 : 1;
}
