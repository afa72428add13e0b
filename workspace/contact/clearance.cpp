#include "workspace/contact/clearance.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/sector.hpp"
#include "workspace/contact/copy_contact.hpp"
#include "workspace/contact/subdivision.hpp"
#include "workspace/reach.hpp"
#include "workspace/slack.hpp"

namespace kempe {
namespace {

/// To what the figure is certified, mm.
double certain_to(const CopyingLinkage& linkage) {
  return std::min(slack::certain_gap, slack::certain_gap_share * reachable_annulus(linkage).outer);
}

constexpr std::size_t most_cells = 200'000;
constexpr std::size_t tried_each_level = 400;

/// A point of the region's outlines at a distance from the pole, or the nearest of their points to it.
Point place_at_distance(const Region& region, const Point& pole, double radius) {
  Point best = pole;
  double miss = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Point& point) {
    const double here = std::abs(point.norm() - radius);
    if (here < miss) best = pole + point, miss = here;
  };
  const auto offer_edge = [&](const Point& from, const Point& to) {
    const Point along = to - from;
    const double squared = along.squaredNorm();
    if (!(squared > 0)) return offer(from);
    const double foot = -from.dot(along) / squared;
    const double half =
        std::sqrt(std::max(0.0, radius * radius / squared - (from + foot * along).squaredNorm() / squared));
    for (const double share : {0.0, 1.0, foot - half, foot + half, foot})
      if (share >= 0 && share <= 1) offer(from + share * along);
  };
  const auto offer_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      offer_edge(ring[i] - pole, ring[(i + 1) % ring.size()] - pole);
  };
  for (const Polygon& polygon : region.polygons) {
    offer_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) offer_ring(hole);
  }
  return best;
}

/// Gaps nearer to each other than this share of what the figure is certain to are equally tight, and the pair found first is named: a design that is best where
/// several pairs are at their limit would else name one of them by rounding.
constexpr double as_tight = 1e-7;

ClearanceFigure uncertified(ClearanceFigure figure) {
  figure.certified = false;
  return figure;
}

std::string parts_of(const ContactScene& scene, const Encounter& between) {
  return scene.piece_name(between) + " and " + scene.obstacle_name(between);
}

/// Tries points of the region in the open cells; keeps the smallest gap found, and ends with one below `enough`. `named` is that of the
/// pair named.
void improve(ClearanceFigure& best, double& named, const ContactScene& scene, const Encounters& encounters,
             const Subdivision& cells, double enough, const StopFlag& stop) {
  const CopyingLinkage& linkage = cells.grid().linkage();
  const std::size_t stride = std::max<std::size_t>(1, cells.open().size() / tried_each_level);
  for (std::size_t i = 0; i < cells.open().size() && best.gap >= enough && !stop(); i += stride) {
    const auto point = cells.region_point_in(cells.open()[i]);
    if (!point) continue;
    const Point reach = *point - linkage.pole();
    const auto opening = linkage.opening_at(reach.norm());
    if (!opening) continue;
    const ObstacleGap here = tightest_obstacle(scene, encounters, *opening, std::atan2(reach.y(), reach.x()));
    if (here.gap < named - as_tight * certain_to(linkage)) {
      best.parts = parts_of(scene, here.between);
      best.at = *point;
      named = here.gap;
    }
    best.gap = std::min(best.gap, here.gap);
  }
}

/// The figure, or what of the moving parts and obstacles comes nearer over the openings: the nearest, or the first below `enough`.
ClearanceFigure with_obstacles(const PreparedTask& prepared, ClearanceFigure best, const StopFlag& stop,
                               double enough = -infinity) {
  const auto& [task, openings, own, at_pole, scene, region] = prepared;
  Encounters encounters = scene.nearer_than(best.gap);
  if (openings_over(task.linkage, task.region)) {
    const CopyContacts contacts =
        copy_contacts(prepared, encounters, best.gap, as_tight * certain_to(task.linkage), stop);
    encounters = contacts.others;
    if (const auto& copy = contacts.smallest)
      best = {copy->gap, parts_of(scene, copy->between), copy->at, best.certified};
    if (best.gap < enough) return uncertified(best);
  }
  if (encounters.pairs.empty() || !(openings.width() > 0)) return best;
  Subdivision cells(scene, encounters, region, AngleGrid(task.linkage, openings),
                    best.gap - certain_to(task.linkage), {.contacts_stay_open = true, .region_only = true});
  double named = best.gap;
  while (!cells.open().empty() && cells.open().size() < most_cells && !stop()) {
    improve(best, named, scene, encounters, cells, enough, stop);
    if (best.gap < enough) return uncertified(best);
    cells.lower_clearance(best.gap - certain_to(task.linkage));
    if (!cells.split(unless(stop))) break;
  }
  best.certified = cells.open().empty();
  return best;
}

}  // namespace

std::optional<ClearanceFigure> smallest_clearance(const PreparedTask& prepared, const StopFlag& stop,
                                                  double enough) {
  if (prepared.openings.empty()) return std::nullopt;
  const auto& [task, openings, own, at_pole, scene, region] = prepared;
  ClearanceFigure best{
      own.gap, name(*own.pair),
      place_at_distance(task.region, task.linkage.pole(), task.linkage.radius_at(own.opening)), true};
  if (const auto post = tightest(at_pole); post && post->gap < best.gap) {
    best.gap = post->gap;
    best.parts = post->post + " and " + post->obstacle;
  }
  return with_obstacles(prepared, best, stop, enough);
}

std::optional<ClearanceFigure> smallest_clearance(const MapTask& task, const StopFlag& stop, double enough) {
  return smallest_clearance(PreparedTask(task), stop, enough);
}

ObstacleClearance obstacle_clearance(const MapTask& task, double within, const StopFlag& stop) {
  const double sure = certain_to(task.linkage);
  const ClearanceFigure figure =
      with_obstacles(PreparedTask(task, within + sure), {within + sure, "", task.linkage.pole(), true}, stop);
  if (!figure.certified) return {figure, -std::numeric_limits<double>::infinity()};
  return {figure, figure.parts.empty() ? within : figure.gap - sure};
}

}  // namespace kempe
