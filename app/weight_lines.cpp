#include "app/weight_lines.hpp"

#include <fmt/format.h>

#include "geometry/fixed_text.hpp"
#include "synthesis/design/error_budget.hpp"
#include "synthesis/loads/feel.hpp"
#include "workspace/reach.hpp"

namespace kempe::app {
namespace {

/// Shares: an angle read in degrees is upright, and a limit is kept, but for rounding.
constexpr double angle_rounding = 1e-12, load_limit_rounding = 1e-9;

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
  if (stands_upright(design))
    return plays ? fmt::format("sag          {:.4g} mm at most at tracer and pen, by play\n",
                               *design.quality.sag)
                 : "sag          none: on an upright table nothing sinks by its weight\n";
  const double sag = *design.quality.sag > no_drop ? *design.quality.sag : 0;
  return fmt::format("sag          {:.4g} mm at most at tracer and pen, by weight{}\n", sag,
                     plays ? " and play" : "");
}

std::string balance_lines(const Feel& feel, double tilt) {
  std::string text = fmt::format(
      "weight       the hand holds up to {:.3g} N besides, on the table tilted by {:.4g} degrees\n",
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

std::string help_words(const BudgetEntry* entry) {
  return entry == nullptr ? ""
                          : fmt::format("{} ({}: {:.3g} -> {:.3g} mm)", entry->changes.front().words,
                                        name(entry->source), entry->error, entry->changes.front().after);
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
  std::string text = "budget       in the plane " + parts_of(*budget, true) + "\n";
  if (!budget->states_layers)
    text += "             what the layers add is not stated: two joints of a link are too near each other\n";
  if (budget->sum(false) > 0)
    text += std::string("             ") + (budget->pulls() ? "down or up " : "down ") +
            parts_of(*budget, false) + "\n";
  if (const auto& limit = design.limits.load_error; limit && design.quality.loads) {
    const double links = design.quality.loads->error_max, beyond = budget->beyond_the_links();
    const double kept = *limit * (1 + load_limit_rounding);
    if (links <= kept && links + beyond > kept)
      text += fmt::format(
          "             limits.load_error_mm speaks of the links alone; with {} the pen gives way by up to "
          "{:.3g} mm\n",
          budget->has_own_weight() ? "pins, layers and the links' own weight" : "pins and layers",
          links + beyond);
  }
  const std::string in_plane = help_words(budget->most_helpful(true)),
                    down = help_words(budget->most_helpful(false));
  if (!in_plane.empty()) text += "             most would help " + in_plane + "\n";
  if (!down.empty())
    text += fmt::format(
        "             {} {}\n",
        in_plane.empty() ? "most would help" : "and " + std::string(budget->help_out_of_plane()), down);
  return text;
}

}  // namespace kempe::app
