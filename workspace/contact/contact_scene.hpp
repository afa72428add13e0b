#pragma once
// The moving parts of a linkage and the obstacles that they can meet, seen from the pole.

#include <cstdint>
#include <vector>

#include "workspace/contact/gap_bounds.hpp"
#include "workspace/map_task.hpp"
#include "workspace/obstacles.hpp"

namespace kempe {

/// A convex piece of a part's axis.
struct ScenePiece {
  Part part;
  JointHull hull;
  double half_width;  ///< mm
  double farthest;    ///< mm, upper bound of the axis's distance from the pole
};

/// An obstacle as the map asks it: the distance of its edges, exact up to `slack`. (The search asks for derivatives instead, of
/// its convex parts: ObstacleShape in synthesis/problem.)
struct SceneObstacle {
  EdgeTree edges;      ///< the pole at the origin
  std::size_t number;  ///< index in MapTask::obstacles
  double slack;        ///< mm: rounding of distances to it
};

/// A piece that shares a layer with an obstacle and may come near it.
struct Encounter {
  std::uint16_t piece, obstacle;
};

struct ContactScene {
  /// For contact: with the obstacles that anything comes nearer to than the task's clearance, perhaps.
  explicit ContactScene(const MapTask& task) : ContactScene(task, task.clearance) {}
  /// For gaps: with those that anything comes nearer to than `within`, mm.
  ContactScene(const MapTask& task, double within);

  LinkageMotion motion;
  std::vector<ScenePiece> pieces;        ///< all but the pole post, which does not move
  std::vector<SceneObstacle> obstacles;  ///< the others can be nowhere so near
  std::vector<Encounter> encounters;
};

/// The smallest gap to any obstacle with the mechanism in one pose, mm; +infinity without obstacles. A piece
/// inside an obstacle has the gap of a piece at its edge: minus its half width.
struct ObstacleGap {
  double gap;
  Encounter between{};
};
ObstacleGap tightest_obstacle(const ContactScene& scene, double opening, double bearing);

/// The gap between the pole post, which does not move, and an obstacle in its layers.
struct PoleGap {
  std::string post;
  std::size_t obstacle;  ///< index in MapTask::obstacles
  double gap;            ///< mm
};
std::vector<PoleGap> gaps_at_pole(const MapTask& task);
/// The smallest of them, the first of equals; nothing without an obstacle in its layers.
std::optional<PoleGap> tightest_at_pole(const MapTask& task);
/// The first obstacle within `clearance` of the pole post; nothing if there is none.
std::optional<std::size_t> obstacle_at_pole(const MapTask& task);

}  // namespace kempe
