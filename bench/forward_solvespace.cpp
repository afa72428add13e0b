// SolveSpace's constraint solver on points and distances in the plane.

// slvs.h uses memset and does not declare it, so the order matters.
// clang-format off
#include <string.h>
#include <slvs.h>
// clang-format on

#include <algorithm>
#include <limits>

#include "forward_task.hpp"

namespace kempe::bench {
namespace {

constexpr Slvs_hGroup given = 1, sought = 2;
constexpr Slvs_hEntity plane = 200;

/// The system of one task. Handles: parameters of point i are 1000 + 2i and the next, its entity 1000 + i.
class Sketch {
 public:
  explicit Sketch(const PointTask& task) : task_(task) {
    params_.reserve(7 + 2 * task.start.size());
    add_plane();
    for (std::size_t i = 0; i < task.start.size(); ++i) add_point(i);
    for (std::size_t i = 0; i < task.bars.size(); ++i) add_bar(i);
    system_.param = params_.data();
    system_.params = static_cast<int>(params_.size());
    system_.entity = entities_.data();
    system_.entities = static_cast<int>(entities_.size());
    system_.constraint = constraints_.data();
    system_.constraints = static_cast<int>(constraints_.size());
  }

  /// Puts the driven point at a place and solves from the last pose; true if it converged.
  bool solve(const Point& driven) {
    params_[7 + 2 * task_.driven].val = driven.x();
    params_[8 + 2 * task_.driven].val = driven.y();
    Slvs_Solve(&system_, sought);
    return system_.result == SLVS_RESULT_OKAY;
  }

  Point place(std::size_t point) const { return {params_[7 + 2 * point].val, params_[8 + 2 * point].val}; }

 private:
  void add_plane() {
    const double values[7] = {0, 0, 0, 1, 0, 0, 0};  // origin, then the unit quaternion
    for (Slvs_hParam h = 1; h <= 7; ++h) params_.push_back(Slvs_MakeParam(h, given, values[h - 1]));
    entities_.push_back(Slvs_MakePoint3d(101, given, 1, 2, 3));
    entities_.push_back(Slvs_MakeNormal3d(102, given, 4, 5, 6, 7));
    entities_.push_back(Slvs_MakeWorkplane(plane, given, 101, 102));
  }

  void add_point(std::size_t i) {
    const Slvs_hGroup group = task_.fixed[i] ? given : sought;
    const auto x = static_cast<Slvs_hParam>(1000 + 2 * i);
    params_.push_back(Slvs_MakeParam(x, group, task_.start[i].x()));
    params_.push_back(Slvs_MakeParam(x + 1, group, task_.start[i].y()));
    entities_.push_back(Slvs_MakePoint2d(entity(i), group, plane, x, x + 1));
  }

  void add_bar(std::size_t i) {
    const auto& bar = task_.bars[i];
    constraints_.push_back(Slvs_MakeConstraint(static_cast<Slvs_hConstraint>(1 + i), sought,
                                               SLVS_C_PT_PT_DISTANCE, plane, bar.length, entity(bar.a),
                                               entity(bar.b), 0, 0));
  }

  static Slvs_hEntity entity(std::size_t point) { return static_cast<Slvs_hEntity>(1000 + point); }

  const PointTask& task_;
  std::vector<Slvs_Param> params_;
  std::vector<Slvs_Entity> entities_;
  std::vector<Slvs_Constraint> constraints_;
  Slvs_System system_{};
};

}  // namespace

ForwardResult move_with_solvespace(const PointTask& task, int rounds) {
  ForwardResult result;
  result.us_per_pose = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    Sketch sketch(task);
    result.failures = 0;
    const double begin = cpu_seconds();
    for (const Point& driven : task.places) result.failures += !sketch.solve(driven);
    const double spent = cpu_seconds() - begin;
    result.us_per_pose = std::min(result.us_per_pose, 1e6 * spent / static_cast<double>(task.places.size()));
  }
  // Places to compare, not timed: it stops at 1e-8 mm, so a second solve from there gives the last digits.
  Sketch sketch(task);
  for (const Point& driven : task.places) {
    sketch.solve(driven);
    sketch.solve(driven);
    for (std::size_t i = 0; i < task.start.size(); ++i) result.places.push_back(sketch.place(i));
  }
  return result;
}

}  // namespace kempe::bench
