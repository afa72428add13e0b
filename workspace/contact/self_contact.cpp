// Contact of the linkage with itself, in closed form.
//
// With V at the origin every joint is alpha p + beta q with fixed complex alpha, beta. A link is either
// parallel to p (VA and BCY: alpha varies along the link, beta does not) or to q (VB and ACX: the other way
// round); a pin or post is a point and passes for either. Links of different kind share a joint, so every
// pair is of one kind, say p. Seen from p, its parts are the fixed outlines {alpha |p|} and only translate
// against each other by
//     t = (beta_2 - beta_1) |q| exp(i d):
// a point on a circle, with |dt/dd| = |beta_2 - beta_1| |q|. The distance of their axes is that of t from the
// convex polygon P = axis_1 - axis_2 (Minkowski), so
//     distance = h  where the circle crosses P grown by h: its sides moved out by h, and circles of radius h about its
// corners. These crossings are two closed-form angles each; between neighbouring crossings the sign of
// distance - h is constant, and one test in the middle decides it. The smallest distance over an arc of the
// circle is taken at an end of the arc, at the circle's crossings with P, or where t points to a corner of P
// or against the normal of a side.

#include "workspace/contact/self_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

#include "geometry/convex_hull.hpp"
#include "geometry/orientation.hpp"
#include "geometry/segment_distance.hpp"

namespace kempe {
namespace {

/// A convex polygon of few corners, counter-clockwise; one or two corners are a point and a segment.
struct SmallPolygon {
  std::array<Point, 18> corner;
  std::size_t count = 0;

  const Point& next(std::size_t i) const { return corner[i + 1 == count ? 0 : i + 1]; }

  double distance(const Point& point) const {
    double least = std::numeric_limits<double>::infinity();
    bool within = count > 2;
    for (std::size_t i = 0; i < count; ++i) {
      least = std::min(least, squared_distance(point, corner[i], next(i)));
      within = within && cross(next(i) - corner[i], point - corner[i]) > 0;
    }
    return within ? 0 : std::sqrt(least);
  }
};

/// By insertion: the few points of a hull are sorted faster so.
void sort_from_left(std::span<Point> points) {
  for (std::size_t i = 1; i < points.size(); ++i)
    for (std::size_t j = i; j > 0 && sweeps_before(points[j], points[j - 1]); --j)
      std::swap(points[j], points[j - 1]);
}

SmallPolygon hull_of(std::span<Point> points) {
  sort_from_left(points);
  SmallPolygon hull;
  const auto turns_left = [](const Point& a, const Point& b, const Point& c) {
    return cross(b - a, c - a) > 0;
  };
  hull.count = hull_of_sorted(points, hull.corner, turns_left);
  return hull;
}

/// A piece of one part against a piece of another, seen from the direction they share.
struct RelativeMotion {
  SmallPolygon polygon;
  double radius = 0;  ///< of the circle, mm
  double phase = 0;   ///< the circle's angle is phase + sense d
  double sense = 1;
  double kept = 0;  ///< sum of the half widths, mm

