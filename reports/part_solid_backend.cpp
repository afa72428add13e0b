// Triangulation of a part's faces by CGAL.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "reports/part_solid.hpp"

namespace kempe {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_2<Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

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
    const Complex centre = 0.5 * (a + b) + Complex(0, 1) * (b - a) * (1 - bulge * bulge) / (4 * bulge);
    const double half_step = std::acos(std::max(0.0, 1 - tolerance / std::abs(a - centre)));
    const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) / (2 * half_step))));
    for (int j = 1; j < steps; ++j) add(as_point(centre + (a - centre) * std::polar(1.0, sweep * j / steps)));
  }
  if (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

void insert(Triangulation& triangulation, const Ring& ring) {
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const Point& point : ring) vertices.push_back(triangulation.insert({point.x(), point.y()}));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    triangulation.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
}

/// The faces reached from outside across an odd number of constraints: the outline's inside less its holes.
std::vector<Triangulation::Face_handle> inside(Triangulation& triangulation) {
  std::map<Triangulation::Face_handle, int> level;
  std::vector<Triangulation::Face_handle> here{triangulation.infinite_face()}, beyond, result;
  for (int depth = 0; !here.empty(); ++depth, here.swap(beyond), beyond.clear())
    while (!here.empty()) {
      const auto face = here.back();
      here.pop_back();
      if (!level.emplace(face, depth).second) continue;
      if (depth % 2 == 1) result.push_back(face);
      for (int i = 0; i < 3; ++i)
        if (!level.count(face->neighbor(i)))
          (face->is_constrained(i) ? beyond : here).push_back(face->neighbor(i));
    }
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

}  // namespace

Solid part_solid(const CutPart& part, double tolerance) {
  std::vector<Ring> rings{chords(part.outline, tolerance)};
  for (const CutPart::Hole& hole : part.holes)
    rings.push_back(chords(reversed(circle(hole.centre, 0.5 * part.hole_diameter)), tolerance));
  const double height = single(part.thickness);
  Triangulation triangulation;
  for (const Ring& ring : rings) insert(triangulation, ring);
  Solid solid;
  for (const auto& face : inside(triangulation)) {
    const auto at = [&](int i) { return Point(face->vertex(i)->point().x(), face->vertex(i)->point().y()); };
    solid.push_back({raised(at(0), height), raised(at(1), height), raised(at(2), height)});
    solid.push_back({raised(at(2), 0), raised(at(1), 0), raised(at(0), 0)});
  }
  for (const Ring& ring : rings) add_walls(solid, ring, height);
  return solid;
}

}  // namespace kempe
