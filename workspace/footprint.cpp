#include "workspace/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/edge_tree.hpp"
#include "workspace/grid_outline.hpp"
#include "workspace/linkage_motion.hpp"
#include "workspace/parts.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// Angles from `from` counter-clockwise to `to`, rad; from <= to.
struct Bearings {
  double from, to;
};

/// Those that overlap, or come as near to each other as `gap`, joined, by rising angle.
std::vector<Bearings> merged(std::vector<Bearings> all, double gap = 0) {
  std::sort(all.begin(), all.end(), [](const Bearings& a, const Bearings& b) { return a.from < b.from; });
  std::vector<Bearings> found;
  for (const Bearings& one : all) {
    if (!found.empty() && one.from <= found.back().to + gap)
      found.back().to = std::max(found.back().to, one.to);
    else
      found.push_back(one);
  }
  return found;
}

/// The angles shifted by every bearing between two, cut at a whole turn.
void add_turned(const Bearings& angles, const Bearings& turned, std::vector<Bearings>& all) {
  const double width = std::min(2 * pi, angles.to - angles.from + turned.to - turned.from);
  double from = angles.from + turned.from;
  from -= 2 * pi * std::floor(from / (2 * pi));
  all.push_back({from, std::min(from + width, 2 * pi)});
  if (from + width > 2 * pi) all.push_back({0, from + width - 2 * pi});
}

/// Rings and bins about the pole, filled by angles; a difference array a ring.
class PolarBins {
 public:
  PolarBins(const FootprintGrid& grid, double radius)
      : rings_(grid.rings), bins_(grid.bins), step_(radius / grid.rings),
        change_(static_cast<std::size_t>(rings_ * (bins_ + 1)), 0) {}

  int rings() const { return rings_; }
  double step() const { return step_; }
  double middle(int ring) const { return (ring + 0.5) * step_; }

  /// All bins that hold some of the angles.
  void fill(int ring, const Bearings& angles) {
    const double per_bin = bins_ / (2 * pi);
    if (angles.to - angles.from >= 2 * pi) return add(ring, 0, bins_);
    const double first = std::floor(angles.from * per_bin), past = std::ceil(angles.to * per_bin);
    const int count = std::min(bins_, static_cast<int>(past - first));
    const int start = static_cast<int>(first - bins_ * std::floor(first / bins_));
    add(ring, start, std::min(bins_, start + count));
    if (start + count > bins_) add(ring, 0, start + count - bins_);
  }

  /// Runs of filled bins of a ring, [from, to).
  std::vector<std::array<int, 2>> runs(int ring) const {
    std::vector<std::array<int, 2>> found;
    int depth = 0;
    for (int bin = 0; bin <= bins_; ++bin) {
      const int before = depth;
      depth += bin < bins_ ? change_[at(ring, bin)] : -depth;
      if (before == 0 && depth > 0) found.push_back({bin, bin});
      if (before > 0 && depth == 0) found.back()[1] = bin;
    }
    return found;
  }

  double area() const {
    double sum = 0;
    for (int ring = 0; ring < rings_; ++ring)
      for (const auto& [from, to] : runs(ring)) sum += (to - from) * middle(ring);
    return sum * step_ * 2 * pi / bins_;
  }

 private:
  std::size_t at(int ring, int bin) const {
    return static_cast<std::size_t>(ring) * static_cast<std::size_t>(bins_ + 1) +
           static_cast<std::size_t>(bin);
  }
  void add(int ring, int from, int to) {
    if (to <= from) return;
    ++change_[at(ring, from)];
    --change_[at(ring, to)];
  }

  int rings_, bins_;
  double step_;
  std::vector<int> change_;
};

