#include "synthesis/problem/search_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/segment_distance.hpp"
#include "kinematics/copying_linkage.hpp"
#include "synthesis/problem/slack.hpp"

namespace kempe {
namespace {

/// Poles looked at first: a lattice of so many squared, and so many places along the outline.
constexpr int pole_lattice = 16;
constexpr int pole_outline = 96;
/// Places of the tracer at which obstacles are looked at first.
constexpr int obstacle_places = 90;
/// Regions with more corners are seen as their hull when original and copy must keep apart.
constexpr std::size_t most_gap_corners = 128;

Region pole_region(const PoleSpec& pole) { return pole.is_fixed() ? Region{} : std::get<Region>(pole.place); }

}  // namespace

SearchSpace::SearchSpace(Spec given) : spec_(std::move(given)), region_(spec_.region) {
  const Spec& spec = spec_;
  if (!spec.pole.is_fixed()) area_.emplace(pole_region(spec.pole));
  layout_.pole_is_free = area_.has_value();
  if (area_) {
    layout_.origin = region_.centre();
    layout_.unit = std::max(region_.diagonal(), std::abs(area_->nearest(region_.centre()).distance));
  } else {
    layout_.origin = std::get<Point>(spec.pole.place);
    distances_of_fixed_pole_ =
        DistanceRange{region_.nearest(layout_.origin).distance, region_.farthest(layout_.origin).distance};
    layout_.unit = distances_of_fixed_pole_->farthest;
  }
  sample_poles();
  obstacles_ = obstacle_shapes(obstructions_of(spec.obstacles, spec.bodies, spec.table));
  if (!obstacles_.empty()) places_ = kempe::tracer_places(spec.region, obstacle_places);
  if (spec.limits.copy_gap) list_gap_corners();
}

void SearchSpace::list_gap_corners() {
  std::vector<Point> corners;
  if (region_.edges().size() <= most_gap_corners)
    for (const BoundaryEdge& edge : region_.edges()) corners.push_back(edge.from);
  else  // the hull's gap is never larger than the region's: the safe side
    for (std::size_t i = 0; i < region_.hull().size(); i += 1 + region_.hull().size() / most_gap_corners)
      corners.push_back(region_.hull()[i]);
  for (const Point& corner : corners)
    gap_corners_.insert(gap_corners_.end(), {{corner, true}, {corner, false}});
}

/// A corner of the copy lies at pole + k (z - pole). A corner z of the region against the copy is, |k| times as large,
/// pole + (z - pole)/k against the region.
SearchSpace::AgainstRegion SearchSpace::against_region(const GapCorner& corner, const Point& pole) const {
  const Complex factor = corner.is_copied ? k() : 1.0 / k();
  return {pole + as_point(factor * as_complex(corner.corner - pole)), factor,
          corner.is_copied ? 1 : std::abs(k())};
}

SearchSpace::CornerGap SearchSpace::copy_gap(const GapCorner& corner, const Point& pole) const {
  const auto [place, factor, scale] = against_region(corner, pole);
  const RegionReach::Nearest nearest = region_.nearest(place);
  const BoundaryEdge& edge = region_.edges()[nearest.edge];
  const double away = std::abs(nearest.distance);
  const Point normal = away > 0 ? Point((place - nearest.place) / nearest.distance) : Point(1, 0);
  const bool at_corner = nearest.place == edge.from || nearest.place == edge.to;
  return {scale * nearest.distance, scale * normal, 1.0 - factor,
          at_corner && away > 0 ? scale / nearest.distance : 0};
}

SearchSpace::SmallestCopyGap SearchSpace::smallest_copy_gap(const Point& pole) const {
  SmallestCopyGap smallest{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < gap_corners_.size(); ++i) {
    const AgainstRegion corner = against_region(gap_corners_[i], pole);
    // What is sooner known of a place: outside the region its gap is no smaller than 0, nor than that to the region's box.
    const bool is_no_nearer = smallest.distance > 0
                                  ? corner.scale * region_.distance_from_box(corner.place) > smallest.distance
                                  : !region_.contains(corner.place);
    if (is_no_nearer) continue;
    const double distance = corner.scale * region_.nearest(corner.place).distance;
    if (distance < smallest.distance) smallest = {distance, i};
  }
  return smallest;
}

void SearchSpace::sample_poles() {
  if (!area_) {
    samples_.push_back({layout_.origin, *distances_of_fixed_pole_});
    return;
  }
  const auto add = [&](const Point& pole) { samples_.push_back({pole, distances(pole)}); };
  const Box& box = area_->box();
  for (int i = 0; i < pole_lattice; ++i)
    for (int j = 0; j < pole_lattice; ++j) {
      const Point share((i + 0.5) / pole_lattice, (j + 0.5) / pole_lattice);
      const Point pole = box.lower + (box.upper - box.lower).cwiseProduct(share);
      if (area_->contains(pole)) add(pole);
    }
  double outline = 0;
  for (const BoundaryEdge& edge : area_->edges()) outline += (edge.to - edge.from).norm();
  double walked = 0;
  int next = 0;  // places evenly along the outline, whatever the edges' lengths
  for (const BoundaryEdge& edge : area_->edges()) {
    const double length = (edge.to - edge.from).norm();
    for (; next < pole_outline && next * outline / pole_outline < walked + length; ++next)
      add(edge.from + (next * outline / pole_outline - walked) / length * (edge.to - edge.from));
    walked += length;
  }
}

DistanceRange SearchSpace::distances(const Point& pole) const {
  if (distances_of_fixed_pole_ && pole == layout_.origin) return *distances_of_fixed_pole_;
  return {region_.nearest(pole).distance, region_.farthest(pole).distance};
}

double SearchSpace::pole_distance(const Point& place) const {
  return area_ ? std::max(0.0, area_->nearest(place).distance) : (place - layout_.origin).norm();
}

Point SearchSpace::nearest_pole(const Point& place) const {
  if (!area_) return layout_.origin;
  const RegionReach::Nearest nearest = area_->nearest(place);
  return nearest.distance <= 0 ? place : nearest.place;
}

bool SearchSpace::is_on_edge(const Point& place) const {
  if (!area_) return false;
  const BoundaryEdge& edge = area_->edges()[area_->nearest(place).edge];
  return place != edge.from && place != edge.to;
}

Box SearchSpace::pole_box(double margin) const {
  const Box box = area_ ? area_->box() : Box{layout_.origin, layout_.origin};
  return {box.lower - Point(margin, margin), box.upper + Point(margin, margin)};
}

std::vector<HalfPlane> SearchSpace::room_around(const Point& pole) const {
  struct Cut {
    double distance;
    Point place;
    std::size_t edge;
  };
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i < area_->edges().size(); ++i) {
    const BoundaryEdge& edge = area_->edges()[i];
    const Point place = nearest_on_segment(pole, edge.from, edge.to);
    cuts.push_back({(place - pole).norm(), place, i});
  }
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.edge < b.edge);
  });
  std::vector<HalfPlane> room;
  const double touching = slack::same_place * layout_.unit;
  for (const Cut& cut : cuts) {
    const Point &from = area_->edges()[cut.edge].from, &to = area_->edges()[cut.edge].to;
    const auto beyond = [&](const HalfPlane& plane) {
      return plane.inside(from) <= touching && plane.inside(to) <= touching;
    };
    if (std::any_of(room.begin(), room.end(), beyond)) continue;
    const Point along = (to - from).normalized();
    const HalfPlane edge_line{Point(along.y(), -along.x()), cut.place};
    const bool at_corner = cut.place == from || cut.place == to;
    const bool on_hull = std::all_of(area_->hull().begin(), area_->hull().end(), [&](const Point& corner) {
      return edge_line.inside(corner) >= -touching;
    });
    if (at_corner && !on_hull && cut.distance > touching)
      room.push_back({(cut.place - pole) / cut.distance, cut.place});
    else
      room.push_back(edge_line);
  }
  return room;
}

