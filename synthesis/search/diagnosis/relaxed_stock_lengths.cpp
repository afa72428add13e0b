#include <fmt/format.h>

#include "synthesis/search/relaxation_words.hpp"
#include "synthesis/search/relaxations.hpp"

namespace kempe {
namespace {

/// A key that a spec need not have, and the spec without it.
struct OptionalKey {
  std::string key;
  Spec without;
};

std::vector<OptionalKey> optional_keys(const Spec& spec) {
  std::vector<OptionalKey> keys;
  const auto without = [&](const std::string& key) -> Spec& {
    keys.push_back({key, spec});
    return keys.back().without;
  };
  const WorkshopSpec& workshop = spec.links.workshop;
  if (workshop.grid) without("links.grid_mm").links.workshop.grid = std::nullopt;
  if (!workshop.stock.empty()) without("links.stock_mm").links.workshop.stock.clear();
  for (std::size_t i = 0; i < workshop.locked.size(); ++i)
    if (workshop.locked[i])
      without(fmt::format("links.{}_mm", LinkLengths::names[i])).links.workshop.locked[i] = std::nullopt;
  if (spec.objective.groundings.size() < all_groundings.size())
    without("objective.groundings").objective.groundings = ObjectiveSpec{}.groundings;
  return keys;
}

/// More layers than four are of use with obstacles only.
int most_layers(const Spec& spec) { return spec.obstacles.empty() ? 4 : 8; }

void more_layers(Questions& questions) {
  Spec spec = questions.spec();
  const int most = most_layers(spec), demanded = spec.links.layers;
  if (demanded >= most || questions.stopped()) return;
  questions.note("links.layers");
  spec.links.layers = most;
  auto design = questions.best_of(spec);
  if (!design) return;
  int enough = most;
  for (spec.links.layers = demanded + 1; spec.links.layers < enough; ++spec.links.layers)
    if (auto fewer = questions.best_of(spec)) {
      design = std::move(fewer);
      enough = spec.links.layers;
    }
  questions.keep(Relaxation{.key = "links.layers",
                            .sentence = would_do("links.layers", demanded, enough),
                            .design = *std::move(design)});
}

}  // namespace

void relax_workshop(Questions& questions) {
  for (const OptionalKey& one : optional_keys(questions.spec())) {
    if (questions.stopped()) return;
    questions.note(one.key);
    if (auto design = questions.best_of(one.without))
      questions.keep(
          Relaxation{.key = one.key, .sentence = without_it(one.key), .design = *std::move(design)});
  }
  more_layers(questions);
}

}  // namespace kempe
