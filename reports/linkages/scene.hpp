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

/// A place of the motion that stands out.
struct SceneMark {
  double moment;  ///< among the moments: 2.5 is half way between the third and the fourth
  int body;       ///< the link that turns back; -1: the motion stopped
  std::string
      words;  ///< empty where another mark of the same place says it: the link is drawn, the mark not listed
};

/// A place that the linkage was asked for, and the one that it reaches; y and angles as on the page.
struct SceneWanted {
  Point at, reached;
  std::optional<double> angle, reached_angle;  ///< rad; of poses
  double moment;                               ///< as in SceneMark
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
    std::vector<std::optional<SceneArrow>> reactions{};  ///< none where rigid links do not determine them
    std::vector<double> driven{};                        ///< the drivers' values: degrees or the file's unit
    /// Of each link's frame but the ground's: velocity x, y, angle, then acceleration; a second. Empty at a dead point.
    std::vector<double> rates{};
  };
  struct Driver {
    std::string label, unit;
  };
  std::vector<Driver> drivers;         ///< whose forces the moments give; empty without loads
  std::vector<std::string> reactions;  ///< "B on rod": what the moments' reactions are; empty without loads
  double largest_force = 0;            ///< N, of all arrows
  double arrow_scale = 0;              ///< the file's unit a newton
  std::vector<Driver> driven;          ///< all drivers, with the units of their values
  std::vector<SceneMark> marks;
  std::vector<SceneWanted> wanted;  ///< in their order; empty unless add_wanted_places put them there
  std::string wanted_of;            ///< the point that shall take them
  std::size_t links =
      0;  ///< bodies that are links or points, the ground included; the rest are sliders' blocks
  double seconds_a_step = 0;  ///< how long a step of the motion takes
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
