#pragma once
// What may be done to a task, and what that must do to its answer.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/metamorphic/task_dice.hpp"

namespace kempe::metamorphic {

Task shifted(Task task, const Point& by);
/// Everything that has a length, times `factor`.
Task enlarged(Task task, double factor);

/// How the designs of the changed task compare with those of the task, enlarged by the same factor.
enum class Relation {
  equal,   ///< the same designs
  looser,  ///< these and perhaps others
  tighter  ///< fewer
};

struct ChangedTask {
  Task task;
  Relation relation = Relation::equal;
  double unit = 1;  ///< lengths of the changed task are this many times those of the task
  /// Pole, tracer and pen of the changed task's designs in the task's frame: a design's copy error follows the pen.
  bool same_copy_error = true;
};

struct Change {
  std::string name;
  /// Nothing where the task has not what is to be changed.
  std::function<std::optional<ChangedTask>(const Task&, Dice&)> apply;
};

/// All of them.
const std::vector<Change>& changes();

}  // namespace kempe::metamorphic
