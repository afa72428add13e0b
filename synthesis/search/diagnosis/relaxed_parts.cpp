#include <fmt/format.h>

#include <algorithm>
#include <vector>

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
                              .sentence = would_do(key, demanded, found->value),
                              .design = std::move(found->design),
                              .is_least = found->is_least});
}

double seat_of(const std::string& name) {
  const Hardware* hardware = hardware_named(name);
  return hardware != nullptr ? hardware->seat : 0;
}

}  // namespace

std::optional<Relaxation> smaller_hardware(Questions& questions) {
  constexpr const char* key = "links.hardware";
  const Hardware* given = hardware_named(questions.spec().links.hardware);
  if (given == nullptr || questions.has(key) || questions.stopped()) return std::nullopt;
  questions.note(key);
  std::vector<Hardware> smaller;
  for (const Hardware& each : all_hardware())
    if (each.kind == given->kind && each.pin < given->pin) smaller.insert(smaller.begin(), each);
  for (const Hardware& each : smaller) {
    Spec spec = questions.spec();
    spec.links.hardware = each.name;
    spec.links.style.pin_diameter = each.pin;
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
  const std::string& hardware = questions.spec().links.hardware;
  if (hardware.empty())
    thinner(questions, "links.pin_diameter_mm", &LinkStyle::pin_diameter,
            rounded_down(slack::least_wall_share * style.pin_diameter));
  else
    questions.keep(smaller_hardware(questions));
  // A pin is no wider than its link, and a bearing narrower.
  thinner(questions, "links.width_mm", &LinkStyle::width,
          std::max(style.pin_diameter, (1 + slack::least_wall_share) * seat_of(hardware)));
}

}  // namespace kempe
