#include "synthesis/bound/copy_gap.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/bound/slack.hpp"

namespace kempe::bounding {
CopyGap::CopyGap(const Spec& spec, const RegionReach& region)
    : region_(region), k_(spec.copy.k()), gap_(spec.limits.copy_gap),
      extent_(region.farthest(Point::Zero()).distance) {
  if (!gap_) return;
  constexpr std::size_t most = 24;
  const auto& edges = region.edges();
  for (std::size_t i = 0; i < edges.size(); i += 1 + edges.size() / most) places_.push_back(edges[i].from);
  places_.insert(places_.end(), region.hull().begin(),
                 region.hull().begin() + static_cast<std::ptrdiff_t>(std::min(most, region.hull().size())));
}

CopyGap::Verdict CopyGap::verdict(const Point& pole, double radius) const {
  if (!gap_) return Verdict::far_enough;
  const double coordinates = extent_ + pole.norm() + radius;
  const double rounding = slack::rounding * (*gap_ + (1 + std::abs(k_)) * coordinates);
  const double slack = std::abs(1.0 - k_) * radius + rounding;
  bool far_enough = true;
  for (const Point& place : places_) {
    const Complex from_pole = as_complex(place - pole);
    const Point image = pole + as_point(k_ * from_pole), source = pole + as_point(from_pole / k_);
    const double distance =
        std::min(region_.nearest(image).distance, std::abs(k_) * region_.nearest(source).distance);
    if (distance + slack < *gap_) return Verdict::too_near;
    far_enough = far_enough && distance - slack >= *gap_;
  }
  return far_enough ? Verdict::far_enough : Verdict::undecided;
}

}  // namespace kempe::bounding