  double angle_at(double opening) const { return phase + sense * opening; }
  double distance_at(double angle) const { return polygon.distance(as_point(std::polar(radius, angle))); }
  double scale() const { return radius + polygon.corner[0].norm() + kept; }
  /// True if the polygon lies so deep in the circle that the gap is larger, surely, wherever the point is.
  bool is_farther_everywhere(double gap) const {
    constexpr double surely = 1e-9;
    double farthest = 0;
    for (std::size_t i = 0; i < polygon.count; ++i)
      farthest = std::max(farthest, polygon.corner[i].squaredNorm());
    return radius - std::sqrt(farthest) - kept - gap > surely * (radius + kept + std::abs(gap));
  }
};

/// Angles on a circle; at most four for each corner of a polygon, and two ends.
struct Angles {
  std::array<double, 76> at;
  std::size_t count = 0;
  void add(double angle) { at[count++] = angle; }
  /// Both angles whose cosine against `direction` is `cosine`, if there are any.
  void add_both(double direction, double cosine) {
    if (!(std::abs(cosine) <= 1)) return;
    const double half = std::acos(cosine);
    add(direction - half);
    add(direction + half);
  }
};

double side_normal(const Point& from, const Point& to) {
  return std::atan2(from.x() - to.x(), to.y() - from.y());
}

/// Where the circle crosses the sides of the polygon moved outwards by `reach`; the sides' normals as well if
/// wanted.
void add_side_crossings(Angles& angles, const RelativeMotion& motion, double reach,
                        bool also_inward_normals) {
  const SmallPolygon& polygon = motion.polygon;
  for (std::size_t i = 0; polygon.count > 1 && i < polygon.count; ++i) {
    const double normal = side_normal(polygon.corner[i], polygon.next(i));
    const double offset = polygon.corner[i].dot(as_point(std::polar(1.0, normal)));
    angles.add_both(normal, (offset + reach) / motion.radius);
    if (also_inward_normals) angles.add(normal + pi);
  }
}

/// Where the circle crosses the boundary of the polygon grown by `reach`, and perhaps at some other angles.
Angles crossings(const RelativeMotion& motion, double reach) {
  Angles angles;
  add_side_crossings(angles, motion, reach, false);
  for (std::size_t i = 0; i < motion.polygon.count; ++i) {
    const Point& corner = motion.polygon.corner[i];
    const double norm = corner.norm();
    if (norm > 0)
      angles.add_both(
          std::atan2(corner.y(), corner.x()),
          (motion.radius * motion.radius + norm * norm - reach * reach) / (2 * motion.radius * norm));
  }
  return angles;
}

/// Calls `use(lower, upper)` for the intervals of openings within `within` in which the motion's distance is
/// < reach.
template <class Use>
void for_each_contact(const RelativeMotion& motion, double reach, const OpeningInterval& within, Use use) {
  const auto nearer = [&](double opening) { return motion.distance_at(motion.angle_at(opening)) < reach; };
  Angles angles = crossings(motion, reach);
  std::array<double, 80> stops;
  std::size_t count = 0;
  stops[count++] = within.lower;
  for (std::size_t i = 0; i < angles.count; ++i) {
    double opening = motion.sense * (angles.at[i] - motion.phase);
    opening -= 2 * pi * std::floor((opening - within.lower) / (2 * pi));
    if (opening < within.upper) stops[count++] = opening;
  }
  stops[count++] = within.upper;
  std::sort(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(count));
  for (std::size_t i = 0; i + 1 < count; ++i)
    if (nearer(0.5 * (stops[i] + stops[i + 1]))) use(stops[i], stops[i + 1]);
}

/// The openings at which the distance over `within` may be smallest, for the motion's own side of the circle.
template <class Use>
void for_each_candidate(const RelativeMotion& motion, const OpeningInterval& within, Use use) {
  Angles angles;
  if (motion.radius > 0) add_side_crossings(angles, motion, 0, true);
  for (std::size_t i = 0; i < motion.polygon.count; ++i)
    angles.add(std::atan2(motion.polygon.corner[i].y(), motion.polygon.corner[i].x()));
  use(within.lower);
  use(within.upper);
  for (std::size_t i = 0; i < angles.count; ++i) {
    double opening = motion.sense * (angles.at[i] - motion.phase);
    opening -= 2 * pi * std::floor((opening - within.lower) / (2 * pi));
    if (opening < within.upper) use(opening);
  }
}

/// True if the parts of a pair are seen from p, false if from q.
bool seen_from_p(const ContactPair& pair) {
  const Part& link = pair.first.kind == Part::Kind::link ? pair.first : pair.second;
  return link.kind != Part::Kind::link || link.link == Link::VA || link.link == Link::BCY;
}

RelativeMotion relative_motion(const CopyingLinkage& linkage, const JointHull& one, const JointHull& other,
                               bool from_p, double kept) {
  const auto fixed = [&](const LinkagePoint& w) {
    return from_p ? linkage.VA() * w.of_p : linkage.VB() * w.of_q;
  };
  const auto moving = [&](const LinkagePoint& w) {
    return from_p ? linkage.VB() * w.of_q : linkage.VA() * w.of_p;
  };
  const auto weights = [&](const JointHull& piece, int i) {
    return linkage_point(piece.joints[static_cast<std::size_t>(i)], linkage.shape());
  };
  std::array<Point, 9> differences;
  std::size_t count = 0;
  for (int i = 0; i < one.count; ++i)
    for (int j = 0; j < other.count; ++j)
      differences[count++] = as_point(fixed(weights(one, i)) - fixed(weights(other, j)));
  const Complex translation = moving(weights(other, 0)) - moving(weights(one, 0));
  return {hull_of(std::span(differences).first(count)), std::abs(translation), std::arg(translation),
          from_p ? 1.0 : -1.0, kept};
}

/// The first pair of parts of which `is_so` is true for a pair of pieces in their motion.
template <class IsSo>
std::optional<std::size_t> find_pair(const CopyingLinkage& linkage, const LinkStyle& style,
                                     const std::vector<ContactPair>& pairs, IsSo is_so) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const ContactPair& pair = pairs[i];
    const double kept = half_width(pair.first, style) + half_width(pair.second, style);
    const auto others = axis_of(pair.second, linkage.shape(), style.plate);
    for (const JointHull& one : axis_of(pair.first, linkage.shape(), style.plate))
      for (const JointHull& other : others)
        if (is_so(i, relative_motion(linkage, one, other, seen_from_p(pair), kept))) return i;
  }
  return std::nullopt;
}