/// A convex piece of a link at rest, grown by `half_width`; the pole at the origin. Three corners run counter-clockwise.
class GrownPiece {
 public:
  GrownPiece(const std::array<Point, 3>& corners, int count, double half_width)
      : count_(count), half_width_(half_width) {
    for (std::size_t i = 0; i < size(); ++i) {
      Side& side = sides_[i];
      side.from = corners[i];
      side.along = corners[(i + 1) % size()] - corners[i];
      side.length = side.along.norm();
      if (side.length > 0) side.along /= side.length;
      side.outward = {side.along.y(), -side.along.x()};
      side.height = side.outward.dot(side.from) + half_width;
      side.away = side.from.norm();
      side.from_bearing = std::atan2(side.from.y(), side.from.x());
      side.outward_bearing = std::atan2(side.outward.y(), side.outward.x());
    }
  }

  /// How near to the pole and how far from it the piece comes.
  double nearest() const { return std::max(0.0, std::sqrt(squared_distance(Point::Zero())) - half_width_); }
  double farthest() const {
    double far = 0;
    for (std::size_t i = 0; i < size(); ++i) far = std::max(far, sides_[i].away);
    return far + half_width_;
  }

  /// The angles of the circle of radius rho about the pole that lie in the piece; replaces `found`.
  void angles_in(double rho, std::vector<Bearings>& found) const {
    found.clear();
    Crossings angles;
    crossings(rho, angles);
    if (angles.count == 0) {
      if (has(rho, 0)) found.push_back({0, 2 * pi});
      return;
    }
    for (std::size_t i = 0; i < angles.count; ++i) {
      const double from = angles.at[i], to = i + 1 < angles.count ? angles.at[i + 1] : angles.at[0] + 2 * pi;
      if (!has(rho, 0.5 * (from + to))) continue;
      if (!found.empty() && found.back().to == from)
        found.back().to = to;
      else
        found.push_back({from, to});
    }
  }

 private:
  /// A corner and the straight outline beside the edge that leaves it.
  struct Side {
    Point from = Point::Zero(), along = Point::Zero(), outward = Point::Zero();
    double length = 0, height = 0;  ///< of the edge; of the outline's line over the pole
    double away = 0, from_bearing = 0, outward_bearing = 0;
  };
  struct Crossings {
    std::array<double, 12> at;
    std::size_t count = 0;
    void add(double angle) { at[count++] = angle - 2 * pi * std::floor(angle / (2 * pi)); }
  };

  std::size_t size() const { return static_cast<std::size_t>(count_); }

  double squared_distance(const Point& point) const {
    double least = std::numeric_limits<double>::infinity();
    bool inside = count_ == 3;
    for (std::size_t i = 0; i < size(); ++i) {
      const Side& side = sides_[i];
      const Point from = point - side.from;
      const double share = std::clamp(from.dot(side.along), 0.0, side.length);
      least = std::min(least, (from - share * side.along).squaredNorm());
      inside = inside && side.outward.dot(from) < 0;
    }
    return inside ? 0 : least;
  }

  bool has(double rho, double bearing) const {
    return squared_distance(rho * Point(std::cos(bearing), std::sin(bearing))) <= half_width_ * half_width_;
  }

  /// Angles at which the circle passes the outline, in rising order: its straight parts and its round corners. What
  /// rounding puts at an end of both is listed twice, which does no harm.
  void crossings(double rho, Crossings& found) const {
    const double slack = 1e-9 * (rho + half_width_);
    for (std::size_t i = 0; i < size(); ++i) {
      const Side &side = sides_[i], &before = sides_[(i + size() - 1) % size()];
      if (side.away > 0) {
        // The circle passes that of the corner at two points, beyond both edges where they are of the outline.
        const double forth =
            (rho * rho + side.away * side.away - half_width_ * half_width_) / (2 * side.away);
        if (std::abs(forth) < rho) {
          const double aside = std::sqrt(rho * rho - forth * forth), half = std::acos(forth / rho);
          const Point ahead = side.from / side.away, left(-ahead.y(), ahead.x());
          for (const double sign : {-1.0, 1.0}) {
            const Point out = forth * ahead + sign * aside * left - side.from;
            if (out.dot(side.along) <= slack && out.dot(before.along) >= -slack)
              found.add(side.from_bearing + sign * half);
          }
        }
      }
      if (side.length > 0 && std::abs(side.height) < rho) {
        const double aside = std::sqrt(rho * rho - side.height * side.height),
                     half = std::acos(side.height / rho);
        const double start = side.from.dot(side.along);
        for (const double sign : {-1.0, 1.0}) {  // `along` lies a quarter turn ahead of `outward`
          const double share = sign * aside - start;
          if (share >= -slack && share <= side.length + slack) found.add(side.outward_bearing + sign * half);
        }
      }
    }
    std::sort(found.at.begin(), found.at.begin() + static_cast<std::ptrdiff_t>(found.count));
  }

