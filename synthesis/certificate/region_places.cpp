#include "synthesis/certificate/region_places.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/segment_distance.hpp"
#include "synthesis/certificate/slack.hpp"
#include "synthesis/problem/obstacle_gap.hpp"

namespace kempe::certificate {
namespace {

void append_starts(std::size_t polygon, std::size_t ring, std::size_t corners,
                   std::vector<EdgePlace>& starts) {
  for (std::size_t corner = 0; corner < corners; ++corner) starts.push_back({polygon, ring, corner, 0});
}

}  // namespace

RegionPlaces::RegionPlaces(const Region& region) : region_(region), reach_(region) {
  for (std::size_t i = 0; i < region.polygons.size(); ++i) {  // in the order of RegionReach::edges()
    append_starts(i, 0, region.polygons[i].outer.size(), start_of_);
    for (std::size_t j = 0; j < region.polygons[i].holes.size(); ++j)
      append_starts(i, j + 1, region.polygons[i].holes[j].size(), start_of_);
  }
  std::map<std::pair<double, double>, std::size_t> first_from;
  for (std::size_t i = 0; i < reach_.edges().size(); ++i) {
    const Point& from = reach_.edges()[i].from;
    first_from.emplace(std::pair(from.x(), from.y()), i);
  }
  for (const Point& corner : reach_.hull())
    corner_of_.push_back(first_from.at(std::pair(corner.x(), corner.y())));
  constexpr int about = 60;
  spread_out(region, about);
}

EdgePlace RegionPlaces::edge_place(std::size_t edge, double share) const {
  EdgePlace place = start_of_[edge];
  place.share = share;
  return place;
}

KnownPlace RegionPlaces::nearest(const Point& to) const {
  const RegionReach::Nearest found = reach_.nearest(to);
  if (found.distance < -slack::inside_region * (reach_.diagonal() + to.norm())) return {to, to};
  const BoundaryEdge& edge = reach_.edges()[found.edge];
  return {edge_place(found.edge, nearest_share(found.place, edge.from, edge.to)), found.place};
}

KnownPlace RegionPlaces::farthest(const Point& from) const {
  const std::size_t corner = reach_.farthest(from).corner;
  return {edge_place(corner_of_[corner], 0), reach_.hull()[corner]};
}

const std::vector<KnownPlace>& RegionPlaces::many() const {
  constexpr int about = 2000;
  if (many_.empty())
    for (const Point& place : tracer_places(region_, about)) many_.push_back(nearest(place));
  return many_;
}

void RegionPlaces::spread_out(const Region& region, int about) {
  double length = 0;
  for (const BoundaryEdge& edge : reach_.edges()) length += (edge.to - edge.from).norm();
  const double step = length / about;
  double since = step;  // the first corner is one of them
  for (std::size_t i = 0; i < reach_.edges().size(); ++i) {
    const BoundaryEdge& edge = reach_.edges()[i];
    const double along = (edge.to - edge.from).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(along / step)));
    for (int j = 0; j < pieces; ++j) {
      if (since >= 0.5 * step || (j == 0 && reach_.edges().size() <= static_cast<std::size_t>(about))) {
        const double share = static_cast<double>(j) / pieces;
        spread_.push_back({edge_place(i, share), edge.from + share * (edge.to - edge.from)});
        since = 0;
      }
      since += along / pieces;
    }
  }
  for (const Point& place : tracer_places(region, about))
    if (reach_.nearest(place).distance < -slack::spread_inside * reach_.diagonal())
      spread_.push_back({place, place});
}

}  // namespace kempe::certificate
