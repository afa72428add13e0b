#pragma once
// What solve, mobility and centres share: a linkage file read, put together and set in motion, or an exit
// code with its message already told.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/command.hpp"
#include "reports/linkages/running.hpp"
#include "reports/linkages/scene.hpp"

namespace kempe::app {

/// Whether the user asked to stop, for the solver's own looking.
std::function<bool()> wish_to_stop();

/// The argument LINKAGE; whether it is required is the caller's.
CLI::Option* add_linkage_argument(CLI::App& command, std::string& file);

/// Reads the file, builds its model and tells the reader's notes on stderr (unless quiet).
tl::expected<LoadedLinkage, int> load_linkage(const Session& session, const std::string& file);

/// Tells why there is no answer; returns the exit code.
int tell(const Session& session, const LoadedLinkage& loaded, const NoRun& none);

/// The closed positions at the start, the chosen one first.
tl::expected<std::vector<PlanarPosition>, int> assemble_linkage(const Session& session,
                                                                const LoadedLinkage& loaded,
                                                                std::uint64_t seed);

/// Drives the linkage from a closed position over `steps` parts. A motion that stops early is a run, not a
/// failure; one that the user stops is.
tl::expected<PlanarRun, int> drive_linkage(const Session& session, const LoadedLinkage& loaded,
                                           const PlanarPosition& start, int steps);

/// The moment at a step, whole or not, from 0 to the file's last, reached along the motion; `option` named it.
tl::expected<RunFrame, int> frame_at(const Session& session, const LoadedLinkage& loaded,
                                     const PlanarPosition& start, double step, const std::string& option);

/// Of a motion that ended early: `no_design` where the linkage cannot go on, `stopped` where the work allowed was spent.
ExitCode code_of(const PlanarRun& run);

/// What is wrong with the names of animations: `option` takes pages and pictures that move.
std::optional<InputError> wrong_animation(const std::string& option, const std::vector<std::string>& files);

/// Writes a scene as pages (.html) and pictures that move; as write_output.
int write_animations(const Session& session, const LinkageScene& scene,
                     const std::vector<std::string>& files);

/// Writes an output file; on failure tells why and returns cannot_write.
int write_output(const Session& session, const std::string& path, const std::string& contents);

}  // namespace kempe::app
