#pragma once
// What two answers, or an answer and a mechanism, must have to do with each other.

#include <map>
#include <string>
#include <vector>

#include "tests/metamorphic/answer.hpp"
#include "tests/metamorphic/task_changes.hpp"

namespace kempe::metamorphic {

struct Finding {
  /// A false proof, or a design that does not hold; else a design that is not as good as it could be.
  bool is_false_proof = false;
  std::string law, sentence;
  std::vector<Task> tasks{};
  std::optional<MechanismSpec> mechanism{};  ///< of the first task, with its pole there
};

using Counts = std::map<std::string, long>;

/// Share by which equal tasks' designs may differ, and a looser task's design may be worse.
inline constexpr double as_good = 0.005;

/// The design keeps every limit, and lies on the right side of what is proven of its own task.
std::vector<Finding> check_alone(const Task& task, const Answer& answer);

/// The answer to a task and to what was made of it.
std::vector<Finding> check_pair(const Task& task, const Answer& answer, const std::string& law,
                                const ChangedTask& changed, const Answer& other);

/// Random mechanisms that the map certifies lie on the right side of what is proven. Most of those tried are smaller than the
/// bound: they must fail.
std::vector<Finding> check_mechanisms(const Task& task, const Answer& answer, Dice& dice, Counts& counts);

}  // namespace kempe::metamorphic