namespace {

/// To one value, which may lie on a limit, or be another locked length's up to its last digits.
void lock(LogRange& range, double locked) {
  constexpr double slack = 2 * slack::inward_log_length;
  if (locked < range.lower - slack || locked > range.upper + slack)
    range = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  else if (range.width() > 0)
    range = {locked, locked};
}

}  // namespace

LogBox length_box(const Reach& reach, const Requirements& limits, const StockLengths& stock_lengths) {
  const Reach::LengthFactors& f = reach.factors();
  const double low = std::max(limits.shortest, slack::least_length_share * limits.longest);
  LogBox box{{std::log(low / f.least_of_VA) + slack::inward_log_length,
              std::log(limits.longest / f.most_of_VA) - slack::inward_log_length},
             {std::log(low / f.least_of_VB) + slack::inward_log_length,
              std::log(limits.longest / f.most_of_VB) - slack::inward_log_length}};
  const std::array<double, 8> per_bar = lengths_of_links(reach.shape(), 1, 1).values();
  for (std::size_t i = 0; i < per_bar.size(); ++i)
    if (const auto& locked = stock_lengths.locked[i])
      lock(is_multiple_of_VA[i] ? box.u : box.v, std::log(*locked / per_bar[i]));
  return box;
}

}  // namespace kempe
