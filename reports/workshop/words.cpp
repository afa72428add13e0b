#include "reports/workshop/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "geometry/edge_tree.hpp"
#include "reports/drawings/drawing.hpp"

namespace kempe::workshop {
namespace {

Region on_paper_of(const View& view, Region region) {
  const auto put = [&](Ring& ring) {
    for (Point& point : ring) point = view.at(point);
  };
  for (Polygon& polygon : region.polygons) {
    put(polygon.outer);
    for (Ring& hole : polygon.holes) put(hole);
  }
  return region;
}

/// Where a word's middle may lie inside a region on paper, nearest to the region's middle first.
std::vector<PictureBox> places_in(const Region& region, const Point& half) {
  constexpr int steps = 24;  // each way
  const Box box = bounding_box(region);
  const Point middle = 0.5 * (box.lower + box.upper);
  const EdgeTree edges(region, Point::Zero());  // an outline may have a million edges
  std::vector<PictureBox> places;
  for (int i = 1; i < steps; ++i)
    for (int j = 1; j < steps; ++j) {
      const Point share(static_cast<double>(i) / steps, static_cast<double>(j) / steps);
      const Point at = box.lower + share.cwiseProduct(box.upper - box.lower);
      if (edges.winds_around(at)) places.push_back({at, half});
    }
  std::stable_sort(places.begin(), places.end(), [&](const PictureBox& a, const PictureBox& b) {
    return (a.centre - middle).norm() < (b.centre - middle).norm();
  });
  return places;
}

/// Where a word's middle may lie around a box, nearest to it first.
std::vector<PictureBox> places_around(const PictureBox& box, const Point& half) {
  constexpr double farthest = 60, step = 1.5;  // mm
  constexpr int directions = 24;
  std::vector<PictureBox> places;
  for (double away = 0.5; away < farthest; away += step)
    for (int i = 0; i < directions; ++i) {
      const Point direction = as_point(std::polar(1.0, 2 * pi * i / directions));
      places.push_back({box.centre +
                            (box.half + half).cwiseProduct(direction) / direction.cwiseAbs().maxCoeff() +
                            away * direction,
                        half});
    }
  return places;
}

/// A circle's eighths, those nearest to `preferred` first; of no preference the corners first.
std::array<Point, 8> directions_from(const Point& preferred) {
  // Right above, right below, left above, left below; right, above, left, below.
  constexpr std::array eighths{1, 7, 3, 5, 0, 2, 4, 6};
  std::array<Point, 8> directions;
  for (std::size_t i = 0; i < 8; ++i) directions[i] = as_point(std::polar(1.0, eighths[i] * pi / 4));
  if (!preferred.isZero())
    std::stable_sort(directions.begin(), directions.end(), [&](const Point& a, const Point& b) {
      return a.dot(preferred) > b.dot(preferred) + 1e-9 * preferred.norm();
    });
  return directions;
}

/// To which side of its anchor a word stands, in each coordinate: -1, 0 (across the anchor) or 1.
Point sides_of(const Point& direction) {
  const auto side = [](double value) { return std::abs(value) < 1e-9 ? 0.0 : value > 0 ? 1.0 : -1.0; };
  return {side(direction.x()), side(direction.y())};
}

/// The corner of a region's outer edges that is nearest to a place.
Point nearest_corner(const Region& region, const Point& place) {
  Point best = region.polygons.front().outer.front();
  for (const Polygon& polygon : region.polygons)
    for (const Point& corner : polygon.outer)
      if ((corner - place).norm() < (best - place).norm()) best = corner;
  return best;
}

}  // namespace

void Words::avoid_edges(const View& view, const Region& region) {
  constexpr double detail = 2;  // mm on paper
  for (const Polygon& polygon : region.polygons) {
    const Ring ring = thinned(polygon.outer, detail / view.scale);
    for (std::size_t i = 0; i < ring.size(); ++i)
      placer_.avoid(view.at(ring[i]), view.at(ring[(i + 1) % ring.size()]), 0.3);
  }
}

void Words::write(const std::string& text, const Point& anchor, double radius, double height,
                  const Point& preferred) {
  const Point half = Point(0.5 * lettering_(text, height), 0.5 * height);
  const Point room = half + Point(0.2, 0.2);
  const auto places = [&](const std::vector<double>& distances) {
    std::vector<PictureBox> all;
    for (const double away : distances)
      for (const Point& direction : directions_from(preferred))
        all.push_back({anchor + (radius + away) * direction + room.cwiseProduct(sides_of(direction)), room});
    return all;
  };
  constexpr double apart = 0.25;  // mm, from any line
  const auto near = placer_.place_if_apart(places({0.5, 1.0, 1.7, 2.5, 3.5, 5.0}), apart);
  auto place = near;
  if (!place) place = placer_.place_if_apart(places({6.5, 8.5, 11, 14, 18, 23}), apart);
  if (!place) place = placer_.place_around(anchor, radius, room, Point(1, 1));
  if (!near) lead({*place, room}, anchor);
  sheet_.text(text, *place - Point(0, half.y()), height, Align::middle);
}

void Words::write_in(const std::string& text, const View& view, const Region& region, double height) {
  if (region.empty()) return;
  const Region shown = on_paper_of(view, region);
  const Point half(0.5 * lettering_(text, height), 0.5 * height), room = half + Point(0.4, 0.8);
  constexpr double apart = 0.2;  // mm, from any line
  auto place = placer_.place_if_apart(places_in(shown, room), apart);
  if (!place) {
    const Box box = bounding_box(shown);
    const PictureBox all{0.5 * (box.lower + box.upper), 0.5 * (box.upper - box.lower)};
    place = placer_.place_if_apart(places_around(all, room), apart);
    if (!place) place = placer_.place_beside(all, room);
    lead({*place, half}, nearest_corner(shown, *place));
  }
  sheet_.text(text, *place - Point(0, half.y()), height, Align::middle);
}

/// A thin line from a word's edge to what it names.
void Words::lead(const PictureBox& word, const Point& to) {
  const Point way = to - word.centre;
  const double beyond = way.cwiseAbs().cwiseQuotient(word.half).maxCoeff();  // > 1: outside the word
  if (beyond <= 1) return;
  const Point from = word.centre + way / beyond;
  sheet_.line(from, to, Pen::hatch);
  placer_.avoid(from, to, 0.3);
}

}  // namespace kempe::workshop
