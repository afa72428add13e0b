#include "synthesis/loads/link_arms.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "kinematics/assembly_mode.hpp"

namespace kempe {

std::vector<LinkArm> arms_of(Link link, Complex shape) {
  const auto [joints, count] = joints_of(link);
  if (count == 2) return {{joints[0], joints[1]}};
  if (!is_straight(shape)) return {{joints[0], joints[1]}, {joints[0], joints[2]}};
  const double third = (link == Link::ACX ? 1.0 / shape : shape).real();
  std::array<std::pair<double, Joint>, 3> places{{{0, joints[0]}, {1, joints[1]}, {third, joints[2]}}};
  std::sort(places.begin(), places.end());
  return {{places[0].second, places[1].second}, {places[1].second, places[2].second}};
}

std::array<Joint, 2> ends_of(const std::vector<LinkArm>& arms) {
  const bool bent = arms.size() == 2 && arms.front().from == arms.back().from;
  return {bent ? arms.front().to : arms.front().from, arms.back().to};
}

}  // namespace kempe
