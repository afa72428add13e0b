// part_solid() of part_solid.hpp: two faces of triangles, and walls between them.

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/complex_vectors.hpp"
#include "geometry/regions/triangulation.hpp"
#include "reports/drawings/part_solid.hpp"

namespace kempe {
namespace {

/// What a float holds of it.
double single(double value) { return static_cast<double>(static_cast<float>(value)); }

/// Corners on the ring's arcs, no chord farther than the tolerance from its arc; as floats hold them, so that
/// what is written is closed to the last bit.
Ring chords(const ArcRing& ring, double tolerance) {
  Ring result;
  const auto add = [&](const Point& point) {
    const Point kept(single(point.x()), single(point.y()));
    if (result.empty() || result.back() != kept) result.push_back(kept);
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    add(ring[i].at);
    if (ring[i].bulge == 0) continue;
    const Complex a = as_complex(ring[i].at), b = as_complex(ring[(i + 1) % ring.size()].at);
    const double bulge = ring[i].bulge, sweep = 4 * std::atan(bulge);
    const Complex centre = arc_centre(a, b, bulge);
    const double radius = std::abs(a - centre);
    const double half_step =
        std::acos(std::max(0.0, 1 - std::min(tolerance, chord_tolerance(radius)) / radius));
    const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) / (2 * half_step))));
    for (int j = 1; j < steps; ++j) add(as_point(centre + (a - centre) * std::polar(1.0, sweep * j / steps)));
  }
  if (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

Eigen::Vector3d raised(const Point& point, double z) { return {point.x(), point.y(), z}; }

/// The two triangles of a wall over each edge; the outline runs counter-clockwise, holes clockwise.
void add_walls(Solid& solid, const Ring& ring, double height) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    solid.push_back({raised(a, 0), raised(b, 0), raised(b, height)});
    solid.push_back({raised(a, 0), raised(b, height), raised(a, height)});
  }
}

/// How far apart floats are that hold the part's coordinates.
double spacing(const ArcRing& outline) {
  const Box box = bounding_box(outline);
  return 0x1p-23 * std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
}

}  // namespace

double chord_tolerance(double radius) { return std::min(0.01, 0.005 * radius); }

Solid part_solid(const CutPart& part, double tolerance) {
  const double least = 4 * spacing(part.outline);
  const bool is_bored = std::all_of(part.holes.begin(), part.holes.end(),
                                    [&](const auto& hole) { return hole.diameter > least; });
  if (!(part.wall > least && is_bored && single(part.thickness) > 0)) return {};
  // Chords of the outline cut into the wall: no more than half of it.
  tolerance = std::min(tolerance, 0.5 * part.wall);
  std::vector<Ring> rings{chords(part.outline, tolerance)};
  for (const CutPart::Hole& hole : part.holes)
    rings.push_back(chords(reversed(circle(hole.centre, 0.5 * hole.diameter)), tolerance));
  const double height = single(part.thickness);
  const Triangulation faces = triangulated(rings);
  Solid solid;
  for (const auto& triangle : faces.triangles) {
    const auto at = [&](std::size_t i) { return faces.corners[triangle[i]]; };
    solid.push_back({raised(at(0), height), raised(at(1), height), raised(at(2), height)});
    solid.push_back({raised(at(2), 0), raised(at(1), 0), raised(at(0), 0)});
  }
  for (const Ring& ring : rings) add_walls(solid, ring, height);
  return is_closed(solid) ? solid : Solid{};
}

}  // namespace kempe
