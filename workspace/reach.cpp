#include "workspace/reach.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/slack.hpp"

namespace kempe {

namespace {

/// The opening at a distance within the reach; at an end of the reach, which rounding may put outside, that of the end.
double opening_within(const CopyingLinkage& linkage, double distance) {
  if (const auto opening = linkage.opening_at(distance)) return *opening;
  const OpeningInterval& all = linkage.assembly_mode().openings;
  const double lower = linkage.radius_at(all.lower), upper = linkage.radius_at(all.upper);
  return std::abs(lower - distance) < std::abs(upper - distance) ? all.lower : all.upper;
}

}  // namespace

bool Annulus::contains(const Point& point) const {
  const double distance = (point - centre).norm();
  return inner <= distance && distance <= outer;
}

Annulus annulus_over(const CopyingLinkage& linkage, const OpeningInterval& openings) {
  if (openings.empty()) return {linkage.pole()};
  const auto radii = linkage.radii_over(openings);
  return {linkage.pole(), radii.lower, radii.upper};
}

Annulus reachable_annulus(const CopyingLinkage& linkage) {
  return annulus_over(linkage, linkage.assembly_mode().openings);
}

Annulus usable_annulus(const CopyingLinkage& linkage, double transmission) {
  return annulus_over(linkage, linkage.openings_with_transmission(transmission));
}

Annulus chain_annulus(const CopyingLinkage& linkage) {
  // Folded and stretched: the chain's directions differ by pi and by 0 at openings arg s + pi and arg s.
  const double stretched = std::arg(linkage.shape());
  const double folded = linkage.radius_at(stretched + pi), outer = linkage.radius_at(stretched);
  return {linkage.pole(), folded > slack::rounding * outer ? folded : 0, outer};
}

double area(const Annulus& annulus) {
  return annulus.empty() ? 0 : pi * (annulus.outer - annulus.inner) * (annulus.outer + annulus.inner);
}

ArcRegion as_region(const Annulus& annulus) {
  if (annulus.empty() || !(annulus.outer > annulus.inner)) return {};
  ArcPolygon polygon{circle(annulus.centre, annulus.outer), {}};
  if (annulus.inner > slack::rounding * annulus.outer)
    polygon.holes.push_back(reversed(circle(annulus.centre, annulus.inner)));
  return {polygon};
}

ArcRegion difference(const Annulus& whole, const Annulus& part) {
  if (whole.empty() || part.empty()) return as_region(whole);
  ArcRegion result = as_region({whole.centre, whole.inner, std::min(part.inner, whole.outer)});
  for (ArcPolygon& polygon : as_region({whole.centre, std::max(part.outer, whole.inner), whole.outer}))
    result.push_back(std::move(polygon));
  return result;
}

bool covers(const Annulus& annulus, const Region& region) {
  if (region.empty()) return true;
  if (annulus.empty()) return false;
  const DistanceRange range = distance_range(region, annulus.centre);
  return annulus.inner <= range.nearest && range.farthest <= annulus.outer;
}

OpeningInterval openings_met(const CopyingLinkage& linkage, const Region& region) {
  const Annulus reach = reachable_annulus(linkage);
  const DistanceRange range = distance_range(region, linkage.pole());
  const double near = std::max(range.nearest, reach.inner), far = std::min(range.farthest, reach.outer);
  if (!(near <= far)) return {};
  const double a = opening_within(linkage, near), b = opening_within(linkage, far);
  return {std::min(a, b), std::max(a, b)};
}

std::optional<OpeningInterval> openings_over(const CopyingLinkage& linkage, const Region& region) {
  if (region.empty()) return std::nullopt;
  const DistanceRange range = distance_range(region, linkage.pole());
  const auto near = linkage.opening_at(range.nearest), far = linkage.opening_at(range.farthest);
  if (!near || !far) return std::nullopt;
  return OpeningInterval{std::min(*near, *far), std::max(*near, *far)};
}

}  // namespace kempe
