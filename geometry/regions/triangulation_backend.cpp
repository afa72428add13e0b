// triangulated() by CGAL's constrained Delaunay triangulation: exact predicates, no new points.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>

#include "geometry/regions/triangulation.hpp"

namespace kempe {
namespace {

using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr std::size_t not_numbered = static_cast<std::size_t>(-1);
struct Number {
  std::size_t value = not_numbered;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Predicates>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Predicates>;
using Faces = CGAL::Constrained_Delaunay_triangulation_2<
    Predicates, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>, CGAL::Exact_predicates_tag>;

void insert(Faces& faces, const Ring& ring) {
  std::vector<Faces::Vertex_handle> vertices;
  for (const Point& point : ring) vertices.push_back(faces.insert({point.x(), point.y()}));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto next = vertices[(i + 1) % vertices.size()];
    if (vertices[i] != next) faces.insert_constraint(vertices[i], next);
  }
}

/// The faces reached from outside across an odd number of constraints.
std::vector<Faces::Face_handle> inside(const Faces& faces) {
  std::map<Faces::Face_handle, int> level;
  std::vector<Faces::Face_handle> here{faces.infinite_face()}, beyond, result;
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

}  // namespace

Triangulation triangulated(const std::vector<Ring>& rings) {
  Faces faces;
  for (const Ring& ring : rings) insert(faces, ring);
  Triangulation result;
  const auto numbered = [&](Faces::Vertex_handle vertex) {
    std::size_t& number = vertex->info().value;
    if (number == not_numbered) {
      number = result.corners.size();
      result.corners.emplace_back(vertex->point().x(), vertex->point().y());
    }
    return number;
  };
  for (const auto& face : inside(faces)) {
    const std::size_t a = numbered(face->vertex(0)), b = numbered(face->vertex(1)),
                      c = numbered(face->vertex(2));
    result.triangles.push_back({a, b, c});
  }
  return result;
}

}  // namespace kempe
