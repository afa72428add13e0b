#include "synthesis/design/error_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "synthesis/design/other_sections.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/load_error.hpp"
#include "synthesis/loads/pin_compliance.hpp"
#include "synthesis/loads/plane_weight.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/loads/top_over.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

std::string instead(const LinkStyle& now, const LinkStyle& before) {
  return section_words(now) + " instead of " + section_words(before);
}

constexpr ErrorSource all_sources[] = {ErrorSource::lengths, ErrorSource::play,   ErrorSource::load,
                                       ErrorSource::pins,    ErrorSource::layers, ErrorSource::own_weight,
                                       ErrorSource::weight,  ErrorSource::tilt,   ErrorSource::pull};

/// What a builder could change: the rest of a design stays.
struct Made {
  SagConditions conditions;  ///< links, pins, grip and what rests
  CopyTolerance tolerance{};
};

/// mm, of each source; infinite where it cannot be stated.
struct Errors {
  std::array<double, std::size(all_sources)> mm{};
  double give = 0;  ///< of ErrorBudget
  double& operator[](ErrorSource source) { return mm[static_cast<std::size_t>(source)]; }
  double operator[](ErrorSource source) const { return mm[static_cast<std::size_t>(source)]; }
};

/// What budget and course share.
struct Measured {
  const Design& design;
  OpeningInterval openings;

  /// mm, over the openings.
  double give(const LinkStyle& style, const PinCompliance& pins) const {
    const CopyingLinkage& linkage = design.linkage;
    return LoadErrorProfile(linkage.k(), linkage.grounding(), style, *design.material,
                            most_force_at_pen(*design.load), pins)
        .worst_over({linkage.VA(), linkage.VB()}, openings);
  }
  PinCompliance pins(const SagConditions& conditions) const {
    return pin_compliance(design.linkage.grounding(), design.layers, conditions.style, conditions.hardware);
  }
  /// The worst copy error over the region under these tolerances; 0 where there are none.
  double copy_error(const CopyTolerance& tolerance) const {
    const auto over = copy_error_over(design.linkage, tolerance, design.region);
    return over ? over->worst : 0;
  }
};

/// mm, the most that the pen moves in the plane by the links' own weight: with links, pins and layers, or where the layers say nothing with links and
/// pins alone.
double own_weight(const Measured& measured, const SagConditions& conditions) {
  const Design& design = measured.design;
  const CopyingLinkage& linkage = design.linkage;
  const BarLengths lengths{linkage.VA(), linkage.VB()};
  const double layered =
      LayeredErrorProfile(linkage.k(), linkage.grounding(), conditions, most_force_at_pen(*design.load))
          .by_weight_over(lengths, measured.openings)
          .in_plane;
  if (std::isfinite(layered)) return layered;
  return PlaneWeight(linkage.k(), linkage.grounding(), conditions.style, *design.material, conditions.tilt,
                     measured.pins(conditions))
      .most_over(lengths, measured.openings);
}

/// The most that tracer or pen sinks over the openings by this part, mm.
double worst_drop(const Measured& measured, const SagConditions& conditions, double Drop::*part) {
  const CopyingLinkage& linkage = measured.design.linkage;
  const SagProfile profile(linkage.k(), linkage.grounding(), conditions);
  const auto most = [&](double opening) {
    const SagAt at = profile.at(linkage.VA(), linkage.VB(), opening);
    return std::isfinite(at.most()) ? std::max({0.0, at.tracer.*part, at.pen.*part}) : infinity;
  };
  return most(top_over(measured.openings, most));
}

/// Links in layers above each other: in the plane what they give beyond load and pins, and how far tracer or pen rises or sinks, on a tilted
/// table by the links' own weight along it too.
void add_layers(const Measured& measured, const SagConditions& conditions, Errors& errors) {
  const CopyingLinkage& linkage = measured.design.linkage;
  const auto all = LayeredErrorProfile(linkage.k(), linkage.grounding(), conditions,
                                       most_force_at_pen(*measured.design.load))
                       .over({linkage.VA(), linkage.VB()}, measured.openings);
  const double flat = errors[ErrorSource::load] + errors[ErrorSource::pins];
  errors[ErrorSource::layers] = all ? std::max(0.0, all->error_max - flat) : infinity;
  errors.give = all ? std::max(errors[ErrorSource::load], all->error_max) : flat;
  errors[ErrorSource::pull] = all ? all->rise_max + all->weight_rise_max.value_or(0) : infinity;
}

