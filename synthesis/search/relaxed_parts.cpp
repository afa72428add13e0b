#include "synthesis/search/relaxation_words.hpp"
#include "synthesis/search/relaxations.hpp"
#include "synthesis/search/steps/tolerances.hpp"

namespace kempe {
namespace {

void thinner(Questions& questions, const char* key, double LinkStyle::*part, double least) {
  const double demanded = questions.spec().links.style.*part;
  if (least >= demanded || questions.has(key) || questions.stopped()) return;
  questions.note(key);
  if (auto found = thinned(questions, part, least))
    questions.keep(Relaxation{
        .key = key, .sentence = would_do(key, demanded, found->value), .design = std::move(found->design)});
}

}  // namespace

void relax_parts(Questions& questions) {
  const LinkStyle& style = questions.spec().links.style;
  thinner(questions, "links.pin_diameter_mm", &LinkStyle::pin_diameter,
          rounded_down(tolerance::least_wall_share * style.pin_diameter));
  thinner(questions, "links.width_mm", &LinkStyle::width,
          style.pin_diameter);  // a pin is no wider than its link
}

}  // namespace kempe
