// kempe function: a function-generating four-bar, on request with its error plotted.

#include <fmt/format.h>

#include <memory>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/linkage_run.hpp"
#include "app/output_check.hpp"
#include "app/stopping.hpp"
#include "app/words.hpp"
#include "geometry/fixed_text.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/linkages/function_equations.hpp"
#include "reports/linkages/generated.hpp"
#include "reports/linkages/generator_answers.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

struct FunctionArguments {
  std::string spec_file, plot_file, linkage_file;
  bool with_equations = false;
  double time_limit = Deadline::unlimited;
};

std::string_view in_words(FunctionMethod method) {
  switch (method) {
    case FunctionMethod::precision_points: return "precision points";
    case FunctionMethod::least_squares: return "least squares";
    case FunctionMethod::minimax: return "minimax: the smallest largest error";
  }
  return {};
}

std::string lengths_text(const FourBar& bar) {
  std::string text;
  const std::pair<const char*, double> lengths[] = {
      {"ground", bar.ground}, {"input", bar.input}, {"coupler", bar.coupler}, {"output", bar.output}};
  const int decimals = decimals_of_size(bar.ground + bar.input + bar.coupler + bar.output);
  for (const auto& [label, length] : lengths)
    text += fmt::format("  {:<8} {:10.{}f} mm\n", label, length, decimals);
  return text;
}

/// How sure it is that no linkage near it is better; empty where nothing is known.
std::string proof_line(const FunctionDesign& design) {
  if (!design.optimum) return "";
  const MinimaxOptimum& optimum = *design.optimum;
  std::string text = fmt::format("proof        {}: {} equal ripples, {} unknowns",
                                 optimum.proven ? "no linkage near it is better" : "none", optimum.ripples,
                                 optimum.unknowns);
  if (!optimum.limits.empty()) text += fmt::format("; held by {}", fmt::join(optimum.limits, ", "));
  return text + "\n";
}

std::string text_of(const FunctionSpec& spec, const FunctionTask& task, const FunctionDesign& design) {
  std::string text = fmt::format("function     {}, x from {:.6g} to {:.6g}\n", wanted_text(spec),
                                 task.x_lower, task.x_upper);
  text += fmt::format("method       {}\n", in_words(task.method));
  text += fmt::format("linkage      {}, assembled on branch {} of 2\n", name(design.motion),
                      design.linkage.branch == FourBarBranch::first ? 1 : 2);
  text += lengths_text(design.linkage);
  text += fmt::format("input crank  from {} degrees over {:.6g} degrees\n",
                      fixed_text(degrees(design.input_start), 3), degrees(task.input_range));
  text += fmt::format("output crank from {} degrees over {:.6g} degrees: y from {:.6g} to {:.6g}\n",
                      fixed_text(degrees(design.output_start), 3), degrees(task.output_range), design.y_lower,
                      design.y_upper);
  text += fmt::format("error        {:.4g} degrees of the output crank at most, {:.4g} degrees RMS\n",
                      degrees(design.error_largest), degrees(design.error_rms));
  text += "exact at     x =";
  for (const double x : design.precision_points) text += fmt::format(" {:.6g}", x);
  text += fmt::format("\ntransmission {:.3f} degrees at least\n", degrees(design.transmission_min));
  return text + proof_line(design);
}

int run(const Session& session, const FunctionArguments& arguments) {
  const Deadline deadline(arguments.time_limit);
  if (const auto clash = output_clash({arguments.spec_file}, {arguments.plot_file, arguments.linkage_file}))
    return fail(session, *clash);
  const auto text = read_text_file(arguments.spec_file);
  if (!text) return fail(session, text.error());
  const auto spec = read_function_spec(*text, arguments.spec_file);
  if (!spec) return fail(session, spec.error());
  auto task = function_task(*spec, arguments.spec_file);
  if (!task) return fail(session, task.error());
  const Stopping stopping(deadline);
  task->stop = stopping.flag();
  const auto design = generate_function(*task);
  if (!design && design.error().stopped)
    return tell_stopped(session, stopping, design.error().sentence + "; nothing is written");
  if (!design && design.error().proven)
    return fail(session, no_design, "no design exists: " + why_none(*spec, design.error()));
  if (!design) return fail_unproven(session, "no design found: " + why_none(*spec, design.error()));
  if (!arguments.plot_file.empty()) {
    const auto written = write_whole(arguments.plot_file, function_plot(*design, wanted_text(*spec)));
    if (!written) return fail(session, cannot_write, written.error());
  }
  if (!arguments.linkage_file.empty()) {
    const std::string linkage = function_linkage(*task, *design, wanted_text(*spec));
    if (const int code = write_output(session, arguments.linkage_file, linkage); code != done) return code;
  }
  if (const std::string words = reservation(*design); !words.empty()) say(words);
  print(session.json ? function_json(*task, *design, arguments.with_equations)
                     : text_of(*spec, *task, *design));
  if (!session.json && arguments.with_equations) print(function_equations_text(*task, *design));
  if (!session.json && !arguments.linkage_file.empty())
    print(fmt::format("linkage file {}: for kempe solve, mobility and centres\n",
                      printable(arguments.linkage_file)));
  return stopping.interrupted() ? interrupted : done;
}

}  // namespace

void add_function_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "function", "Design a function-generating four-bar linkage",
                  "kempe function specs/examples/generators/logarithm.toml --plot error.svg");
  auto arguments = std::make_shared<FunctionArguments>();
  command->add_option("SPEC", arguments->spec_file, "What is wanted (TOML; see docs/function-generator.md)")
      ->required();
  command->add_flag(
      "--equations", arguments->with_equations,
      "Write out Chebyshev's spacing, Freudenstein's equations and the ripples with their numbers");
  command->add_option("--plot", arguments->plot_file, "Write the structural error's curve as SVG");
  command->add_option("--linkage", arguments->linkage_file,
                      "Write the four-bar as a linkage file, for solve, mobility and centres");
  add_time_limit(*command, arguments->time_limit,
                 "Seconds; then the best four-bar so far, marked as such, or exit code 6 if there is none");
  command->callback(
      [&session, arguments] { session.chosen = [&session, arguments] { return run(session, *arguments); }; });
}

}  // namespace kempe::app
