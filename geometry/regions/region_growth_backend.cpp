// Growth and union with exact Boolean operations of CGAL. Coordinates are exact until the end, where they are
// rounded to doubles; the result is examined again after that.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/convex_hull_2.h>
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

/// What growth by a convex polygon around the origin adds beside a ring that runs with the region to its left: beside
/// each edge what its way to the polygon's outermost corner there passes, and at each convex corner the sector
/// between the outermost corners of its two edges. What is reached a share of the way lies there too, as the outline
/// grown by that share is made of the same corners; so region and additions together are Minkowski's sum.
class RingGrowth {
 public:
  RingGrowth(const Ring& ring, const std::vector<ExactPoint>& convex) : convex_(convex) {
    for (const Point& corner : ring) corners_.emplace_back(corner.x(), corner.y());
  }

  void append_to(std::vector<ExactPart>& parts) const {
    const std::size_t count = corners_.size();
    Outermost before = outermost(corners_[count - 1], corners_[0]);
    for (std::size_t i = 0; i < count; ++i) {
      const ExactPoint &from = corners_[i], &to = corners_[(i + 1) % count];
      const Outermost here = outermost(from, to);
      if (CGAL::left_turn(corners_[(i + count - 1) % count], from, to) && before.last != here.first)
        parts.emplace_back(sector(from, before.last, here.first));
      ExactRing& beside = parts.emplace_back().outer_boundary();
      for (const ExactPoint& corner : {from, moved(from, here.first), moved(to, here.last), to})
        beside.push_back(corner);
      before = here;
    }
  }

 private:
  /// The polygon's corners farthest to the right of an edge: two where the edge is parallel to one of its own.
  struct Outermost {
    std::size_t first, last;
  };

  std::size_t next(std::size_t corner) const { return (corner + 1) % convex_.size(); }

  Outermost outermost(const ExactPoint& from, const ExactPoint& to) const {
    const auto along = to - from;
    const auto turn_after = [&](std::size_t corner) {
      return CGAL::orientation(convex_[next(corner)] - convex_[corner], along);
    };
    const auto before = [&](std::size_t corner) { return (corner + convex_.size() - 1) % convex_.size(); };
    const double bearing = std::atan2(CGAL::to_double(along.y()), CGAL::to_double(along.x())) - pi / 2;
    const double size = static_cast<double>(convex_.size());
    auto corner =
        static_cast<std::size_t>(std::lround(bearing / (2 * pi) * size + 2 * size)) % convex_.size();
    while (turn_after(corner) == CGAL::LEFT_TURN) corner = next(corner);
    while (turn_after(before(corner)) != CGAL::LEFT_TURN) corner = before(corner);
    return {corner, turn_after(corner) == CGAL::COLLINEAR ? next(corner) : corner};
  }

  ExactPoint moved(const ExactPoint& corner, std::size_t by) const {
    return corner + (convex_[by] - ExactPoint(0, 0));
  }

  ExactRing sector(const ExactPoint& corner, std::size_t first, std::size_t last) const {
    ExactRing result;
    result.push_back(corner);
    for (std::size_t i = first; i != last; i = next(i)) result.push_back(moved(corner, i));
    result.push_back(moved(corner, last));
    return result;
  }

  const std::vector<ExactPoint>& convex_;
  std::vector<ExactPoint> corners_;
};

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
  const std::vector<ExactPoint> disc = around_disc(Point::Zero(), margin);
  std::vector<ExactPart> parts;
  for (const Polygon& polygon : region.polygons) {
    ExactPart whole(exact(polygon.outer));
    for (const Ring& hole : polygon.holes) whole.add_hole(exact(hole));
    parts.push_back(std::move(whole));
    RingGrowth(polygon.outer, disc).append_to(parts);
    for (const Ring& hole : polygon.holes) RingGrowth(hole, disc).append_to(parts);
  }
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
