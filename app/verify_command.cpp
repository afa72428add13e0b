// kempe verify: a design checked anew from its file alone.

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/all_commands.hpp"
#include "reports/design_json.hpp"
#include "specs/text_file.hpp"
#include "synthesis/verification.hpp"

namespace kempe::app {
namespace {

int run(const std::string& file) {
  const auto text = read_text_file(file);
  if (!text) return fail(text.error());
  const auto design = read_design(*text, file);
  if (!design) return fail(design.error());
  const Verification found = verify(verification_task(*design));
  nlohmann::ordered_json object{{"file", file},
                                {"certified", found.certified},
                                {"samples", found.samples},
                                {"copy_error_max_mm", found.copy_error_max},
                                {"loop_residual_max_mm", found.loop_residual_max},
                                {"scale", found.scale},
                                {"rotation_deg", degrees(found.rotation)},
                                {"flips", found.flips}};
  if (!found.certified) object["failure"] = found.failure;
  print(object.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  return found.certified ? done : fail(verification_failed, file + ": " + found.failure);
}

}  // namespace

void add_verify_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "verify", "Check a design from its file alone, by closing the loops",
                  "kempe verify out/plagiograph/design.json");
  auto file = std::make_shared<std::string>();
  command->add_option("DESIGN", *file, "A design.json")->required();
  command->callback([&session, file] { session.chosen = [file] { return run(*file); }; });
}

}  // namespace kempe::app