void add_tolerances(const Measured& measured, const CopyTolerance& tolerance, Errors& errors) {
  errors[ErrorSource::lengths] = measured.copy_error({tolerance.length, {}});
  errors[ErrorSource::play] = measured.copy_error({{}, tolerance.play});
}

void add_loads(const Measured& measured, const SagConditions& conditions, Errors& errors) {
  const double rigid_pins = measured.give(conditions.style, {});
  errors[ErrorSource::load] = rigid_pins;
  errors[ErrorSource::pins] = measured.give(conditions.style, measured.pins(conditions)) - rigid_pins;
  add_layers(measured, conditions, errors);
  errors[ErrorSource::own_weight] = own_weight(measured, conditions);
  errors.give += errors[ErrorSource::own_weight];
  errors[ErrorSource::weight] = worst_drop(measured, conditions, &Drop::by_weight);
  errors[ErrorSource::tilt] = worst_drop(measured, conditions, &Drop::by_play);
}

/// A change with all that is then left.
struct Candidate {
  std::string words;
  Errors after;
  bool needs_other_lengths = false;
};

const SourceContribution* largest_source(const std::vector<SourceContribution>& sources, std::size_t from,
                                         std::size_t to) {
  const auto begin = sources.begin() + static_cast<std::ptrdiff_t>(from);
  const auto end = sources.begin() + static_cast<std::ptrdiff_t>(to);
  const auto best =
      std::max_element(begin, end, [](const auto& a, const auto& b) { return a.worst < b.worst; });
  return best == end || best->worst == 0 ? nullptr : &*best;
}

/// All that a builder might change, one at a time.
class Candidates {
 public:
  Candidates(const Measured& measured, const Made& now, const Errors& errors)
      : measured_(measured), now_(now), errors_(errors) {}

  std::vector<Candidate> all() {
    tighten();
    wider();
    thicker();
    thicker_pins();
    let_rest();
    hold_longer();
    return std::move(all_);
  }

 private:
  void add_tighter(std::string words, const CopyTolerance& tolerance) {
    Candidate one{std::move(words), errors_};
    add_tolerances(measured_, tolerance, one.after);
    all_.push_back(std::move(one));
  }

  /// The link's length and the pin's play that do most.
  void tighten() {
    const Design& design = measured_.design;
    if (!design.tolerance) return;
    const auto over = copy_error_over(design.linkage, now_.tolerance, design.region);
    if (!over || over->sources.size() != error_source_count) return;
    const auto number = [&](const SourceContribution* source) {
      return static_cast<std::size_t>(source - over->sources.data());
    };
    if (const auto* worst = largest_source(over->sources, 0, 8)) {
      CopyTolerance better = now_.tolerance;
      better.length[number(worst)] *= 0.5;
      add_tighter(fmt::format("{} to ±{:.3g} mm", worst->name, 0.5 * design.tolerance->length), better);
    }
    if (const auto* worst = largest_source(over->sources, 8, error_source_count)) {
      CopyTolerance reamed = now_.tolerance;
      reamed.play[number(worst) - 8] = 0;
      add_tighter(fmt::format("no {}: ream the hole to its pin", worst->name), reamed);
    }
  }

  void add(std::string words, const SagConditions& conditions) {
    Candidate one{std::move(words), errors_};
    add_loads(measured_, conditions, one.after);
    all_.push_back(std::move(one));
  }

  /// Of other outlines: a design that does not keep its spec as it is says nothing of them.
  void add_other_parts(std::string words, const SagConditions& conditions) {
    add(std::move(words), conditions);
    const Design& design = measured_.design;
    all_.back().needs_other_lengths =
        keeps_the_rest(design, now_.conditions.style, now_.conditions.hardware) &&
        !keeps_the_rest(design, conditions.style, conditions.hardware);
  }

  void wider() {
    SagConditions other = now_.conditions;
    other.style.width = next_width(other.style.width);
    add_other_parts(instead(other.style, now_.conditions.style), other);
  }

  void thicker() {
    SagConditions other = now_.conditions;
    other.style.thickness = next_thickness(other.style.thickness);
    if (!measured_.design.load->grip) other.grip = other.style.thickness;
    add(instead(other.style, now_.conditions.style), other);
  }

  void thicker_pins() {
    SagConditions other = now_.conditions;
    other.style.pin_diameter = next_pin_diameter(other.style.pin_diameter);
    other.hardware = {};
    add_other_parts(fmt::format("pins of {:.3g} mm", other.style.pin_diameter), other);
  }