  std::array<Side, 3> sides_;
  int count_;
  double half_width_;
};

/// Bearings at which the region has points at distances inner .. outer from the pole (the origin): the
/// projection of a closed set is that of its boundary, and its boundary is made of the region's edges and of
/// both circles.
class RegionBearings {
 public:
  RegionBearings(const Region& region, const Point& pole) : edges_(region, pole) {}

  /// Gaps between bearings up to `gap` are filled.
  std::vector<Bearings> between(double inner, double outer, double gap = 0) const {
    std::vector<Bearings> found;
    for_each_edge_between(
        inner, outer, [&](const EdgeTree::Edge& edge) { add_edge(edge.from, edge.to, inner, outer, found); });
    add_circle(inner, found);
    if (outer > inner) add_circle(outer, found);
    return merged(std::move(found), gap);
  }

 private:
  /// Calls `visit(edge)` for all edges that come between two distances from the pole, and for few others.
  template <class Visit>
  void for_each_edge_between(double inner, double outer, Visit visit) const {
    constexpr double rounding = 1e-12;
    for_each_edge(
        edges_,
        [&](const Box& box) {
          const Point far = box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs());
          return far.squaredNorm() >= inner * inner &&
                 distance(box, {Point::Zero(), Point::Zero()}) <= outer * (1 + rounding);
        },
        visit);
  }

  /// Shares of the edge a-b at which it is `radius` from the pole, in order.
  static std::array<double, 2> shares_at(const Point& a, const Point& b, double radius) {
    const Point along = b - a;
    const double length2 = along.squaredNorm(), foot = -a.dot(along) / length2;
    const double under = radius * radius - (a + foot * along).squaredNorm();
    const double half = under > 0 ? std::sqrt(under / length2) : 0;
    return {foot - half, foot + half};
  }

  static void add_piece(const Point& a, const Point& b, double from, double to,
                        std::vector<Bearings>& found) {
    if (from > to) return;
    const Point first = a + from * (b - a), last = a + to * (b - a);
    const double start = std::atan2(first.y(), first.x());
    const double turn = std::atan2(cross(first, last), first.dot(last));
    found.push_back({std::min(start, start + turn), std::max(start, start + turn)});
  }

  static void add_edge(const Point& a, const Point& b, double inner, double outer,
                       std::vector<Bearings>& found) {
    const double far2 = std::max(a.squaredNorm(), b.squaredNorm());
    if (far2 < inner * inner || !((b - a).squaredNorm() > 0)) return;
    const auto out = shares_at(a, b, outer), in = shares_at(a, b, inner);
    const double from = std::max(0.0, out[0]), to = std::min(1.0, out[1]);
    const bool passes_hole = in[1] > in[0];
    add_piece(a, b, from, passes_hole ? std::min(to, in[0]) : to, found);
    if (passes_hole) add_piece(a, b, std::max(from, in[1]), to, found);
  }

  void add_circle(double radius, std::vector<Bearings>& found) const {
    std::vector<double> angles;
    for_each_edge_between(radius, radius, [&](const EdgeTree::Edge& edge) {
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
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double to = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * pi;
      if (inside(0.5 * (angles[i] + to))) found.push_back({angles[i], to});
    }
  }

  EdgeTree edges_;  ///< seen from the pole
};

/// What one sweep needs beside the bins.
struct Sweep {
  const CopyingLinkage& linkage;
  const LinkStyle& style;
  OpeningInterval openings;
  bool outward;  ///< grow, so that nothing is missed
};

