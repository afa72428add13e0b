// kempe inversor: the three inversors for a lens, the best by size.

#include <fmt/format.h>

#include <memory>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/linkage_run.hpp"
#include "app/output_check.hpp"
#include "app/words.hpp"
#include "reports/linkages/generated.hpp"
#include "reports/linkages/generator_answers.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

struct InversorArguments {
  std::string spec_file, linkage_file, kind;
};

std::string_view spoken_name(InversorKind kind) {
  switch (kind) {
    case InversorKind::peaucellier: return "Peaucellier";
    case InversorKind::hart: return "Hart";
    case InversorKind::right_angle: return "right angle";
  }
  return {};
}

/// Three lines and more for each kind: its lengths, or why there is none.
std::string text_of(const InversorAnswer& answer) {
  if (!answer.design) return fmt::format("{:<12} none: {}\n", spoken_name(answer.kind), answer.why_not);
  const InversorDesign& design = *answer.design;
  std::string text =
      fmt::format("{:<12} size {:.{}f} mm, transmission {:.3f} degrees at least\n", spoken_name(answer.kind),
                  design.size, decimals_of_size(design.size), degrees(design.transmission_min));
  for (const InversorLength& length : design.lengths)
    text += fmt::format("             {} x {:<23} {:10.{}f} mm, wrong by 1 mm: image off by {:.3g} mm\n",
                        length.count, length.name, length.value, decimals_of_size(design.size),
                        length.sensitivity);
  if (design.point_share > 0)
    text += fmt::format("             its points at {:.6f} of each bar\n", design.point_share);
  return text;
}

std::string text_of(const InversorTask& task, const std::vector<InversorAnswer>& answers,
                    const InversorDesign& best) {
  std::string text = fmt::format("lens         focal length {:.6g} mm, magnification {:.6g} to {:.6g}\n",
                                 task.focal_length, task.magnification_lower, task.magnification_upper);
  const int decimals = decimals_of_size(best.size);
  text += fmt::format("smallest     {}: size {:.{}f} mm, the sum of all its lengths\n",
                      spoken_name(best.kind), best.size, decimals);
  text += fmt::format("travel       object {1:.{0}f} mm, image {2:.{0}f} mm\n", decimals, best.travel_object,
                      best.travel_image);
  for (const InversorAnswer& answer : answers) text += text_of(answer);
  return text;
}

/// The design whose linkage file is wanted, of the kind asked for or else the best; nothing with the reason where there is none.
tl::expected<InversorDesign, std::string> chosen_design(const std::string& kind,
                                                        const std::vector<InversorAnswer>& answers,
                                                        const InversorDesign& best) {
  if (kind.empty()) return best;
  for (const InversorAnswer& answer : answers) {
    if (name(answer.kind) != kind) continue;
    if (answer.design) return *answer.design;
    return tl::unexpected("no linkage file: " + kind + ": " + answer.why_not);
  }
  return best;
}

int run(const Session& session, const InversorArguments& arguments) {
  const std::string& file = arguments.spec_file;
  if (const auto clash = output_clash({file}, {arguments.linkage_file})) return fail(session, *clash);
  const auto text = read_text_file(file);
  if (!text) return fail(session, text.error());
  const auto spec = read_inversor_spec(*text, file);
  if (!spec) return fail(session, spec.error());
  const InversorTask task = inversor_task(*spec);
  const auto answers = design_inversors(task);
  const auto best = smallest(answers);
  if (best && !arguments.linkage_file.empty()) {
    const auto chosen = chosen_design(arguments.kind, answers, *best);
    if (!chosen) return fail_unproven(session, chosen.error());
    const int code = write_output(session, arguments.linkage_file, inversor_linkage(task, *chosen));
    if (code != done) return code;
  }
  if (best && !session.json) {
    print(text_of(task, answers, *best));
    if (!arguments.linkage_file.empty())
      print(fmt::format("linkage file {}: for kempe solve, mobility and centres\n",
                        printable(arguments.linkage_file)));
    return done;
  }
  if (best) {
    print(inversor_json(task, answers));
    return done;
  }
  return fail_unproven(session, no_inversor_sentence(answers));
}

}  // namespace

void add_inversor_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "inversor", "Design an inversor for a lens",
                  "kempe inversor specs/examples/generators/enlarger.toml --linkage inversor.toml");
  auto arguments = std::make_shared<InversorArguments>();
  command
      ->add_option("SPEC", arguments->spec_file,
                   "Lens and range of magnification (TOML; see docs/inversor.md)")
      ->required();
  auto* linkage =
      command->add_option("--linkage", arguments->linkage_file,
                          "Write the best one as a linkage file, for solve, mobility and centres");
  std::vector<std::string> kinds;
  for (const InversorKind kind : all_inversors) kinds.emplace_back(name(kind));
  command->add_option("--kind", arguments->kind, "Write this one instead of the best")
      ->check(CLI::IsMember(kinds))
      ->needs(linkage);
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
