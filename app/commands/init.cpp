// kempe init: a commented spec to start from.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "kempe/spec.hpp"
#include "reports/data/atomic_file.hpp"
#include "specs/key_checks.hpp"
#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

struct InitArguments {
  std::string name, file;
};

std::string list_text() {
  std::size_t longest = 0;
  for (const SpecTemplate& one : spec_templates()) longest = std::max(longest, one.name.size());
  std::string text;
  for (const SpecTemplate& one : spec_templates())
    text += fmt::format("{:{}}  {}\n", one.name, longest, one.purpose);
  return text + "\nStart with one of them: kempe init TEMPLATE -o job.toml\n";
}

std::string list_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SpecTemplate& one : spec_templates())
    list.push_back({{"name", one.name}, {"purpose", one.purpose}});
  return json_text({{"templates", list}});
}

InputError no_such(const std::string& name) {
  constexpr std::size_t longest = 60;
  std::vector<std::string_view> names;
  for (const SpecTemplate& one : spec_templates()) names.push_back(one.name);
  return {"", 0, "TEMPLATE", printable(name, longest),
          known_instead(std::string_view(name).substr(0, longest), names, "template")};
}

int write_spec(const Session& session, const SpecTemplate& chosen, const std::string& file) {
  std::error_code unknown;
  if (std::filesystem::exists(file, unknown))
    return fail(session, {file, 0, "", "a file that is there already", "a name that is free"});
  if (const auto written = write_whole(std::filesystem::path(file), chosen.spec); !written)
    return fail(session, cannot_write, written.error());
  const std::string next = fmt::format("kempe synthesize {} -o {}", shell_word(file), chosen.name);
  print(session.json ? json_text({{"name", chosen.name}, {"file", file}, {"next", next}})
                     : fmt::format("{}\nwritten  {}\nnext     {}\n", chosen.purpose, file, next));
  return done;
}

int run(const Session& session, const InitArguments& arguments) {
  if (arguments.name.empty()) {
    print(session.json ? list_json() : list_text());
    return done;
  }
  const auto all = spec_templates();
  const auto chosen = std::find_if(all.begin(), all.end(),
                                   [&](const SpecTemplate& one) { return one.name == arguments.name; });
  if (chosen == all.end()) return fail(session, no_such(arguments.name));
  if (!arguments.file.empty()) return write_spec(session, *chosen, arguments.file);
  print(session.json ? json_text({{"name", chosen->name}, {"spec", chosen->spec}})
                     : std::string(chosen->spec));
  return done;
}

}  // namespace

void add_init_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "init", "A commented spec to start from",
                                  "kempe init sign-router -o sign.toml");
  auto arguments = std::make_shared<InitArguments>();
  auto* name =
      command->add_option("TEMPLATE", arguments->name, "The job to start from; left out: a list of them");
  command
      ->add_option("-o,--output", arguments->file,
                   "The spec's file, which must not be there yet; left out: it is printed")
      ->needs(name);
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
