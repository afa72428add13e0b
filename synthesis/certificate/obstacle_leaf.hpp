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
  /// The middle design with the tracer at a place.
  struct Middle {
    std::array<Point, 6> joints;  ///< by their numbers
    double unsteady =
        0;  ///< mm: V + of_a p + of_b q/s strays by |of_a - of_b| of it at least, the pole's joint being at 0
  };
  std::optional<Middle> middle_at(const DesignCell& cell, const Point& place) const;
  /// A part and an obstacle that share a layer in some assignment.
  struct Meeting {
    PartName part;
    std::size_t obstacle;
  };
  std::vector<Meeting> meetings_in(const Assignments& assignments) const;
  bool out_of_reach(PartName part, std::size_t obstacle, const Middle& middle) const;
  std::optional<ObstacleGuess> deepest(PartName part, std::size_t obstacle, const KnownPlace& place,
                                       const Middle& middle) const;

  /// An outline as it is met.
  struct Target {
    std::vector<std::optional<std::size_t>> edges;  ///< or all of it
    std::vector<Complex> corners;
    Point centre = Point::Zero();    ///< of a circle around it
    double radius = 0, deepest = 0;  ///< mm; no place lies deeper in it
  };
  static Target target_of(const Obstacle& obstacle);
  /// A point of a part, and the share of Middle::unsteady that it strays at least.
  struct AxisPoint {
    PartPoint point;
    bounding::MaterialPoint at;
    double strays = 0;
  };

  const RootTask& task_;
  std::vector<Target> targets_;  ///< of each obstacle
  std::array<std::vector<AxisPoint>, part_count> points_;
  std::array<double, part_count> steadiest_{};  ///< the least share of its points
};

}  // namespace kempe::certificate
