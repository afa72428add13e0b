#pragma once
// A tree of boxes over the edges of rings: what lies near a place, and which side of the rings a place is on.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/region.hpp"

namespace kempe {

/// Boxes over the edges of one polygon or region, each node one half of its parent's edges.
///
/// Invariant: a node of n edges has 2n - 1 nodes below and with it, in preorder: its left half follows it at
/// once. Building takes O(n log n). Rings need not be simple: a place is inside where its winding number is
/// not 0, which is the union for rings that cross themselves.
class EdgeTree {
 public:
  struct Edge {
    Point from, to;
  };
  struct Node {
    Box box;
    std::uint32_t first_edge, edges;  ///< the node's edges in edge order; one edge: a leaf
  };
  /// Of edges that follow each other along a ring the segment from the first one's start to the last one's end, else one of the edges.
  struct Chord {
    Edge segment;
    double
        stray;  ///< mm, rounded up; no point of the segment or of the edges is farther from the others; of one edge 0
  };
  /// Whether nodes have their chords: as much memory as the edges and boxes together.
  enum class Chords { none, kept };

  EdgeTree() = default;
  /// `origin` becomes (0, 0).
  EdgeTree(const Polygon& polygon, const Point& origin);
  EdgeTree(const Region& region, const Point& origin, Chords chords = Chords::none);

  bool empty() const { return nodes_.empty(); }
  const Node& node(std::uint32_t index) const { return nodes_[index]; }
  const Edge& edge(std::uint32_t index) const { return edges_[index]; }
  /// Of a node, where they are kept.
  const Chord& chord(std::uint32_t index) const { return chords_[index]; }
  /// The children of a node with more than one edge.
  static std::uint32_t left(std::uint32_t index) { return index + 1; }
  std::uint32_t right(std::uint32_t index) const { return index + 2 * (nodes_[index].edges / 2); }

  /// True if the rings wind around the point (its place on an edge itself is decided by rounding).
  bool winds_around(const Point& point) const;

  /// Largest coordinate's magnitude, mm: what rounding is measured against.
  double magnitude() const;

 private:
  void add(const Ring& ring, const Point& origin);
  void build(std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t count, Chords chords);
  Chord chord_of(std::span<const std::uint32_t> some) const;

  std::vector<Edge> edges_;
  std::vector<Node> nodes_;
  std::vector<Chord> chords_;  // of the nodes, or none
};

/// Calls `visit(edge)` for the edges whose boxes `wanted(box)` accepts.
template <class Wanted, class Visit>
void for_each_edge(const EdgeTree& tree, Wanted wanted, Visit visit) {
  if (tree.empty()) return;
  std::array<std::uint32_t, 40> open{0};  // halves of 2^32 edges are at most 32 deep
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t index = open[--count];
    const EdgeTree::Node& node = tree.node(index);
    if (!wanted(node.box)) continue;
    if (node.edges == 1) {
      visit(tree.edge(node.first_edge));
    } else {
      open[count++] = tree.right(index);
      open[count++] = EdgeTree::left(index);
    }
  }
}

/// Distance between two boxes, mm; 0 if they overlap.
inline double distance(const Box& a, const Box& b) {
  const Point between = (a.lower - b.upper).cwiseMax(b.lower - a.upper).cwiseMax(0.0);
  return between.norm();
}

}  // namespace kempe
