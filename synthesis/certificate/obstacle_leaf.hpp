#pragma once
// Obstacles, bodies that keep their direction and the table's edge in a proof's tree: a point of the linkage that is too near to one, for every design of a node.
// A body is looked at from the joint that carries it, where it is at rest.

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/convex_distance.hpp"
#include "specs/spec_keys.hpp"
#include "synthesis/certificate/proof_node.hpp"

namespace kempe::certificate {

/// The search for obstacles that refute nodes of one root. Keeps a reference to the task.
class ObstacleLeaves {
 public:
  explicit ObstacleLeaves(const RootTask& task);

  /// A leaf if an obstacle refutes the node; a parting of its layer assignments if it refutes some of them; or nothing. Notes in the node
  /// what came near.
  std::optional<Step> step(Node& node) const;
  struct ByTheCopy {
    std::optional<Step> step{};
    std::optional<ObstacleGuess>
        guess{};  ///< what the middle pole brings most deeply into an obstacle, where that refutes nothing
  };
  /// The same by the links' ends at tracer and pen alone: where all lengths are left no other point refutes.
  ByTheCopy by_the_copy(const Node& node) const;
  /// Where the middle design of a node meets an obstacle most deeply, looked at from many places of the tracer.
  std::optional<KnownPlace> place_met(const Node& node) const;

 private:
  double depth(const Point& at, std::size_t obstacle, const std::optional<std::size_t>& edge,
               double needed) const;
  double depth_by_few(const Point& at, std::size_t obstacle, const std::optional<std::size_t>& edge,
                      double needed) const;
  double circle_depth(const Point& at, std::size_t obstacle, double need) const;
  double needed(PartName part, std::size_t obstacle) const;
  Point copied_place(const PartPoint& point, std::size_t obstacle, const Point& place,
                     const Point& pole) const;
  bool hits(const ObstacleGuess& guess, const DesignCell& cell) const;
  Assignments sharing(const Assignments& all, PartName part, std::size_t obstacle) const;
  std::optional<Step> leaf_for(const Node& node, const ObstacleGuess& guess) const;
  /// The middle design with the tracer at a place.
  struct Middle {
    std::array<Point, 6> joints;  ///< by their numbers
    /// mm: over the cell the point V + of_a p + of_b q/s moves by at least |of_a - of_b| times this, both counted from the pole's joint.
    double unsteady = 0;
    double moves = 0;  ///< mm: about twice what any joint moves beside another over the cell
  };
  std::optional<Middle> middle_at(const DesignCell& cell, const Point& place) const;
  /// A part and an obstacle that share a layer in some assignment.
  struct Meeting {
    PartName part;
    std::size_t obstacle;
  };
  std::vector<Meeting> meetings_in(const Assignments& assignments) const;
  std::vector<PartBeside> to_look_at(const Node& node) const;
  bool keeps_off(PartName part, std::size_t obstacle, const Middle& middle, double beyond) const;
  double gap_to(PartName part, std::size_t obstacle, const Middle& middle) const;
  bool out_of_reach(PartName part, std::size_t obstacle, const Middle& middle) const;
  std::vector<std::optional<std::size_t>> edges_in_reach(PartName part, std::size_t obstacle,
                                                         const Middle& middle) const;
  /// A point of a part in an obstacle, and how much deeper than it strays, mm.
  struct Depth {
    ObstacleGuess guess;
    double depth = 0;
  };
  std::optional<Depth> deepest(PartName part, std::size_t obstacle, const KnownPlace& place,
                               const Middle& middle) const;

  /// An outline as it is met.
  struct Target {
    std::vector<std::optional<std::size_t>> edges;  ///< or all of it
    std::vector<Complex> corners;
    std::vector<Complex> few;  ///< enough of them to find a point in it: of a circle's 1440 some forty
    std::optional<FixedConvex>
        outline{};                   ///< of these, where it is met as a whole; absent for a single point, too
    Point centre = Point::Zero();    ///< of a circle around it
    double radius = 0, deepest = 0;  ///< mm; no place lies deeper in it
    int lowest_layer = 1, highest_layer = most_layers;
    double beyond = 0;                 ///< mm: the outline is grown by this
    double left_out = 0;               ///< mm: no place of the outline is farther from that of `few`
    std::optional<Joint> seen_from{};  ///< the joint that carries it; absent: it rests on the table
  };
  static Point carrier_place(const Target& target, const Middle& middle);
  std::vector<PartPoint> nearest_points(PartName part, const Target& target,
                                        const std::function<Point(const PartPoint&)>& place_of) const;
  static Target target_of(const Ring& outline, bool by_edges_alone);
  static std::vector<Target> targets_of(const Spec& spec, const JointRoles& roles);
  bool may_meet(PartName part, const Target& target) const;
  bool share(std::uint32_t assignment, PartName part, const Target& target) const {
    return task_.filled[assignment].share(part, target.lowest_layer, target.highest_layer);
  }
  /// The joint from which a target is seen, as a material point: the pole's for what rests on the table.
  bounding::MaterialPoint origin_of(const Target& target) const;
  bounding::MaterialPoint pole_point() const;
  /// The share of Middle::unsteady by which one point moves beside another.
  static double strays_beside(const bounding::MaterialPoint& at, const bounding::MaterialPoint& from);
  /// A point of a part, and the share of Middle::unsteady that it strays at least.
  struct AxisPoint {
    PartPoint point;
    bounding::MaterialPoint at;
    double strays = 0;
  };

  const RootTask& task_;
  std::vector<Target> targets_;  ///< of each obstacle, body and the table's edge, by their numbers in the log
  std::array<std::vector<JointHull>, part_count> axes_;
  std::array<std::vector<AxisPoint>, part_count> points_;
  std::array<double, part_count> steadiest_{};    ///< the least share of its points
  double unsteadiest_ = 0;                        ///< the largest share of joints beside each other
  std::array<double, part_count> half_widths_{};  ///< mm
  /// For each target that a joint carries the shares of every part's points beside that joint.
  std::vector<std::array<std::vector<double>, part_count>> seen_strays_;
};

}  // namespace kempe::certificate
