#include "synthesis/search/diagnosis/relaxations.hpp"

#include <algorithm>

#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/best/improve.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"

namespace kempe {

Questions::Questions(const SearchTask& task, const Point& origin, bool thorough)
    : task_(task), origin_(origin), thorough_(thorough) {}

SearchResult Questions::best(const SearchTask& asked) {
  SearchResult found = best_design(asked);
  if (thorough_ && !found.design && !found.proven_none)
    found = searched_again(asked, std::move(found), has_design);
  count(found.evaluations);
  return found;
}

std::optional<FoundDesign> Questions::best_of(const Spec& other) {
  if (stopped()) return std::nullopt;
  return best(pose(other, task_.control.silent_part())).design;
}

void Questions::count(std::uint64_t evaluations) {
  evaluations_ += evaluations;
  spent_ += std::max(evaluations, budget().least_of_search);
}

void Questions::note(const std::string& key) {
  if (std::find(noted_.begin(), noted_.end(), key) == noted_.end()) noted_.push_back(key);
}

bool Questions::has_had_its_share(std::uint64_t began) const {
  const double share = budget().one_limit * static_cast<double>(budget().evaluations);
  return stopped() || static_cast<double>(spent_ - began) >= share;
}

void Questions::keep(std::optional<Relaxation> found) {
  if (!found) return;
  if (!found->is_least) found->sentence += may_be_smaller;
  found_.push_back(*std::move(found));
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
  return Thinned{enough, *std::move(design), !questions.stopped()};
}

}  // namespace kempe
