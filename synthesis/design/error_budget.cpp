#include "synthesis/design/error_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "synthesis/design/assemble.hpp"
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

/// Widths and thicknesses of flat bars as the trade has them, mm (EN 10058, EN 10278).
constexpr double flat_widths[] = {6, 8, 10, 12, 15, 20, 25, 30, 40, 50, 60, 80, 100};
constexpr double flat_thicknesses[] = {2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40};

template <std::size_t size>
double next_of(const double (&sizes)[size], double value) {
  const auto* larger =
      std::find_if(std::begin(sizes), std::end(sizes), [&](double one) { return one > 1.05 * value; });
  return larger != std::end(sizes) ? *larger : 1.5 * value;
}

std::string section_words(const LinkStyle& style) {
  return fmt::format("{:.4g} x {:.4g} mm", style.width, style.thickness);
}

std::string instead(const LinkStyle& now, const LinkStyle& before) {
  return section_words(now) + " instead of " + section_words(before);
}

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
  PinCompliance pins(const LinkStyle& style, const JointHardware& hardware) const {
    return pin_compliance(design.linkage.grounding(), design.layers, style, hardware);
  }
  /// The worst copy error over the region under these tolerances; 0 where there are none.
  double copy_error(const CopyTolerance& tolerance) const {
    const auto over = copy_error_over(design.linkage, tolerance, design.region);
    return over ? over->worst : 0;
  }
};

BudgetEntry load_entry(const Measured& of) {
  const LinkStyle& style = of.design.style;
  LinkStyle wider = style;
  wider.width = next_of(flat_widths, style.width);
  return {ErrorSource::load, of.give(style, {}), {{instead(wider, style), of.give(wider, {})}}};
}

BudgetEntry pins_entry(const Measured& of) {
  constexpr double thicker = 1.25;
  const LinkStyle& style = of.design.style;
  LinkStyle other = style;
  other.pin_diameter *= thicker;
  const double rigid = of.give(style, {});
  return {
      ErrorSource::pins,
      of.give(style, of.pins(style, of.design.hardware)) - rigid,
      {{fmt::format("pins of {:.3g} mm", other.pin_diameter), of.give(style, of.pins(other, {})) - rigid}}};
}

/// mm, the most that the pen moves in the plane by the links' own weight: with links, pins and layers, or where the layers say nothing with links and
/// pins alone.
double own_weight(const Measured& of, const SagConditions& conditions) {
  const CopyingLinkage& linkage = of.design.linkage;
  const BarLengths lengths{linkage.VA(), linkage.VB()};
  const double layered =
      LayeredErrorProfile(linkage.k(), linkage.grounding(), conditions, most_force_at_pen(*of.design.load))
          .by_weight_over(lengths, of.openings)
          .in_plane;
  if (std::isfinite(layered)) return layered;
  return PlaneWeight(linkage.k(), linkage.grounding(), conditions.style, *of.design.material, conditions.tilt,
                     of.pins(conditions.style, of.design.hardware))
      .most_over(lengths, of.openings);
}

void add_own_weight(const Measured& of, std::vector<BudgetEntry>& entries) {
  const SagConditions now = sag_conditions(spec_of(of.design), of.design.layers);
  const double error = own_weight(of, now);
  if (!(error > no_drop)) return;
  SagConditions wider = now;
  wider.style.width = next_of(flat_widths, now.style.width);
  entries.push_back(
      {ErrorSource::own_weight, error, {{instead(wider.style, now.style), own_weight(of, wider)}}});
}

const SourceContribution* largest_source(const std::vector<SourceContribution>& sources, std::size_t from,
                                         std::size_t to) {
  const auto begin = sources.begin() + static_cast<std::ptrdiff_t>(from);
  const auto end = sources.begin() + static_cast<std::ptrdiff_t>(to);
  const auto best =
      std::max_element(begin, end, [](const auto& a, const auto& b) { return a.worst < b.worst; });
  return best == end || best->worst == 0 ? nullptr : &*best;
}

/// Lengths and play, each alone, as the tolerance says.
void add_tolerances(const Measured& of, std::vector<BudgetEntry>& entries) {
  if (!of.design.tolerance) return;
  const Tolerance& given = *of.design.tolerance;
  const CopyTolerance all = CopyTolerance::uniform(given);
  const auto over = copy_error_over(of.design.linkage, all, of.design.region);
  if (!over || over->sources.size() != error_source_count) return;
  const auto number = [&](const SourceContribution* source) {
    return static_cast<std::size_t>(source - over->sources.data());
  };
  if (const auto* worst = largest_source(over->sources, 0, 8); worst && given.length > 0) {
    CopyTolerance better{all.length, {}};
    better.length[number(worst)] *= 0.5;
    entries.push_back(
        {ErrorSource::lengths,
         of.copy_error({all.length, {}}),
         {{fmt::format("{} to ±{:.3g} mm", worst->name, 0.5 * given.length), of.copy_error(better)}}});
  }
  if (const auto* worst = largest_source(over->sources, 8, error_source_count); worst && given.play > 0) {
    CopyTolerance reamed{{}, all.play};
    reamed.play[number(worst) - 8] = 0;
    entries.push_back(
        {ErrorSource::play,
         of.copy_error({{}, all.play}),
         {{fmt::format("no {}: ream the hole to its pin", worst->name), of.copy_error(reamed)}}});
  }
}