  /// On a tilted table little holds down what rests.
  void let_rest() {
    if (now_.conditions.tilt != 0) return;
    for (const auto& [rests, point] :
         {std::pair{&SagConditions::tracer_rests, "tracer"}, std::pair{&SagConditions::pen_rests, "pen"}}) {
      SagConditions other = now_.conditions;
      if (std::exchange(other.*rests, true)) continue;
      add(fmt::format("the {} resting on the table", point), other);
    }
  }

  void hold_longer() {
    if (!(now_.conditions.play > 0)) return;
    SagConditions other = now_.conditions;
    other.grip *= 2;
    add(fmt::format("pins gripped over {:.3g} mm instead of {:.3g} mm", other.grip, now_.conditions.grip),
        other);
  }

  const Measured& measured_;
  const Made& now_;
  const Errors& errors_;
  std::vector<Candidate> all_{};
};

/// Share of a source's error: a change that takes less of it away is not worth a new part.
constexpr double least_gain = 0.05;
/// Told of one source.
constexpr std::size_t most_changes = 3;

bool is_better(const BudgetChange& a, const BudgetChange& b) {
  return std::pair(a.needs_other_lengths, a.after) < std::pair(b.needs_other_lengths, b.after);
}

/// What counts together, mm, after a change or without one, of what is stated `now`.
struct Sums {
  Sums(const Errors& now, const Errors& then)
      : give(std::isfinite(now[ErrorSource::layers]) && !std::isfinite(then[ErrorSource::layers])
                 ? infinity
                 : then.give) {
    for (const ErrorSource source : all_sources)
      if (std::isfinite(now[source])) (is_in_plane(source) ? in_plane : down) += then[source];
  }
  double in_plane = 0, down = 0, give;
};

/// True if a change that helps against one source does not do more harm by another.
bool helps_in_all(ErrorSource source, const Errors& now, const Errors& then) {
  const Sums before(now, now), after(now, then);
  if (is_give(source) && after.give > before.give) return false;
  return is_in_plane(source) ? after.in_plane < before.in_plane : after.down < before.down;
}

/// Those that help, the best first.
std::vector<BudgetChange> changes_of(ErrorSource source, const Errors& errors,
                                     const std::vector<Candidate>& candidates) {
  std::vector<BudgetChange> changes;
  for (const Candidate& one : candidates)
    if (const double after = one.after[source];
        after < (1 - least_gain) * errors[source] && helps_in_all(source, errors, one.after))
      changes.push_back({one.words, after, one.needs_other_lengths});
  std::stable_sort(changes.begin(), changes.end(), is_better);
  if (changes.size() > most_changes) changes.resize(most_changes);
  return changes;
}

/// Of those that help with any of the entries counted, the change that leaves least of a sum.
template <typename IsCounted>
std::optional<BestChange> best_change(const std::vector<BudgetEntry>& entries, const Errors& errors,
                                      const std::vector<Candidate>& candidates, const IsCounted& is_counted,
                                      double Sums::*sum) {
  std::optional<BestChange> best;
  const double before = Sums(errors, errors).*sum;
  for (const Candidate& one : candidates) {
    double most = 0;
    ErrorSource mostly{};
    bool helps = false;
    for (const BudgetEntry& entry : entries) {
      if (!is_counted(entry.source)) continue;
      const double here = one.after[entry.source];
      helps = helps || here < (1 - least_gain) * entry.error;
      if (entry.error - here > most) most = entry.error - here, mostly = entry.source;
    }
    const double after = Sums(errors, one.after).*sum;
    if (!helps || !(after < before)) continue;
    BestChange found{{one.words, after, one.needs_other_lengths}, before, mostly};
    if (!best || is_better(found.change, best->change)) best = std::move(found);
  }
  return best;
}

/// The entries of a design as it is, in the order of ErrorBudget.
std::vector<BudgetEntry> entries_of(const Errors& errors, const std::vector<Candidate>& candidates) {
  std::vector<BudgetEntry> entries;
  for (const ErrorSource source : all_sources) {
    const double error = errors[source];
    const bool always = source == ErrorSource::load || source == ErrorSource::pins;
    if (std::isfinite(error) && (always || error > no_drop))
      entries.push_back({source, error, changes_of(source, errors, candidates)});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const BudgetEntry& a, const BudgetEntry& b) {
    const bool a_in_plane = is_in_plane(a.source), b_in_plane = is_in_plane(b.source);
    return a_in_plane != b_in_plane ? a_in_plane : a.error > b.error;
  });
  return entries;
}

}  // namespace

