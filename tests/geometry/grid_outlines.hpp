#pragma once
// Outlines on whole numbers, as people type them: corners within straight edges, slots one step wide, notches as deep as
// their arms, holes. Reflex corners stand exactly on diagonals all the time, which random reals never do.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "geometry/region.hpp"

namespace kempe::test {

inline int whole_below(std::mt19937_64& random, int n) {
  return static_cast<int>(random() % static_cast<std::uint64_t>(n));
}

/// Unit cells that hang together by their sides.
class Cells {
 public:
  Cells(std::mt19937_64& random, int across, int count) : across_(across), taken_(index(across, 0)) {
    take(whole_below(random, across), whole_below(random, across));
    for (int i = 1, misses = 0; i < count && misses < 1000; ++misses) {
      const int x = whole_below(random, across);
      const int y = whole_below(random, across);
      if (at(x, y) || !(at(x - 1, y) || at(x + 1, y) || at(x, y - 1) || at(x, y + 1))) continue;
      take(x, y);
      ++i;
    }
  }

  /// Without cells that meet in a corner only: then no ring touches itself or another.
  void fill_corners() {
    for (bool again = true; std::exchange(again, false);)
      for (int x = 0; x + 1 < across_; ++x)
        for (int y = 0; y + 1 < across_; ++y) {
          if (at(x, y) != at(x + 1, y + 1) || at(x + 1, y) != at(x, y + 1) || at(x, y) == at(x + 1, y))
            continue;
          for (const auto& [i, j] : {std::pair{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}}) take(i, j);
          again = true;
        }
  }

  /// The outline with a corner at every whole number that it passes.
  Polygon outline() const {
    std::multimap<std::pair<int, int>, std::pair<int, int>> steps;  // with a cell on the left
    for (int x = 0; x < across_; ++x)
      for (int y = 0; y < across_; ++y) {
        if (!at(x, y)) continue;
        if (!at(x, y - 1)) steps.insert({{x, y}, {x + 1, y}});
        if (!at(x + 1, y)) steps.insert({{x + 1, y}, {x + 1, y + 1}});
        if (!at(x, y + 1)) steps.insert({{x + 1, y + 1}, {x, y + 1}});
        if (!at(x - 1, y)) steps.insert({{x, y + 1}, {x, y}});
      }
    Polygon polygon;
    while (!steps.empty()) {
      Ring ring;
      for (auto step = steps.begin(); step != steps.end(); step = steps.find(to_pair(ring.back()))) {
        ring.emplace_back(step->second.first, step->second.second);
        steps.erase(step);
      }
      if (signed_area(ring) > 0)
        polygon.outer = std::move(ring);
      else
        polygon.holes.push_back(std::move(ring));
    }
    return polygon;
  }

 private:
  static std::pair<int, int> to_pair(const Point& point) {
    return {static_cast<int>(point.x()), static_cast<int>(point.y())};
  }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(x * across_ + y); }
  bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < across_ && y < across_ && taken_[index(x, y)];
  }
  void take(int x, int y) { taken_[index(x, y)] = true; }

  int across_;
  std::vector<bool> taken_;
};

/// Twice the area of a triangle of whole numbers, exactly.
inline std::int64_t twice_area(const Point& a, const Point& b, const Point& c) {
  const auto whole = [](double value) { return static_cast<std::int64_t>(value); };
  return (whole(b.x()) - whole(a.x())) * (whole(c.y()) - whole(a.y())) -
         (whole(b.y()) - whole(a.y())) * (whole(c.x()) - whole(a.x()));
}

/// Closed segments of whole numbers.
inline bool segments_touch(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto sign = [](std::int64_t value) { return (value > 0) - (value < 0); };
  const int c_side = sign(twice_area(a, b, c)), d_side = sign(twice_area(a, b, d));
  const int a_side = sign(twice_area(c, d, a)), b_side = sign(twice_area(c, d, b));
  if (c_side != 0 || d_side != 0) return c_side * d_side <= 0 && a_side * b_side <= 0;
  const auto overlap = [](double p, double q, double r, double s) {
    return std::max(std::min(p, q), std::min(r, s)) <= std::min(std::max(p, q), std::max(r, s));
  };
  return overlap(a.x(), b.x(), c.x(), d.x()) && overlap(a.y(), b.y(), c.y(), d.y());
}