using PartOfDrop = double Drop::*;

/// The most that tracer or pen sinks over the openings by this part; which of the two.
struct WorstDrop {
  double drop = 0;
  Carrier point = Carrier::pen;
};

WorstDrop worst_drop(const Measured& of, const SagConditions& conditions, PartOfDrop part) {
  const CopyingLinkage& linkage = of.design.linkage;
  const SagProfile profile(linkage.k(), linkage.grounding(), conditions);
  const auto sag = [&](double opening) { return profile.at(linkage.VA(), linkage.VB(), opening); };
  const auto most = [&](const SagAt& at) {
    return std::isfinite(at.most()) ? std::max({0.0, at.tracer.*part, at.pen.*part}) : infinity;
  };
  const SagAt worst = sag(top_over(of.openings, [&](double opening) { return most(sag(opening)); }));
  return {most(worst), worst.tracer.*part > worst.pen.*part ? Carrier::tracer : Carrier::pen};
}

SagConditions with_next_thickness(SagConditions conditions) {
  conditions.style.thickness = next_of(flat_thicknesses, conditions.style.thickness);
  return conditions;
}

/// What links in layers above each other do: in the plane what they give beyond load and pins, and how far tracer or pen rises or sinks, on a
/// tilted table by the links' own weight along it too.
struct LayersDo {
  double in_plane, rise;  ///< mm; infinite where they cannot be stated
};

LayersDo layers_do(const Measured& of, const SagConditions& conditions) {
  const CopyingLinkage& linkage = of.design.linkage;
  const auto all =
      LayeredErrorProfile(linkage.k(), linkage.grounding(), conditions, most_force_at_pen(*of.design.load))
          .over({linkage.VA(), linkage.VB()}, of.openings);
  if (!all) return {infinity, infinity};
  const double stated = of.give(conditions.style, of.pins(conditions.style, of.design.hardware));
  return {std::max(0.0, all->error_max - stated), all->rise_max + all->weight_rise_max.value_or(0)};
}

/// False where they cannot be stated.
bool add_layers(const Measured& of, std::vector<BudgetEntry>& entries) {
  const SagConditions now = sag_conditions(spec_of(of.design), of.design.layers);
  const LayersDo here = layers_do(of, now);
  if (!std::isfinite(here.in_plane)) return false;
  const SagConditions thicker = with_next_thickness(now);
  const LayersDo then = layers_do(of, thicker);
  BudgetEntry in_plane{
      ErrorSource::layers, here.in_plane, {{instead(thicker.style, now.style), then.in_plane}}};
  BudgetEntry down{ErrorSource::pull, here.rise, {{instead(thicker.style, now.style), then.rise}}};
  if (now.tilt == 0)
    for (const Carrier point : {Carrier::tracer, Carrier::pen}) {
      SagConditions resting = now;
      (point == Carrier::tracer ? resting.tracer_rests : resting.pen_rests) = true;
      const LayersDo rested = layers_do(of, resting);
      const std::string words =
          fmt::format("the {} resting on the table", point == Carrier::tracer ? "tracer" : "pen");
      in_plane.changes.push_back({words, rested.in_plane});
      down.changes.push_back({words, rested.rise});
    }
  if (here.in_plane > no_drop) entries.push_back(std::move(in_plane));
  if (here.rise > no_drop) entries.push_back(std::move(down));
  return true;
}

