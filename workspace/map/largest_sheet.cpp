#include "workspace/map/largest_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/chance.hpp"
#include "geometry/edge_tree.hpp"
#include "kinematics/parallel.hpp"

namespace kempe {
namespace {

constexpr int pixels = 160;  ///< across the raster of the first search
constexpr int turns = 24;    ///< tried in half a turn
constexpr int kept = 6;      ///< places that are improved
/// Of the region's size: a rectangle is moved by no smaller steps, and arcs are followed to this.
constexpr double finest_step = 1e-6, flat_to = 1e-5;
constexpr double enlarged_by = 1e-9;  ///< sheets are shrunk by this share against rounding

/// Where a rectangle stands; its scale is half its height.
struct Place {
  Point centre = Point::Zero();
  double turn = 0;
  double half_height = 0;
};

Point turned_by(const Point& point, double cosine, double sine) {
  return {cosine * point.x() - sine * point.y(), sine * point.x() + cosine * point.y()};
}

/// A region, not empty, as every search for a sheet asks it.
struct Free {
  EdgeTree edges;
  Box box;
  explicit Free(const Region& region) : edges(region, Point::Zero()), box(bounding_box(region)) {}
};

/// Rectangles of one proportion in a region, which must outlive the object.
class SheetFinder {
 public:
  SheetFinder(const Free& region, double proportion, const StopFlag& stop)
      : tree_(region.edges), proportion_(proportion), corner_(std::hypot(1, proportion)), box_(region.box),
        stop_(stop) {}

  /// Half the height of the largest rectangle about a centre at a turn; 0 if the centre lies outside.
  double half_height_at(const Point& centre, double turn, double at_most) const {
    InTheWay none;
    return half_height_above(0, centre, turn, at_most, none);
  }

  /// The best places of a coarse search, best first.
  std::vector<Place> candidates(const std::vector<double>& at_turns) const {
    std::vector<Place> places;
    for (const double turn : at_turns)
      if (!stop_()) places.push_back(coarse(turn));
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.half_height > b.half_height; });
    places.resize(std::min<std::size_t>(places.size(), kept));
    return places;
  }

  /// Moves (and turns) a rectangle to where it can be larger, by random steps that shrink when they stop
  /// helping or the search is stopped.
  Place improved(Place place, bool may_turn) const {
    InTheWay in_the_way;
    const double size = (box_.upper - box_.lower).norm();
    Chance chance(1);
    place.half_height = half_height_at(place.centre, place.turn, size);
    for (double step = size / pixels; step > finest_step * size && !stop_(); step *= 0.5) {
      for (int failures = 0; failures < 24;) {
        const double down = chance.symmetric(), across = chance.symmetric();
        const Point centre = place.centre + step * Point(across, down);
        const double turn = place.turn + (may_turn ? chance.symmetric(4 * step / size) : 0);
        const double half_height = half_height_above(place.half_height, centre, turn, size, in_the_way);
        if (half_height > place.half_height) {
          place = {centre, turn, half_height};
        } else {
          ++failures;
        }
      }
    }
    return place;
  }

 private:
  /// A point in the frame in which the rectangle is a square of half side 1 for a half height of 1.
  Point squared_up(const Point& point, double cosine, double sine) const {
    const Point turned = turned_by(point, cosine, -sine);
    return {turned.x() / proportion_, turned.y()};
  }

  /// The edges that left too little room last.
  struct InTheWay {
    std::array<EdgeTree::Edge, 4> edges{};
    std::size_t count = 0, next = 0;
    void add(const EdgeTree::Edge& edge) {
      edges[next] = edge;
      next = (next + 1) % edges.size();
      count = std::max(count, next == 0 ? edges.size() : next);
    }
  };

  /// half_height_at() where it is larger than `than`; else any value that is not. Mostly one edge is in the way again and again.
  double half_height_above(double than, const Point& centre, double turn, double at_most,
                           InTheWay& in_the_way) const {
    const double cosine = std::cos(turn), sine = std::sin(turn);
    const auto room_beside = [&](const EdgeTree::Edge& edge) {
      return square_distance(squared_up(edge.from - centre, cosine, sine),
                             squared_up(edge.to - centre, cosine, sine));
    };
    double least = at_most;
    for (std::size_t i = 0; i < in_the_way.count; ++i) {
      least = std::min(least, room_beside(in_the_way.edges[i]));
      if (least <= than) return 0;
    }
    for_each_edge(
        tree_,
        [&](const Box& box) {
          return least > than && distance(box, {centre, centre}) < least * corner_;
        },
        [&](const EdgeTree::Edge& edge) {
          const double room = room_beside(edge);
          if (room <= than && least > than) in_the_way.add(edge);
          least = std::min(least, room);
        });
    return least > than && tree_.winds_around(centre) ? least : 0;
  }

