#include "synthesis/search/relaxations.hpp"

#include <algorithm>

#include "synthesis/search/best_design.hpp"
#include "synthesis/search/improve.hpp"
#include "synthesis/search/relaxation_words.hpp"

namespace kempe {

Questions::Questions(const SearchTask& task, const Point& origin, bool thorough)
    : task_(task), origin_(origin), thorough_(thorough) {}

SearchResult Questions::best(const SearchTask& asked) {
  SearchResult found = best_design(asked);
  if (thorough_ && !found.design && !found.proven_none)
    found = searched_again(asked, std::move(found), has_design);
  evaluations_ += found.evaluations;
  return found;
}

std::optional<FoundDesign> Questions::best_of(const Spec& other) {
  if (stopped()) return std::nullopt;
  return best(pose(other, task_.control.silent_part())).design;
}

void Questions::note(const std::string& key) {
  if (std::find(noted_.begin(), noted_.end(), key) == noted_.end()) noted_.push_back(key);
}

void Questions::keep(std::optional<Relaxation> found) {
  if (found) found_.push_back(*std::move(found));
}

bool Questions::has(const std::string& key) const {
  return std::any_of(found_.begin(), found_.end(), [&](const Relaxation& one) { return one.key == key; });
}

std::optional<Thinned> thinned(Questions& questions, double LinkStyle::*part, double least) {
  Spec spec = questions.spec();
  const auto with = [&](double value) {
    spec.links.style.*part = value;
    return questions.best_of(spec);
  };
  double enough = least, too_much = questions.spec().links.style.*part;
  auto design = with(enough);
  for (int i = 0; design && i < questions.budget().halvings && !questions.stopped(); ++i) {
    const double middle = rounded_down(0.5 * (enough + too_much));
    if (middle <= enough) break;
    const auto found = with(middle);
    (found ? enough : too_much) = middle;
    if (found) design = found;
  }
  if (!design) return std::nullopt;
  return Thinned{enough, *std::move(design)};
}

}  // namespace kempe
