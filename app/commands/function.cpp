// kempe function: a function-generating four-bar, as JSON and on request with its error plotted.

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/all_commands.hpp"
#include "app/output_check.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/pictures/error_plot.hpp"
#include "specs/generator_spec.hpp"
#include "specs/text/expression.hpp"
#include "specs/text/text_file.hpp"
#include "synthesis/functions/function_generator.hpp"

namespace kempe::app {
namespace {

struct FunctionArguments {
  std::string spec_file, plot_file;
};

FunctionMethod method_named(const std::string& method) {
  for (const FunctionMethod one : {FunctionMethod::least_squares, FunctionMethod::minimax})
    if (method == name(one)) return one;
  return FunctionMethod::precision_points;
}

tl::expected<FunctionTask, InputError> task_of(const FunctionSpec& spec, const std::string& file) {
  FunctionTask task;
  if (spec.expression.empty()) {
    task.wanted = interpolated(spec.table);
  } else {
    const auto compiled = compile_expression(spec.expression);
    if (!compiled)
      return tl::unexpected(InputError{file, 0, "function.expression", compiled.error(),
                                       "an expression of x such as log10(x)"});
    task.wanted = *compiled;
  }
  task.x_lower = spec.x_lower;
  task.x_upper = spec.x_upper;
  task.input_range = spec.input_range;
  task.output_range = spec.output_range;
  task.input_start = spec.input_start;
  task.output_start = spec.output_start;
  task.points = spec.points;
  task.method = method_named(spec.method);
  task.ground = spec.ground;
  task.transmission = spec.transmission;
  task.longest_ratio = spec.longest_ratio;
  return task;
}

nlohmann::ordered_json json_of(const FunctionTask& task, const FunctionDesign& design) {
  const FourBar& bar = design.linkage;
  nlohmann::ordered_json object{
      {"method", std::string(name(task.method))},
      {"lengths_mm",
       {{"ground", bar.ground}, {"input", bar.input}, {"coupler", bar.coupler}, {"output", bar.output}}},
      {"branch", bar.branch == FourBarBranch::first ? 1 : 2},
      {"motion", std::string(name(design.motion))},
      {"input", {{"start_deg", degrees(design.input_start)}, {"range_deg", degrees(task.input_range)}}},
      {"output",
       {{"start_deg", degrees(design.output_start)},
        {"range_deg", degrees(task.output_range)},
        {"y_at_start", design.y_lower},
        {"y_at_end", design.y_upper}}},
      {"precision_points", design.precision_points},
      {"structural_error_max_deg", degrees(design.error_largest)},
      {"structural_error_rms_deg", degrees(design.error_rms)},
      {"transmission_min_deg", degrees(design.transmission_min)},
      {"rejected",
       {{"branch", design.rejected_branch},
        {"order", design.rejected_order},
        {"other", design.rejected_other}}}};
  if (design.optimum)
    object["minimax"] = {{"equal_ripples", design.optimum->ripples},
                         {"unknowns", design.optimum->unknowns},
                         {"limits_at_work", design.optimum->limits},
                         {"local_minimum_proven", design.optimum->proven}};
  for (const StructuralErrorSample& at : design.curve)
    object["structural_error"].push_back({{"x", at.x},
                                          {"y", at.y_wanted},
                                          {"y_generated", at.y_generated},
                                          {"input_deg", degrees(at.input_angle)},
                                          {"output_deg", degrees(at.output_angle)},
                                          {"error_deg", degrees(at.error)}});
  return object;
}

/// Nothing where the answer says all that is to be said.
std::string reservation(const FunctionDesign& design) {
  if (!design.optimum || design.optimum->proven) return "";
  return "the best found, but not proven to be a local minimum: a linkage near it may have a smaller largest "
         "error";
}

std::string plot_of(const FunctionDesign& design, const std::string& title) {
  ErrorPlot plot{title, "x", "structural error, degrees", {}, design.precision_points};
  for (const StructuralErrorSample& at : design.curve) plot.curve.emplace_back(at.x, degrees(at.error));
  return error_plot_svg(plot);
}

int run(const FunctionArguments& arguments) {
  if (const auto clash = output_clash({arguments.spec_file}, {arguments.plot_file})) return fail(*clash);
  const auto text = read_text_file(arguments.spec_file);
  if (!text) return fail(text.error());
  const auto spec = read_function_spec(*text, arguments.spec_file);
  if (!spec) return fail(spec.error());
  const auto task = task_of(*spec, arguments.spec_file);
  if (!task) return fail(task.error());
  const auto design = generate_function(*task);
  if (!design) return fail(no_design, "no design found: " + design.error().sentence);
  if (!arguments.plot_file.empty()) {
    const std::string wanted = spec->expression.empty() ? "the table" : "y = " + spec->expression;
    const auto written = write_whole(arguments.plot_file, plot_of(*design, wanted));
    if (!written) return fail(cannot_write, written.error());
  }
  auto object = json_of(*task, *design);
  if (const std::string words = reservation(*design); !words.empty()) {
    object["reservation"] = words;
    fmt::print(stderr, "kempe: {}\n", words);
  }
  print(object.dump(1) + "\n");
  return done;
}

}  // namespace

void add_function_command(CLI::App& program, Session& session) {
  CLI::App* command =
      add_command(program, session, "function", "Design a function-generating four-bar linkage",
                  "kempe function specs/examples/generators/logarithm.toml --plot error.svg");
  auto arguments = std::make_shared<FunctionArguments>();
  command->add_option("SPEC", arguments->spec_file, "What is wanted (TOML; see docs/function-generator.md)")
      ->required();
  command->add_option("--plot", arguments->plot_file, "Write the structural error's curve as SVG");
  command->callback([&session, arguments] { session.chosen = [arguments] { return run(*arguments); }; });
}

}  // namespace kempe::app
