#pragma once
// What Kempe says about a task: a design or none, and what it says is proven.

#include <optional>
#include <string>

#include "synthesis/bound/proven_bound.hpp"
#include "synthesis/search/search.hpp"
#include "tests/metamorphic/task.hpp"

namespace kempe::metamorphic {

struct Answer {
  Spec spec;
  std::optional<FoundDesign> design{};
  bool proven_none = false;  ///< by the search or by one of the bounds below
  bool complete = true;      ///< not stopped
  /// mm, no design is smaller; of all bounds that were proven the sharpest
  std::optional<double> least_size{};
  std::optional<double> most_transmission{};  ///< rad, no design has more
};

struct AnswerOptions {
  /// Without a search the design is the best that the bound met on its way, if it keeps all limits: a hundredth of the work.
  bool search = true;
  double seconds = 1e9;     ///< of the processor's work, for a search
  std::size_t boxes = 400;  ///< for each of the two bounds that are asked for beside the search's
};

Answer answer_of(const Task& task, const AnswerOptions& options);

/// The first limit that a linkage in the given layers misses, by map and figures; "" if it keeps them all.
std::string limit_missed(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers,
                         double slack);

}  // namespace kempe::metamorphic