std::vector<GrownPiece> pieces_at(const Sweep& sweep, const LinkageMotion& motion, double opening,
                                  double half_slab, double half_ring) {
  const MovingJoints joints = motion.over(opening, sweep.outward ? half_slab : 0, 0, 0);
  std::vector<GrownPiece> pieces;
  for (const Link link : all_links)
    for (const JointHull& hull :
         axis_of({.kind = Part::Kind::link, .link = link}, sweep.linkage.shape(), sweep.style.plate)) {
      std::array<Point, 3> corners;
      double half_width = 0.5 * sweep.style.width, strays = 0;
      for (int i = 0; i < hull.count; ++i) {
        const MovingJoint& joint = joints[static_cast<std::size_t>(hull.joints[static_cast<std::size_t>(i)])];
        corners[static_cast<std::size_t>(i)] = joint.at;
        strays = std::max(strays, joint.reach);
      }
      if (hull.count == 3 && cross(corners[1] - corners[0], corners[2] - corners[0]) < 0)
        std::swap(corners[1], corners[2]);
      if (sweep.outward) half_width += strays + half_ring;
      pieces.emplace_back(corners, hull.count, half_width);
    }
  return pieces;
}

void fill_slab(const std::vector<GrownPiece>& pieces, const std::vector<Bearings>& bearings,
               PolarBins& bins) {
  std::vector<Bearings> found;
  for (const GrownPiece& piece : pieces) {
    const int first = std::max(0, static_cast<int>(piece.nearest() / bins.step()) - 1);
    const int last = std::min(bins.rings() - 1, static_cast<int>(piece.farthest() / bins.step()) + 1);
    for (int ring = first; ring <= last; ++ring) {
      piece.angles_in(bins.middle(ring), found);
      for (const Bearings& angles : found)
        for (const Bearings& turned : bearings)
          bins.fill(ring, {angles.from + turned.from, angles.to + turned.to});
    }
  }
}

std::optional<PolarBins> swept_bins(const CopyingLinkage& linkage, const LinkStyle& style,
                                    const Region& region, const FootprintGrid& grid) {
  const OpeningInterval openings = openings_met(linkage, region);
  if (openings.empty()) return std::nullopt;
  const Sweep sweep{linkage, style, openings, true};
  const LinkageMotion motion(linkage);
  double farthest = 0;
  for (const Joint joint : all_joints) farthest = std::max(farthest, motion.farthest(joint));
  PolarBins bins(grid, 1.05 * (farthest + style.width));
  const RegionBearings region_bearings(region, linkage.pole());
  const double half_slab = openings.width() / grid.slabs / 2;
  const double one_bin = 2 * pi / grid.bins;  // what lies between is swept to within the grid anyway
  for (int slab = 0; slab < grid.slabs; ++slab) {
    const double opening = openings.lower + (2 * slab + 1) * half_slab;
    const double a = linkage.radius_at(opening - half_slab), b = linkage.radius_at(opening + half_slab);
    const auto bearings = region_bearings.between(std::min(a, b), std::max(a, b), one_bin);
    fill_slab(pieces_at(sweep, motion, opening, half_slab, bins.step() / 2), bearings, bins);
  }
  return bins;
}

/// A ring of the grid's outline in the plane. Outer arcs are drawn outside their circle, so that chords do
/// not cut in.
Ring in_the_plane(const GridRing& ring, const FootprintGrid& grid, double step, const Point& pole,
                  std::int64_t unit_x) {
  constexpr int chord_bins = 16;
  const double bin = 2 * pi / grid.bins;
  Ring result;
  for (std::size_t i = 0; i < ring.corners.size(); ++i) {
    const GridPoint from = ring.corners[i], to = ring.corners[(i + 1) % ring.corners.size()];
    const double first = static_cast<double>(from.x) / static_cast<double>(unit_x);
    double past = static_cast<double>(to.x) / static_cast<double>(unit_x);
    if (i + 1 == ring.corners.size()) past += ring.winding * grid.bins;
    const double radius = static_cast<double>(from.y) / 16.0 * step;
    const double outward = past < first ? 1 / std::cos(0.5 * chord_bins * bin) : 1;
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(past - first) / chord_bins)));
    for (int j = 0; j < pieces; ++j) {
      const double angle = (first + (past - first) * j / pieces) * bin;
      result.push_back(pole + outward * radius * Point(std::cos(angle), std::sin(angle)));
    }
  }
  std::reverse(result.begin(), result.end());  // bearing and distance make a left-handed frame
  return result;
}

