#include "synthesis/bound/pole_places.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/bound/slack.hpp"

namespace kempe::bounding {
namespace {

/// The largest distance of a corner from the frame's origin, mm.
double extent(const RegionReach& region) { return region.farthest(Point::Zero()).distance; }

}  // namespace

Box box_of_places(const PoleSpec& pole) {
  if (const auto* area = std::get_if<Region>(&pole.place)) return bounding_box(*area);
  const Point& at = std::get<Point>(pole.place);
  return {at, at};
}

PolePlaces::PolePlaces(const Spec& spec, bool posts)
    : spec_(spec), region_(spec.region), copy_gap_(spec, region_) {
  if (const Region* area = std::get_if<Region>(&spec.pole.place)) area_.emplace(*area);
  place_rounding_ = slack::rounding * std::max(extent(region_), area_ ? extent(*area_) : 0);
  constexpr std::size_t most_corners = 256;
  const std::size_t stride = 1 + (region_.hull().size() - 1) / most_corners;
  for (std::size_t i = 0; i < region_.hull().size(); i += stride) corners_.push_back(region_.hull()[i]);
  // The posts stand on the table: pole, tracer and pen keep their distance from each other.
  const double between_posts = spec.links.style.pin_diameter + spec.limits.clearance;
  const double k = std::abs(spec.copy.k()), third = std::abs(1.0 - spec.copy.k());
  least_radius_ = posts ? between_posts / std::min({1.0, k, third}) * slack::surely_less : 0;
}

void PolePlaces::plant(TreeNode& root) const {
  const Box box = box_of_places(spec_.pole);
  root.x = {box.lower.x(), box.upper.x()};
  root.y = {box.lower.y(), box.upper.y()};
}

bool PolePlaces::measure(TreeNode& node) const {
  if (!measure_distances(node)) return false;
  if (node.copy_is_apart) return true;
  const PoleDisc poles = disc_around(node.x, node.y);
  const CopyGap::Verdict copy = copy_gap_.verdict(poles.centre, poles.radius);
  node.copy_is_apart = copy == CopyGap::Verdict::far_enough;
  return copy != CopyGap::Verdict::too_near;
}

/// The corner of the region that is farthest from the nearest point of the box to it.
const Point& PolePlaces::farthest_corner(const Range& x, const Range& y) const {
  const Point lower(x.lower, y.lower), upper(x.upper, y.upper);
  const auto apart = [&](const Point& corner) {
    return (corner - corner.cwiseMax(lower).cwiseMin(upper)).squaredNorm();
  };
  return *std::max_element(corners_.begin(), corners_.end(),
                           [&](const Point& less, const Point& more) { return apart(less) < apart(more); });
}

bool PolePlaces::measure_distances(TreeNode& node) const {
  const auto [centre, radius] = disc_around(node.x, node.y);
  if (area_ && area_->nearest(centre).distance > radius + place_rounding_) return false;
  const RegionReach::Nearest nearest = region_.nearest(centre);
  if (-nearest.distance > radius + place_rounding_)
    return false;  // inside the region wherever it stands: it would touch the tracer
  node.distances.nearest_at_most = distance_from_box(nearest.place, place_rounding_, node.x, node.y).upper;
  node.distances.farthest_at_least =
      distance_from_box(farthest_corner(node.x, node.y), place_rounding_, node.x, node.y).lower;
  if (node.distances.nearest_at_most < least_radius_) return false;
  const Point& farthest = farthest_corner({centre.x(), centre.x()}, {centre.y(), centre.y()});
  const Spread spread = spread_over(farthest, nearest.place, place_rounding_, node.x, node.y);
  node.distances.ratio_at_least = spread.ratio;
  node.distances.squares_at_least = spread.squares;
  return true;
}

ReachedPlaces PolePlaces::ends_from(const Point& pole) const {
  return {region_.nearest(pole).place, farthest_corner({pole.x(), pole.x()}, {pole.y(), pole.y()}),
          place_rounding_};
}

std::optional<DistanceRange> PolePlaces::distances_from(const Point& pole) const {
  if (area_ && !area_->contains(pole)) return std::nullopt;
  const DistanceRange range = region_.range(pole);
  if (!(range.nearest > 0) || copy_gap_.verdict(pole, 0) == CopyGap::Verdict::too_near) return std::nullopt;
  return range;
}

}  // namespace kempe::bounding
