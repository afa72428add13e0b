// kempe path: four-bars whose coupler point follows given points, or whose coupler takes given poses.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "app/all_commands.hpp"
#include "app/command.hpp"
#include "app/linkage_run.hpp"
#include "app/output_check.hpp"
#include "app/words.hpp"
#include "geometry/fixed_text.hpp"
#include "reports/linkages/generated.hpp"
#include "reports/linkages/path_answers.hpp"
#include "specs/generator_spec.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe::app {
namespace {

struct PathArguments {
  std::string spec_file, linkage_file;
  std::vector<std::string> animations;
  int answer = 1, cognate = 0;
  double copy_scale = 1, copy_rotation_deg = 0;
  std::string copy_pole;
  bool copies = false;
  std::optional<CopyTask> copy_task() const {
    if (!copies) return std::nullopt;
    return CopyTask{copy_scale, radians(copy_rotation_deg), copy_pole_named(copy_pole)};
  }
};

std::string columns_of(const Point& p) {
  return fmt::format("{:>10} {:>10}", fixed_text(p.x(), 4), fixed_text(p.y(), 4));
}

std::string links_text(const CouplerFourBar& bar) {
  return fmt::format(
      "  pivots    {}  and {}\n  crank {:.6g}, coupler {:.6g}, rocker {:.6g}; coupler point {:.6g} along, "
      "{:.6g} to the "
      "left; assembly mode {}\n",
      columns_of(bar.crank_pivot), columns_of(bar.rocker_pivot), bar.crank, bar.coupler, bar.rocker,
      bar.coupler_point.x(), bar.coupler_point.y(), bar.branch == FourBarBranch::first ? 1 : 2);
}

std::string cognates_text(const PathAnswer& answer) {
  std::string text;
  for (std::size_t c = 0; answer.cognates && c < 2; ++c)
    text += fmt::format("  cognate {}, driven by its {}\n", c + 1,
                        (*answer.cognates)[c].driver == CognateDriver::crank ? "crank" : "coupler") +
            links_text((*answer.cognates)[c].linkage);
  return text;
}

std::string copy_text(const CopiesOfAnswers& copies, std::size_t k) {
  return k < copies.copies.size() ? kempe::copy_text(copies.task, copies.copies[k]) : "";
}

std::string text_of(const PoseTask& task, const PoseSearch& search, const CopiesOfAnswers& copies) {
  std::string text = fmt::format("poses        {}, each taken exactly\n", task.poses.size());
  text += fmt::format(
      "searched     {} within the limits, {} of them; {} with poses on two branches or in "
      "another order, {} "
      "against a limit\n",
      counted(search.dyads.size(), "dyad"), counted(search.linkages, "four-bar"), search.defective,
      search.limited);
  if (task.poses.size() == 5) {
    text += "dyads        centre, circle point in the coupler's frame, length\n";
    for (const Dyad& dyad : burmester_dyads(task.poses))
      text += fmt::format("  {}  {}  {:10.4f}{}\n", columns_of(dyad.centre), columns_of(dyad.circle),
                          dyad.length, is_used(search, dyad) ? "" : "  against a limit: not used");
  }
  for (std::size_t k = 0; k < search.answers.size(); ++k) {
    const PoseAnswer& answer = search.answers[k];
    text += fmt::format(
        "\nanswer {}: {}, transmission {:.3f} degrees at least; off by {:.2g} mm and {:.2g} degrees at "
        "most\n",
        k + 1, name(answer.path.linkage.links().motion()), degrees(answer.path.transmission_min),
        answer.path.error_max, degrees(answer.error_angle));
    text += links_text(answer.path.linkage) + cognates_text(answer.path) + copy_text(copies, k);
  }
  text += fmt::format("\nanswer 1 at each pose\n{:>10} {:>10} {:>10} {:>10}\n", "crank deg", "x", "y",
                      "turned deg");
  const PoseAnswer& best = search.answers.front();
  for (std::size_t i = 0; i < task.poses.size(); ++i)
    text += fmt::format("{:10.3f} {} {:>10}\n", degrees(best.path.crank_angles[i]),
                        columns_of(best.path.reached[i]), fixed_text(degrees(best.angles[i]), 4));
  return text;
}

/// Which limits hold an answer back; empty where it meets its points or stands at no limit.
std::string limits_text(const PathTask& task, const PathAnswer& answer) {
  if (meets_points(task, answer)) return "";
  std::string text;
  for (const ActiveLimit& limit : answer.active)
    text += (text.empty() ? "  stands at " : ", ") + limit.key +
            (limit.what.empty() ? "" : " (" + limit.what + ")");
  return text.empty() ? text : text + ": another limit there may allow a smaller error\n";
}

std::string text_of(const PathTask& task, const PathSearch& search, const CopiesOfAnswers& copies) {
  std::string text =
      fmt::format("path         {} points, {}; {}\n", task.points.size(),
                  task.turns.empty() ? "timing free" : "with timing",
                  task.aim == PathAim::mean_square ? "least mean square distance" : "least largest distance");
  text += fmt::format(
      "searched     {} four-bars, {} refined with {} evaluations of the path\nbound        none: {}\n",
      search.effort.starts, search.effort.refined, search.effort.evaluations, no_path_bound);
  for (std::size_t k = 0; k < search.answers.size(); ++k) {
    const PathAnswer& answer = search.answers[k];
    text += fmt::format(
        "\nanswer {}: {}, error {:.4g} mm RMS, {:.4g} mm at most, transmission {:.3f} degrees at least\n",
        k + 1, name(answer.linkage.links().motion()), answer.error_rms, answer.error_max,
        degrees(answer.transmission_min));
    text += links_text(answer.linkage) + limits_text(task, answer);
    text += cognates_text(answer) + copy_text(copies, k);
  }
  text += fmt::format("\nanswer 1 at each point\n{:>10} {:>10} {:>10} {:>10} {:>10} {:>11}\n", "crank deg",
                      "wanted x", "wanted y", "reached x", "reached y", "distance");
  const PathAnswer& best = search.answers.front();
  for (std::size_t i = 0; i < task.points.size(); ++i)
    text +=
        fmt::format("{:10.3f} {} {} {:11.3g}\n", degrees(best.crank_angles[i]), columns_of(task.points[i]),
                    columns_of(best.reached[i]), (best.reached[i] - task.points[i]).norm());
  return text;
}

/// Writes the linkage moving, with the places that were asked for.
int animate(const Session& session, const PathArguments& arguments, const std::string& linkage,
            const std::vector<PlaceAskedFor>& wanted) {
  if (arguments.animations.empty()) return done;
  auto file = parse_linkage_file(linkage, arguments.spec_file);
  if (!file) return fail(session, file.error());
  const auto loaded = loaded_linkage(std::move(*file));
  if (!loaded) return fail(session, loaded.error());
  const auto assembly_modes = assemble_linkage(session, *loaded, 1);
  if (!assembly_modes) return assembly_modes.error();
  const auto run =
      drive_linkage(session, *loaded, assembly_modes->front(), animated_steps(loaded->file.steps));
  if (!run) return run.error();
  LinkageScene scene = linkage_scene(loaded->file, loaded->model, *run, loaded->file.steps);
  add_wanted_places(loaded->file, wanted, coupler_point_name, scene);
  return write_animations(session, scene, arguments.animations);
}

/// The linkage file asked for, or the code of why there is none.
tl::expected<std::string, int> linkage_text(const Session& session, const PathArguments& arguments,
                                            const std::vector<PathAnswer>& answers,
                                            const CopiesOfAnswers& copies) {
  const PathAnswer& answer = answers[static_cast<std::size_t>(arguments.answer - 1)];
  if (arguments.copies) {
    const auto& copy = copies.copies[static_cast<std::size_t>(arguments.answer - 1)];
    if (!copy)
      return tl::unexpected(fail_unproven(
          session, "no copy of answer " + std::to_string(arguments.answer) + ": " + copy.error()));
    return copy_linkage(answer, copies.task, *copy);
  }
  if (arguments.cognate == 0) return path_linkage(answer);
  if (!answer.cognates)
    return tl::unexpected(
        fail(session, {"", 0, "--cognate", fmt::format("{}", arguments.cognate),
                       "none: the coupler point lies on a joint, so a cognate has a link without length"}));
  return path_linkage(answer, static_cast<std::size_t>(arguments.cognate - 1));
}

/// Writes linkage file and animations, as far as they are asked for; `wanted_of` has the wanted places of an answer by its number.
template <class WantedOf>
int write_answer(const Session& session, const PathArguments& arguments,
                 const std::vector<PathAnswer>& answers, const CopiesOfAnswers& copies,
                 const WantedOf& wanted_of) {
  if (arguments.linkage_file.empty() && arguments.animations.empty()) return done;
  if (arguments.answer > std::ssize(answers))
    return fail(session, {"", 0, "--answer", fmt::format("{}", arguments.answer),
                          fmt::format("1 to {}, the answers found", answers.size())});
  const auto text = linkage_text(session, arguments, answers, copies);
  if (!text) return text.error();
  if (!arguments.linkage_file.empty())
    if (const int code = write_output(session, arguments.linkage_file, *text); code != done) return code;
  std::vector<PlaceAskedFor> wanted = wanted_of(static_cast<std::size_t>(arguments.answer - 1));
  return animate(session, arguments, *text,
                 arguments.cognate == 0 ? std::move(wanted) : of_a_cognate(std::move(wanted)));
}

int run(const Session& session, const PathArguments& arguments) {
  if (arguments.linkage_file.empty() && arguments.animations.empty() &&
      (arguments.answer > 1 || arguments.cognate > 0))
    return fail(session, {"", 0, arguments.answer > 1 ? "--answer" : "--cognate", "nothing to write it to",
                          "beside -o or --animate"});
  if (const auto wrong = wrong_animation("--animate", arguments.animations)) return fail(session, *wrong);
  std::vector<std::filesystem::path> outputs{arguments.linkage_file};
  outputs.insert(outputs.end(), arguments.animations.begin(), arguments.animations.end());
  if (const auto clash = output_clash({arguments.spec_file}, outputs)) return fail(session, *clash);
  const auto text = read_text_file(arguments.spec_file);
  if (!text) return fail(session, text.error());
  const auto spec = read_path_spec(*text, arguments.spec_file);
  if (!spec) return fail(session, spec.error());
  const auto finish = [&](const std::vector<PathAnswer>& answers, const auto& wanted_of, const auto& json,
                          const auto& words) {
    const CopiesOfAnswers copies = copies_of(answers, arguments.copy_task(), arguments.cognate);
    if (const int code = write_answer(session, arguments, answers, copies, wanted_of); code != done)
      return code;
    print(session.json ? json(copies) : words(copies));
    if (!session.json && !arguments.linkage_file.empty())
      print(fmt::format("linkage file {}: for kempe solve, mobility and centres\n",
                        printable(arguments.linkage_file)));
    return static_cast<int>(done);
  };
  if (!spec->poses.empty()) {
    const PoseTask task = pose_task(*spec);
    const auto search = guide_poses(task);
    if (!search) return fail_unproven(session, search.error());
    std::vector<PathAnswer> answers;
    for (const PoseAnswer& answer : search->answers) answers.push_back(answer.path);
    return finish(
        answers, [&](std::size_t k) { return wanted_places(task, search->answers[k]); },
        [&](const auto& copies) { return path_json(task, *search, copies); },
        [&](const auto& copies) { return text_of(task, *search, copies); });
  }
  const PathTask task = path_task(*spec);
  const auto search = generate_path(task);
  if (!search) return fail_unproven(session, search.error());
  return finish(
      search->answers, [&](std::size_t k) { return wanted_places(task, search->answers[k]); },
      [&](const auto& copies) { return path_json(*search, copies); },
      [&](const auto& copies) { return text_of(task, *search, copies); });
}

}  // namespace

