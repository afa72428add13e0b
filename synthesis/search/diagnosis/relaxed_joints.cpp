// The joints of a link are kept apart by shortest_mm or by their holes, whichever asks for more: that one may give.

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/diagnosis/relaxed_limits.hpp"
#include "synthesis/search/steps/slack.hpp"

namespace kempe {
namespace {

std::string holes_would_do(const Spec& spec, const char* key, double demanded, double possible,
                           SpecUnit unit) {
  return fmt::format("{} = {} is in the way: {}; {} would do", name_in(unit, key), six_digits(demanded, unit),
                     holes_sentence(spec, unit), six_digits(possible, unit));
}

/// A thinner wall between two holes, of which something is left.
std::optional<Relaxation> thinner_wall(Questions& questions) {
  const Spec& spec = questions.spec();
  const double bore = joint_width(spec);
  const MovableLimit limit{
      Goal::shortest, "links.wall_mm", 1,
      std::max({spec.links.shortest, (1 + slack::least_wall_share) * bore, slack::nearest_joints})};
  auto found = relaxed(questions, limit);
  if (!found) return std::nullopt;
  found->sentence =
      holes_would_do(spec, limit.key, least_wall(spec), *found->possible - bore, questions.unit());
  return found;
}

/// Thinner pins, which stand in fewer parts' way too.
std::optional<Relaxation> thinner_pins(Questions& questions) {
  const Spec& spec = questions.spec();
  const double pin = spec.links.style.pin_diameter;
  questions.note("links.pin_diameter_mm");
  auto found = thinned(questions, &LinkStyle::pin_diameter,
                       rounded_down(slack::least_wall_share * pin, questions.unit()));
  if (!found) return std::nullopt;
  Spec with_thinner = spec;
  with_thinner.links.style.pin_diameter = found->value;
  return Relaxation{
      .limit = Goal::shortest,
      .key = "links.pin_diameter_mm",
      .demanded = questions.limits().shortest,
      .possible = least_joint_distance(with_thinner),
      .sentence = holes_would_do(spec, "links.pin_diameter_mm", pin, found->value, questions.unit()),
      .design = std::move(found->design),
      .is_least = found->is_least};
}

}  // namespace

void relax_joints(Questions& questions) {
  if (questions.stopped()) return;
  const double holes = hole_distance(questions.spec()), shortest = questions.spec().links.shortest;
  if (shortest > holes)
    return questions.keep(
        relaxed(questions, {Goal::shortest, "links.shortest_mm", 1, std::max(holes, slack::nearest_joints)}));
  if (shortest == holes) return;
  auto found = thinner_wall(questions);
  if (!found)
    found = questions.spec().links.hardware.none() ? thinner_pins(questions) : smaller_hardware(questions);
  questions.keep(std::move(found));
}

}  // namespace kempe
