// kempe studio: the browser page with a spec inside.

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/design_run.hpp"
#include "app/output_check.hpp"
#include "app/studio_page.hpp"
#include "reports/data/atomic_file.hpp"

namespace kempe::app {
namespace {

struct StudioArguments {
  std::string spec_file, page;
};

/// Beside the spec: "plate.toml" becomes "plate.studio.html".
std::string page_beside(const std::string& spec_file) {
  return std::filesystem::path(spec_file).replace_extension(".studio.html").string();
}

int run(const Session& session, StudioArguments arguments) {
  if (arguments.page.empty()) arguments.page = page_beside(arguments.spec_file);
  const auto loaded = load_spec(session, arguments.spec_file);
  if (!loaded) return fail(session, loaded.error());
  const auto studio = find_studio();
  if (!studio) return fail(session, failed, studio.error());
  const auto page = studio_page(*studio, *loaded);
  if (!page) return fail(session, failed, page.error());
  std::vector<std::filesystem::path> inputs = loaded->inputs();
  inputs.push_back(studio->file);
  if (const auto clash = output_clash(inputs, {arguments.page})) return fail(session, *clash);
  if (const auto written = write_whole(arguments.page, *page); !written)
    return fail(session, cannot_write, written.error());
  print(session.json ? json_text({{"page", arguments.page}}) : arguments.page + "\n");
  return done;
}

}  // namespace

void add_studio_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "studio",
                                  "Write the browser page with a spec inside, to be changed there by hand",
                                  "kempe studio specs/examples/plagiograph.toml -o out/plagiograph.html");
  auto arguments = std::make_shared<StudioArguments>();
  command->add_option("SPEC", arguments->spec_file, "The spec (TOML; see docs/spec.md)")->required();
  command->add_option("-o,--output", arguments->page,
                      "The page, one file; left out: beside the spec, with .studio.html in place of .toml");
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
