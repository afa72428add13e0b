// What holds an answer back, and how far two answers are apart.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/segment_distance.hpp"
#include "synthesis/paths/path_generator.hpp"
#include "synthesis/paths/slack.hpp"

namespace kempe {
namespace {

struct NamedLength {
  const char* name;
  double mm;
};

bool stands_at(double value, double limit) { return std::abs(value - limit) <= slack::path_at_limit * limit; }

void add_pivots(const PathTask& task, const CouplerFourBar& bar, std::vector<ActiveLimit>& active) {
  const std::vector<Point>& polygon = task.pivots_within;
  double size = 0;
  for (const Point& corner : polygon) size = std::max(size, (corner - polygon.front()).norm());
  const auto on_edge = [&](const Point& place) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
      if (std::abs(cross((to - from).normalized(), place - from)) <= slack::path_at_limit * size) return true;
    }
    return false;
  };
  if (!task.crank_pivot && on_edge(bar.crank_pivot))
    active.push_back({"limits.pivots_within_mm", "crank pivot"});
  if (on_edge(bar.rocker_pivot)) active.push_back({"limits.pivots_within_mm", "rocker pivot"});
}

/// The coupler curve from the first point to the last, `places` between two points.
std::vector<Point> curve_of(const PathAnswer& answer, int places) {
  std::vector<Point> curve;
  for (std::size_t i = 1; i < answer.crank_angles.size(); ++i) {
    const double from = answer.crank_angles[i - 1], to = answer.crank_angles[i];
    for (int k = i == 1 ? 0 : 1; k <= places; ++k)
      if (const auto place = answer.linkage.at(from + (to - from) * k / places)) curve.push_back(place->P);
  }
  return curve;
}

/// The largest distance of a place of `one` from the polyline `other`.
double farthest_from(const std::vector<Point>& one, const std::vector<Point>& other, double enough) {
  double farthest = 0;
  for (const Point& place : one) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < other.size(); ++k)
      nearest = std::min(nearest, distance(place, other[k - 1], other[k]));
    if (nearest > enough) return std::numeric_limits<double>::infinity();
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

}  // namespace

std::vector<ActiveLimit> active_limits(const PathTask& task, const PathAnswer& answer) {
  const CouplerFourBar& bar = answer.linkage;
  std::vector<ActiveLimit> active;
  const std::array<NamedLength, 6> lengths{
      {{"ground", bar.ground()},
       {"crank", bar.crank},
       {"coupler", bar.coupler},
       {"rocker", bar.rocker},
       {"coupler point from A", bar.coupler_point.norm()},
       {"coupler point from B", (bar.coupler_point - Point(bar.coupler, 0)).norm()}}};
  for (const NamedLength& length : lengths)
    if (stands_at(length.mm, task.longest)) active.push_back({"limits.longest_mm", length.name});
  const double kept = std::max(task.transmission, slack::path_from_dead_points);
  if (answer.transmission_min - kept <= slack::path_at_limit)
    active.push_back({kept == task.transmission ? "limits.transmission_deg" : "dead point", ""});
  add_pivots(task, bar, active);
  if (task.crank_pivot) active.push_back({"limits.crank_pivot_mm", ""});
  if (task.ground_angle) active.push_back({"limits.ground_deg", ""});
  if (task.first_angle) active.push_back({"limits.first_angle_deg", ""});
  if (!task.motions.empty()) {
    std::array<double, 4> links{bar.ground(), bar.crank, bar.coupler, bar.rocker};
    std::sort(links.begin(), links.end());
    const double excess = links[0] + links[3] - links[1] - links[2];
    if (std::abs(excess) <= 2 * slack::path_from_change_point * links[3])
      active.push_back({"limits.motion", ""});
  }
  for (std::size_t k = 1; k < 4; ++k) {
    const double ratio = lengths[k].mm / bar.ground();
    if (stands_at(ratio, slack::path_largest_ratio) || stands_at(1 / ratio, slack::path_largest_ratio))
      active.push_back({"ratios searched", lengths[k].name});
  }
  return active;
}

double curves_apart(const PathAnswer& one, const PathAnswer& other, double enough, int places) {
  const std::vector<Point> first = curve_of(one, places), second = curve_of(other, places);
  return std::max(farthest_from(first, second, enough), farthest_from(second, first, enough));
}

}  // namespace kempe
