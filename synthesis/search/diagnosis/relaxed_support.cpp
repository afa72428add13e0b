// Where a limit on the sag is in the way: the tracer or the pen resting on the table, pins held over a longer grip, less play in
// them. How much is estimated from the best design without the limit; then the spec is searched with it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/loads/sag.hpp"
#include "synthesis/search/diagnosis/least_change.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

/// How many times what pins may tilt by they do, in the best design without the limit; nothing where its weight alone is too much, or
/// where tilt is not in the way.
std::optional<double> too_much_tilt(const Spec& spec, const FoundDesign& best, double limit) {
  const auto openings = openings_over(best.linkage, spec.region);
  if (!openings) return std::nullopt;
  const SagAt worst = largest_sag(best.linkage, sag_conditions(spec, best.layers), *openings).sag;
  const Drop& drop = worst.tracer.total() > worst.pen.total() ? worst.tracer : worst.pen;
  const double left = limit - drop.by_weight;
  if (!(left > 0) || !(drop.by_play > left)) return std::nullopt;
  return drop.by_play / left;
}

/// On a tilted table little holds down what rests.
void let_rest(Questions& questions) {
  const Load& load = *questions.spec().load;
  if (load.tilt != 0) return;
  for (const Carrier point : {Carrier::tracer, Carrier::pen}) {
    if (load.rests_at(point) || questions.stopped()) continue;
    questions.note("load.rests");
    Spec spec = questions.spec();
    spec.load->rests.push_back(point);
    auto design = questions.best_of(spec);
    if (!design) continue;
    questions.keep(Relaxation{
        .key = "load.rests",
        .sentence = fmt::format("load.rests does not name the {0}; with \"{0}\" added a design exists",
                                point == Carrier::tracer ? "tracer" : "pen"),
        .design = *std::move(design)});
  }
}

/// "load.grip_mm, left out, is the links' thickness, 5, which is in the way; 20 would do"
std::string grip_would_do(const Spec& spec, double enough, SpecUnit unit) {
  const double now = spec.links.style.thickness;
  if (spec.load->grip) return length_would_do("load.grip_mm", *spec.load->grip, enough, unit);
  return fmt::format("{}, left out, is the links' thickness, {}, which is in the way; {} would do",
                     name_in(unit, "load.grip_mm"), six_digits(now, unit), six_digits(enough, unit));
}

void longer_grip(Questions& questions, double times) {
  const Spec& spec = questions.spec();
  const double given = spec.load->grip.value_or(spec.links.style.thickness);
  if (questions.stopped()) return;
  questions.note("load.grip_mm");
  auto found = least_change(
      questions, given, [&](double share) { return share * times * given; },
      [&](double grip) { return next_size(grip, questions.unit()); },
      [&](double grip) {
        Spec other = spec;
        other.load->grip = grip;
        return questions.best_of(other);
      });
  if (!found) return;
  questions.keep(Relaxation{.key = "load.grip_mm",
                            .sentence = grip_would_do(spec, found->value, questions.unit()),
                            .design = std::move(found->design),
                            .is_least = found->is_least});
}

void less_play(Questions& questions, double times) {
  const Spec& spec = questions.spec();
  const double given = spec.tolerance->play;
  if (questions.stopped()) return;
  questions.note("tolerance.play_mm");
  auto found = least_change(
      questions, given, [&](double share) { return given / (share * times); },
      [&](double play) { return next_smaller(play, questions.unit()); },
      [&](double play) {
        Spec other = spec;
        other.tolerance->play = play;
        return questions.best_of(other);
      });
  if (!found) return;
  questions.keep(
      Relaxation{.key = "tolerance.play_mm",
                 .sentence = length_would_do("tolerance.play_mm", given, found->value, questions.unit()),
                 .design = std::move(found->design),
                 .is_least = found->is_least});
}

}  // namespace

void relax_support(Questions& questions) {
  const auto& found = questions.found();
  const auto sag = std::find_if(found.begin(), found.end(),
                                [](const Relaxation& one) { return one.key == "limits.sag_mm"; });
  if (sag == found.end()) return;
  const Spec& spec = questions.spec();
  const auto times = too_much_tilt(spec, sag->design, sag->demanded);
  if (spec.load) let_rest(questions);
  if (!times || *times > questions.budget().firmer) return;
  if (spec.load) longer_grip(questions, *times);
  less_play(questions, *times);
}

}  // namespace kempe
