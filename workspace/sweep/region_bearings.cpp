#include "workspace/sweep/region_bearings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/segment_distance.hpp"
#include "workspace/sweep/slack.hpp"

namespace kempe::sweep {
namespace {

/// Calls `visit(edge)` for all edges that come between two distances from the pole, and for few others.
template <class Visit>
void for_each_edge_between(const EdgeTree& edges, double inner, double outer, Visit visit) {
  for_each_edge(
      edges,
      [&](const Box& box) {
        const Point far = box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs());
        return far.squaredNorm() >= inner * inner &&
               distance(box, {Point::Zero(), Point::Zero()}) <= outer * (1 + box_rounding);
      },
      visit);
}

/// Shares of the edge a-b at which it is `radius` from the pole, in order.
std::array<double, 2> shares_at(const Point& a, const Point& b, double radius) {
  const Point along = b - a;
  const double length2 = along.squaredNorm(), foot = -a.dot(along) / length2;
  const double under = radius * radius - (a + foot * along).squaredNorm();
  const double half = under > 0 ? std::sqrt(under / length2) : 0;
  return {foot - half, foot + half};
}

void add_piece(const Point& a, const Point& b, double from, double to, std::vector<Bearings>& found) {
  if (from > to) return;
  const Point first = a + from * (b - a), last = a + to * (b - a);
  const double start = std::atan2(first.y(), first.x());
  const double turn = std::atan2(cross(first, last), first.dot(last));
  found.push_back({std::min(start, start + turn), std::max(start, start + turn)});
}

void add_edge(const Point& a, const Point& b, double inner, double outer, std::vector<Bearings>& found) {
  const double far2 = std::max(a.squaredNorm(), b.squaredNorm());
  if (far2 < inner * inner || !((b - a).squaredNorm() > 0)) return;
  if (distance(Point::Zero(), a, b) > outer * (1 + box_rounding)) return;
  const auto out = shares_at(a, b, outer), in = shares_at(a, b, inner);
  const double from = std::max(0.0, out[0]), to = std::min(1.0, out[1]);
  const bool passes_hole = in[1] > in[0];
  add_piece(a, b, from, passes_hole ? std::min(to, in[0]) : to, found);
  if (passes_hole) add_piece(a, b, std::max(from, in[1]), to, found);
}

}  // namespace

std::vector<Bearings> RegionBearings::between(double inner, double outer, double gap,
                                              const StopFlag& stop) const {
  std::vector<Bearings> found;
  for_each_edge_between(edges_, inner, outer, [&](const EdgeTree::Edge& edge) {
    add_edge(edge.from, edge.to, inner, outer, found);
  });
  add_circle(inner, found, stop);
  if (outer > inner) add_circle(outer, found, stop);
  return merged(std::move(found), gap);
}

void RegionBearings::add_circle(double radius, std::vector<Bearings>& found, const StopFlag& stop) const {
  std::vector<double> angles;
  for_each_edge_between(edges_, radius, radius, [&](const EdgeTree::Edge& edge) {
    const Point &a = edge.from, &b = edge.to;
    if ((b - a).squaredNorm() == 0 || std::max(a.squaredNorm(), b.squaredNorm()) < radius * radius) return;
    for (const double share : shares_at(a, b, radius)) {
      if (share < 0 || share > 1) continue;
      const Point at = a + share * (b - a);
      angles.push_back(std::atan2(at.y(), at.x()));
    }
  });
  std::sort(angles.begin(), angles.end());
  const auto inside = [&](double angle) {
    return edges_.winds_around(radius * Point(std::cos(angle), std::sin(angle)));
  };
  // A circle that only touches the region may seem to miss its edges by rounding, so one place tells nothing.
  if (angles.empty() && inside(1) && inside(1 + 2 * pi / 3) && inside(1 + 4 * pi / 3))
    found.push_back({0, 2 * pi});
  constexpr std::size_t between_polls = 64;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (i % between_polls == 0 && stop()) return;
    const double to = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * pi;
    if (inside(0.5 * (angles[i] + to))) found.push_back({angles[i], to});
  }
}

}  // namespace kempe::sweep
