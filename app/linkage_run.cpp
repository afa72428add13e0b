#include "app/linkage_run.hpp"

#include <cstdio>
#include <filesystem>

#include "app/interrupt.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/linkages/animation.hpp"

namespace kempe::app {
namespace {

/// The answer, or the exit code of its absence, which is told.
template <class Answer>
tl::expected<Answer, int> answer_or_code(const Session& session, const LoadedLinkage& loaded,
                                         tl::expected<Answer, NoRun> found) {
  if (found) return std::move(*found);
  return tl::unexpected(tell(session, loaded, found.error()));
}

}  // namespace

std::function<bool()> wish_to_stop() {
  static const Interrupt interrupt;
  return [] { return interrupt.requested().load(); };
}

CLI::Option* add_linkage_argument(CLI::App& command, std::string& file) {
  return command.add_option("LINKAGE", file, "The linkage (TOML; see docs/linkage-file.md)");
}

tl::expected<LoadedLinkage, int> load_linkage(const Session& session, const std::string& path) {
  auto file = read_linkage_file(path);
  if (!file) return tl::unexpected(fail(session, file.error()));
  if (!session.quiet)
    for (const std::string& note : file->notes) std::fprintf(stderr, "kempe: note: %s\n", note.c_str());
  auto loaded = loaded_linkage(std::move(*file));
  if (!loaded) return tl::unexpected(fail(session, loaded.error()));
  return std::move(*loaded);
}

int tell(const Session& session, const LoadedLinkage& loaded, const NoRun& none) {
  switch (none.why) {
    case NoRun::Why::bad_input: return fail(session, none.fault);
    case NoRun::Why::impossible: return fail(session, no_design, loaded.file.file + ": " + none.sentence);
    case NoRun::Why::gave_up: return fail(session, stopped, loaded.file.file + ": " + none.sentence);
    case NoRun::Why::interrupted: return fail(session, interrupted, "stopped; nothing is written");
  }
  return failed;
}

tl::expected<std::vector<PlanarPosition>, int> assemble_linkage(const Session& session,
                                                                const LoadedLinkage& loaded,
                                                                std::uint64_t seed) {
  return answer_or_code(session, loaded, assembled(loaded, seed, wish_to_stop()));
}

tl::expected<PlanarRun, int> drive_linkage(const Session& session, const LoadedLinkage& loaded,
                                           const PlanarPosition& start, int steps) {
  return answer_or_code(session, loaded, driven_run(loaded, start, steps, wish_to_stop()));
}

tl::expected<RunFrame, int> frame_at(const Session& session, const LoadedLinkage& loaded,
                                     const PlanarPosition& start, double step, const std::string& option) {
  return answer_or_code(session, loaded, frame_at_step(loaded, start, step, option, wish_to_stop()));
}

ExitCode code_of(const PlanarRun& run) {
  if (!run.stop) return done;
  return run.stop->end == PathEnd::gave_up ? stopped : no_design;
}

std::optional<InputError> wrong_animation(const std::string& option, const std::vector<std::string>& files) {
  for (const std::string& file : files)
    if (const auto kind = std::filesystem::path(file).extension(); kind != ".html" && kind != ".svg")
      return InputError{"", 0, option, file, "a file that ends in .html or .svg"};
  return std::nullopt;
}

int write_animations(const Session& session, const LinkageScene& scene,
                     const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    const bool page = std::filesystem::path(file).extension() == ".html";
    if (const int code = write_output(session, file, page ? animation_html(scene) : animation_svg(scene));
        code != done)
      return code;
  }
  return done;
}

int write_output(const Session& session, const std::string& path, const std::string& contents) {
  const auto written = write_whole(path, contents);
  return written ? static_cast<int>(done) : fail(session, cannot_write, written.error());
}

}  // namespace kempe::app
