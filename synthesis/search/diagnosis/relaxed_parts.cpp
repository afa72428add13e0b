#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "kinematics/grounding.hpp"
#include "specs/hardware.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/diagnosis/relaxations.hpp"
#include "synthesis/search/steps/slack.hpp"

namespace kempe {
namespace {

void thinner(Questions& questions, const char* key, double LinkStyle::*part, double least) {
  const double demanded = questions.spec().links.style.*part;
  if (least >= demanded || questions.has(key) || questions.stopped()) return;
  questions.note(key);
  if (auto found = thinned(questions, part, least))
    questions.keep(Relaxation{.key = key,
                              .sentence = length_would_do(key, demanded, found->value, questions.unit()),
                              .design = std::move(found->design),
                              .is_least = found->is_least});
}

/// Of what is bought for the joints what takes most room, which keeps joints apart; null where pins are plain.
const Hardware* widest_of(const JointHardware& hardware) {
  const Hardware* widest = nullptr;
  for (const Joint joint : all_joints)
    if (const Hardware* of = hardware_named(hardware[joint]);
        of != nullptr &&
        (widest == nullptr || std::max(of->seat, of->pin) > std::max(widest->seat, widest->pin)))
      widest = of;
  return widest;
}

/// The spec with something else wherever `given` was.
Spec with_instead(Spec spec, const Hardware& given, const Hardware& other) {
  JointHardware& hardware = spec.links.hardware;
  const double before = thickest_pin(hardware);
  if (hardware.every == given.name) hardware.every = other.name;
  for (std::string& name : hardware.at)
    if (name == given.name) name = other.name;
  // Plain pins that were given thicker than all stay so.
  if (spec.links.style.pin_diameter == before) spec.links.style.pin_diameter = thickest_pin(hardware);
  return spec;
}

}  // namespace

std::optional<Relaxation> smaller_hardware(Questions& questions) {
  constexpr const char* key = "links.hardware";
  const Hardware* given = widest_of(questions.spec().links.hardware);
  if (given == nullptr || questions.has(key) || questions.stopped()) return std::nullopt;
  questions.note(key);
  std::vector<Hardware> smaller;
  for (const Hardware& each : all_hardware())
    if (each.kind == given->kind && each.pin < given->pin) smaller.insert(smaller.begin(), each);
  for (const Hardware& each : smaller) {
    const Spec spec = with_instead(questions.spec(), *given, each);
    if (questions.stopped()) return std::nullopt;
    if (const auto design = questions.best_of(spec))
      return Relaxation{
          .key = key,
          .sentence = fmt::format("{} = \"{}\" is in the way; \"{}\" would do", key, given->name, each.name),
          .design = *design};
  }
  return std::nullopt;
}

void relax_parts(Questions& questions) {
  const LinkStyle& style = questions.spec().links.style;
  const JointHardware& hardware = questions.spec().links.hardware;
  if (hardware.none())
    thinner(questions, "links.pin_diameter_mm", &LinkStyle::pin_diameter,
            rounded_down(slack::least_wall_share * style.pin_diameter, questions.unit()));
  else
    questions.keep(smaller_hardware(questions));
  // A pin is no wider than its link, and a bearing narrower.
  thinner(questions, "links.width_mm", &LinkStyle::width,
          std::max(style.pin_diameter, (1 + slack::least_wall_share) * widest_seat(hardware)));
}

}  // namespace kempe