  /// Least of max(|x|, |y|) along a segment: at an end or where it crosses a diagonal.
  static double square_distance(const Point& a, const Point& b) {
    const auto size = [](const Point& p) { return std::max(std::abs(p.x()), std::abs(p.y())); };
    double least = std::min(size(a), size(b));
    for (const double sign : {1.0, -1.0}) {
      const double from = a.x() - sign * a.y(), to = b.x() - sign * b.y();
      if ((from < 0) != (to < 0)) least = std::min(least, size(a + from / (from - to) * (b - a)));
    }
    return least;
  }

  /// The largest square of pixels whose middles lie inside, at one turn.
  Place coarse(double turn) const;

  const EdgeTree& tree_;
  double proportion_,
      corner_;  ///< width, and distance of a corner from the middle, of a rectangle with half a height of 1
  Box box_;
  StopFlag stop_;
};

/// The raster of one turn: for each pixel, whether its middle lies inside.
class Raster {
 public:
  Raster(const Box& box)
      : origin_(box.lower), pixel_((box.upper - box.lower).maxCoeff() / pixels), crossings_(pixels) {}

  void add(const Point& a, const Point& b) {
    const Point &low = a.y() < b.y() ? a : b, &high = a.y() < b.y() ? b : a;
    const double first = std::ceil((low.y() - origin_.y()) / pixel_ - 0.5);
    const double last = std::ceil((high.y() - origin_.y()) / pixel_ - 0.5);
    for (int row = std::max(0, static_cast<int>(first)); row < std::min<double>(pixels, last); ++row) {
      const double y = origin_.y() + (row + 0.5) * pixel_;
      const double x = low.x() + (y - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
      crossings_[static_cast<std::size_t>(row)].push_back((x - origin_.x()) / pixel_ - 0.5);
    }
  }

  /// Side in pixels and middle of the largest square of inside pixels.
  std::pair<int, Point> largest_square() {
    std::vector<int> side(static_cast<std::size_t>(pixels) * pixels, 0);
    const auto at = [&](int row, int column) -> int& {
      return side[static_cast<std::size_t>(row) * pixels + static_cast<std::size_t>(column)];
    };
    int best = 0;
    Point middle = Point::Zero();
    for (int row = 0; row < pixels; ++row) {
      mark_inside(row, [&](int column) { at(row, column) = 1; });
      for (int column = 0; column < pixels; ++column) {
        if (at(row, column) == 0 || row == 0 || column == 0) continue;
        at(row, column) += std::min({at(row - 1, column), at(row, column - 1), at(row - 1, column - 1)});
        if (at(row, column) <= best) continue;
        best = at(row, column);
        middle = origin_ + pixel_ * Point(column + 1 - 0.5 * best, row + 1 - 0.5 * best);
      }
    }
    return {best, middle};
  }
  double pixel() const { return pixel_; }

 private:
  template <class Mark>
  void mark_inside(int row, Mark mark) {
    auto& at = crossings_[static_cast<std::size_t>(row)];
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); i += 2)
      for (int column = std::max(0, static_cast<int>(std::ceil(at[i])));
           column < std::min<double>(pixels, at[i + 1]); ++column)
        mark(column);
  }

  Point origin_;
  double pixel_;
  std::vector<std::vector<double>> crossings_;
};

Place SheetFinder::coarse(double turn) const {
  const double cosine = std::cos(turn), sine = std::sin(turn);
  std::vector<std::pair<Point, Point>> edges;
  Box box{Point::Constant(std::numeric_limits<double>::infinity()),
          Point::Constant(-std::numeric_limits<double>::infinity())};
  for_each_edge(
      tree_, [](const Box&) { return true; },
      [&](const EdgeTree::Edge& edge) {
        edges.emplace_back(squared_up(edge.from, cosine, sine), squared_up(edge.to, cosine, sine));
        box = {box.lower.cwiseMin(edges.back().first), box.upper.cwiseMax(edges.back().first)};
      });
  Raster raster(box);
  for (const auto& [a, b] : edges) raster.add(a, b);
  const auto [side, middle] = raster.largest_square();
  return {turned_by({middle.x() * proportion_, middle.y()}, cosine, sine), turn, 0.5 * side * raster.pixel()};
}

/// Flat enough that the loss is not seen, and inside the region.
Region flattened_finely(const ArcRegion& region) {
  Box box{Point::Constant(std::numeric_limits<double>::infinity()),
          Point::Constant(-std::numeric_limits<double>::infinity())};
  for (const ArcPolygon& polygon : region)
    for (const ArcVertex& vertex : polygon.outer)
      box = {box.lower.cwiseMin(vertex.at), box.upper.cwiseMax(vertex.at)};
  return flattened(region, flat_to * (box.upper - box.lower).norm(), Flatten::shrinks);
}

std::vector<double> turns_to_try(bool turned) {
  if (!turned) return {0, pi / 2};
  std::vector<double> all;
  for (int i = 0; i < turns; ++i) all.push_back(pi * i / turns);
  return all;
}

