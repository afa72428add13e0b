// kempe/linkage.hpp.

#include "kempe/linkage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/planar/rates.hpp"
#include "reports/linkages/animation.hpp"
#include "reports/linkages/centres_page.hpp"
#include "reports/linkages/centres_picture.hpp"
#include "reports/linkages/forces.hpp"
#include "reports/linkages/generated.hpp"
#include "reports/linkages/json.hpp"
#include "reports/linkages/loop_equations.hpp"
#include "reports/linkages/running.hpp"
#include "reports/linkages/scene_wanted.hpp"
#include "reports/linkages/solve_table.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

/// What takes the place of an answer.
template <typename Answer>
LinkageAnswer<Answer> absent(const NoRun& none) {
  if (none.why == NoRun::Why::bad_input) return none.fault;
  if (none.why == NoRun::Why::interrupted) return NoMotion{"stopped", true};
  return NoMotion{none.sentence, none.why == NoRun::Why::gave_up};
}

/// The linkage with so many steps, velocities and accelerations, and all forces.
tl::expected<LoadedLinkage, InputError> told_whole(const LoadedLinkage& loaded, std::optional<int> steps) {
  LoadedLinkage whole = loaded;
  whole.file.output.velocities = whole.file.output.accelerations = whole.file.output.reactions = true;
  if (!steps) return whole;
  if (*steps < 1 || *steps > loaded.file.most_steps())
    return tl::unexpected(InputError{"", 0, "steps", fmt::format("{}", *steps),
                                     fmt::format("1 to {} with so many links", loaded.file.most_steps())});
  whole.file.steps = *steps;
  return whole;
}

tl::expected<PlanarPosition, NoRun> chosen_start(const LoadedLinkage& loaded, const AssemblyChoice& choice) {
  const auto known = assembled(loaded, choice.seed, choice.stop);
  if (!known) return tl::unexpected(known.error());
  if (choice.number >= 0 && static_cast<std::size_t>(choice.number) < known->size())
    return (*known)[static_cast<std::size_t>(choice.number)];
  return tl::unexpected(NoRun{NoRun::Why::bad_input,
                              {"", 0, "assembly", fmt::format("{}", choice.number),
                               fmt::format("0 to {}: so many are known", known->size() - 1)},
                              {}});
}

/// The moment at a step of the motion that starts where it is chosen.
tl::expected<RunFrame, NoRun> moment_at(const LoadedLinkage& loaded, double step,
                                        const AssemblyChoice& choice) {
  const auto start = chosen_start(loaded, choice);
  if (!start) return tl::unexpected(start.error());
  return frame_at_step(loaded, *start, step, "at", choice.stop);
}

/// False where the motion stopped.
bool has_rates(const RunFrame& frame) { return frame.rate.size() > 0; }

std::vector<MovedPoint> moved_points(const LinkageModel& model, const PlanarRun& run) {
  std::vector<MovedPoint> points;
  for (const ModelPoint& point : model.points) {
    MovedPoint& moved = points.emplace_back();
    moved.name = point.name;
    for (const RunFrame& frame : run.frames) {
      auto& velocity = moved.velocities.emplace_back();
      auto& acceleration = moved.accelerations.emplace_back();
      moved.places.push_back(place(frame.position, point.place));
      if (!has_rates(frame)) continue;
      velocity = velocity_of(frame.position, frame.rate, point.place);
      acceleration = acceleration_of(frame.position, frame.rate, frame.second, point.place);
    }
  }
  return points;
}

std::vector<MovedLink> moved_links(const LoadedLinkage& loaded, const PlanarRun& run) {
  std::vector<MovedLink> links;
  for (const FileLink& link : loaded.file.links) {
    const int body = loaded.model.body(link.name);
    MovedLink& moved = links.emplace_back();
    moved.name = link.name;
    for (const RunFrame& frame : run.frames) {
      auto& rate = moved.rates.emplace_back();
      auto& acceleration = moved.accelerations.emplace_back();
      moved.angles.push_back(frame.position[static_cast<std::size_t>(body)].angle);
      if (!has_rates(frame)) continue;
      rate = spin_of(frame.rate, body);
      acceleration = spin_of(frame.second, body);
    }
  }
  return links;
}

