#pragma once
// The moving parts of a linkage and the obstructions that they can meet (obstructions.hpp), each in the obstruction's frame.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "workspace/contact/gap_bounds.hpp"
#include "workspace/map_task.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {

/// The frames in which obstructions are at rest: the links' in the order of Link. Bearing and opening move the joints in each of them
/// alike: by turning them about its origin, and as the linkage opens; in a link's frame the bearing moves nothing.
enum class SceneFrame : std::uint8_t { table, tracer, pen, VA, VB, ACX, BCY };
inline constexpr std::size_t scene_frames = 7;
inline constexpr bool is_of_link(SceneFrame frame) { return frame >= SceneFrame::VA; }
/// The joints over a rectangle of openings and bearings, in each frame that has an obstruction; else as they were.
using FramedJoints = std::array<MovingJoints, scene_frames>;

/// A convex piece of a part's axis, the point of a body that keeps its direction, or a piece of one that turns.
struct ScenePiece {
  Part part;  ///< of a body a post at its point
  PointHull hull;
  double half_width;  ///< mm
  std::string name;   ///< "link VA", "router"
};

/// An obstruction as the map asks it: the distance of its edges, exact up to `slack`. (The search asks for derivatives instead, of
/// its convex parts: ObstacleShape in synthesis/problem.)
struct SceneObstacle {
  EdgeTree edges;      ///< with their chords; the frame's origin at the origin: the pole of the table's frame
  SceneFrame frame;    ///< where it is at rest
  double grown;        ///< mm: it is what lies within this of the edges, or inside
  std::size_t number;  ///< in the order of obstructions_of()
  std::string name;    ///< "vice", "router", "the table's edge"
  double slack;        ///< mm: rounding of distances to it
};

/// A piece that shares a layer with an obstruction and may come near it.
struct Encounter {
  std::uint32_t piece, obstacle;
};

/// What may meet, and the frames in which it does.
struct Encounters {
  std::vector<Encounter> pairs;    ///< none of the pole post and what is at rest on the table: neither moves
  std::vector<SceneFrame> frames;  ///< of their obstacles, each once

  /// `frame`: the obstacle's.
  void add(const Encounter& between, SceneFrame frame);
};

struct ContactScene {
  /// For contact: with the obstacles that anything comes nearer to than the task's clearance, perhaps.
  explicit ContactScene(const MapTask& task) : ContactScene(task, task.limits.clearance) {}
  /// For gaps: with those that anything comes nearer to than `within`, mm.
  ContactScene(const MapTask& task, double within);

  std::vector<LinkagePoint> corners;     ///< of bodies that turn with a link; the motions' points
  LinkageMotion motion;                  ///< seen from the pole: in the table's frame
  std::array<LinkageMotion, 2> carried;  ///< seen from tracer and pen: in their frames
  std::vector<LinkageMotion> linked;     ///< seen from each link, where a body turns with one; else none
  std::vector<ScenePiece>
      pieces;  ///< links, pins, posts, bodies that turn, and the points of those that do not
  std::vector<SceneObstacle> obstacles;  ///< the others can be nowhere so near
  Encounters encounters;                 ///< all that may come so near as the scene was made for

  /// Those that may come nearer than `gap` (mm), which is not more than what the scene was made for.
  Encounters nearer_than(double gap) const;

  const LinkageMotion& motion_in(SceneFrame frame) const {
    if (is_of_link(frame))
      return linked[static_cast<std::size_t>(frame) - static_cast<std::size_t>(SceneFrame::VA)];
    return frame == SceneFrame::table ? motion : carried[frame == SceneFrame::tracer ? 0 : 1];
  }
  /// What the cell's sides are in the frame: seen from a link no bearing moves anything.
  static HalfSides sides_in(SceneFrame frame, const HalfSides& half) {
    return is_of_link(frame) ? HalfSides{half.opening, 0} : half;
  }
  /// The parts that meet, for a person: "link VA", "vice".
  const std::string& piece_name(const Encounter& between) const { return pieces[between.piece].name; }
  const std::string& obstacle_name(const Encounter& between) const {
    return obstacles[between.obstacle].name;
  }

 private:
  /// Distances from the frame's origin: no edge of the obstacle is nearer, no place of the piece farther.
  struct Apart {
    double nearest_edge, farthest_piece;
    bool may_come_within(double gap) const { return nearest_edge < farthest_piece + gap; }
  };
  std::vector<Apart> apart_;  // of the encounters, in their order
};

/// The smallest gap to any obstruction with the mechanism in one pose, mm; +infinity without obstructions. A piece inside an obstruction has the
/// gap of a piece at its edge: minus its half width, and minus what the obstruction is grown by.
struct ObstacleGap {
  double gap;
  Encounter between{};
};
ObstacleGap tightest_obstacle(const ContactScene& scene, const Encounters& encounters, double opening,
                              double bearing);
inline ObstacleGap tightest_obstacle(const ContactScene& scene, double opening, double bearing) {
  return tightest_obstacle(scene, scene.encounters, opening, bearing);
}

/// The gap between the pole post, which does not move, and an obstacle in its layers or the table's edge.
struct PoleGap {
  std::string post;
  std::string obstacle;  ///< its name
  double gap;            ///< mm
};
std::vector<PoleGap> gaps_at_pole(const MapTask& task);
/// The smallest of them, the first of equals; nothing if there are none.
std::optional<PoleGap> tightest(const std::vector<PoleGap>& gaps);
/// The obstacle of the first gap below a clearance, mm; nothing if all keep it.
std::optional<std::string> obstacle_within(double clearance, const std::vector<PoleGap>& gaps);

}  // namespace kempe
