#include "synthesis/verification/obstacles.hpp"

#include <algorithm>

#include "synthesis/verification/plain_distance.hpp"
#include "workspace/obstacle_names.hpp"

namespace kempe {
namespace {

using plain::Corners;

/// Between a part's axis and an obstacle, mm; 0 if they overlap.
double distance(const Corners& hull, const Polygon& obstacle) {
  if (contains(Region{{obstacle}}, hull.front()) || plain::holds(hull, obstacle.outer.front())) return 0;
  double least = plain::distance_of_edges(hull, obstacle.outer);
  for (const Ring& hole : obstacle.holes) least = std::min(least, plain::distance_of_edges(hull, hole));
  return least;
}

Polygon seen_from(const Point& pole, Polygon shape) {
  for (Point& corner : shape.outer) corner -= pole;
  for (Ring& hole : shape.holes)
    for (Point& corner : hole) corner -= pole;
  return shape;
}

}  // namespace

ObstacleWatch::ObstacleWatch(const CopyingLinkage& linkage, const VerificationTask& task) {
  for (const Obstacle& obstacle : task.obstacles) {
    const Polygon shape = seen_from(task.mechanism.pole_position, obstacle.shape);
    obstacles_.push_back(
        {obstacle_name(task.obstacles, obstacles_.size()), shape, bounding_box(Region{{shape}})});
  }
  if (obstacles_.empty()) return;
  for (const Part& part : parts_of(linkage, task.layers))
    for (const JointHull& hull : axis_of(part, linkage.shape(), task.style.plate)) {
      pieces_.push_back({hull, half_width(part, task.style), name(part)});
      for (std::size_t i = 0; i < task.obstacles.size(); ++i)
        if (share_layer(part, task.obstacles[i])) meetings_.push_back({pieces_.size() - 1, i});
    }
}

std::optional<ObstacleWatch::Near> ObstacleWatch::nearest(const Pose& pose, double within) const {
  std::optional<Near> found;
  for (const Meeting& meeting : meetings_) {
    const Piece& piece = pieces_[meeting.piece];
    const Solid& obstacle = obstacles_[meeting.obstacle];
    const double wanted = (found ? found->gap : within) + piece.half_width;
    const Corners corners = plain::corners_of(piece.hull, pose);
    if (!(plain::distance_of_boxes(corners, obstacle.box) < wanted)) continue;
    const double axis = distance(corners, obstacle.shape);
    if (axis < wanted) found = Near{axis - piece.half_width, piece.part, obstacle.name};
  }
  return found;
}

}  // namespace kempe
