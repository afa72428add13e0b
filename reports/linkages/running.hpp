#pragma once
// A linkage put together and set in motion, or the words that say why not: what solve, mobility, centres and the library share.

#include <cstdint>
#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/planar/mobility.hpp"
#include "specs/linkages/model.hpp"

namespace kempe {

struct LoadedLinkage {
  LinkageFile file;
  LinkageModel model;
};

/// Why a linkage gives no answer.
struct NoRun {
  enum class Why {
    bad_input,   ///< `fault` says what
    impossible,  ///< it does not assemble, or cannot start or go so far
    gave_up,     ///< the work allowed was spent
    interrupted  ///< `stop` said so
  };
  Why why = Why::impossible;
  InputError fault;
  std::string sentence;  ///< of the two in the middle, without the file's name
};

/// The model of a file. The error names the links that cannot be solved.
tl::expected<LoadedLinkage, InputError> loaded_linkage(LinkageFile file);

/// The same linkage, its drivers and bounds taken away.
LoadedLinkage without_drivers(const LoadedLinkage& loaded);

/// The closed positions at the start, the chosen one first.
tl::expected<std::vector<PlanarPosition>, NoRun> assembled(const LoadedLinkage& loaded, std::uint64_t seed,
                                                           const std::function<bool()>& stop);

/// A closed position with the drivers at their start, or, if they contradict each other, without them.
tl::expected<PlanarPosition, NoRun> closed_position(const LoadedLinkage& loaded, std::uint64_t seed,
                                                    const std::function<bool()>& stop);

/// The linkage driven from a closed position over `steps` parts. A motion that stops early is a run, not a failure; one that
/// is interrupted is.
tl::expected<PlanarRun, NoRun> driven_run(const LoadedLinkage& loaded, const PlanarPosition& start, int steps,
                                          const std::function<bool()>& stop);

/// The moment at a step, whole or not, from 0 to the file's last, reached along the motion; `option` named it.
tl::expected<RunFrame, NoRun> frame_at_step(const LoadedLinkage& loaded, const PlanarPosition& start,
                                            double step, const std::string& option,
                                            const std::function<bool()>& stop);

/// "dead point at step 17.33 of 36 (...): A, B and C in line (crank, rod)"; empty where the run did not end early.
std::string stop_sentence(const LoadedLinkage& loaded, const PlanarRun& run, int steps);

/// How many parts a motion of `steps` parts is run in to look smooth: each cut into equal parts.
int animated_steps(int steps);

}  // namespace kempe
