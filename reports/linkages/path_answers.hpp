#pragma once
// What `kempe path` asks and answers: the tasks of its spec, and the answers as JSON for programs.

#include <string>

#include "specs/generator_spec.hpp"
#include "synthesis/paths/path_generator.hpp"
#include "synthesis/paths/pose_guidance.hpp"

namespace kempe {

/// What every answer leaves open, in words.
inline constexpr const char* no_path_bound =
    "a search: no bound of the least error is known, and nothing is proven about what was not found";

/// The task of a spec with points.
PathTask path_task(const PathSpec& spec);
/// The task of a spec with poses.
PoseTask pose_task(const PathSpec& spec);

/// Whether four-bars were made with a dyad: those against a limit are listed, but not used.
bool is_used(const PoseSearch& search, const Dyad& dyad);

/// One JSON object (docs/path.md): every answer with its cognates, what was searched; of five poses all dyads too.
std::string path_json(const PathSearch& search);
std::string path_json(const PoseTask& task, const PoseSearch& search);

}  // namespace kempe
