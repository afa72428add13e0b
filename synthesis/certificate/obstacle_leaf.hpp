#pragma once
// Obstacles in a proof's tree: a point of the linkage that is too near to one, for every design of a node.

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "synthesis/certificate/proof_node.hpp"

namespace kempe::certificate {

/// The search for obstacles that refute nodes of one root. Keeps a reference to the task.
class ObstacleLeaves {
 public:
  explicit ObstacleLeaves(const RootTask& task);

  /// A leaf if an obstacle refutes the node; a parting of its layer assignments if it refutes some of them; or nothing.
  std::optional<Step> step(const Node& node) const;

 private:
  double depth(const Point& at, std::size_t obstacle, const std::optional<std::size_t>& edge,
               double needed) const;
  double circle_depth(const Point& at, std::size_t obstacle, double need) const;
  double needed(PartName part) const;
  bool hits(const ObstacleGuess& guess, const DesignCell& cell) const;
  Assignments sharing(const Assignments& all, PartName part, std::size_t obstacle) const;
  std::optional<Step> leaf_for(const Node& node, const ObstacleGuess& guess) const;
  std::optional<std::array<Complex, 6>> joints_at(const DesignCell& cell, const Point& place) const;
  /// A part and an obstacle that share a layer in some assignment.
  struct Meeting {
    PartName part;
    std::size_t obstacle;
  };
  std::vector<Meeting> meetings_in(const Assignments& assignments) const;
  std::optional<ObstacleGuess> deepest(PartName part, std::size_t obstacle, const KnownPlace& place,
                                       const std::array<Complex, 6>& joints) const;

  const RootTask& task_;
  std::vector<std::vector<std::optional<std::size_t>>> targets_;  ///< of each obstacle: edges, or all of it
  std::vector<std::pair<Point, double>> circles_;                 ///< around them: centre and radius, mm
  /// Along each part.
  std::array<std::vector<std::pair<PartPoint, bounding::MaterialPoint>>, part_count> points_;
};

}  // namespace kempe::certificate
