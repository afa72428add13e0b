// kempe/generators.hpp.

#include "kempe/generators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/deadline.hpp"
#include "reports/linkages/generated.hpp"
#include "reports/linkages/generator_answers.hpp"
#include "reports/linkages/path_answers.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

std::optional<InputError> fault_in(const PlagiographOptions& copy) {
  if (!(copy.scale >= 0.001 && copy.scale <= 1000))
    return InputError{"", 0, "copy.scale", fmt::format("{}", copy.scale), "0.001 to 1000"};
  if (!(std::abs(copy.rotation) <= radians(360)))
    return InputError{"", 0, "copy.rotation_deg", fmt::format("{:.12g}", degrees(copy.rotation)),
                      "-360 to 360"};
  if (!copy.pole.empty() && !copy_pole_named(copy.pole))
    return InputError{"", 0, "copy.pole", copy.pole, "crank or rocker"};
  if (copy.cognate < 0 || copy.cognate > 2)
    return InputError{"", 0, "copy.cognate", fmt::format("{}", copy.cognate), "0 to 2"};
  return std::nullopt;
}

/// The plagiographs asked for.
CopiesOfAnswers copies_of(const std::vector<PathAnswer>& answers,
                          const std::optional<PlagiographOptions>& copy) {
  if (!copy) return {};
  return copies_of(answers, CopyTask{copy->scale, copy->rotation, copy_pole_named(copy->pole)},
                   copy->cognate);
}

/// Each answer's linkage file, followed by those of its cognates and of its copy, which may stand on a cognate; `wanted` has what each answer
/// was asked for.
std::vector<GeneratedLinkage> linkages_of(const std::vector<PathAnswer>& answers,
                                          const std::vector<std::vector<PlaceAskedFor>>& wanted,
                                          const CopiesOfAnswers& copies, bool copies_of_cognates) {
  std::vector<GeneratedLinkage> linkages;
  for (std::size_t index = 0; index < answers.size(); ++index) {
    const PathAnswer& answer = answers[index];
    const std::string kind = "answer_" + std::to_string(index + 1);
    const std::vector<PlaceAskedFor> points = of_a_cognate(wanted[index]);
    linkages.push_back({kind, path_linkage(answer), wanted[index]});
    for (std::size_t cognate = 0; answer.cognates && cognate < 2; ++cognate)
      linkages.push_back(
          {kind + "_cognate_" + std::to_string(cognate + 1), path_linkage(answer, cognate), points});
    if (index < copies.copies.size() && copies.copies[index])
      linkages.push_back({kind + "_copy", copy_linkage(answer, copies.task, *copies.copies[index]),
                          copies_of_cognates ? points : wanted[index]});
  }
  return linkages;
}

}  // namespace

std::variant<Generated, InputError, NothingGenerated> generate_function_text(std::string_view text,
                                                                             const std::string& name,
                                                                             const Options& options) {
  const Deadline deadline(options.time_limit.value_or(Deadline::unlimited));
  const auto spec = read_function_spec(text, name);
  if (!spec) return spec.error();
  auto task = function_task(*spec, name);
  if (!task) return task.error();
  task->stop = deadline.flag(options.stop ? StopFlag(options.stop) : StopFlag());
  const auto design = generate_function(*task);
  if (!design && design.error().stopped)
    return NothingGenerated{"stopped " + design.error().sentence, false, true};
  if (!design) return NothingGenerated{why_none(*spec, design.error()), design.error().proven};
  const std::string wanted = wanted_text(*spec);
  return Generated{function_json(*task, *design, true),
                   {{"four_bar", function_linkage(*task, *design, wanted), {}}},
                   function_plot(*design, wanted)};
}

std::variant<Generated, InputError, NothingGenerated> generate_inversor_text(std::string_view text,
                                                                             const std::string& name) {
  const auto spec = read_inversor_spec(text, name);
  if (!spec) return spec.error();
  const InversorTask task = inversor_task(*spec);
  const auto answers = design_inversors(task);
  std::vector<InversorDesign> designs;
  for (const InversorAnswer& answer : answers)
    if (answer.design) designs.push_back(*answer.design);
  if (designs.empty()) return NothingGenerated{no_inversor_sentence(answers), false};
  std::stable_sort(designs.begin(), designs.end(),
                   [](const InversorDesign& a, const InversorDesign& b) { return a.size < b.size; });
  Generated found{inversor_json(task, answers), {}, {}};
  for (const InversorDesign& design : designs)
    found.linkages.push_back({std::string(kempe::name(design.kind)), inversor_linkage(task, design), {}});
  return found;
}

std::variant<Generated, InputError, NothingGenerated> generate_path_text(
    std::string_view text, const std::string& name, const std::optional<PlagiographOptions>& copy) {
  const auto spec = read_path_spec(text, name);
  if (!spec) return spec.error();
  if (copy)
    if (const auto fault = fault_in(*copy)) return *fault;
  const bool on_cognates = copy && copy->cognate != 0;
  if (spec->poses.empty()) {
    const PathTask task = path_task(*spec);
    const auto search = generate_path(task);
    if (!search) return NothingGenerated{search.error(), false};
    const CopiesOfAnswers copies = copies_of(search->answers, copy);
    std::vector<std::vector<PlaceAskedFor>> wanted;
    for (const PathAnswer& answer : search->answers) wanted.push_back(wanted_places(task, answer));
    return Generated{
        path_json(*search, copies), linkages_of(search->answers, wanted, copies, on_cognates), {}};
  }
  const PoseTask task = pose_task(*spec);
  const auto search = guide_poses(task);
  if (!search) return NothingGenerated{search.error(), false};
  std::vector<PathAnswer> answers;
  std::vector<std::vector<PlaceAskedFor>> wanted;
  for (const PoseAnswer& answer : search->answers) {
    answers.push_back(answer.path);
    wanted.push_back(wanted_places(task, answer));
  }
  const CopiesOfAnswers copies = copies_of(answers, copy);
  return Generated{path_json(task, *search, copies), linkages_of(answers, wanted, copies, on_cognates), {}};
}

std::variant<Generated, InputError, NothingGenerated> generate_path(
    const std::filesystem::path& file, const std::optional<PlagiographOptions>& copy) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return generate_path_text(*text, file.string(), copy);
}

std::variant<Generated, InputError, NothingGenerated> generate_function(const std::filesystem::path& file,
                                                                        const Options& options) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return generate_function_text(*text, file.string(), options);
}

std::variant<Generated, InputError, NothingGenerated> generate_inversor(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return generate_inversor_text(*text, file.string());
}

}  // namespace kempe
