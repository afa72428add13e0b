// kempe mobility: how many freedoms a linkage has, counted and in truth; and which links make up a linkage.

#include <memory>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/interrupt.hpp"
#include "app/linkage_run.hpp"
#include "reports/linkages/json.hpp"
#include "reports/linkages/text.hpp"

namespace kempe::app {
namespace {

struct MobilityArguments {
  std::string linkage;
  int links = 0, freedoms = 1;
  std::uint64_t seed = 1;
};

int run(const Session& session, const MobilityArguments& arguments) {
  if (arguments.links > 0) {
    const auto answer = session.json ? number_synthesis_json : number_synthesis_text;
    print(answer(arguments.links, arguments.freedoms, number_synthesis(arguments.links, arguments.freedoms)));
    return done;
  }
  const auto loaded = load_linkage(session, arguments.linkage);
  if (!loaded) return loaded.error();
  const auto closed = closed_position(*loaded, arguments.seed, wish_to_stop());
  if (!closed) return tell(session, *loaded, closed.error());
  let_signals_end();
  const Mobility mobility = mobility_of(loaded->model.linkage, *closed, arguments.seed);
  const auto answer = session.json ? mobility_json : mobility_text;
  print(answer(loaded->file, loaded->model, mobility));
  return done;
}

}  // namespace

void add_mobility_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "mobility", "Gruebler's count and the true mobility; number synthesis",
                  "kempe mobility specs/examples/linkages/plagiograph.toml\n"
                  "  kempe mobility --links 6 --dof 1");
  auto arguments = std::make_shared<MobilityArguments>();
  auto* linkage = add_linkage_argument(*command, arguments->linkage);
  auto* links = command
                    ->add_option("--links", arguments->links,
                                 "Number synthesis: chains of so many links, the ground included")
                    ->check(CLI::Range(2, 40));
  command->add_option("--dof", arguments->freedoms, "Number synthesis: chains of so many freedoms")
      ->check(CLI::Range(0, 40))
      ->needs(links);
  add_seed_option(*command, arguments->seed, "Seed of the random numbers in the search for closed positions")
      ->capture_default_str();
  linkage->excludes(links);
  command->callback([&session, arguments, linkage, links] {
    if (linkage->empty() && links->empty()) throw CLI::RequiredError("LINKAGE or --links");
    session.chosen = [&session, arguments] { return run(session, *arguments); };
  });
}

}  // namespace kempe::app
