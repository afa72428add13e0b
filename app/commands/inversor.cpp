// kempe inversor: the three inversors for a lens, the best by size.

#include "synthesis/functions/inversor.hpp"

#include <memory>
#include <nlohmann/json.hpp>

#include "app/all_commands.hpp"
#include "specs/generator_spec.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

nlohmann::ordered_json json_of(const InversorAnswer& answer) {
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

int run(const std::string& file) {
  const auto text = read_text_file(file);
  if (!text) return fail(text.error());
  const auto spec = read_inversor_spec(*text, file);
  if (!spec) return fail(spec.error());
  const InversorTask task{spec->focal_length,
                          spec->magnification_lower,
                          spec->magnification_upper,
                          spec->transmission,
                          spec->shortest,
                          spec->longest};
  const auto answers = design_inversors(task);
  const auto best = smallest(answers);
  nlohmann::ordered_json object{{"focal_length_mm", task.focal_length},
                                {"magnification", {task.magnification_lower, task.magnification_upper}}};
  object["best"] =
      best ? nlohmann::ordered_json(std::string(name(best->kind))) : nlohmann::ordered_json(nullptr);
  for (const InversorAnswer& answer : answers) object["inversors"].push_back(json_of(answer));
  if (best) {
    print(object.dump(1) + "\n");
    return done;
  }
  std::string why = "no design found";
  for (const InversorAnswer& answer : answers)
    why += "\n  " + std::string(name(answer.kind)) + ": " + answer.why_not;
  return fail(no_design, why);
}

}  // namespace

void add_inversor_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "inversor", "Design an inversor for a lens",
                                  "kempe inversor specs/examples/generators/enlarger.toml");
  auto file = std::make_shared<std::string>();
  command->add_option("SPEC", *file, "Lens and range of magnification (TOML; see docs/inversor.md)")
      ->required();
  command->callback([&session, file] { session.chosen = [file] { return run(*file); }; });
}

}  // namespace kempe::app
