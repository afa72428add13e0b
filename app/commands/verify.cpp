// kempe verify: a design checked anew from its file alone.

#include <fmt/format.h>

#include <memory>

#include "app/all_commands.hpp"
#include "reports/audit/design_audit.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

struct VerifyArguments {
  std::string file;
  bool in_words = false;
};

/// What is broken, a line each.
std::string complaint(const DesignAudit& found, const std::string& file) {
  std::string text = printable(file) + ":";
  for (const BrokenLimit& breach : found.broken)
    text += fmt::format("\n  {}: {}", breach.limit, breach.sentence);
  return text;
}

int run(const VerifyArguments& arguments, bool json) {
  const auto text = read_text_file(arguments.file);
  if (!text) return fail(text.error());
  const auto design = read_design(*text, arguments.file);
  if (!design) return fail(design.error());
  const auto found = audit(*design, arguments.file);
  if (!found) return fail(found.error());
  print(arguments.in_words && !json ? audit_text(*found) : audit_json(*found, arguments.file));
  return found->certified() ? done : fail(verification_failed, complaint(*found, arguments.file));
}

}  // namespace

void add_verify_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "verify",
                                  "Check everything that a design's file states, from the file alone",
                                  "kempe verify out/plagiograph/design.json --text");
  auto arguments = std::make_shared<VerifyArguments>();
  command->add_option("DESIGN", arguments->file, "A design.json")->required();
  command->add_flag("--text", arguments->in_words, "Print text instead of JSON");
  command->callback([&session, arguments] {
    session.chosen = [&session, arguments] { return run(*arguments, session.json); };
  });
}

}  // namespace kempe::app
