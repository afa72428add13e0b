#pragma once
// The layout of the design vector, here and nowhere else.
//
//   0  u = log VA                                  VA, VB in mm
//   1  v = log VB
//   2  near opening: the linkage is opened at least so far towards the pole that ...    rad
//   3  far opening:  ... the region's nearest and farthest places lie between the two   rad
//   4  pole x, 5  pole y: in units of `unit` from `origin`, only where the spec leaves the pole free
//   last  goal: the limit that is made as good as it can be, only where a limit is the goal
//
// The two openings are variables, not functions of the rest. So every constraint is smooth, none has the
// infinite slope that opening_at() has at a dead point, and a contact is looked for between openings known
// before.

#include <Eigen/Core>

#include "geometry/point.hpp"

namespace kempe {

/// At most 2 lengths, 2 openings, 2 for the pole, 1 goal: small enough to live on the stack.
inline constexpr int most_variables = 7;
using DesignVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_variables, 1>;
using DesignMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_variables, most_variables>;

struct DesignLayout {
  bool pole_is_free = false;
  bool has_goal = false;
  Point origin = Point::Zero();  ///< mm; the pole itself where it is fixed
  double unit = 1;               ///< mm, the size of the task: every length in a constraint is divided by it

  static constexpr int log_VA = 0, log_VB = 1, near_opening = 2, far_opening = 3, pole_x = 4, pole_y = 5;
  int goal() const { return pole_is_free ? 6 : 4; }
  int size() const { return 4 + (pole_is_free ? 2 : 0) + (has_goal ? 1 : 0); }

  Point pole(const DesignVector& x) const {
    return pole_is_free ? Point(origin + unit * Point(x[pole_x], x[pole_y])) : origin;
  }
  void set_pole(DesignVector& x, const Point& pole) const {
    if (pole_is_free) x.segment<2>(pole_x) = (pole - origin) / unit;
  }
};

}  // namespace kempe
