#include <fmt/format.h>

#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/diagnosis/relaxations.hpp"

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
  const StockLengths& stock_lengths = spec.links.stock_lengths;
  if (stock_lengths.grid) without("links.grid_mm").links.stock_lengths.grid = std::nullopt;
  if (!stock_lengths.stock.empty()) without("links.stock_mm").links.stock_lengths.stock.clear();
  for (std::size_t i = 0; i < stock_lengths.locked.size(); ++i)
    if (stock_lengths.locked[i])
      without(fmt::format("links.{}_mm", LinkLengths::names[i])).links.stock_lengths.locked[i] = std::nullopt;
  if (spec.objective.groundings.size() < all_groundings.size())
    without("objective.groundings").objective.groundings = ObjectiveSpec{}.groundings;
  return keys;
}

/// More layers than four are of use with obstacles or bodies only.
int layers_of_use(const Spec& spec) { return spec.obstacles.empty() && spec.bodies.empty() ? 4 : 8; }

void more_layers(Questions& questions) {
  Spec spec = questions.spec();
  const int most = layers_of_use(spec), demanded = spec.links.layers;
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
                            .design = *std::move(design),
                            .is_least = !questions.stopped()});
}

}  // namespace

void relax_stock_lengths(Questions& questions) {
  for (const OptionalKey& one : optional_keys(questions.spec())) {
    if (questions.stopped()) return;
    questions.note(one.key);
    if (auto design = questions.best_of(one.without))
      questions.keep(Relaxation{
          .key = one.key, .sentence = without_it(one.key, questions.unit()), .design = *std::move(design)});
  }
  more_layers(questions);
}

}  // namespace kempe