std::vector<MotionColumn> columns_of(const SolveTable& table) {
  std::vector<MotionColumn> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const bool is_force = table.kinds[i] == ColumnKind::force || table.kinds[i] == ColumnKind::moment;
    MotionColumn& column = columns.emplace_back(MotionColumn{table.columns[i], {}, is_force});
    for (const auto& row : table.rows) column.values.push_back(row[i]);
  }
  return columns;
}

/// The forces in joints and guides, whose two parts stand next to each other at the end of the table.
std::vector<JointReaction> reactions_of(const LoadedLinkage& loaded, const std::vector<MotionColumn>& table) {
  std::vector<JointReaction> reactions;
  const auto forces = force_columns(loaded.file, loaded.model);
  const std::size_t first = table.size() - forces.size();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (forces[i].part != ForceColumn::Part::x) continue;
    constexpr std::string_view suffix = "_x_N";
    JointReaction& reaction = reactions.emplace_back();
    reaction.name = forces[i].name.substr(0, forces[i].name.size() - suffix.size());
    const MotionColumn &x = table[first + i], &y = table[first + i + 1];
    for (std::size_t row = 0; row < x.values.size(); ++row) {
      auto& force = reaction.forces.emplace_back();
      if (x.values[row] && y.values[row]) force = Point(*x.values[row], *y.values[row]);
    }
  }
  return reactions;
}

DrivenMotion motion_of(const LoadedLinkage& loaded, const PlanarRun& run) {
  const int steps = loaded.file.steps;
  const SolveTable table = solve_table(loaded.file, loaded.model, run, steps);
  DrivenMotion motion;
  for (const RunFrame& frame : run.frames) {
    motion.steps.push_back(frame.share * steps);
    motion.times.push_back(frame.share * loaded.file.duration);
  }
  motion.points = moved_points(loaded.model, run);
  motion.links = moved_links(loaded, run);
  motion.table = columns_of(table);
  if (!loaded.model.loads.empty()) {
    motion.reactions = reactions_of(loaded, motion.table);
    motion.force_sentences = force_sentences(loaded.file, loaded.model, table);
    motion.undetermined = undetermined_reactions(loaded.file, loaded.model, table);
  }
  if (run.stop)
    motion.end = {std::string(name(run.stop->end)), run.frames.back().share * steps, run.stop->sentences,
                  stop_sentence(loaded, run, steps)};
  return motion;
}

/// What stands in a run from the chosen start; `steps_of` says in how many parts it is run.
template <typename Answer, typename Steps, typename Make>
LinkageAnswer<Answer> of_run(const LoadedLinkage& loaded, std::optional<int> steps,
                             const AssemblyChoice& choice, const Steps& steps_of, const Make& make) {
  const auto whole = told_whole(loaded, steps);
  if (!whole) return whole.error();
  const auto start = chosen_start(*whole, choice);
  if (!start) return absent<Answer>(start.error());
  const auto run = driven_run(*whole, *start, steps_of(whole->file.steps), choice.stop);
  if (!run) return absent<Answer>(run.error());
  return make(*whole, *run);
}

}  // namespace

Linkage::Linkage(std::shared_ptr<const LoadedLinkage> inside, std::string text)
    : inside_(std::move(inside)), text_(std::move(text)) {}

std::variant<Linkage, InputError> Linkage::parse(std::string_view text, const std::string& name) {
  auto file = parse_linkage_file(text, name);
  if (!file) return file.error();
  file->name = printable(file->name);  // a file without a name has its path's, which may be any bytes
  auto loaded = loaded_linkage(std::move(*file));
  if (!loaded) return loaded.error();
  return Linkage(std::make_shared<const LoadedLinkage>(std::move(*loaded)), std::string(text));
}

std::variant<Linkage, InputError> Linkage::read(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return parse(*text, file.string());
}

const std::string& Linkage::text() const { return text_; }
const std::string& Linkage::name() const { return inside_->file.name; }
const std::string& Linkage::unit() const { return inside_->file.unit.name; }
std::vector<std::string> Linkage::points() const { return inside_->file.point_names(); }
int Linkage::steps() const { return inside_->file.steps; }
const std::vector<std::string>& Linkage::notes() const { return inside_->file.notes; }

