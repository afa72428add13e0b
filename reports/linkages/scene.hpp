#pragma once
// A moving linkage as something to look at: each link's shape in its own frame, a placement of every link for
// every moment, the curves of traced points. y is turned downward, as on a page.

#include <optional>
#include <string>
#include <vector>

#include "specs/linkages/model.hpp"

namespace kempe {

/// A link's shape in its own frame, in the file's unit, y downward.
struct SceneBody {
  std::string name;
  std::vector<Point> hull;  ///< of its joints, in order; two points for a bar
  std::vector<Point> pins;
  struct Wheel {
    Point centre;
    double radius;
  };
  std::vector<Wheel> wheels;
  struct Guide {  ///< a line that something slides or rolls on
    Point from, to;
  };
  std::vector<Guide> guides;
  bool is_block = false;  ///< no link: the sign of a slider, along its frame's x axis
};

struct ScenePoint {
  std::string name;
  int body;
  Point local;
  bool fixed;
  bool pivot = false;  ///< a link turns about this fixed point
};

/// A force as an arrow that ends where it acts.
struct SceneArrow {
  Point at, force;  ///< the file's unit, N; y downward
};

struct LinkageScene {
  std::string title, unit;
  std::vector<SceneBody> bodies;  ///< the ground first, the links, then a block for each slider
  std::vector<ScenePoint> points;
  std::vector<std::size_t> traced;  ///< numbers in points
  struct Moment {
    double step;
    std::vector<Point> at;                               ///< of each body's frame
    std::vector<double> angle;                           ///< rad, as seen on the page (clockwise positive)
    std::vector<SceneArrow> arrows{};                    ///< of the forces at points and of drivers
    std::vector<std::optional<double>> driver_forces{};  ///< N or N m; none at a dead point
  };
  struct Driver {
    std::string label, unit;
  };
  std::vector<Driver> drivers;  ///< whose forces the moments give; empty without loads
  double largest_force = 0;     ///< N, of all arrows
  double arrow_scale = 0;       ///< the file's unit a newton
  std::vector<Moment> moments;
  Point lower, upper;   ///< box of all that ever moves, y downward
  std::string ending;   ///< how the motion stopped before its time; empty if it did not
  bool closed = false;  ///< the last moment is the first: it runs around

  /// Where a point is at a moment.
  Point place(const ScenePoint& point, const Moment& moment) const;
  double extent() const { return (upper - lower).maxCoeff(); }
};

/// The scene of a run of `steps` parts.
LinkageScene linkage_scene(const LinkageFile& file, const LinkageModel& model, const PlanarRun& run,
                           int steps);

}  // namespace kempe
