// Obstacles as convex parts: with holes and without, against their area and random points; on whole numbers exactly, in
// integers and without any function of the rooms.
#include "geometry/regions/convex_parts.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "tests/geometry/grid_outlines.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

double area_of(const ConvexPart& part) {
  double twice = 0;
  for (std::size_t i = 0; i < part.size(); ++i)
    twice += std::imag(std::conj(part[i]) * part[(i + 1) % part.size()]);
  return twice / 2;
}

bool holds(const ConvexPart& part, Complex place) {
  for (std::size_t i = 0; i < part.size(); ++i)
    if (std::imag(std::conj(part[(i + 1) % part.size()] - part[i]) * (place - part[i])) < 0) return false;
  return true;
}

/// A square ring, clockwise as holes are.
Ring hole_at(double x, double y, double half) {
  return {{x - half, y - half}, {x - half, y + half}, {x + half, y + half}, {x + half, y - half}};
}

TEST(ConvexParts, CoverThePolygonAndNothingElse) {
  test::SpecDice dice(12);
  for (int i = 0; i < 200; ++i) {
    const double x = dice.uniform(-50, 50), y = dice.uniform(-50, 50);
    Polygon polygon = dice.star({x, y}, 100, 3 + i % 20);  // all within 20 of its centre is inside
    if (i % 2 == 1)
      polygon.holes = {hole_at(x - 6, y - 3, 2.5), hole_at(x + 5, y + 4, 2.5), hole_at(x, y + 12, 2.5)};
    const Region region{{polygon}};
    const std::vector<ConvexPart> parts = convex_parts(polygon);
    double sum = 0;
    for (const ConvexPart& part : parts) {
      EXPECT_GT(area_of(part), 0);
      sum += area_of(part);
    }
    EXPECT_NEAR(sum, area(region), 1e-9 * area(region)) << i;
    for (int j = 0; j < 50; ++j) {
      const Point place(dice.uniform(-160, 160), dice.uniform(-160, 160));
      const bool held = std::any_of(parts.begin(), parts.end(), [&](const ConvexPart& part) {
        return holds(part, {place.x(), place.y()});
      });
      EXPECT_EQ(held, contains(region, place)) << i;
    }
  }
}

// On whole numbers ---------------------------------------------------------------------------------------------------

struct Whole {
  std::int64_t x, y;
  auto operator<=>(const Whole&) const = default;
};
using WholeRing = std::vector<Whole>;

std::int64_t twice_area(const Whole& a, const Whole& b, const Whole& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::int64_t twice_area(const WholeRing& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += twice_area(ring[0], ring[i], ring[i + 1]);
  return sum;
}

/// Places are looked at on a grid this much finer than the corners'.
constexpr std::int64_t finer = 8;

Whole whole(double x, double y) {
  return {finer * static_cast<std::int64_t>(x), finer * static_cast<std::int64_t>(y)};
}

WholeRing whole(const Ring& ring) {
  WholeRing result;
  for (const Point& point : ring) result.push_back(whole(point.x(), point.y()));
  return result;
}

WholeRing whole(const ConvexPart& part) {
  WholeRing result;
  for (const Complex& corner : part) result.push_back(whole(corner.real(), corner.imag()));
  return result;
}

enum class Side { out, on, in };

/// By counting the edges that a ray to the right crosses.
Side side_of(const std::vector<WholeRing>& rings, const Whole& place) {
  bool in = false;
  for (const WholeRing& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Whole &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const std::int64_t area = twice_area(a, b, place);
      if (area == 0 && std::min(a.x, b.x) <= place.x && place.x <= std::max(a.x, b.x) &&
          std::min(a.y, b.y) <= place.y && place.y <= std::max(a.y, b.y))
        return Side::on;
      if ((a.y <= place.y) != (b.y <= place.y) && (area > 0) == (b.y > a.y)) in = !in;
    }
  return in ? Side::in : Side::out;
}

/// Places beside every corner, where a part that reaches too far must show, and places all over the polygon's box.
std::vector<Whole> places_to_look_at(const std::vector<WholeRing>& rings, std::mt19937_64& random) {
  std::vector<Whole> places;
  for (const WholeRing& ring : rings)
    for (const Whole& corner : ring)
      for (const Whole& step : {Whole{1, 2}, {2, -1}, {-1, -2}, {-2, 1}})
        places.push_back({corner.x + step.x, corner.y + step.y});
  Whole lower = rings[0][0], upper = lower;
  for (const Whole& corner : rings[0]) {
    lower = {std::min(lower.x, corner.x), std::min(lower.y, corner.y)};
    upper = {std::max(upper.x, corner.x), std::max(upper.y, corner.y)};
  }
  for (int i = 0; i < 60; ++i) {
    const std::int64_t x =
        lower.x + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(upper.x - lower.x));
    const std::int64_t y =
        lower.y + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(upper.y - lower.y));
    places.push_back({x, y});
  }
  return places;
}