void add_path_command(CLI::App& program, Session& session) {
  CLI::App* command = add_command(program, session, "path",
                                  "Design four-bars whose coupler follows given points or takes given poses",
                                  "kempe path specs/examples/generators/straight-line.toml -o line.toml");
  auto arguments = std::make_shared<PathArguments>();
  command->add_option("SPEC", arguments->spec_file, "Points or poses, and limits (TOML; see docs/path.md)")
      ->required();
  command->add_option("-o,--linkage", arguments->linkage_file,
                      "Write an answer as a linkage file, for solve, mobility and centres");
  command->add_option("--animate", arguments->animations,
                      "The answer moving, with the wanted points or poses and its deviations: FILE.html or "
                      "FILE.svg; may be given twice");
  command->add_option("--answer", arguments->answer, "Write this answer instead of the best")
      ->check(CLI::Range(1, 6));
  command->add_option("--cognate", arguments->cognate, "Write this cognate of the answer instead of itself")
      ->check(CLI::Range(1, 2));
  auto* scale = command
                    ->add_option("--copy-scale", arguments->copy_scale,
                                 "Add the plagiograph that draws the coupler curve so many times as large")
                    ->check(number_between(0.001, 1000));
  auto* rotation = command
                       ->add_option("--copy-rotation", arguments->copy_rotation_deg,
                                    "Add the plagiograph that draws it turned by so many degrees")
                       ->check(number_between(-360, 360));
  auto* pole =
      command
          ->add_option(
              "--copy-pole", arguments->copy_pole,
              "The copy's fixed pivot: crank or rocker; left out: the one farther from change points")
          ->check(CLI::IsMember({"crank", "rocker"}));
  command->callback([&session, arguments, scale, rotation, pole] {
    arguments->copies = scale->count() + rotation->count() + pole->count() > 0;
    session.chosen = [&session, arguments] { return run(session, *arguments); };
  });
}

}  // namespace kempe::app
