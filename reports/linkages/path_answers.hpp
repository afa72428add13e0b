#pragma once
// What `kempe path` asks and answers: the tasks of its spec, and the answers as JSON for programs.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/linkages/scene_wanted.hpp"
#include "specs/generator_spec.hpp"
#include "synthesis/paths/coupler_copy.hpp"
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

/// The task's points or poses beside those of an answer, for its page; poses are the coupler's, which cognates do not have.
std::vector<PlaceAskedFor> wanted_places(const PathTask& task, const PathAnswer& answer);
std::vector<PlaceAskedFor> wanted_places(const PoseTask& task, const PoseAnswer& answer);
/// The same of a cognate, which draws the same curve while its coupler turns otherwise: the points without directions.
std::vector<PlaceAskedFor> of_a_cognate(std::vector<PlaceAskedFor> wanted);

/// Whether four-bars were made with a dyad: those against a limit are listed, but not used.
bool is_used(const PoseSearch& search, const Dyad& dyad);

/// The plagiographs of some answers, in their order: each with what it is, or a sentence why there is none.
struct CopiesOfAnswers {
  CopyTask task;
  std::vector<tl::expected<CouplerCopy, std::string>> copies;
};

/// The pivot that "crank" or "rocker" names; nothing for another word.
std::optional<CopyPole> copy_pole_named(std::string_view word);
/// The plagiograph on every answer, or on its cognate 1 or 2; none without a task.
CopiesOfAnswers copies_of(const std::vector<PathAnswer>& answers, const std::optional<CopyTask>& task,
                          int cognate);

/// One JSON object (docs/path.md): every answer with its cognates, and the copies if there are any; what was searched; of five poses all
/// dyads too.
std::string path_json(const PathSearch& search, const CopiesOfAnswers& copies);
std::string path_json(const PoseTask& task, const PoseSearch& search, const CopiesOfAnswers& copies);

/// A copy in words, a few lines with an indent of two.
std::string copy_text(const CopyTask& task, const tl::expected<CouplerCopy, std::string>& copy);

}  // namespace kempe
