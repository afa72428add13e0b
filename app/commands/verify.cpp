// kempe verify: a design checked anew from its file alone.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <system_error>

#include "app/all_commands.hpp"
#include "app/broken_design.hpp"
#include "app/command.hpp"
#include "app/own_files.hpp"
#include "reports/audit/design_audit.hpp"
#include "reports/certificate.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

/// The command that proves the bound, where its log stands beside the design.
std::string proof_line(const StoredDesign& design, const std::string& file) {
  const auto log = std::filesystem::path(file).parent_path() / certificate_name;
  std::error_code unknown;
  if (!design.quality.proven_bound || !std::filesystem::is_regular_file(log, unknown)) return "";
  return fmt::format("proof        check the bound with: {} {} {}\n", checker_command(),
                     printable(shell_word(file)), printable(shell_word(log.string())));
}

int check_file(const Session& session, const std::string& file) {
  const auto text = read_text_file(file);
  if (!text) return fail(session, text.error());
  const auto design = read_design(*text, file);
  if (!design) return fail(session, design.error());
  const auto found = audit(*design, file);
  if (!found) return fail(session, found.error());
  answer(session, audit_text(*found) + proof_line(*design, file), audit_json(*found, file));
  return found->holds() ? done : fail_told(verification_failed, broken_text(*found, file));
}

}  // namespace

void add_verify_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "verify",
                                  "Check everything that a design's file states, from the file alone",
                                  "kempe verify out/plagiograph/design.json");
  auto file = std::make_shared<std::string>();
  command->add_option("DESIGN", *file, "A design.json")->required();
  command->callback(
      [&session, file] { session.chosen = [&session, file] { return check_file(session, *file); }; });
}

}  // namespace kempe::app
