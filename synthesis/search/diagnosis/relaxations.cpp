#include "synthesis/search/diagnosis/relaxations.hpp"

#include <algorithm>

#include "synthesis/search/best/best_design.hpp"
#include "synthesis/search/best/improve.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/steps/design_check.hpp"
#include "synthesis/search/steps/obstacle_check.hpp"
#include "workspace/footprint.hpp"

namespace kempe {

Questions::Questions(const SearchTask& task, const Point& origin, bool thorough)
    : task_(task.with(task.control.silent())),
      progress_(task.control.progress_of(thorough ? "looking again for what would help"
                                                  : "looking for what would help")),
      origin_(origin), thorough_(thorough) {}

SearchResult Questions::best(const SearchTask& asked) {
  SearchResult found = best_design(asked);
  if (thorough_ && !found.design && !found.proven_none)
    found = searched_again(asked, std::move(found), has_design);
  count(asked, found.evaluations);
  return found;
}

std::optional<FoundDesign> Questions::best_of(const Spec& other) {
  if (stopped()) return std::nullopt;
  return best(pose(other, task_.control.silent_part())).design;
}

void Questions::count(const SearchTask& asked, std::uint64_t evaluations) {
  evaluations_ += evaluations;
  const std::uint64_t weight = (asked.space().obstacles().empty() ? 0 : budget().among_obstacles) +
                               (asked.limits.sag ? budget().of_sag : 0);
  spent_ += std::max(evaluations * std::max<std::uint64_t>(weight, 1), budget().least_of_search);
  if (progress_)
    progress_(std::min(1.0, static_cast<double>(spent_) / static_cast<double>(budget().evaluations)));
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

bool Questions::permits(const FoundDesign& design) {
  const DesignCheck check = check_design(spec(), limits(), design.linkage, design.layers);
  if (!check.feasible || !keeps_stock_lengths(design.linkage, spec().links.stock_lengths)) return false;
  Attained attained = check.attained;
  if (!task_.space().obstacles().empty()) {
    const ObstacleCheck obstacles = check_obstacles(task_.space().spec(), limits(), design.linkage,
                                                    design.layers, check.opening, task_.stop());
    if (!obstacles.clear) return false;
    attained.clearance = std::min(attained.clearance, obstacles.clearance);
  }
  if (task_.goal == Goal::footprint)
    attained.footprint = footprint(design.linkage, spec().links.style, spec().region).area;
  permitted_ = design;
  permitted_->goal = task_.goal;
  permitted_->attained = attained;
  permitted_->value = attained.of(task_.goal);
  permitted_->opening = check.opening;
  return true;
}

bool Questions::has(const std::string& key) const {
  return std::any_of(found_.begin(), found_.end(), [&](const Relaxation& one) { return one.key == key; });
}

namespace {

/// True where thick parts may keep a limit that thin ones break.
bool asks_for_stiff_parts(const Requirements& limits) { return limits.load_error || limits.sag; }

struct ThinnedPart {
  double value;  ///< mm
  FoundDesign design;
};

/// Of the thinnest part; where that is too soft, of the thickest of a few values in between with which there is a design.
template <class With>
std::optional<ThinnedPart> thinned_at_first(Questions& questions, const With& with, double least,
                                            double demanded) {
  if (auto design = with(least)) return ThinnedPart{least, *std::move(design)};
  if (!asks_for_stiff_parts(questions.limits())) return std::nullopt;
  for (const double share : questions.budget().thinner) {
    if (questions.stopped()) break;
    const double value = rounded_down(demanded - share * (demanded - least), questions.unit());
    if (auto design = with(value)) return ThinnedPart{value, *std::move(design)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Thinned> thinned(Questions& questions, double LinkStyle::*part, double least) {
  Spec spec = questions.spec();
  const auto with = [&](double value) {
    spec.links.style.*part = value;
    return questions.best_of(spec);
  };
  double too_much = questions.spec().links.style.*part;
  auto enough = thinned_at_first(questions, with, least, too_much);
  for (int i = 0; enough && i < questions.budget().halvings && !questions.stopped(); ++i) {
    const double middle = rounded_down(0.5 * (enough->value + too_much), questions.unit());
    if (middle <= enough->value) break;
    if (auto found = with(middle))
      enough = ThinnedPart{middle, *std::move(found)};
    else
      too_much = middle;
  }
  if (!enough) return std::nullopt;
  const bool is_least = !questions.stopped() && !asks_for_stiff_parts(questions.limits());
  return Thinned{enough->value, std::move(enough->design), is_least};
}

}  // namespace kempe
