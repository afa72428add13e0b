#include "app/linkage_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "kinematics/mobility.hpp"
#include "reports/atomic_file.hpp"
#include "reports/linkage_json.hpp"

namespace kempe::app {
namespace {

std::string length_text(const LoadedLinkage& loaded, double mm) {
  return fmt::format("{:.6g} {}", mm / loaded.file.unit.in_mm, loaded.file.unit.name);
}

tl::unexpected<int> refuse(const LoadedLinkage& loaded, ExitCode code, const std::string& what) {
  return tl::unexpected(fail(code, loaded.file.file + ": " + what));
}

std::string driver_text(const LoadedLinkage& loaded, std::size_t driver, double value) {
  const auto& linkage = loaded.model.linkage;
  const Constraint& constraint =
      linkage.constraints()[static_cast<std::size_t>(linkage.drivers()[driver])].constraint;
  const std::string label = loaded.model.driver_label(static_cast<int>(driver));
  if (std::holds_alternative<RelativeAngle>(constraint))
    return fmt::format("{} = {:.6f} deg", label, degrees(value));
  return fmt::format("{} = {}", label, length_text(loaded, value));
}

std::string mobility_text(const LoadedLinkage& loaded, const PlanarPosition& position) {
  const Mobility mobility = mobility_of(loaded.model.linkage, position);
  return fmt::format("{}", fmt::join(mobility_sentences(loaded.model, mobility), "; "));
}

int tell_no_path(const LoadedLinkage& loaded, const NoPathHere& none) {
  const std::string& file = loaded.file.file;
  const std::size_t drivers = loaded.model.linkage.drivers().size();
  if (none.why == NoPath::does_not_assemble)
    return fail(no_design,
                fmt::format("{}: does not assemble: {} stays open by {}", file, none.assembly.worst,
                            length_text(loaded, none.assembly.closure_error)));
  const Mobility mobility = mobility_of(loaded.model.linkage, none.position);
  if (mobility.mobility == static_cast<int>(drivers) && mobility.singular_here())
    return fail(no_design, fmt::format("{}: the motion starts at a singular position: {}", file,
                                       mobility_text(loaded, none.position)));
  if (mobility.mobility == static_cast<int>(drivers))
    return fail(
        no_design,
        fmt::format("{}: the motion starts at a dead point: the drivers cannot move the linkage there",
                    file));
  return fail(
      bad_input,
      fmt::format(
          "{}: drivers: found {} driven {} on a mobility of {} ({}); allowed: as many as the mobility", file,
          drivers, drivers == 1 ? "value" : "values", mobility.mobility,
          mobility_text(loaded, none.position)));
}

}  // namespace

tl::expected<LoadedLinkage, int> load_linkage(const Session& session, const std::string& path) {
  auto file = read_linkage_file(path);
  if (!file) return tl::unexpected(fail(file.error()));
  if (!session.quiet)
    for (const std::string& note : file->notes) std::fprintf(stderr, "kempe: note: %s\n", note.c_str());
  LinkageModel model = linkage_model(*file);
  if (const std::string fault = model.linkage.fault(); !fault.empty())
    return tl::unexpected(fail(bad_input, path + ": " + fault));
  return LoadedLinkage{std::move(*file), std::move(model)};
}

tl::expected<std::vector<PlanarPosition>, int> assemble_linkage(const LoadedLinkage& loaded,
                                                                std::uint64_t seed) {
  AssemblySearch search;
  search.seed = seed;
  auto found = start_assemblies(loaded.file, loaded.model, search);
  if (found) return std::move(*found);
  const NoAssembly& none = found.error();
  if (!none.unmet.empty())
    return refuse(
        loaded, no_design,
        fmt::format("no closing of the linkage lies within the bounds of {}", fmt::join(none.unmet, ", ")));
  return refuse(loaded, no_design,
                fmt::format("does not assemble at the start: {} stays open by {}", none.nearest.worst,
                            length_text(loaded, none.nearest.closure_error)));
}

tl::expected<PlanarRun, int> drive_linkage(const LoadedLinkage& loaded, const PlanarPosition& start,
                                           int steps) {
  if (loaded.model.linkage.drivers().empty())
    return refuse(loaded, bad_input,
                  "drivers: found nothing; allowed: [[drivers]], as many as the linkage has freedoms");
  auto run = run_motion(loaded.model.linkage, start, loaded.model.schedule, steps);
  if (!run) return tl::unexpected(tell_no_path(loaded, run.error()));
  return std::move(*run);
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

int write_output(const std::string& path, const std::string& contents) {
  const auto written = write_whole(path, contents);
  return written ? static_cast<int>(done) : fail(cannot_write, written.error());
}

}  // namespace kempe::app