std::vector<std::string> Linkage::links() const {
  std::vector<std::string> names;
  for (const FileLink& link : inside_->file.links) names.push_back(link.name);
  return names;
}

LinkageAnswer<std::vector<std::vector<PlacedPoint>>> Linkage::assemblies(const AssemblyChoice& choice) const {
  using Answer = std::vector<std::vector<PlacedPoint>>;
  const auto known = assembled(*inside_, choice.seed, choice.stop);
  if (!known) return absent<Answer>(known.error());
  Answer answer;
  for (const PlanarPosition& position : *known) {
    auto& places = answer.emplace_back();
    for (const ModelPoint& point : inside_->model.points)
      places.push_back({point.name, place(position, point.place)});
  }
  return answer;
}

LinkageAnswer<DrivenMotion> Linkage::solve(std::optional<int> steps, const AssemblyChoice& choice) const {
  return of_run<DrivenMotion>(
      *inside_, steps, choice, [](int parts) { return parts; }, motion_of);
}

LinkageAnswer<std::string> Linkage::mobility(const AssemblyChoice& choice) const {
  const auto closed = closed_position(*inside_, choice.seed, choice.stop);
  if (!closed) return absent<std::string>(closed.error());
  const Mobility mobility = mobility_of(inside_->model.linkage, *closed, choice.seed);
  return mobility_json(inside_->file, inside_->model, mobility);
}

LinkageAnswer<std::string> Linkage::centres(double step, const AssemblyChoice& choice) const {
  const auto moment = moment_at(*inside_, step, choice);
  if (!moment) return absent<std::string>(moment.error());
  const LinkageModel& model = inside_->model;
  return centres_json(inside_->file, model, step, *moment, model.schedule.speeds_at(moment->share),
                      instant_centres(model.linkage, moment->position, moment->rate));
}

LinkageAnswer<std::string> Linkage::centres_drawing(double step, const AssemblyChoice& choice) const {
  const auto moment = moment_at(*inside_, step, choice);
  if (!moment) return absent<std::string>(moment.error());
  const auto found = instant_centres(inside_->model.linkage, moment->position, moment->rate);
  const LinkageScene scene =
      linkage_scene(inside_->file, inside_->model, PlanarRun{{*moment}, std::nullopt}, inside_->file.steps);
  return centres_svg(scene, found, inside_->file.unit.in_mm);
}

LinkageAnswer<std::string> Linkage::centres_page(double step, const AssemblyChoice& choice) const {
  const auto moment = moment_at(*inside_, step, choice);
  if (!moment) return absent<std::string>(moment.error());
  const LinkageScene scene =
      linkage_scene(inside_->file, inside_->model, PlanarRun{{*moment}, std::nullopt}, inside_->file.steps);
  return centres_html(inside_->file, inside_->model, scene, step,
                      instant_centres(inside_->model.linkage, moment->position, moment->rate));
}

LinkageAnswer<std::string> Linkage::equations(double step, const AssemblyChoice& choice) const {
  const auto moment = moment_at(*inside_, step, choice);
  if (!moment) return absent<std::string>(moment.error());
  return loop_equations_json(inside_->file, inside_->model, step, *moment);
}

LinkageAnswer<std::string> Linkage::animation(AnimationFile file, std::optional<int> steps,
                                              const AssemblyChoice& choice,
                                              const std::vector<PlaceAskedFor>& wanted) const {
  return of_run<std::string>(
      *inside_, steps, choice, animated_steps, [&](const LoadedLinkage& loaded, const PlanarRun& run) {
        LinkageScene scene = linkage_scene(loaded.file, loaded.model, run, loaded.file.steps);
        if (!wanted.empty()) add_wanted_places(loaded.file, wanted, coupler_point_name, scene);
        return file == AnimationFile::page ? animation_html(scene) : animation_svg(scene);
      });
}

std::variant<std::string, InputError> chains(int links, int freedoms) {
  if (links < 2 || links > 40) return InputError{"", 0, "links", fmt::format("{}", links), "2 to 40"};
  if (freedoms < 0 || freedoms > 40)
    return InputError{"", 0, "freedoms", fmt::format("{}", freedoms), "0 to 40"};
  return number_synthesis_json(links, freedoms, number_synthesis(links, freedoms));
}

}  // namespace kempe