std::size_t reflex_corners(const std::vector<WholeRing>& rings) {
  std::size_t count = 0;
  for (const WholeRing& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      count += twice_area(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) < 0;
  return count;
}

/// Every guarantee of convex_parts(), exactly; "" if all hold.
std::string fault_of_parts(const Polygon& polygon, std::mt19937_64& random) {
  std::vector<WholeRing> rings{whole(polygon.outer)};
  for (const Ring& hole : polygon.holes) rings.push_back(whole(hole));
  std::set<Whole> corners;
  std::int64_t area = 0, area_of_parts = 0;
  for (const WholeRing& ring : rings) {
    area += twice_area(ring);
    corners.insert(ring.begin(), ring.end());
  }
  std::vector<std::vector<WholeRing>> parts;
  for (const ConvexPart& part : convex_parts(polygon)) {
    const WholeRing ring = whole(part);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!corners.count(ring[i])) return "a corner of a part that is none of the polygon";
      if (twice_area(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) < 0)
        return "a part not convex";
    }
    if (twice_area(ring) <= 0) return "a part without an area";
    area_of_parts += twice_area(ring);
    parts.push_back({ring});
  }
  if (parts.size() > 2 * reflex_corners(rings) + 1) return "more parts than need be";
  if (area_of_parts != area) return "areas that do not add up";
  for (const Whole& place : places_to_look_at(rings, random)) {
    const auto parts_at = [&](Side side) {
      return std::count_if(parts.begin(), parts.end(),
                           [&](const auto& part) { return side_of(part, place) == side; });
    };
    const Side side = side_of(rings, place);
    if (side == Side::out && parts_at(Side::out) < static_cast<std::ptrdiff_t>(parts.size()))
      return "a part outside";
    if (side == Side::in && parts_at(Side::in) == 0 && parts_at(Side::on) < 2)
      return "a place inside that no part covers";
    if (parts_at(Side::in) > 1) return "parts that overlap";
  }
  return "";
}

std::string told(const Polygon& polygon) {
  std::ostringstream text;
  for (const Point& corner : polygon.outer) text << "[" << corner.x() << ", " << corner.y() << "] ";
  text << "and " << polygon.holes.size() << " holes";
  return text.str();
}

TEST(ConvexParts, AreExactOnWholeNumbersFromEveryCorner) {
  std::mt19937_64 random(21);
  int with_holes = 0, not_convex = 0;
  for (int i = 0; i < test::samples(4000); ++i) {
    Polygon polygon = test::grid_polygon(random, 3 + i % 6);
    if (i % 5 == 0) polygon = test::mapped(polygon, {1, 0, 0, 1}, {-3'000'000, 7'000'001});
    with_holes += !polygon.holes.empty();
    not_convex += convex_parts(polygon).size() > 1;
    for (std::size_t first = 0; first < polygon.outer.size(); ++first) {
      const Polygon listed{test::from_corner(polygon.outer, first), polygon.holes};
      ASSERT_EQ(fault_of_parts(listed, random), "") << told(listed);
    }
  }
  EXPECT_GT(with_holes, test::expected(200));
  EXPECT_GT(not_convex, test::expected(2000));
}

TEST(ConvexParts, AreExactWhereRingsTouchInACorner) {
  std::mt19937_64 random(22);
  int tried = 0;
  for (int i = 0; i < test::samples(2000); ++i) {
    const int count = 4 + test::whole_below(random, 24);
    const Polygon polygon = test::Cells(random, 6, count).outline();
    if (polygon.outer.empty()) continue;
    ++tried;
    ASSERT_EQ(fault_of_parts(polygon, random), "") << told(polygon);
  }
  EXPECT_GT(tried, test::expected(1500));
}

TEST(ConvexParts, AreExactForNeedles) {
  std::mt19937_64 random(23);
  for (int i = 0; i < test::samples(500); ++i) {
    const Polygon polygon = test::mapped(test::grid_polygon(random, 5), {1000, 999, 999, 998}, {0, 0});
    ASSERT_EQ(fault_of_parts(polygon, random), "") << told(polygon);
  }
}

}  // namespace
}  // namespace kempe
