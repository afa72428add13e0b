// "Weight, balance and feel": how far tracer and pen sink, friction, the mass felt, and what balances a tilted table.
#include <fmt/format.h>

#include <cmath>

#include "reports/page/html_table.hpp"
#include "reports/page/sections.hpp"
#include "reports/pictures/html_text.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/loads/feel.hpp"
#include "synthesis/loads/sag.hpp"
#include "workspace/reach.hpp"

namespace kempe::report_sections {
namespace {

using WeightRows = std::vector<std::vector<std::string>>;

std::string three_digits(double value, std::string_view unit) {
  return fmt::format("{:.3g}\u00a0{}", value, unit);
}

/// N: what bears no more does not rest, but for rounding.
constexpr double no_force = 1e-9;

std::string drop_words(const Drop& drop, double bears) {
  if (bears > no_force)
    return fmt::format("rests on the table, which bears {} there", three_digits(bears, "N"));
  return fmt::format("{} by weight, up to {} by play", length_text(drop.by_weight),
                     length_text(drop.by_play));
}

void add_sag(const Design& design, const OpeningInterval& openings, WeightRows& rows) {
  const LargestDrops sag =
      largest_drops(design.linkage, sag_conditions(spec_of(design), design.layers), openings);
  if (!std::isfinite(sag.pen.most()) || !std::isfinite(sag.tracer.most())) {
    rows.push_back({"Pen and tracer sink", "not stated",
                    "two joints of a link are so near each other that the equations lose their digits"});
    return;
  }
  const Drop& pen = sag.pen.pen;
  const Drop& tracer = sag.tracer.tracer;
  rows.push_back({"The pen sinks", length_text(pen.total()), drop_words(pen, sag.pen.pen_bears)});
  rows.push_back(
      {"The tracer sinks", length_text(tracer.total()), drop_words(tracer, sag.tracer.tracer_bears)});
}

std::string lock_words(const Feel& feel, const CopyingLinkage& linkage) {
  if (feel.friction_share >= 1) return "as much as the work itself: it is about to lock";
  const OpeningInterval all = linkage.openings_with_transmission(0);
  const bool lower = feel.without_lock.lower > all.lower, upper = feel.without_lock.upper < all.upper;
  if (!lower && !upper) return "it locks nowhere in this assembly mode";
  if (!lower)
    return fmt::format("it would lock beyond an opening of {}", angle_text(feel.without_lock.upper));
  if (!upper) return fmt::format("it would lock below an opening of {}", angle_text(feel.without_lock.lower));
  return fmt::format("it would lock outside openings of {} to {}", angle_text(feel.without_lock.lower),
                     angle_text(feel.without_lock.upper));
}

void add_balance(const Feel& feel, double tilt, WeightRows& rows) {
  rows.push_back({fmt::format("Weight on the table at {}", angle_text(tilt)),
                  three_digits(feel.weight_most, "N"), "what the hand holds at the worst place, unbalanced"});
  rows.push_back(
      {"Counterweights", "", words(feel.counterweights[0]) + ";<br>" + words(feel.counterweights[1])});
  if (feel.springs)
    rows.push_back({"Or springs of zero free length", "",
                    words((*feel.springs)[0]) + ";<br>" + words((*feel.springs)[1])});
}

}  // namespace

std::string weight(const Design& design) {
  const auto openings = openings_over(design.linkage, design.region);
  if (!design.material || !design.load || !openings || openings->empty()) return {};
  WeightRows rows;
  add_sag(design, *openings, rows);
  const Feel feel =
      feel_over(design.linkage, design.style, design.hardware, *design.material, *design.load, *openings);
  rows.push_back({"Friction in the pins", fmt::format("{:.2g} %", 100 * feel.friction_share),
                  "most that it adds to the work at the pen; " + lock_words(feel, design.linkage)});
  rows.push_back({"Mass felt at the tracer",
                  fmt::format("{:.3g} to {}", feel.mass_least, three_digits(feel.mass_most, "kg")),
                  "in the lightest and the heaviest direction over the region"});
  const bool tilted = design.load->tilt > 0;
  rows.push_back(
      {"The hand pushes with", three_digits(feel.hand_most, "N"),
       tilted ? "at most: work, friction and weight together" : "at most: work and friction together"});
  if (tilted) add_balance(feel, design.load->tilt, rows);
  return html_section("weight", "Weight, balance and feel",
                      html_table("budget", {{"What"}, {"Figure", true}, {"What it says"}}, rows));
}

}  // namespace kempe::report_sections