/// Outer rings counter-clockwise with the holes of the same component.
Region outline_in_the_plane(const PolarBins& bins, const FootprintGrid& grid, const Point& pole) {
  const std::int64_t unit_x = static_cast<std::int64_t>(AngleGrid::turn) / grid.bins;
  std::vector<GridCell> cells;
  for (int ring = 0; ring < bins.rings(); ++ring)
    for (const auto& [from, to] : bins.runs(ring))
      cells.push_back({static_cast<std::uint32_t>(from * unit_x), static_cast<std::uint32_t>(ring * 16),
                       static_cast<std::uint32_t>((to - from) * unit_x), 16});
  const GridOutline outline = outline_of(cells, Corners::join);
  std::vector<std::pair<std::size_t, Polygon>> parts;
  for (const bool holes : {false, true})
    for (const GridRing& ring : outline.rings) {
      Ring points = in_the_plane(ring, grid, bins.step(), pole, unit_x);
      if (signed_area(points) == 0 || (signed_area(points) < 0) != holes) continue;  // 0: the pole itself
      if (!holes)
        parts.push_back({ring.component, {std::move(points), {}}});
      else
        for (auto& [component, polygon] : parts)
          if (component == ring.component) polygon.holes.push_back(points);
    }
  Region region;
  for (auto& part : parts) region.polygons.push_back(std::move(part.second));
  return region;
}

}  // namespace

Footprint footprint(const CopyingLinkage& linkage, const LinkStyle& style, const Region& region,
                    const FootprintGrid& grid) {
  const auto bins = swept_bins(linkage, style, region, grid);
  if (!bins) return {};
  return {bins->area(), outline_in_the_plane(*bins, grid, linkage.pole())};
}

double footprint_estimate(const CopyingLinkage& linkage, const LinkStyle& style, const Region& region,
                          const FootprintGrid& grid) {
  const OpeningInterval openings = openings_met(linkage, region);
  if (openings.empty()) return 0;
  const Sweep sweep{linkage, style, openings, false};
  const LinkageMotion motion(linkage);
  double farthest = 0;
  for (const Joint joint : all_joints) farthest = std::max(farthest, motion.farthest(joint));
  const double step = (farthest + style.width) / grid.rings;
  const RegionBearings region_bearings(region, linkage.pole());
  std::vector<std::vector<Bearings>> swept(static_cast<std::size_t>(grid.rings));
  std::vector<Bearings> found;
  for (int slab = 0; slab < grid.slabs; ++slab) {
    const double opening = openings.lower + slab * openings.width() / std::max(1, grid.slabs - 1);
    const double radius = linkage.radius_at(opening);
    const auto bearings = region_bearings.between(radius, radius);
    for (const GrownPiece& piece : pieces_at(sweep, motion, opening, 0, 0)) {
      const int first = std::max(0, static_cast<int>(piece.nearest() / step) - 1);
      const int last = std::min(grid.rings - 1, static_cast<int>(piece.farthest() / step) + 1);
      for (int ring = first; ring <= last; ++ring) {
        piece.angles_in((ring + 0.5) * step, found);
        for (const Bearings& angles : found)
          for (const Bearings& turned : bearings)
            add_turned(angles, turned, swept[static_cast<std::size_t>(ring)]);
      }
    }
  }
  double area = 0;
  for (int ring = 0; ring < grid.rings; ++ring)
    for (const Bearings& angles : merged(std::move(swept[static_cast<std::size_t>(ring)])))
      area += std::min(2 * pi, angles.to - angles.from) * (ring + 0.5) * step * step;
  return area;
}

}  // namespace kempe
