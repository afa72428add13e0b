// kempe synthesize: from a spec to the best design.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/all_commands.hpp"
#include "app/batch/batch.hpp"
#include "app/batch/task_spec.hpp"
#include "app/command.hpp"
#include "app/design_run.hpp"
#include "app/progress.hpp"
#include "app/stopping.hpp"
#include "app/studio_page.hpp"
#include "app/words.hpp"
#include "reports/certificate.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/search.hpp"
#include "synthesis/search/search_faults.hpp"

namespace kempe::app {
namespace {

struct SynthesizeArguments {
  std::string spec_file, batch_source, only, folder;
  std::uint64_t seed = 1;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  double time_limit = Deadline::unlimited;
  double map_tolerance = MapOptions{}.map_tolerance;
  bool studio = false;
  Paper paper = Paper::A4;
};

/// In the objective's unit.
std::string known_bound(Objective objective, const std::optional<double>& bound) {
  if (!bound || !std::isfinite(*bound)) return "";
  if (objective == Objective::transmission)
    return fmt::format("; none is larger than {:.4f} degrees", degrees(*bound));
  return fmt::format("; none is smaller than {} mm", shown(*bound, 4));
}

int run(const Session& session, const SynthesizeArguments& arguments) {
  if (!arguments.batch_source.empty() && arguments.only.empty())
    return run_batch(session, {arguments.batch_source, arguments.folder, arguments.threads, arguments.seed,
                               arguments.time_limit});
  const Deadline deadline(arguments.time_limit);
  const auto loaded = arguments.batch_source.empty() ? load_spec(session, arguments.spec_file)
                                                     : spec_of_batch(arguments.batch_source, arguments.only);
  if (!loaded) return fail(session, loaded.error());
  if (auto fault = search_fault(loaded->spec)) {
    fault->file = loaded->file;
    return fail(session, *fault);
  }
  const auto studio = studio_page_if(arguments.studio, *loaded);
  if (!studio) return fail(session, failed, studio.error());
  const Stopping stopping(deadline);
  SearchOutcome outcome = NoDesign{};
  {
    Progress progress(session.quiet);
    SearchOptions options;
    options.seed = arguments.seed;
    options.unit = loaded->unit();
    options.threads = arguments.threads;
    options.time_limit = stopping.left();
    options.stop = stopping.flag();
    options.progress = [&](double share, std::string_view what) { progress.show(share, what); };
    outcome = synthesize(loaded->spec, options);
  }
  const Objective objective = loaded->spec.objective.objective;
  if (const auto* early = std::get_if<Stopped>(&outcome))
    return tell_stopped(session, stopping,
                        "before a design was found or proven impossible; nothing is written" +
                            known_bound(objective, early->proven_bound),
                        early->proven_bound);
  const StopFlag to_map = stopping.flag(time_to_map(stopping.limit()));
  if (const auto* none = std::get_if<NoDesign>(&outcome))
    return tell_no_design(session, *none, loaded->unit(), ProofFolder{*loaded, arguments.folder, to_map});
  const auto& found = std::get<FoundDesign>(outcome);
  std::optional<CertificateOrNone> proof;
  auto design = certified_design(
      loaded->spec, found, {.map_tolerance = arguments.map_tolerance, .stop = to_map}, Detail::full,
      arguments.threads, [&](const Design& searched) { proof = certificate_of(searched, to_map); });
  if (!design) return fail_unproven(session, none_found + (": " + design.error()));
  const StopFlag to_write = stopping.flag(time_to_write(stopping.limit()));
  const int code = publish_design(session, *design, *loaded, arguments.folder, {to_map, to_write}, *studio,
                                  arguments.paper, arguments.threads, std::move(proof));
  return code == done && stopping.interrupted() ? interrupted : code;
}

}  // namespace

void add_synthesize_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "synthesize",
                                  "Find the best design for a spec, map its workspace, verify it",
                                  "kempe synthesize specs/examples/plagiograph.toml -o out/plagiograph");
  auto arguments = std::make_shared<SynthesizeArguments>();
  auto* spec = command->add_option("SPEC", arguments->spec_file, "The spec (TOML; see docs/spec.md)");
  auto* batch = command->add_option(
      "--batch", arguments->batch_source,
      "Many specs: a folder of *.toml, a .jsonl file or a sweep (.json); resumable (docs/batch.md)");
  spec->excludes(batch);
  command->add_option("-o,--output", arguments->folder, "Folder for the design's files")->required();
  add_seed_option(*command, arguments->seed,
                  "Seed of the random numbers; the same seed gives the same design")
      ->capture_default_str();
  add_threads_option(*command, arguments->threads);
  add_time_limit(*command, arguments->time_limit,
                 "Seconds (for each spec of a batch); then the best design so far, marked as such, or exit "
                 "code 6 if there is none");
  command
      ->add_option("--map-tolerance", arguments->map_tolerance,
                   "Share of the free workspace that may stay uncertain")
      ->check(number_between(1e-5, 0.5))
      ->capture_default_str();
  command
      ->add_option("--only", arguments->only,
                   "Of a batch the one spec that its results call so (line-17, cell-2-1), with all files")
      ->needs(batch);
  const std::array of_one_design{add_studio_option(*command, arguments->studio),
                                 add_paper_option(*command, arguments->paper)};
  command->callback([&session, arguments, spec, batch, of_one_design] {
    if (spec->empty() && batch->empty()) throw CLI::RequiredError("SPEC or --batch");
    for (const CLI::Option* option : of_one_design)
      if (!option->empty() && !batch->empty() && arguments->only.empty())
        throw CLI::ExcludesError(option->get_name(), "--batch without --only");
    session.chosen = [&session, arguments] { return run(session, *arguments); };
  });
}

}  // namespace kempe::app
