#include "reports/linkages/generator_answers.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/linkages/function_equations.hpp"
#include "reports/pictures/error_plot.hpp"
#include "specs/text/expression.hpp"

namespace kempe {
namespace {

FunctionMethod method_named(const std::string& method) {
  for (const FunctionMethod one : {FunctionMethod::least_squares, FunctionMethod::minimax})
    if (method == name(one)) return one;
  return FunctionMethod::precision_points;
}

/// Of the error: what its figures may be off by without a word; they are printed with four digits.
constexpr double negligible_share = 1e-4;

nlohmann::ordered_json answer_json(const InversorAnswer& answer) {
  nlohmann::ordered_json object{{"kind", std::string(name(answer.kind))}};
  if (!answer.design) {
    object["why_not"] = answer.why_not;
    return object;
  }
  const InversorDesign& design = *answer.design;
  object["size_mm"] = design.size;
  for (const InversorLength& length : design.lengths)
    object["lengths"].push_back({{"name", length.name},
                                 {"count", length.count},
                                 {"mm", length.value},
                                 {"sensitivity_mm_per_mm", length.sensitivity}});
  if (design.point_share > 0) object["point_share"] = design.point_share;
  object["travel_object_mm"] = design.travel_object;
  object["travel_image_mm"] = design.travel_image;
  object["transmission_min_deg"] = degrees(design.transmission_min);
  return object;
}

}  // namespace

tl::expected<FunctionTask, InputError> function_task(const FunctionSpec& spec, const std::string& file) {
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

std::string wanted_text(const FunctionSpec& spec) {
  return spec.expression.empty() ? "the table" : "y = " + spec.expression;
}

std::string why_none(const FunctionSpec& spec, const NoFunctionDesign& none) {
  if (none.allowed.empty()) return none.sentence;
  const std::string key = spec.expression.empty() ? "function.table" : "function.expression";
  return InputError{"", 0, key, none.sentence, none.allowed}.message();
}

std::string reservation(const FunctionDesign& design) {
  std::vector<std::string> words;
  if (!design.complete)
    words.emplace_back("the search was stopped before its end: this is the best four-bar it had found");
  if (design.optimum && !design.optimum->proven)
    words.emplace_back(
        "the best found, but not proven to be a local minimum: a linkage near it may have a smaller largest "
        "error");
  if (design.unseen > negligible_share * design.error_rms)
    words.push_back(
        fmt::format("the function bends in more places than are looked at: its errors may be {:.2g} degrees "
                    "off the figures told; those of a smoother function are not",
                    degrees(design.unseen)));
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string function_json(const FunctionTask& task, const FunctionDesign& design, bool with_equations) {
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
  if (!design.complete) object["complete"] = false;
  for (const StructuralErrorSample& at : design.curve)
    object["structural_error"].push_back({{"x", at.x},
                                          {"y", at.y_wanted},
                                          {"y_generated", at.y_generated},
                                          {"input_deg", degrees(at.input_angle)},
                                          {"output_deg", degrees(at.output_angle)},
                                          {"error_deg", degrees(at.error)}});
  if (const std::string words = reservation(design); !words.empty()) object["reservation"] = words;
  if (with_equations) object["equations"] = function_equations_json(task, design);
  return object.dump(1) + "\n";
}

std::string function_plot(const FunctionDesign& design, const std::string& wanted) {
  ErrorPlot plot{wanted, "x", "structural error, degrees", {}, design.precision_points};
  for (const StructuralErrorSample& at : design.curve) plot.curve.emplace_back(at.x, degrees(at.error));
  return error_plot_svg(plot);
}

InversorTask inversor_task(const InversorSpec& spec) {
  return {
      spec.focal_length, spec.magnification_lower, spec.magnification_upper, spec.transmission, spec.shortest,
      spec.longest};
}

std::string inversor_json(const InversorTask& task, const std::vector<InversorAnswer>& answers) {
  const auto best = smallest(answers);
  nlohmann::ordered_json object{{"focal_length_mm", task.focal_length},
                                {"magnification", {task.magnification_lower, task.magnification_upper}}};
  object["best"] =
      best ? nlohmann::ordered_json(std::string(name(best->kind))) : nlohmann::ordered_json(nullptr);
  for (const InversorAnswer& answer : answers) object["inversors"].push_back(answer_json(answer));
  return object.dump(1) + "\n";
}

std::string no_inversor_sentence(const std::vector<InversorAnswer>& answers) {
  std::string why = "no design found (not proven: lengths are searched)";
  for (const InversorAnswer& answer : answers)
    why += "\n  " + std::string(name(answer.kind)) + ": " + answer.why_not;
  return why;
}

}  // namespace kempe
