// kempe/generators.hpp.

#include "kempe/generators.hpp"

#include <algorithm>

#include "reports/linkages/generated.hpp"
#include "reports/linkages/generator_answers.hpp"
#include "reports/linkages/path_answers.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

/// Each answer's linkage file, followed by those of its cognates.
std::vector<GeneratedLinkage> linkages_of(const std::vector<PathAnswer>& answers) {
  std::vector<GeneratedLinkage> linkages;
  for (const PathAnswer& answer : answers) {
    const std::string kind = "answer_" + std::to_string(&answer - answers.data() + 1);
    linkages.push_back({kind, path_linkage(answer)});
    if (!answer.cognates) continue;
    for (std::size_t cognate = 0; cognate < 2; ++cognate)
      linkages.push_back({kind + "_cognate_" + std::to_string(cognate + 1), path_linkage(answer, cognate)});
  }
  return linkages;
}

}  // namespace

std::variant<Generated, InputError, NothingGenerated> generate_function_text(std::string_view text,
                                                                             const std::string& name) {
  const auto spec = read_function_spec(text, name);
  if (!spec) return spec.error();
  const auto task = function_task(*spec, name);
  if (!task) return task.error();
  const auto design = generate_function(*task);
  if (!design) return NothingGenerated{design.error().sentence, design.error().proven};
  const std::string wanted = wanted_text(*spec);
  return Generated{function_json(*task, *design, true),
                   {{"four_bar", function_linkage(*task, *design, wanted)}},
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
    found.linkages.push_back({std::string(kempe::name(design.kind)), inversor_linkage(task, design)});
  return found;
}

std::variant<Generated, InputError, NothingGenerated> generate_path_text(std::string_view text,
                                                                         const std::string& name) {
  const auto spec = read_path_spec(text, name);
  if (!spec) return spec.error();
  if (spec->poses.empty()) {
    const auto search = generate_path(path_task(*spec));
    if (!search) return NothingGenerated{search.error(), false};
    return Generated{path_json(*search, {}), linkages_of(search->answers), {}};
  }
  const PoseTask task = pose_task(*spec);
  const auto search = guide_poses(task);
  if (!search) return NothingGenerated{search.error(), false};
  std::vector<PathAnswer> answers;
  for (const PoseAnswer& answer : search->answers) answers.push_back(answer.path);
  return Generated{path_json(task, *search, {}), linkages_of(answers), {}};
}

std::variant<Generated, InputError, NothingGenerated> generate_path(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return generate_path_text(*text, file.string());
}

std::variant<Generated, InputError, NothingGenerated> generate_function(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return generate_function_text(*text, file.string());
}

std::variant<Generated, InputError, NothingGenerated> generate_inversor(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return generate_inversor_text(*text, file.string());
}

}  // namespace kempe
