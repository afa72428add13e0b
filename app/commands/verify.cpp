// kempe verify: a design checked anew from its file alone.

#include <fmt/format.h>

#include <memory>

#include "app/all_commands.hpp"
#include "reports/audit/design_audit.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

/// What is broken, a line each.
std::string complaint(const DesignAudit& found, const std::string& file) {
  std::string text = printable(file) + ":";
  for (const BrokenLimit& breach : found.broken)
    text += fmt::format("\n  {}: {}", breach.limit, breach.sentence);
  return text;
}

int check_file(const Session& session, const std::string& file) {
  const auto text = read_text_file(file);
  if (!text) return fail(session, text.error());
  const auto design = read_design(*text, file);
  if (!design) return fail(session, design.error());
  const auto found = audit(*design, file);
  if (!found) return fail(session, found.error());
  print(session.json ? audit_json(*found, file) : audit_text(*found));
  return found->certified() ? done : fail_told(verification_failed, complaint(*found, file));
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