/// Calls `use(pair index, motion)` for every pair of pieces of every pair of parts.
template <class Use>
void for_each_motion(const CopyingLinkage& linkage, const LinkStyle& style,
                     const std::vector<ContactPair>& pairs, Use use) {
  find_pair(linkage, style, pairs, [&](std::size_t pair, const RelativeMotion& motion) {
    use(pair, motion);
    return false;
  });
}

/// What the contacts leave of `within`, moved inwards by `precision` at each contact.
std::vector<FreeOpenings> between(const std::vector<ContactOpenings>& contacts, const OpeningInterval& within,
                                  double precision) {
  std::vector<FreeOpenings> result;
  double decided = within.lower;  // everything below is
  std::optional<ContactPair> below;
  const auto add = [&](double upper, std::optional<ContactPair> above) {
    const OpeningInterval free{below ? decided + precision : decided, above ? upper - precision : upper};
    if (!free.empty()) result.push_back({free, below, above});
  };
  for (const auto& [interval, pair] : contacts) {
    if (interval.lower > decided) add(interval.lower, pair);
    if (interval.upper <= decided) continue;
    decided = interval.upper;
    below = pair;
  }
  if (decided < within.upper || !below) add(within.upper, std::nullopt);
  return result;
}

/// Distances are computed to this share of the sizes involved; twice as much more is kept than asked.
constexpr double pose_rounding = 1e-14;

}  // namespace

/// Share of a motion's scale: of pairs that are so nearly as tight the first is named. A design that is best where two pairs are at
/// their limit would else name one of them by rounding.
constexpr double equally_tight = 1e-10;

Tightest smallest_gap_over(const CopyingLinkage& linkage, const LinkStyle& style,
                           const LayerAssignment& layers, const OpeningInterval& openings) {
  return smallest_gap_over(linkage, style, contact_pairs(linkage, layers), openings);
}

Tightest smallest_gap_over(const CopyingLinkage& linkage, const LinkStyle& style,
                           const std::vector<ContactPair>& pairs, const OpeningInterval& openings) {
  Tightest tightest{std::numeric_limits<double>::infinity(), std::nullopt};
  if (openings.empty()) return tightest;
  double named = tightest.gap;  // of the pair named
  for_each_motion(linkage, style, pairs, [&](std::size_t pair, const RelativeMotion& motion) {
    for_each_candidate(motion, openings, [&](double opening) {
      const double here = motion.distance_at(motion.angle_at(opening)) - motion.kept;
      if (here < named - equally_tight * motion.scale()) {
        tightest = {std::min(here, tightest.gap), pairs[pair], opening};
        named = here;
      }
      tightest.gap = std::min(tightest.gap, here);
    });
  });
  return tightest;
}

std::optional<std::size_t> pair_nearer_than(double clearance, const CopyingLinkage& linkage,
                                            const LinkStyle& style, const std::vector<ContactPair>& pairs,
                                            const OpeningInterval& openings) {
  if (openings.empty()) return std::nullopt;
  return find_pair(linkage, style, pairs, [&](std::size_t, const RelativeMotion& motion) {
    if (motion.is_farther_everywhere(clearance)) return false;
    bool is_nearer = false;
    const auto look_at = [&](double opening) {
      is_nearer = is_nearer || motion.distance_at(motion.angle_at(opening)) - motion.kept < clearance;
    };
    look_at(openings.lower);
    if (!is_nearer) for_each_candidate(motion, openings, look_at);
    return is_nearer;
  });
}

std::vector<ContactOpenings> contact_openings(const CopyingLinkage& linkage, const LinkStyle& style,
                                              const LayerAssignment& layers, double clearance,
                                              const OpeningInterval& within) {
  if (within.empty()) return {};
  const std::vector<ContactPair> pairs = contact_pairs(linkage, layers);
  std::vector<ContactOpenings> contacts;
  for_each_motion(linkage, style, pairs, [&](std::size_t pair, const RelativeMotion& motion) {
    const double reach = motion.kept + clearance + 2 * pose_rounding * (motion.scale() + clearance);
    for_each_contact(motion, reach, within, [&](double lower, double upper) {
      contacts.push_back({{lower, upper}, pairs[pair]});
    });
  });
  std::stable_sort(contacts.begin(), contacts.end(), [](const ContactOpenings& a, const ContactOpenings& b) {
    return std::tie(a.interval.lower, a.interval.upper) < std::tie(b.interval.lower, b.interval.upper);
  });
  return contacts;
}

std::vector<FreeOpenings> contact_free_openings(const CopyingLinkage& linkage, const LinkStyle& style,
                                                const LayerAssignment& layers, double clearance,
                                                const OpeningInterval& within, double precision) {
  if (within.empty()) return {};
  return between(contact_openings(linkage, style, layers, clearance, within), within, precision);
}

}  // namespace kempe
