// kempe centres: every instant centre of a linkage at one step of its motion.

#include <fmt/format.h>

#include <memory>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/interrupt.hpp"
#include "app/linkage_run.hpp"
#include "app/output_check.hpp"
#include "reports/linkages/centres_page.hpp"
#include "reports/linkages/centres_picture.hpp"
#include "reports/linkages/json.hpp"
#include "reports/linkages/text.hpp"

namespace kempe::app {
namespace {

struct CentresArguments {
  std::string linkage, picture, page;
  double step = 0;
  std::uint64_t seed = 1;
};

int run(const Session& session, const CentresArguments& arguments) {
  if (const auto clash = output_clash({arguments.linkage}, {arguments.picture, arguments.page}))
    return fail(session, *clash);
  const auto loaded = load_linkage(session, arguments.linkage);
  if (!loaded) return loaded.error();
  const auto assembly_modes = assemble_linkage(session, *loaded, arguments.seed);
  if (!assembly_modes) return assembly_modes.error();
  const auto frame = frame_at(session, *loaded, assembly_modes->front(), arguments.step, "--at");
  if (!frame) return frame.error();
  let_signals_end();
  const auto centres = instant_centres(loaded->model.linkage, frame->position, frame->rate);
  const std::vector<double> speeds = loaded->model.schedule.speeds_at(frame->share);
  const PlanarRun moment{{*frame}, std::nullopt};
  const LinkageScene scene = linkage_scene(loaded->file, loaded->model, moment, loaded->file.steps);
  if (!arguments.picture.empty()) {
    const int code =
        write_output(session, arguments.picture, centres_svg(scene, centres, loaded->file.unit.in_mm));
    if (code != done) return code;
  }
  if (!arguments.page.empty()) {
    const int code = write_output(session, arguments.page,
                                  centres_html(loaded->file, loaded->model, scene, arguments.step, centres));
    if (code != done) return code;
  }
  const auto answer = session.json ? centres_json : centres_text;
  print(answer(loaded->file, loaded->model, arguments.step, *frame, speeds, centres));
  return done;
}

}  // namespace

void add_centres_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "centres", "Every instant centre, by joints and Aronhold-Kennedy",
                  "kempe centres specs/examples/linkages/plagiograph.toml --at 3 -o centres.svg");
  auto arguments = std::make_shared<CentresArguments>();
  add_linkage_argument(*command, arguments->linkage)->required();
  command->add_option("--at", arguments->step, "Step of the motion")->capture_default_str();
  command->add_option("-o,--svg", arguments->picture, "Draw them too: FILE.svg");
  command->add_option("--page", arguments->page, "Write a page that finds them step by step: FILE.html");
  add_seed_option(*command, arguments->seed, "Seed of the random numbers in the search for assembly modes")
      ->capture_default_str();
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