/// Random corners whose edges were turned round until none of them meet; nothing if they did not come apart.
inline std::optional<Ring> untangled_ring(std::mt19937_64& random, int corners, int across) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const int x = whole_below(random, across + 1);
    const int y = whole_below(random, across + 1);
    const Point corner(x, y);
    if (std::find(ring.begin(), ring.end(), corner) == ring.end()) ring.push_back(corner);
  }
  const std::size_t n = ring.size();
  if (n < 3) return std::nullopt;
  const auto at = [&](std::size_t i) { return ring[i % n]; };
  for (int round = 0; round < 200; ++round) {
    bool met = false;
    for (std::size_t i = 0; i < n; ++i) {
      // Neighbours meet in their corner; more than that if they fold back.
      met = met || (twice_area(at(i), at(i + 1), at(i + 2)) == 0 &&
                    (at(i) - at(i + 1)).dot(at(i + 2) - at(i + 1)) > 0);
      for (std::size_t j = i + 2; j < n; ++j) {
        if ((j + 1) % n == i || !segments_touch(at(i), at(i + 1), at(j), at(j + 1))) continue;
        std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i + 1),
                     ring.begin() + static_cast<std::ptrdiff_t>(j + 1));
        met = true;
      }
    }
    if (!met) {
      if (signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
      return ring;
    }
  }
  return std::nullopt;
}

/// The polygon under a matrix of whole numbers whose determinant is not 0, and a shift: slanted slots, needles.
inline Polygon mapped(const Polygon& polygon, const std::array<int, 4>& matrix, const Point& shift) {
  const bool mirrors = matrix[0] * matrix[3] < matrix[1] * matrix[2];
  const auto image = [&](Ring ring) {
    for (Point& point : ring)
      point = Point(matrix[0] * point.x() + matrix[1] * point.y(),
                    matrix[2] * point.x() + matrix[3] * point.y()) +
              shift;
    if (mirrors) std::reverse(ring.begin(), ring.end());
    return ring;
  };
  Polygon result{image(polygon.outer), {}};
  for (const Ring& hole : polygon.holes) result.holes.push_back(image(hole));
  return result;
}

/// A simple polygon on whole numbers of -4 to 4 times `across`: one in two has holes, most have flat corners.
inline Polygon grid_polygon(std::mt19937_64& random, int across) {
  Polygon polygon;
  if (random() % 2 == 0) {
    const int corners = 4 + whole_below(random, 12);
    auto ring = untangled_ring(random, corners, across);
    while (!ring) ring = untangled_ring(random, corners, across);
    polygon.outer = std::move(*ring);
  } else {
    Cells cells(random, across, 2 + whole_below(random, across * across));
    cells.fill_corners();
    polygon = cells.outline();
  }
  std::array<int, 4> matrix{1, 0, 0, 1};
  if (random() % 2 == 0) do
      for (int& entry : matrix) entry = whole_below(random, 5) - 2;
    while (matrix[0] * matrix[3] == matrix[1] * matrix[2]);
  return mapped(polygon, matrix, Point::Zero());
}

/// The same about a place, on multiples of a power of two, not farther from it than about `radius`.
inline Polygon grid_polygon_about(std::mt19937_64& random, const Point& centre, double radius) {
  Polygon polygon = grid_polygon(random, 3 + whole_below(random, 4));
  Point lower = polygon.outer[0], upper = lower;
  for (const Point& corner : polygon.outer) lower = lower.cwiseMin(corner), upper = upper.cwiseMax(corner);
  const double step = std::exp2(std::floor(std::log2(2 * radius / (upper - lower).norm())));
  const Point shift = (centre / step - 0.5 * (lower + upper)).array().round().matrix();
  const auto place = [&](Ring& ring) {
    for (Point& corner : ring) corner = step * (corner + shift);
  };
  place(polygon.outer);
  for (Ring& hole : polygon.holes) place(hole);
  return polygon;
}

/// The ring from another of its corners on.
inline Ring from_corner(Ring ring, std::size_t first) {
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
  return ring;
}

}  // namespace kempe::test
