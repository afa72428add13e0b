#include "synthesis/verification/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "workspace/obstacles.hpp"

namespace kempe {
namespace {

using Corners = std::vector<Point>;

Corners corners_of(const JointHull& hull, const Pose& pose) {
  Corners corners;
  for (int i = 0; i < hull.count; ++i) corners.push_back(pose[hull.joints[static_cast<std::size_t>(i)]]);
  return corners;
}

/// Not geometry/segment_distance.hpp, by which the map keeps clear: a fault there must show here.
double distance(const Point& point, const Point& from, const Point& to) {
  const Point along = to - from;
  const double squared = along.squaredNorm();
  const double share = squared > 0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0;
  return (from + share * along - point).norm();
}

/// On which side of the line through a and b the point lies.
int side(const Point& a, const Point& b, const Point& point) {
  const double area = cross(b - a, point - a);
  return (area > 0) - (area < 0);
}

double distance(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return 0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

double distance(const Corners& hull, const Ring& ring) {
  double least = std::numeric_limits<double>::infinity();
  const std::size_t edges = hull.size() == 3 ? 3 : 1;
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t j = 0; j < edges; ++j)
      least = std::min(least,
                       distance(ring[i], ring[(i + 1) % ring.size()], hull[j], hull[(j + 1) % hull.size()]));
  return least;
}

bool holds(const Corners& triangle, const Point& point) {
  if (triangle.size() < 3) return false;
  const int first = side(triangle[0], triangle[1], point);
  return first != 0 && first == side(triangle[1], triangle[2], point) &&
         first == side(triangle[2], triangle[0], point);
}

/// Between a part's axis and an obstacle, mm; 0 if they overlap.
double distance(const Corners& hull, const Polygon& obstacle) {
  if (contains(Region{{obstacle}}, hull.front()) || holds(hull, obstacle.outer.front())) return 0;
  double least = distance(hull, obstacle.outer);
  for (const Ring& hole : obstacle.holes) least = std::min(least, distance(hull, hole));
  return least;
}

/// A lower bound of that distance.
double distance_of_boxes(const Corners& hull, const Box& box) {
  Point lower = hull.front(), upper = lower;
  for (const Point& corner : hull) {
    lower = lower.cwiseMin(corner);
    upper = upper.cwiseMax(corner);
  }
  return (lower - box.upper).cwiseMax(box.lower - upper).cwiseMax(0.0).norm();
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
    const Corners corners = corners_of(piece.hull, pose);
    if (!(distance_of_boxes(corners, obstacle.box) < wanted)) continue;
    const double axis = distance(corners, obstacle.shape);
    if (axis < wanted) found = Near{axis - piece.half_width, piece.part, obstacle.name};
  }
  return found;
}

}  // namespace kempe
