// Growth and union with exact Boolean operations of CGAL. Coordinates are exact until the end, where they are
// rounded to doubles; the result is examined again after that.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/minkowski_sum_2.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "geometry/regions/region_checks.hpp"
#include "geometry/regions/region_growth.hpp"
#include "geometry/regions/ring_loops.hpp"

namespace kempe {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_2;
using ExactRing = CGAL::Polygon_2<Kernel>;
using ExactPart = CGAL::Polygon_with_holes_2<Kernel>;
using ExactRegion = CGAL::Polygon_set_2<Kernel>;

/// Corners of the polygon around a disc: it exceeds the radius by 0.12 %.
constexpr int disc_corners = 64;
/// More corners or strokes than these take minutes.
constexpr std::size_t most_grown_corners = 20'000;
constexpr std::size_t most_stroke_edges = 20'000;
constexpr std::size_t most_united_corners = 200'000;

ExactRing exact(const Ring& ring) {
  ExactRing result;
  for (const Point& corner : ring) result.push_back(ExactPoint(corner.x(), corner.y()));
  return result;
}

/// Whether the disc is higher or wider than the hole, which growth then fills.
bool is_filled(const ExactRing& hole, const ExactRing& disc) {
  const CGAL::Bbox_2 of_hole = hole.bbox(), of_disc = disc.bbox();
  return of_hole.ymax() - of_hole.ymin() < of_disc.ymax() - of_disc.ymin() ||
         of_hole.xmax() - of_hole.xmin() < of_disc.xmax() - of_disc.xmin();
}

/// The polygon grown by the disc. Holes that it fills are left out beforehand: CGAL 5.5 erases them one by one through
/// iterators that the first erasure has made invalid (Hole_filter_2.h), and with two of them memory is wrong.
ExactPart grown(const Polygon& polygon, const ExactRing& disc) {
  ExactPart open(exact(polygon.outer));
  for (const Ring& hole : polygon.holes)
    if (ExactRing ring = exact(hole); !is_filled(ring, disc)) open.add_hole(std::move(ring));
  return CGAL::minkowski_sum_2(open, disc);
}

Ring rounded(const ExactRing& ring) {
  Ring result;
  for (const ExactPoint& corner : ring.container()) {
    result.emplace_back(CGAL::to_double(corner.x()), CGAL::to_double(corner.y()));
  }
  return result;
}

/// The regular polygon around a disc, counter-clockwise, with edges that touch it where it is upright or
/// level.
std::vector<ExactPoint> around_disc(const Point& centre, double radius) {
  const double reach = radius / std::cos(pi / disc_corners);
  std::vector<ExactPoint> corners;
  for (int i = 0; i < disc_corners; ++i) {
    const Point corner = centre + as_point(std::polar(reach, 2 * pi * (i + 0.5) / disc_corners));
    corners.emplace_back(corner.x(), corner.y());
  }
  return corners;
}

ExactRing around_stroke_edge(const Point& from, const Point& to, double margin) {
  std::vector<ExactPoint> corners = around_disc(from, margin);
  const std::vector<ExactPoint> others = around_disc(to, margin);
  corners.insert(corners.end(), others.begin(), others.end());
  std::vector<ExactPoint> hull;
  CGAL::convex_hull_2(corners.begin(), corners.end(), std::back_inserter(hull));
  return {hull.begin(), hull.end()};
}

std::size_t corner_count(const Region& region) {
  std::size_t count = 0;
  for (const Polygon& polygon : region.polygons) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

/// Back to doubles. Holes that rounding closes are left closed: the result may only be larger.
tl::expected<Region, std::string> rounded(const ExactRegion& exact_region) {
  std::vector<ExactPart> polygons;
  exact_region.polygons_with_holes(std::back_inserter(polygons));
  std::vector<Ring> outers, holes;
  for (const ExactPart& polygon : polygons) {
    outers.push_back(rounded(polygon.outer_boundary()));
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
      Ring ring = without_repeated_corners(rounded(*hole));
      if (!shape_fault(ring)) holes.push_back(std::move(ring));
    }
  }
  auto region = assemble_region(outers, holes);
  if (region) return std::move(*region);
  return tl::unexpected(region.error().found);
}

std::string too_many(std::string_view what, std::size_t count, std::size_t most) {
  return fmt::format("{} {}; at most {} are allowed", count, what, most);
}

}  // namespace

tl::expected<Region, std::string> grown(const Region& region, double margin) {
  if (margin == 0 || region.empty()) return region;
  const std::size_t corners = corner_count(region);
  if (corners > most_grown_corners)
    return tl::unexpected(too_many("corners to grow", corners, most_grown_corners));
  const std::vector<ExactPoint> disc_ring = around_disc(Point::Zero(), margin);
  const ExactRing disc(disc_ring.begin(), disc_ring.end());
  std::vector<ExactPart> parts;
  for (const Polygon& polygon : region.polygons) parts.push_back(grown(polygon, disc));
  ExactRegion sum;
  sum.join(parts.begin(), parts.end());
  return rounded(sum);
}

tl::expected<Region, std::string> grown(const std::vector<Stroke>& strokes, double margin) {
  std::vector<ExactRing> parts;
  for (const Stroke& stroke : strokes) {
    if (stroke.size() == 1) parts.push_back(around_stroke_edge(stroke[0], stroke[0], margin));
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      parts.push_back(around_stroke_edge(stroke[i - 1], stroke[i], margin));
    }
    if (parts.size() > most_stroke_edges) {
      return tl::unexpected(too_many("or more strokes", parts.size(), most_stroke_edges));
    }
  }
  ExactRegion sum;
  sum.join(parts.begin(), parts.end());
  return rounded(sum);
}

tl::expected<Region, std::string> united(const std::vector<Ring>& rings) {
  std::vector<ExactRing> parts;
  std::size_t corners = 0;
  for (const Ring& ring : rings) {
    corners += ring.size();
    if (corners > most_united_corners) {
      return tl::unexpected(too_many("or more corners to unite", corners, most_united_corners));
    }
    const auto loops = simple_loops(ring);
    if (!loops) return tl::unexpected(std::string("a ring that crosses itself too often"));
    for (const Ring& loop : *loops) parts.push_back(exact(loop));
  }
  ExactRegion sum;
  sum.join(parts.begin(), parts.end());
  return rounded(sum);
}

}  // namespace kempe
