#pragma once
// An oracle for the map: places the joints and measures gaps in the plainest way, with formulas of its own.

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "workspace/map/workspace_map.hpp"

namespace kempe::test {

using Z = std::complex<double>;

struct Joints {
  Z V, A, B, C, X, Y;
};

/// The joints with the tracer at a place, by intersecting circles; of both elbows the one whose opening lies
/// in the assembly. Nothing if neither does.
inline std::optional<Joints> joints_with_tracer_at(const CopyingLinkage& linkage, Z tracer) {
  const Z pole(linkage.pole().x(), linkage.pole().y());
  const Z k = linkage.k();
  const Z pen = pole + k * (tracer - pole);
  Z V, X, Y;
  switch (linkage.grounding()) {
    case Grounding::pole: V = pole, X = tracer, Y = pen; break;
    case Grounding::tracer: X = pole, V = tracer, Y = pen; break;
    case Grounding::pen: X = pole, Y = tracer, V = pen; break;
  }
  const LinkLengths l = linkage.lengths();
  const Z way = X - V;
  const double c = std::abs(way);
  const double along = (c * c + l.VA * l.VA - l.AX * l.AX) / (2 * c);
  const double squared = l.VA * l.VA - along * along;
  if (!(squared >= 0)) return std::nullopt;
  const Z s = (Y - V) / (X - V);
  for (const double side : {1.0, -1.0}) {
    const Z A = V + way / c * Z(along, side * std::sqrt(squared));
    const Z q = s * (X - A);  // AX = q/s
    const double opening = std::arg(q / (A - V));
    if (!linkage.assembly_mode().openings.contains(opening)) continue;
    return Joints{V, A, V + q, A + q, X, Y};
  }
  return std::nullopt;
}

inline double point_to_segment(Z p, Z a, Z b) {
  const Z d = b - a;
  if (std::norm(d) == 0) return std::abs(p - a);
  const Z w = (p - a) / d;
  if (w.real() <= 0) return std::abs(p - a);
  if (w.real() >= 1) return std::abs(p - b);
  return std::abs(w.imag()) * std::abs(d);
}

inline bool segments_cross(Z a, Z b, Z c, Z d) {
  const auto side = [](Z u, Z v, Z p) { return std::imag(std::conj(v - u) * (p - u)); };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

inline double segment_to_segment(Z a, Z b, Z c, Z d) {
  if (a != b && c != d && segments_cross(a, b, c, d)) return 0;
  return std::min({point_to_segment(a, c, d), point_to_segment(b, c, d), point_to_segment(c, a, b),
                   point_to_segment(d, a, b)});
}

inline bool in_ring(const std::vector<Z>& ring, Z p) {
  bool in = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if ((ring[i].imag() > p.imag()) != (ring[j].imag() > p.imag()) &&
        p.real() < (ring[j].real() - ring[i].real()) * (p.imag() - ring[i].imag()) /
                           (ring[j].imag() - ring[i].imag()) +
                       ring[i].real())
      in = !in;
  return in;
}

/// A part as points, segments and perhaps a filled triangle, with half its width and the layers it is in.
struct Solid {
  char letters[8];
  std::vector<std::pair<Z, Z>> segments;
  std::vector<Z> filled;  ///< ring, or empty
  double half;
  int low, high;
  bool post;
};

/// Every part of the mechanism, spelled out from geometry.md.
inline std::vector<Solid> solids(const CopyingLinkage& linkage, const Joints& j, const LinkStyle& style,
                                 const LayerAssignment& layers) {
  const int va = layers.of[0], vb = layers.of[1], ac = layers.of[2], bc = layers.of[3];
  const double w = style.width / 2, r = style.pin_diameter / 2;
  std::vector<Solid> all;
  all.push_back({"VA", {{j.V, j.A}}, {}, w, va, va, false});
  all.push_back({"VB", {{j.V, j.B}}, {}, w, vb, vb, false});
  if (style.plate == PlateStyle::bent) {
    all.push_back({"ACX", {{j.C, j.A}, {j.A, j.X}}, {}, w, ac, ac, false});
    all.push_back({"BCY", {{j.C, j.B}, {j.B, j.Y}}, {}, w, bc, bc, false});
  } else {
    all.push_back({"ACX", {{j.C, j.A}, {j.A, j.X}, {j.X, j.C}}, {j.A, j.C, j.X}, w, ac, ac, false});
    all.push_back({"BCY", {{j.C, j.B}, {j.B, j.Y}, {j.Y, j.C}}, {j.B, j.C, j.Y}, w, bc, bc, false});
  }
  const auto pin = [&](const char* letter, Z at, int one, int other) {
    if (std::abs(one - other) > 1) {
      Solid solid{"", {{at, at}}, {}, r, std::min(one, other) + 1, std::max(one, other) - 1, false};
      solid.letters[0] = letter[0];
      all.push_back(solid);
    }
  };
  pin("V", j.V, va, vb);
  pin("A", j.A, va, ac);
  pin("B", j.B, vb, bc);
  pin("C", j.C, ac, bc);
  all.push_back({"V", {{j.V, j.V}}, {}, r, 1, std::min(va, vb) - 1, true});
  all.push_back({"X", {{j.X, j.X}}, {}, r, 1, ac - 1, true});
  all.push_back({"Y", {{j.Y, j.Y}}, {}, r, 1, bc - 1, true});
  (void)linkage;
  return all;
}

inline bool share_a_letter(const Solid& a, const Solid& b) {
  for (const char* p = a.letters; *p; ++p)
    for (const char* q = b.letters; *q; ++q)
      if (*p == *q) return true;
  return false;
}

inline double gap_between(const Solid& a, const Solid& b) {
  double least = 1e300;
  for (const auto& [p, q] : a.segments)
    for (const auto& [u, v] : b.segments) least = std::min(least, segment_to_segment(p, q, u, v));
  if (!a.filled.empty() && in_ring(a.filled, b.segments[0].first)) least = 0;
  if (!b.filled.empty() && in_ring(b.filled, a.segments[0].first)) least = 0;
  return least - a.half - b.half;
}

inline double self_gap(const std::vector<Solid>& all) {
  double least = 1e300;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      const bool meet = std::max(all[i].low, all[k].low) <= std::min(all[i].high, all[k].high);
      if ((meet || (all[i].post && all[k].post)) && !share_a_letter(all[i], all[k]))
        least = std::min(least, gap_between(all[i], all[k]));
    }
  return least;
}

/// An obstacle as one ring of points with a circle around it.
struct Block {
  std::vector<Z> ring;
  int low, high;
  Z centre;
  double radius;
};

inline std::vector<Block> blocks(const std::vector<Obstacle>& obstacles) {
  std::vector<Block> all;
  for (const Obstacle& obstacle : obstacles) {
    Block block{{}, obstacle.lowest_layer, obstacle.highest_layer, 0, 0};
    for (const Point& point : obstacle.shape.outer) block.ring.emplace_back(point.x(), point.y());
    for (const Z& point : block.ring) block.centre += point / static_cast<double>(block.ring.size());
    for (const Z& point : block.ring) block.radius = std::max(block.radius, std::abs(point - block.centre));
    all.push_back(block);
  }
  return all;
}

/// The smallest gap to any obstacle, or some value > enough if there is none that small.
inline double obstacle_gap(const std::vector<Solid>& all, const std::vector<Block>& obstacles,
                           double enough) {
  double least = 1e300;
  for (const Solid& solid : all)
    for (const Block& block : obstacles) {
      if (std::max(solid.low, block.low) > std::min(solid.high, block.high)) continue;
      for (const auto& [p, q] : solid.segments) {
        if (point_to_segment(block.centre, p, q) - block.radius - solid.half > enough) continue;
        for (std::size_t i = 0, j = block.ring.size() - 1; i < block.ring.size(); j = i++)
          least = std::min(least, segment_to_segment(p, q, block.ring[j], block.ring[i]) - solid.half);
        if (in_ring(block.ring, p)) least = std::min(least, -solid.half);
      }
      if (!solid.filled.empty() && in_ring(solid.filled, block.ring[0])) least = std::min(least, -solid.half);
    }
  return least;
}

/// Point location in polygons of arcs by strips: ray crossings of the flattened rings.
class Locator {
 public:
  Locator(const ArcRegion& region, double tolerance, Flatten side) {
    for (const Polygon& polygon : flattened(region, tolerance, side).polygons) {
      add(polygon.outer);
      for (const Ring& hole : polygon.holes) add(hole);
    }
    if (edges_.empty()) return;
    low_ = 1e300;
    double high = -1e300;
    for (const auto& [a, b] : edges_)
      low_ = std::min({low_, a.y(), b.y()}), high = std::max({high, a.y(), b.y()});
    height_ = (high - low_) / strips * (1 + 1e-9) + 1e-300;
    strip_.resize(strips);
    for (std::size_t i = 0; i < edges_.size(); ++i)
      for (std::size_t s = strip(std::min(edges_[i].first.y(), edges_[i].second.y()));
           s <= strip(std::max(edges_[i].first.y(), edges_[i].second.y())); ++s)
        strip_[s].push_back(i);
  }
  bool contains(Z p) const {
    if (edges_.empty() || p.imag() < low_ || p.imag() >= low_ + height_ * strips) return false;
    bool in = false;
    for (const std::size_t i : strip_[strip(p.imag())]) {
      const auto& [a, b] = edges_[i];
      if ((a.y() > p.imag()) != (b.y() > p.imag()) &&
          p.real() < (b.x() - a.x()) * (p.imag() - a.y()) / (b.y() - a.y()) + a.x())
        in = !in;
    }
    return in;
  }

 private:
  static constexpr std::size_t strips = 4096;
  void add(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) edges_.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  }
  std::size_t strip(double y) const {
    return std::min(strips - 1, static_cast<std::size_t>((y - low_) / height_));
  }
  std::vector<std::pair<Point, Point>> edges_;
  std::vector<std::vector<std::size_t>> strip_;
  double low_ = 0, height_ = 1;
};

}  // namespace kempe::test
