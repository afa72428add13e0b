#include "app/linkage_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "app/interrupt.hpp"
#include "geometry/fixed_text.hpp"
#include "kinematics/planar/mobility.hpp"
#include "kinematics/planar/singularity.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/linkages/json.hpp"
#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

std::string length_text(const LoadedLinkage& loaded, double length) {
  return fmt::format("{:.6g} {}", length / loaded.file.unit.in_mm, loaded.file.unit.name);
}

tl::unexpected<int> no_answer(const Session& session, const LoadedLinkage& loaded, const std::string& what) {
  return tl::unexpected(fail(session, no_design, loaded.file.file + ": " + what));
}

std::string driver_text(const LoadedLinkage& loaded, std::size_t driver, double value) {
  const auto& linkage = loaded.model.linkage;
  const Constraint& constraint =
      linkage.constraints()[static_cast<std::size_t>(linkage.drivers()[driver])].constraint;
  const std::string label = loaded.model.driver_label(static_cast<int>(driver));
  if (std::holds_alternative<RelativeAngle>(constraint))
    return fmt::format("{} = {} deg", label, fixed_text(degrees(value), 6));
  return fmt::format("{} = {}", label, length_text(loaded, value));
}

/// What is missing, in its own unit.
std::string opening_text(const LoadedLinkage& loaded, const Missing& missing) {
  const std::string label = constraint_label(loaded.model, missing.constraint);
  if (missing.gap.is_angle)
    return fmt::format("{}: off by {:.6g} degrees", label, degrees(missing.gap.amount));
  return fmt::format("{} has a gap of {}", label, length_text(loaded, missing.gap.amount));
}

int tell_wrong_drivers(const Session& session, const LoadedLinkage& loaded, const Mobility& mobility) {
  const std::size_t driven = loaded.model.linkage.drivers().size();
  return fail(session,
              {loaded.file.file, loaded.file.drivers.empty() ? 0 : loaded.file.drivers.back().line, "drivers",
               fmt::format("{} driven {} for a mobility of {} ({})", driven, driven == 1 ? "value" : "values",
                           mobility.mobility, fmt::join(mobility_sentences(loaded.model, mobility), "; ")),
               "as many driven values as the mobility"});
}

int tell_stopped(const Session& session) { return fail(session, interrupted, "stopped; nothing is written"); }

/// Nothing closes with the drivers at their start: too many drivers, values out of reach, or no linkage at
/// all.
int tell_not_assembled(const Session& session, const LoadedLinkage& loaded, const Missing& missing,
                       std::uint64_t seed) {
  LoadedLinkage free = loaded;
  free.model.linkage = loaded.model.linkage.undriven();
  free.model.schedule = {};
  free.file.bounds.clear();
  AssemblySearch search;
  search.seed = seed;
  search.stop = wish_to_stop();
  const auto found = start_assembly_modes(free.file, free.model, search);
  if (!found && search.stop()) return tell_stopped(session);
  if (!found)
    return fail(session, no_design,
                fmt::format("{}: does not assemble: {}", loaded.file.file, opening_text(loaded, missing)));
  const Mobility mobility = mobility_of(free.model.linkage, found->front());
  if (mobility.mobility < static_cast<int>(loaded.model.linkage.drivers().size()))
    return tell_wrong_drivers(session, loaded, mobility);
  return fail(session, no_design,
              fmt::format("{}: does not assemble at the start of the motion, where the drivers' "
                          "first values are out of reach: {}",
                          loaded.file.file, opening_text(loaded, missing)));
}

int tell_no_path(const Session& session, const LoadedLinkage& loaded, const NoPathHere& none) {
  if (none.why == NoPath::does_not_assemble)
    return tell_not_assembled(
        session, loaded,
        missing_at(loaded.model.linkage, none.assembly_mode, loaded.model.schedule.values_at(0)), 1);
  const Mobility mobility = mobility_of(loaded.model.linkage, none.position);
  if (mobility.mobility != static_cast<int>(loaded.model.linkage.drivers().size()))
    return tell_wrong_drivers(session, loaded, mobility);
  const std::string why =
      mobility.singular_here()
          ? fmt::format("a singular position: {}",
                        fmt::join(mobility_sentences(loaded.model, mobility), "; "))
          : fmt::format("a dead point, where the drivers cannot move the linkage: {}",
                        fmt::join(describe_singularity(loaded.model.linkage, none.position), "; "));
  return fail(session, no_design, fmt::format("{}: the motion starts at {}", loaded.file.file, why));
}

