#include "synthesis/bound/copy_gap.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/segment_distance.hpp"
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

/// A place of the region that is near to `to`, as `nearest` tells in doubles: `to` itself, if it surely lies inside.
PlaceOnSegment CopyGap::place_near(const Point& to, const RegionReach::Nearest& nearest) const {
  if (-nearest.distance > slack::rounding * extent_) return exactly_at(to);
  const auto& edge = region_.edges()[nearest.edge];
  return {edge.from, edge.to, nearest_share(to, edge.from, edge.to)};
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
    const RegionReach::Nearest to_image = region_.nearest(image), to_source = region_.nearest(source);
    const double distance = std::min(to_image.distance, std::abs(k_) * to_source.distance);
    // No distance is below a gap of 0: there the image must lie inside, deeper than the pole's way can take off.
    if (distance < 0 && (copy_surely_inside(k_, place, region_, pole, radius) ||
                         copy_surely_inside(1.0 / k_, place, region_, pole, radius)))
      return Verdict::too_near;
    const auto too_near = [&](const PlaceOnSegment& copied, const PlaceOnSegment& other) {
      return copy_distance_at_most(k_, copied, other, pole, radius) < *gap_;
    };
    if (distance < *gap_ && (too_near(exactly_at(place), place_near(image, to_image)) ||
                             too_near(place_near(source, to_source), exactly_at(place))))
      return Verdict::too_near;
    far_enough = far_enough && distance - slack >= *gap_;
  }
  return far_enough ? Verdict::far_enough : Verdict::undecided;
}

}  // namespace kempe::bounding
