#include "reports/linkages/running.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/fixed_text.hpp"
#include "kinematics/planar/singularity.hpp"
#include "reports/linkages/json.hpp"

namespace kempe {
namespace {

constexpr int least_animated_moments = 180;

tl::unexpected<NoRun> no_run(NoRun::Why why, std::string sentence = {}) {
  return tl::unexpected(NoRun{why, {}, std::move(sentence)});
}

tl::unexpected<NoRun> no_run(InputError fault) {
  return tl::unexpected(NoRun{NoRun::Why::bad_input, std::move(fault), {}});
}

std::string length_text(const LoadedLinkage& loaded, double length) {
  return fmt::format("{:.6g} {}", length / loaded.file.unit.in_mm, loaded.file.unit.name);
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

tl::unexpected<NoRun> wrong_drivers(const LoadedLinkage& loaded, const Mobility& mobility) {
  const std::size_t driven = loaded.model.linkage.drivers().size();
  return no_run(
      {loaded.file.file, loaded.file.drivers.empty() ? 0 : loaded.file.drivers.back().line, "drivers",
       fmt::format("{} driven {} for a mobility of {} ({})", driven, driven == 1 ? "value" : "values",
                   mobility.mobility, fmt::join(mobility_sentences(loaded.model, mobility), "; ")),
       "as many driven values as the mobility"});
}

/// Nothing closes with the drivers at their start: too many drivers, values out of reach, or no linkage at
/// all.
tl::unexpected<NoRun> not_assembled(const LoadedLinkage& loaded, const Missing& missing, std::uint64_t seed,
                                    const std::function<bool()>& stop) {
  const LoadedLinkage free = without_drivers(loaded);
  AssemblySearch search;
  search.seed = seed;
  search.stop = stop;
  const auto found = start_assembly_modes(free.file, free.model, search);
  if (!found && stop && stop()) return no_run(NoRun::Why::interrupted);
  if (!found) return no_run(NoRun::Why::impossible, "does not assemble: " + opening_text(loaded, missing));
  const Mobility mobility = mobility_of(free.model.linkage, found->front());
  if (mobility.mobility < static_cast<int>(loaded.model.linkage.drivers().size()))
    return wrong_drivers(loaded, mobility);
  return no_run(NoRun::Why::impossible,
                "does not assemble at the start of the motion, where the drivers' first values are out of "
                "reach: " +
                    opening_text(loaded, missing));
}

tl::unexpected<NoRun> no_path(const LoadedLinkage& loaded, const NoPathHere& none,
                              const std::function<bool()>& stop) {
  if (none.why == NoPath::does_not_assemble)
    return not_assembled(
        loaded, missing_at(loaded.model.linkage, none.assembly_mode, loaded.model.schedule.values_at(0)), 1,
        stop);
  const Mobility mobility = mobility_of(loaded.model.linkage, none.position);
  if (mobility.mobility != static_cast<int>(loaded.model.linkage.drivers().size()))
    return wrong_drivers(loaded, mobility);
  const std::string why =
      mobility.singular_here()
          ? fmt::format("a singular position: {}",
                        fmt::join(mobility_sentences(loaded.model, mobility), "; "))
          : fmt::format("a dead point, where the drivers cannot move the linkage: {}",
                        fmt::join(describe_singularity(loaded.model.linkage, none.position), "; "));
  return no_run(NoRun::Why::impossible, "the motion starts at " + why);
}

/// A run, if the linkage has drivers and a path from the start, and nobody stops it.
template <class Run>
tl::expected<PlanarRun, NoRun> driven(const LoadedLinkage& loaded, const std::function<bool()>& stop,
                                      const Run& run_it) {
  if (loaded.model.linkage.drivers().empty())
    return no_run(
        {loaded.file.file, 0, "drivers", "nothing", "[[drivers]], as many as the linkage has freedoms"});
  tl::expected<PlanarRun, NoPathHere> run = run_it();
  if (!run) return no_path(loaded, run.error(), stop);
  if (run->stop && run->stop->end == PathEnd::interrupted) return no_run(NoRun::Why::interrupted);
  return std::move(*run);
}

}  // namespace

tl::expected<LoadedLinkage, InputError> loaded_linkage(LinkageFile file) {
  LinkageModel model = linkage_model(file);
  if (const std::string fault = model.linkage.fault(); !fault.empty())
    return tl::unexpected(InputError{file.file, 0, "links", fault, "a linkage that can be solved"});
  return LoadedLinkage{std::move(file), std::move(model)};
}

LoadedLinkage without_drivers(const LoadedLinkage& loaded) {
  LoadedLinkage free = loaded;
  free.model.linkage = loaded.model.linkage.undriven();
  free.model.schedule = {};
  free.file.bounds.clear();
  return free;
}

tl::expected<std::vector<PlanarPosition>, NoRun> assembled(const LoadedLinkage& loaded, std::uint64_t seed,
                                                           const std::function<bool()>& stop) {
  AssemblySearch search;
  search.seed = seed;
  search.stop = stop;
  auto found = start_assembly_modes(loaded.file, loaded.model, search);
  if (stop && stop()) return no_run(NoRun::Why::interrupted);
  if (found) return std::move(*found);
  const NoAssembly& none = found.error();
  if (!none.unmet.empty())
    return no_run(
        NoRun::Why::gave_up,
        fmt::format(
            "of {} closings that were found none lies within all bounds; the nearest is outside those of {}; "
            "there may be more closings: a [guess] leads to one",
            none.closings, fmt::join(none.unmet, ", ")));
  return not_assembled(loaded, none.missing.value(), seed, stop);
}

tl::expected<PlanarPosition, NoRun> closed_position(const LoadedLinkage& loaded, std::uint64_t seed,
                                                    const std::function<bool()>& stop) {
  AssemblySearch search;
  search.seed = seed;
  search.stop = stop;
  if (const auto driven = start_assembly_modes(loaded.file, loaded.model, search)) return driven->front();
  auto found = assembled(without_drivers(loaded), seed, stop);
  if (!found) return tl::unexpected(std::move(found.error()));
  return found->front();
}

tl::expected<PlanarRun, NoRun> driven_run(const LoadedLinkage& loaded, const PlanarPosition& start, int steps,
                                          const std::function<bool()>& stop) {
  return driven(loaded, stop, [&] {
    return run_motion(loaded.model.linkage, start, loaded.model.schedule, steps, {stop});
  });
}

tl::expected<RunFrame, NoRun> frame_at_step(const LoadedLinkage& loaded, const PlanarPosition& start,
                                            double step, const std::string& option,
                                            const std::function<bool()>& stop) {
  if (!(step >= 0 && step <= loaded.file.steps))
    return no_run({loaded.file.file, 0, option, fmt::format("{:g}", step),
                   fmt::format("a step from 0 to {}", loaded.file.steps)});
  auto run = driven(loaded, stop, [&] {
    return run_to(loaded.model.linkage, start, loaded.model.schedule, step / loaded.file.steps, {stop});
  });
  if (!run) return tl::unexpected(std::move(run.error()));
  if (!run->stop) return run->frames.back();
  return no_run(run->stop->end == PathEnd::gave_up ? NoRun::Why::gave_up : NoRun::Why::impossible,
                fmt::format("the motion ends before step {:g}: {}", step,
                            stop_sentence(loaded, *run, loaded.file.steps)));
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

int animated_steps(int steps) { return steps * ((least_animated_moments + steps - 1) / steps); }

}  // namespace kempe