/// A run, if the linkage has drivers and a path from the start, and nobody stops it.
template <class Run>
tl::expected<PlanarRun, int> driven(const Session& session, const LoadedLinkage& loaded, const Run& run_it) {
  if (loaded.model.linkage.drivers().empty())
    return tl::unexpected(fail(session, {loaded.file.file, 0, "drivers", "nothing",
                                         "[[drivers]], as many as the linkage has freedoms"}));
  tl::expected<PlanarRun, NoPathHere> run = run_it();
  if (!run) return tl::unexpected(tell_no_path(session, loaded, run.error()));
  if (run->stop && run->stop->end == PathEnd::interrupted) return tl::unexpected(tell_stopped(session));
  return std::move(*run);
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
  LinkageModel model = linkage_model(*file);
  if (const std::string fault = model.linkage.fault(); !fault.empty())
    return tl::unexpected(fail(session, {path, 0, "links", fault, "a linkage that can be solved"}));
  return LoadedLinkage{std::move(*file), std::move(model)};
}

tl::expected<std::vector<PlanarPosition>, int> assemble_linkage(const Session& session,
                                                                const LoadedLinkage& loaded,
                                                                std::uint64_t seed) {
  AssemblySearch search;
  search.seed = seed;
  search.stop = wish_to_stop();
  auto found = start_assembly_modes(loaded.file, loaded.model, search);
  if (found) return std::move(*found);
  const NoAssembly& none = found.error();
  if (!none.unmet.empty())
    return no_answer(
        session, loaded,
        fmt::format("no closing of the linkage lies within the bounds of {}", fmt::join(none.unmet, ", ")));
  if (search.stop()) return tl::unexpected(tell_stopped(session));
  return tl::unexpected(tell_not_assembled(session, loaded, none.missing.value(), seed));
}

tl::expected<PlanarRun, int> drive_linkage(const Session& session, const LoadedLinkage& loaded,
                                           const PlanarPosition& start, int steps) {
  return driven(session, loaded, [&] {
    return run_motion(loaded.model.linkage, start, loaded.model.schedule, steps, {wish_to_stop()});
  });
}

tl::expected<PlanarRun, int> drive_to(const Session& session, const LoadedLinkage& loaded,
                                      const PlanarPosition& start, double step) {
  return driven(session, loaded, [&] {
    return run_to(loaded.model.linkage, start, loaded.model.schedule, step / loaded.file.steps,
                  {wish_to_stop()});
  });
}

tl::expected<RunFrame, int> frame_at(const Session& session, const LoadedLinkage& loaded,
                                     const PlanarPosition& start, double step, const std::string& option) {
  if (!(step >= 0 && step <= loaded.file.steps))
    return tl::unexpected(fail(session, {loaded.file.file, 0, option, fmt::format("{:g}", step),
                                         fmt::format("a step from 0 to {}", loaded.file.steps)}));
  auto run = drive_to(session, loaded, start, step);
  if (!run) return tl::unexpected(run.error());
  if (!run->stop) return run->frames.back();
  return tl::unexpected(fail(session, code_of(*run),
                             fmt::format("{}: the motion ends before step {:g}: {}", loaded.file.file, step,
                                         stop_sentence(loaded, *run, loaded.file.steps))));
}

std::string stop_sentence(const LoadedLinkage& loaded, const PlanarRun& run, int steps) {
  if (!run.stop) return {};
  const RunFrame& last = run.frames.back();
  std::string where;
  for (std::size_t i = 0; i < last.values.size(); ++i)
    where += (i ? ", " : "") + driver_text(loaded, i, last.values[i]);
  std::string text =
      fmt::format("{} at step {:.6g} of {} ({})", name(run.stop->end), last.share * steps, steps, where);
  if (!run.stop->sentences.empty()) text += fmt::format(": {}", fmt::join(run.stop->sentences, "; "));
  return text;
}

ExitCode code_of(const PlanarRun& run) {
  if (!run.stop) return done;
  return run.stop->end == PathEnd::gave_up ? stopped : no_design;
}

int write_output(const Session& session, const std::string& path, const std::string& contents) {
  const auto written = write_whole(path, contents);
  return written ? static_cast<int>(done) : fail(session, cannot_write, written.error());
}

}  // namespace kempe::app