bool is_in_plane(ErrorSource source) { return source < ErrorSource::weight; }

bool is_give(ErrorSource source) { return is_in_plane(source) && source >= ErrorSource::load; }

std::string_view name(ErrorSource source) {
  constexpr std::string_view names[] = {"lengths",    "play",   "links", "pins", "layers",
                                        "own weight", "weight", "tilt",  "pull"};
  return names[static_cast<std::size_t>(source)];
}

double ErrorBudget::sum(bool in_plane) const {
  double sum = 0;
  for (const BudgetEntry& entry : entries)
    if (is_in_plane(entry.source) == in_plane) sum += entry.error;
  return sum;
}

bool ErrorBudget::has_own_weight() const {
  return std::any_of(entries.begin(), entries.end(),
                     [](const BudgetEntry& entry) { return entry.source == ErrorSource::own_weight; });
}

bool ErrorBudget::is_one_change_for_both() const {
  return best_in_plane && best_against_give && best_in_plane->change.words == best_against_give->change.words;
}

std::string_view ErrorBudget::help_out_of_plane() const {
  if (best_down && best_down->mostly == ErrorSource::pull) return "against what the load lifts or lowers";
  return pulls() ? "against sinking and what the load lifts or lowers" : "against sinking";
}

bool ErrorBudget::pulls() const {
  return std::any_of(entries.begin(), entries.end(),
                     [](const BudgetEntry& entry) { return entry.source == ErrorSource::pull; });
}

std::optional<ErrorBudget> error_budget(const Design& design) {
  const auto openings = openings_over(design.linkage, design.region);
  if (!design.load || !design.material || !openings || openings->empty()) return std::nullopt;
  const Measured measured{design, *openings};
  const Made now{sag_conditions(spec_of(design), design.layers),
                 design.tolerance ? CopyTolerance::uniform(*design.tolerance) : CopyTolerance{}};
  Errors errors{};
  if (design.tolerance) add_tolerances(measured, now.tolerance, errors);
  add_loads(measured, now.conditions, errors);
  const std::vector<Candidate> candidates = Candidates(measured, now, errors).all();
  ErrorBudget budget{.entries = entries_of(errors, candidates),
                     .states_layers = std::isfinite(errors[ErrorSource::layers]),
                     .give = errors.give};
  const auto best = [&](const auto& is_counted, double Sums::*sum) {
    return best_change(budget.entries, errors, candidates, is_counted, sum);
  };
  budget.best_in_plane = best(is_in_plane, &Sums::in_plane);
  budget.best_down = best([](ErrorSource one) { return !is_in_plane(one); }, &Sums::down);
  budget.best_against_give = best(is_give, &Sums::give);
  return budget;
}

std::optional<double> give_in_all(const Quality& quality) {
  if (!quality.loads || !quality.layered) return std::nullopt;
  return std::max(quality.loads->error_max, quality.layered->error_max) +
         quality.layered->weight_error_max.value_or(0);
}

ErrorCourse::ErrorCourse(const Design& design)
    : bars_{design.linkage.VA(), design.linkage.VB()},
      give_(design.linkage.k(), design.linkage.grounding(), design.style, *design.material,
            most_force_at_pen(*design.load),
            pin_compliance(design.linkage.grounding(), design.layers, design.style, design.hardware)),
      layered_(design.linkage.k(), design.linkage.grounding(), sag_conditions(spec_of(design), design.layers),
               most_force_at_pen(*design.load)),
      sag_(design.linkage.k(), design.linkage.grounding(), sag_conditions(spec_of(design), design.layers)) {
  if (design.tolerance)
    tolerances_ = copy_error_profile(design.linkage, CopyTolerance::uniform(*design.tolerance));
}

double ErrorCourse::tolerances(double opening) const {
  return tolerances_ ? tolerances_->at(opening).worst : 0;
}

double ErrorCourse::give(double opening) const {
  const double flat = give_.at(bars_, opening).worst, layered = layered_.at(bars_, opening).in_plane;
  const double own_weight = layered_.by_weight(bars_, opening).in_plane;
  return std::isfinite(layered) ? std::max(flat, layered) + own_weight : infinity;
}

double ErrorCourse::sag(double opening) const { return sag_.at(bars_.VA, bars_.VB, opening).most(); }

}  // namespace kempe
