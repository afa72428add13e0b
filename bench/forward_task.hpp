#pragma once
// One linkage to be moved by several solvers: Kempe's model of a linkage file, and the same as points and
// distances, which every constraint solver knows.

#include <string>
#include <vector>

#include "kinematics/planar/path.hpp"
#include "specs/linkages/model.hpp"

namespace kempe::bench {

/// The linkage as points and distances. The driven point is put in its place before every pose, which is the
/// leanest statement: a crank then needs no equation at all.
struct PointTask {
  struct Bar {
    std::size_t a, b;  ///< numbers of points
    double length;     ///< mm
  };
  std::vector<std::string> names;
  std::vector<Point> start;   ///< of the first pose, mm
  std::vector<bool> fixed;    ///< on the ground, or driven
  std::vector<Bar> bars;      ///< those between two fixed points left out
  std::size_t driven = 0;     ///< number of the driven point
  std::vector<Point> places;  ///< of the driven point, one a pose
};

struct ForwardTask {
  std::string name;
  LinkageModel model;
  PlanarPosition start;
  std::vector<std::vector<double>> values;  ///< of the drivers, one a pose
  PointTask points;
};

/// Reads a linkage file and lays `poses` poses of a degree each along its drive: around where it turns fully, else to
/// and fro. One driver must turn a link about a fixed point, or a path lead one point; no sliders, no gears.
ForwardTask forward_task(const std::string& file, int poses);

/// The answer of a solver.
struct ForwardResult {
  double us_per_pose = 0;     ///< least of several rounds, CPU time
  std::vector<Point> places;  ///< of all points, pose by pose
  int failures = 0;           ///< poses that the solver gave up
};

/// Largest distance between two answers' points, mm.
double largest_distance(const ForwardResult& a, const ForwardResult& b);

/// CPU seconds of this thread.
double cpu_seconds();

/// Moves the linkage by PlanarPath.
ForwardResult move_with_kempe(const ForwardTask& task, int rounds);

#ifdef KEMPE_BENCH_SLVS
/// Moves the same points with SolveSpace's library, each pose from the last.
ForwardResult move_with_solvespace(const PointTask& task, int rounds);
#endif

/// The task and an answer as JSON, for solvers in other languages.
std::string as_json(const PointTask& task, const ForwardResult& answer);

}  // namespace kempe::bench
