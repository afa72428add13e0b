// The joints of a link are kept apart by shortest_mm or by their holes, whichever asks for more: that one may give.

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/search/relaxation_words.hpp"
#include "synthesis/search/relaxed_limits.hpp"
#include "synthesis/search/steps/tolerances.hpp"

namespace kempe {
namespace {

std::string holes_would_do(const Spec& spec, const char* key, double demanded, double possible) {
  return fmt::format("{} = {:.6g} is in the way: {}; {:.6g} would do", key, demanded, holes_sentence(spec),
                     possible);
}

/// A thinner wall between two holes, of which something is left.
std::optional<Relaxation> thinner_wall(Questions& questions) {
  const Spec& spec = questions.spec();
  const double bore = joint_width(spec);
  const MovableLimit limit{
      Goal::shortest, "links.wall_mm", 1,
      std::max({spec.links.shortest, (1 + tolerance::least_wall_share) * bore, tolerance::nearest_joints})};
  auto found = relaxed(questions, limit);
  if (!found) return std::nullopt;
  found->sentence = holes_would_do(spec, limit.key, least_wall(spec), *found->possible - bore);
  return found;
}

/// Thinner pins, which stand in fewer parts' way too.
std::optional<Relaxation> thinner_pins(Questions& questions) {
  const Spec& spec = questions.spec();
  const double pin = spec.links.style.pin_diameter;
  questions.note("links.pin_diameter_mm");
  auto found = thinned(questions, &LinkStyle::pin_diameter, rounded_down(tolerance::least_wall_share * pin));
  if (!found) return std::nullopt;
  Spec with_thinner = spec;
  with_thinner.links.style.pin_diameter = found->value;
  return Relaxation{Goal::shortest,
                    "links.pin_diameter_mm",
                    questions.limits().shortest,
                    least_joint_distance(with_thinner),
                    holes_would_do(spec, "links.pin_diameter_mm", pin, found->value),
                    std::move(found->design)};
}

}  // namespace

void relax_joints(Questions& questions) {
  if (questions.stopped()) return;
  const double holes = hole_distance(questions.spec()), shortest = questions.spec().links.shortest;
  if (shortest > holes)
    return questions.keep(relaxed(
        questions, {Goal::shortest, "links.shortest_mm", 1, std::max(holes, tolerance::nearest_joints)}));
  if (shortest == holes) return;
  auto found = thinner_wall(questions);
  questions.keep(found ? std::move(found) : thinner_pins(questions));
}

}  // namespace kempe