std::optional<Place> best_place(const Free& region, double proportion, bool turned, const StopFlag& stop) {
  const SheetFinder finder(region, proportion, stop);
  Place best;
  for (const Place& place : finder.candidates(turns_to_try(turned))) {
    const Place better = finder.improved(place, turned);
    if (better.half_height > best.half_height) best = better;
  }
  if (!(best.half_height > 0)) return std::nullopt;
  best.half_height *= 1 - enlarged_by;
  return best;
}

/// A turn brought into (-pi/2, pi/2]: half a turn leaves a rectangle as it is.
double reduced(double turn) {
  const double within = turn - pi * std::ceil(turn / pi - 0.5);
  return within;
}

FittingSheet sheet_at(const Place& place, double proportion) {
  return {"", 2 * place.half_height * proportion, 2 * place.half_height, place.centre, reduced(place.turn)};
}

struct IsoSheet {
  const char* name;
  double width, height;  // mm
};
constexpr std::array<IsoSheet, 9> iso_sheets{{{"A0", 1189, 841},
                                              {"A1", 841, 594},
                                              {"A2", 594, 420},
                                              {"A3", 420, 297},
                                              {"A4", 297, 210},
                                              {"A5", 210, 148},
                                              {"A6", 148, 105},
                                              {"A7", 105, 74},
                                              {"A8", 74, 52}}};

std::optional<FittingSheet> largest_iso_sheet(const Free& region, bool turned, const StopFlag& stop) {
  const auto place = best_place(region, std::sqrt(2.0), turned, stop);
  if (!place) return std::nullopt;
  for (const IsoSheet& sheet : iso_sheets) {
    if (place->half_height < 0.49 * sheet.height) continue;  // 2 % of room for the sheets' own proportions
    const SheetFinder finder(region, sheet.width / sheet.height, stop);
    const Place own = finder.improved(*place, turned);
    if (own.half_height * (1 - enlarged_by) < 0.5 * sheet.height) continue;
    return FittingSheet{sheet.name, sheet.width, sheet.height, own.centre, reduced(own.turn)};
  }
  return std::nullopt;
}

std::optional<FittingSheet> largest_rectangle(const Free& region, double proportion, bool turned,
                                              const StopFlag& stop) {
  const auto place = best_place(region, proportion, turned, stop);
  if (!place) return std::nullopt;
  return sheet_at(*place, proportion);
}

/// Upright or on its side, or at the best turn.
using TwoWays = std::array<std::optional<FittingSheet>, 2>;

std::optional<FittingSheet> wider(const TwoWays& found, double by = 1) {
  const auto& [upright, turned] = found;
  return turned && (!upright || turned->width > by * upright->width) ? turned : upright;
}

/// Width over height of what the box holds; nothing of what is flat.
std::optional<double> proportion_of(const Region& region) {
  if (region.empty()) return std::nullopt;
  const Box box = bounding_box(region);
  const Point size = box.upper - box.lower;
  if (!(size.minCoeff() > 0)) return std::nullopt;
  return size.x() / size.y();
}

}  // namespace

std::optional<FittingSheet> largest_rectangle(const ArcRegion& region, double proportion, bool turned,
                                              const StopFlag& stop) {
  const Region flat = flattened_finely(region);
  if (flat.empty()) return std::nullopt;
  return largest_rectangle(Free(flat), proportion, turned, stop);
}

std::optional<FittingSheet> largest_iso_sheet(const ArcRegion& region, const StopFlag& stop) {
  const Region flat = flattened_finely(region);
  if (flat.empty()) return std::nullopt;
  const Free once(flat);
  return wider({largest_iso_sheet(once, false, stop), largest_iso_sheet(once, true, stop)});
}

std::optional<Point> format_size(std::string_view name) {
  for (const IsoSheet& sheet : iso_sheets)
    if (name == sheet.name) return Point(sheet.width, sheet.height);
  return std::nullopt;
}

std::vector<FittingSheet> largest_sheets(const ArcRegion& free, const Region& like, const StopFlag& stop,
                                         int threads) {
  const Region flat = flattened_finely(free);
  if (flat.empty()) return {};
  const Free once(flat);
  const std::optional<double> proportion = proportion_of(like);
  TwoWays iso, alike;
  run_parallel(proportion ? 4 : 2, threads, [&](std::size_t job) {
    const bool turned = job % 2 == 1;
    if (job < 2)
      iso[job] = largest_iso_sheet(once, turned, stop);
    else
      alike[job - 2] = largest_rectangle(once, *proportion, turned, stop);
  });
  std::vector<FittingSheet> sheets;
  if (auto sheet = wider(iso)) sheets.push_back(std::move(*sheet));
  if (auto sheet = wider(alike, 1.01)) {
    sheet->name = "region's proportions";
    sheets.push_back(std::move(*sheet));
  }
  return sheets;
}

}  // namespace kempe
