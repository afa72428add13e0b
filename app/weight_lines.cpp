#include "app/weight_lines.hpp"

#include <fmt/format.h>

#include <utility>

#include "geometry/fixed_text.hpp"
#include "synthesis/design/error_budget.hpp"
#include "synthesis/loads/feel.hpp"
#include "workspace/reach.hpp"

namespace kempe::app {
namespace {

/// A share: an angle read in degrees is upright but for rounding.
constexpr double angle_rounding = 1e-12;

bool stands_upright(const Design& design) {
  return design.load && design.load->tilt > pi / 2 * (1 - angle_rounding);
}

std::string sag_line(const Design& design) {
  if (!design.quality.sag)
    return design.material && openings_over(design.linkage, design.region)
               ? "sag          not stated: two joints of a link are so near each other that its equations "
                 "lose "
                 "their digits\n"
               : "";
  const bool plays = design.tolerance && design.tolerance->play > 0;
  const std::string allowed = design.limits.sag ? fmt::format(" (limit {:.4g} mm)", *design.limits.sag) : "";
  if (stands_upright(design))
    return plays ? fmt::format(
                       "sag          {:.4g} mm at most at tracer and pen, at right angles to the table, by "
                       "play{}\n",
                       *design.quality.sag, allowed)
                 : "sag          none: on an upright table nothing sinks by its weight\n";
  const double sag = *design.quality.sag > no_drop ? *design.quality.sag : 0;
  return fmt::format("sag          {:.4g} mm at most at tracer and pen, by weight{}{}\n", sag,
                     plays ? " and play" : "", allowed);
}

std::string balance_lines(const Feel& feel, double tilt) {
  std::string text = fmt::format(
      "weight       the hand holds up to {:.3g} N of weight besides, on the table tilted by {:.4g} degrees\n",
      feel.weight_most, degrees(tilt));
  text += "balance      " + words(feel.counterweights[0]) + "\n             " +
          words(feel.counterweights[1]) + "\n";
  if (feel.springs)
    text +=
        "  or springs " + words((*feel.springs)[0]) + "\n             " + words((*feel.springs)[1]) + "\n";
  return text;
}

/// "0.52 mm at worst: lengths 0.4, play 0.11, load 0.01, pins 0.001"
std::string parts_of(const ErrorBudget& budget, bool in_plane) {
  std::string text;
  for (const BudgetEntry& entry : budget.entries)
    if (is_in_plane(entry.source) == in_plane)
      text += fmt::format("{} {} {:.3g}", text.empty() ? "" : ",", name(entry.source), entry.error);
  return fmt::format("{:.3g} mm at worst:{}", budget.sum(in_plane), text);
}

/// "VA to ±0.025 mm (0.53 -> 0.48 mm)"; "" for none.
std::string help_words(const std::optional<BestChange>& best) {
  if (!best) return "";
  return fmt::format("{}{} ({:.3g} -> {:.3g} mm)", best->change.words,
                     best->change.needs_other_lengths ? ", with other lengths" : "", best->before,
                     best->change.after);
}

}  // namespace

std::string weight_lines(const Design& design) {
  std::string text = sag_line(design);
  if (!design.material || !design.load) return text;
  const auto openings = openings_over(design.linkage, design.region);
  if (!openings) return text;
  const Feel feel =
      feel_over(design.linkage, design.style, design.hardware, *design.material, *design.load, *openings);
  text += fmt::format(
      "feel         {:.3g} to {:.3g} kg at the tracer, friction adds up to {:.2g} % to the work\n"
      "             the hand pushes with up to {} N: {}\n",
      feel.mass_least, feel.mass_most, 100 * feel.friction_share, three_digits(feel.hand_most),
      design.load->tilt > 0 ? "work, friction and weight together" : "work and friction together");
  return design.load->tilt > 0 ? text + balance_lines(feel, design.load->tilt) : text;
}

std::string budget_lines(const Design& design) {
  const auto budget = error_budget(design);
  if (!budget) return "";
  const bool tilted = design.load->tilt > 0;
  std::string text = "budget       in the plane " + parts_of(*budget, true) + "\n";
  if (!budget->states_layers)
    text += "             what the layers add is not stated: two joints of a link are too near each other\n";
  if (budget->sum(false) > 0)
    text += fmt::format("             {} {}\n",
                        tilted            ? "at right angles to the table"
                        : budget->pulls() ? "down or up"
                                          : "down",
                        parts_of(*budget, false));
  const std::string give = help_words(budget->best_against_give),
                    in_plane = help_words(budget->best_in_plane), down = help_words(budget->best_down);
  auto add = [&, first = true](const std::string& against, const std::string& words) mutable {
    if (words.empty()) return;
    text += fmt::format("             {} {}: {}\n",
                        std::exchange(first, false) ? "with these lengths most would help" : "and", against,
                        words);
  };
  add("against giving way", give);
  if (!budget->is_one_change_for_both()) add("in the plane", in_plane);
  add(std::string(budget->help_out_of_plane()), down);
  return text;
}

}  // namespace kempe::app