void add_sag(const Measured& of, std::vector<BudgetEntry>& entries) {
  const SagConditions now = sag_conditions(spec_of(of.design), of.design.layers);
  const WorstDrop weight = worst_drop(of, now, &Drop::by_weight), tilt = worst_drop(of, now, &Drop::by_play);
  if (!std::isfinite(weight.drop) || !std::isfinite(tilt.drop)) return;
  const SagConditions thicker = with_next_thickness(now);
  const SagConditions resting = [&] {
    SagConditions other = now;
    (weight.point == Carrier::tracer ? other.tracer_rests : other.pen_rests) = true;
    return other;
  }();
  const auto rest = [&](PartOfDrop part) {
    const char* point = weight.point == Carrier::tracer ? "tracer" : "pen";
    return BudgetChange{fmt::format("the {} resting on the table", point),
                        worst_drop(of, resting, part).drop};
  };
  const bool is_level = now.tilt == 0;  // on a tilted table little holds down what rests
  BudgetEntry by_weight{
      ErrorSource::weight,
      weight.drop,
      {{instead(thicker.style, now.style), worst_drop(of, thicker, &Drop::by_weight).drop}}};
  if (is_level) by_weight.changes.push_back(rest(&Drop::by_weight));
  if (weight.drop > no_drop) entries.push_back(std::move(by_weight));
  if (!(tilt.drop > no_drop)) return;
  SagConditions gripped = now;
  gripped.grip *= 2;
  BudgetEntry by_play{
      ErrorSource::tilt,
      tilt.drop,
      {{fmt::format("pins gripped over {:.3g} mm instead of {:.3g} mm", gripped.grip, now.grip),
        worst_drop(of, gripped, &Drop::by_play).drop}}};
  if (is_level) by_play.changes.push_back(rest(&Drop::by_play));
  entries.push_back(std::move(by_play));
}

/// Share of a source's error: a change that takes less of it away is not worth a new part.
constexpr double least_gain = 0.05;

/// Changes that help, the best first; entries in the order of ErrorBudget.
void put_in_order(std::vector<BudgetEntry>& entries) {
  for (BudgetEntry& entry : entries) {
    std::erase_if(entry.changes, [&](const BudgetChange& change) {
      return !(change.after < (1 - least_gain) * entry.error);
    });
    std::stable_sort(entry.changes.begin(), entry.changes.end(),
                     [](const BudgetChange& a, const BudgetChange& b) { return a.after < b.after; });
  }
  std::stable_sort(entries.begin(), entries.end(), [](const BudgetEntry& a, const BudgetEntry& b) {
    const bool a_in_plane = is_in_plane(a.source), b_in_plane = is_in_plane(b.source);
    return a_in_plane != b_in_plane ? a_in_plane : a.error > b.error;
  });
}

double gain_of(const BudgetEntry& entry) {
  return entry.changes.empty() ? 0 : entry.error - entry.changes.front().after;
}

}  // namespace

bool is_in_plane(ErrorSource source) { return source < ErrorSource::weight; }

std::string_view name(ErrorSource source) {
  constexpr std::string_view names[] = {"lengths",    "play",   "load", "pins", "layers",
                                        "own weight", "weight", "tilt", "pull"};
  return names[static_cast<std::size_t>(source)];
}

double ErrorBudget::sum(bool in_plane) const {
  double sum = 0;
  for (const BudgetEntry& entry : entries)
    if (is_in_plane(entry.source) == in_plane) sum += entry.error;
  return sum;
}

double ErrorBudget::beyond_the_links() const {
  double sum = 0;
  for (const BudgetEntry& entry : entries)
    if (entry.source == ErrorSource::pins || entry.source == ErrorSource::layers ||
        entry.source == ErrorSource::own_weight)
      sum += entry.error;
  return sum;
}

bool ErrorBudget::has_own_weight() const {
  return std::any_of(entries.begin(), entries.end(),
                     [](const BudgetEntry& entry) { return entry.source == ErrorSource::own_weight; });
}

const BudgetEntry* ErrorBudget::most_helpful(bool in_plane) const {
  const BudgetEntry* best = nullptr;
  for (const BudgetEntry& entry : entries)
    if (is_in_plane(entry.source) == in_plane && gain_of(entry) > (best ? gain_of(*best) : 0)) best = &entry;
  return best;
}

std::string_view ErrorBudget::help_out_of_plane() const {
  const BudgetEntry* entry = most_helpful(false);
  return entry != nullptr && entry->source == ErrorSource::pull ? "against what the load lifts or lowers"
                                                                : "against sinking";
}

bool ErrorBudget::pulls() const {
  return std::any_of(entries.begin(), entries.end(),
                     [](const BudgetEntry& entry) { return entry.source == ErrorSource::pull; });
}

std::optional<ErrorBudget> error_budget(const Design& design) {
  const auto openings = openings_over(design.linkage, design.region);
  if (!design.load || !design.material || !openings || openings->empty()) return std::nullopt;
  const Measured of{design, *openings};
  ErrorBudget budget;
  add_tolerances(of, budget.entries);
  budget.entries.push_back(load_entry(of));
  budget.entries.push_back(pins_entry(of));
  budget.states_layers = add_layers(of, budget.entries);
  add_own_weight(of, budget.entries);
  add_sag(of, budget.entries);
  put_in_order(budget.entries);
  return budget;
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
