// "Will it be stiff enough?": what the load does to the pen, the hand, pins and links; the whole error in one table, with what would help.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "geometry/fixed_text.hpp"
#include "reports/drawings/overload_words.hpp"
#include "reports/page/charts.hpp"
#include "reports/page/error_pictures.hpp"
#include "reports/page/html_table.hpp"
#include "reports/page/sections.hpp"
#include "reports/pictures/html_text.hpp"
#include "specs/hardware.hpp"
#include "synthesis/design/error_budget.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/plane_weight.hpp"
#include "synthesis/loads/strength.hpp"
#include "synthesis/loads/top_over.hpp"
#include "workspace/reach.hpp"

namespace kempe::report_sections {
namespace {

std::string force_words(double force) { return force_text(with_three_digits(force), 3); }

/// "30 N at the pen"; on a tilted table "30 N and 29.4 N of weight at the pen".
std::string pull_words(const Load& load) {
  const double weight = most_force_at_pen(load) - load.pen_force;
  return force_words(load.pen_force) + (weight > 0 ? " and " + force_words(weight) + " of weight" : "") +
         " at the pen";
}

std::string section_text(const LinkStyle& style) {
  return fmt::format("{}\u00a0×\u00a0{}", figure_text(style.width, 2), figure_text(style.thickness, 2));
}

/// Plain words for a page: figures do not part from their units.
std::string in_html(const std::string& words) {
  std::string html = html_escaped(words);
  for (const auto& [plain, kept] : {std::pair{" x ", "\u00a0×\u00a0"}, std::pair{" mm", "\u00a0mm"}})
    for (std::size_t at = 0; (at = html.find(plain, at)) != std::string::npos; at += std::strlen(kept))
      html.replace(at, std::strlen(plain), kept);
  return html;
}

bool is_tilted(const Design& design) { return gravity_along(design.load->tilt) > 0; }

std::string source_words(const Design& design, ErrorSource source) {
  switch (source) {
    case ErrorSource::lengths: return "Lengths, ±" + length_text(design.tolerance->length);
    case ErrorSource::play: return "Play, " + length_text(design.tolerance->play) + " in each pin";
    case ErrorSource::load: return "Links, bent by " + pull_words(*design.load);
    case ErrorSource::pins: return "Pins, bent between their layers";
    case ErrorSource::layers: return "Layers: links bent out of the plane";
    case ErrorSource::own_weight: return "The links' own weight along the table";
    case ErrorSource::weight: return "Weight";
    case ErrorSource::tilt: return "Tilt: pins within their play";
    case ErrorSource::pull: break;
  }
  return fmt::format("Pull: what {} lifts or lowers by the links' layers",
                     is_tilted(design) ? "the load, with the links' own weight," : "the load");
}

std::string change_words(const BudgetChange& change) {
  return in_html(change.words) + (change.needs_other_lengths ? ", with other lengths" : "");
}

std::string changes_text(const BudgetEntry& entry) {
  std::string text;
  for (const BudgetChange& change : entry.changes)
    text += fmt::format("{}{}: {} → {}", text.empty() ? "" : "<br>or ", change_words(change),
                        error_length(entry.error), error_length(change.after));
  return text;
}

/// The entries of one direction with their sum.
void add_rows(const Design& design, const ErrorBudget& budget, bool in_plane,
              std::vector<std::vector<std::string>>& rows) {
  const double sum = budget.sum(in_plane);
  bool any = false;
  for (const BudgetEntry& entry : budget.entries) {
    if (is_in_plane(entry.source) != in_plane) continue;
    any = true;
    const double share = sum > 0 ? entry.error / sum : 0;
    rows.push_back({html_escaped(source_words(design, entry.source)) + share_bar(share),
                    error_text(entry.error), figure_text(100 * share, 1), changes_text(entry)});
  }
  if (any)
    rows.push_back({in_plane            ? "<b>In the plane, all together</b>"
                    : is_tilted(design) ? "<b>At right angles to the table, all together</b>"
                    : budget.pulls()    ? "<b>Down or up, all together</b>"
                                        : "<b>Down, all together</b>",
                    "<b>" + error_text(sum) + "</b>", "100", ""});
}

std::string budget_table(const Design& design, const ErrorBudget& budget) {
  std::vector<std::vector<std::string>> rows;
  add_rows(design, budget, true, rows);
  add_rows(design, budget, false, rows);
  return html_table(
      "budget", {{"Source, and its share"}, {"At worst, mm", true}, {"Share, %", true}, {"What would help"}},
      rows);
}

/// How far the pen gives way in all and by the links alone, "under 30 N at the pen it gives way by ..."; of the links alone where what the
/// layers add is not stated.
std::string give_figure(const Design& design) {
  const std::string links = error_length(design.quality.loads->error_max);
  const std::string worst = "in the worst direction at the worst place of the region";
  const auto whole = give_in_all(design.quality);
  return whole ? fmt::format("under {} it gives way by <b>{}</b> {}, with {}; by its links alone by {}",
                             pull_words(*design.load), error_length(*whole), worst, beside_the_links(design),
                             links)
               : fmt::format("under {} it gives way by <b>{}</b> {}, by its links alone",
                             pull_words(*design.load), links, worst);
}

/// Yes or no where there is a limit; else how much of the whole error it is.
std::string give_verdict(const Design& design, const ErrorBudget& budget) {
  const std::string figure = give_figure(design);
  if (const auto& limit = design.limits.load_error) {
    const bool in_all = design.limits.load_error_in_all;
    const std::string text =
        fmt::format("{}; {} are allowed{}.", figure, limit_text(*limit), in_all ? " in all" : "");
    const double counted =
        in_all ? give_in_all(design.quality).value_or(infinity) : design.quality.loads->error_max;
    if (!(counted <= *limit * (1 + 1e-9))) return "No: " + text;
    if (!budget.states_layers)
      return "By links and pins yes; what the layers add is not stated, for two joints of a link are too "
             "near "
             "each other: " +
             text;
    if (!gives_too_far_in_all(design)) return "Yes: " + text;
    return fmt::format(
        "By the links alone yes, with {} no: {} That limit, limits.load_error_mm, speaks of the links alone, "
        "unless limits.load_error_in_all is true.",
        beside_the_links(design), text);
  }
  const auto whole = give_in_all(design.quality);
  if (!design.tolerance || !whole) return fmt::format("U{}.", figure.substr(1));
  const double sum = budget.sum(true);
  return fmt::format("U{}. That is {} % of the whole error in the plane, {} at worst.", figure.substr(1),
                     figure_text(100 * *whole / sum, 1), error_length(sum));
}

/// What the load does beside weight and play, which the sag does not have.
std::string pull_verdict(const Design& design, const ErrorBudget& budget) {
  const auto& layered = design.quality.layered;
  if (!layered || !(layered->rise_max > no_drop)) return "";
  const std::string by_weight =
      layered->weight_rise_max && *layered->weight_rise_max > no_drop
          ? fmt::format(", the links' own weight along the table by up to <b>{}</b> more",
                        error_length(*layered->weight_rise_max))
          : "";
  const std::string in_all =
      design.limits.sag && design.quality.sag
          ? fmt::format(" All together that is up to {}; the limit speaks of weight and play alone.",
                        error_length(budget.sum(false)))
          : "";
  return fmt::format(
      " The load lifts or lowers pen or tracer by up to <b>{}</b>, by the layers of the links{}.{}",
      error_length(layered->rise_max), by_weight, in_all);
}

std::string sag_verdict(const Design& design) {
  if (!design.quality.sag)
    return " How far pen or tracer sinks is not stated: two joints of a link are too near each other.";
  const double sag = *design.quality.sag;
  const auto& limit = design.limits.sag;
  const bool tilted = is_tilted(design);
  if (sag <= no_drop)
    return tilted ? " Neither pen nor tracer leaves its plane by weight or play."
                  : " Neither pen nor tracer sinks by weight or play.";
  const bool weighs = gravity_across(design.load->tilt) > 0;
  const std::string figure = fmt::format("en or tracer {} by up to <b>{}</b> by {}",
                                         tilted ? "moves at right angles to the table" : "sinks",
                                         error_length(sag), weighs ? "weight and play" : "play");
  return limit ? fmt::format(" {}: {}, p{}; {} are allowed.", tilted ? "Out of the plane" : "Down",
                             sag <= *limit * (1 + 1e-9) ? "yes" : "no", figure, limit_text(*limit))
               : fmt::format(" P{}: the spec sets no limit on this (limits.sag_mm).", figure);
}

std::string best_text(const std::optional<BestChange>& best) {
  if (!best) return {};
  return fmt::format("{}: {} → {}", change_words(best->change), error_length(best->before),
                     error_length(best->change.after));
}

std::string what_helps(const ErrorBudget& budget) {
  const std::string give = best_text(budget.best_against_give), in_plane = best_text(budget.best_in_plane),
                    down = best_text(budget.best_down);
  std::string text;
  const auto add = [&](std::string_view against, const std::string& words) {
    if (!words.empty())
      text += fmt::format("{} {}: {}", text.empty() ? "What would help most" : ";", against, words);
  };
  add("against giving way", give);
  if (!budget.is_one_change_for_both()) add("against the whole error in the plane", in_plane);
  add(budget.help_out_of_plane(), down);
  return text.empty() ? text : "<p>" + text + ", all with these lengths.</p>\n";
}

/// What breaks, buckles or bends beyond small bending, before all else.
std::string overload(const Design& design) {
  std::string html;
  const auto add = [&](const std::string& words) {
    html += "<li><b class=\"bad\">" + html_escaped(words) + "</b></li>";
  };
  for (const std::string& words : overload_words(design)) add(words);
  if (const auto words = large_bending_words(design)) add(*words);
  return html.empty() ? html : "<ul>" + html + "</ul>\n";
}

std::string verdict(const Design& design, const ErrorBudget& budget) {
  return overload(design) + "<p class=\"lead\">" + give_verdict(design, budget) + sag_verdict(design) +
         pull_verdict(design, budget) + "</p>\n" + what_helps(budget);
}

std::string share_of_strength(double stress, double strength, const std::string& material) {
  if (!std::isfinite(stress)) return "<b class=\"bad\">the hole leaves nothing</b>";
  if (stress > strength)
    return fmt::format("<b class=\"bad\">{} MPa; {} bears {}</b>", figure_text(stress, 1), material,
                       figure_text(strength, 1));
  const double times = strength / stress;
  if (times > 10000)
    return fmt::format("{} MPa; {} bears more than {} times as much", figure_text(stress, 2), material,
                       count_text(10000));
  return fmt::format("{} MPa; {} bears {} times as much", figure_text(stress, stress < 10 ? 2 : 1), material,
                     number_text(times, times < 10 ? 1 : 0));
}

struct WorstForces {
  PinForces pins;              ///< N
  LinkStresses stresses;       ///< MPa
  bool counts_layers = false;  ///< with bending and twist out of the plane
};

WorstForces worst_forces(const Design& design, const OpeningInterval& openings) {
  const CopyingLinkage& linkage = design.linkage;
  const BarLengths lengths{linkage.VA(), linkage.VB()};
  const double hole = widest_hole(design.style, design.hardware, design.cutting),
               force = most_force_at_pen(*design.load);
  const PlaneWeight weight(linkage.k(), linkage.grounding(), design.style, *design.material,
                           design.load->tilt);
  const auto pins = [&](double opening) {
    return force * pin_forces(linkage.k(), linkage.grounding(), opening) +
           weight.pin_forces(lengths, opening);
  };
  const auto stresses = [&](double opening) {
    return force * link_stresses(linkage.k(), linkage.grounding(), design.style, hole, lengths, opening) +
           weight.stresses(lengths, opening, hole);
  };
  const auto worst = [&](auto figure) { return figure(top_over(openings, figure)); };
  WorstForces all;
  all.pins = {.A = worst([&](double d) { return pins(d).A; }),
              .B = worst([&](double d) { return pins(d).B; }),
              .C = worst([&](double d) { return pins(d).C; }),
              .V = worst([&](double d) { return pins(d).V; }),
              .pole = worst([&](double d) { return pins(d).pole; })};
  all.stresses = {.VA = worst([&](double d) { return stresses(d).VA; }),
                  .VB = worst([&](double d) { return stresses(d).VB; }),
                  .ACX = worst([&](double d) { return stresses(d).ACX; }),
                  .BCY = worst([&](double d) { return stresses(d).BCY; })};
  const SagConditions conditions = sag_conditions(spec_of(design), design.layers);
  const auto layered = LayeredErrorProfile(linkage.k(), linkage.grounding(), conditions, force)
                           .stresses_over(lengths, openings, hole);
  if (layered) all.stresses = *layered;
  all.counts_layers = layered.has_value();
  return all;
}

std::string forces_table(const Design& design, const OpeningInterval& openings) {
  const WorstForces worst = worst_forces(design, openings);
  const double strength = design.material->strength;
  const bool weighs = gravity_along(design.load->tilt) > 0;
  std::vector<std::vector<std::string>> rows{
      {"Hand, at the tracer", force_words(design.quality.loads->hand_force_max),
       weighs ? "the same everywhere; weight and friction come on top"
              : "the same everywhere; friction comes on top"},
      {"Pole's post", force_words(worst.pins.pole),
       weighs ? "with the links' own weight, which depends on the opening" : "the same everywhere"},
      {"Pins A and B", force_words(std::max(worst.pins.A, worst.pins.B)),
       "grows as VA and VB come into line"},
      {"Pin C", force_words(worst.pins.C), "grows as VA and VB come into line"}};
  const LinkStresses& stress = worst.stresses;
  for (const auto& [link, value] : {std::pair{"Link VA", stress.VA}, std::pair{"Link VB", stress.VB},
                                    std::pair{"Link ACX", stress.ACX}, std::pair{"Link BCY", stress.BCY}})
    rows.push_back({link, "", share_of_strength(value, strength, html_escaped(design.material->name))});
  const double push = largest_push_in_bars(design), buckling = buckling_load_of_bars(design);
  const std::string bears = "buckle at " + force_words(buckling);
  rows.push_back(
      {"Bars, pushed", force_words(push), push > buckling ? "<b class=\"bad\">" + bears + "</b>" : bears});
  const std::string note =
      !std::isfinite(design.quality.loads->stress_max) ? "A hole leaves nothing of one of the links."
      : worst.counts_layers
          ? fmt::format(
                "Stress in the links: bending and pull in the plane, which alone come to {} MPa at most, and "
                "bending and twist out of it by layers and weights, on what the joints' holes leave of the "
                "section. Peaks at the edges of the holes are not in it.",
                figure_text(design.quality.loads->stress_max, 2))
          : "Stress in the links: bending and pull in the plane alone, on what the joints' holes leave of "
            "the section; what bends them out of it is not stated, for two joints of a link are too near "
            "each other.";
  const std::string own_weight =
      weighs
          ? " Post, pins, bars and links bear the links' own weight along the table too, as it pulls in the "
            "worst direction, whether the region uses that or not. What the hand holds with weight and "
            "friction stands under weight, balance and feel."
          : "";
  return html_table("budget", {{"What bears, at worst"}, {"Force", true}, {"Stress, or how it varies"}},
                    rows) +
         "<p class=\"note\">" + note + own_weight + "</p>\n";
}

/// With pins and layers, and of the links alone, for which the limit holds; where what the layers add is not stated, of the links alone in two
/// directions.
std::string load_chart(const Design& design, const OpeningInterval& used) {
  const CopyingLinkage& linkage = design.linkage;
  const LoadErrorProfile links(linkage.k(), linkage.grounding(), design.style, *design.material,
                               most_force_at_pen(*design.load));
  const ErrorCourse course(design);
  const bool states_layers = design.quality.layered.has_value();
  CopyErrorChart chart{{}, used, design.limits.load_error};
  chart.title = "How far the pen gives way over the opening";
  chart.y_name = "gives way, mm";
  chart.worst_name = states_layers ? "with " + beside_the_links(design) : "by the links, worst direction";
  chart.rss_name = states_layers ? "by the links alone" : "stiffest direction";
  chart.limit_name = design.limits.load_error_in_all ? "limit" : "limit, of the links alone";
  constexpr int steps = 120;
  for (int i = 0; i <= steps && design.opening.width() > 0; ++i) {
    const double opening = design.opening.lower + design.opening.width() * i / steps;
    const LoadErrorAt alone = links.at({linkage.VA(), linkage.VB()}, opening);
    const double most = states_layers ? course.give(opening) : alone.worst;
    if (std::isfinite(most)) chart.rows.push_back({opening, most, states_layers ? alone.worst : alone.least});
  }
  return copy_error_chart(chart);
}

}  // namespace

std::string loads(const Design& design) {
  if (!design.quality.loads || !design.load || !design.material) return {};
  const auto used = openings_over(design.linkage, design.region);
  if (!used) return {};
  const auto budget = error_budget(design);
  if (!budget) return {};
  std::string note = fmt::format(
      "<p class=\"note\">Links of {}, {} mm, as slender beams, pins of steel; in the plane with pole and "
      "tracer held. {}Each source alone at its worst place, so that a sum is no less than what its sources "
      "do together at any one "
      "place. Each change is judged alone, with the lengths as they are. To try one, give these lengths "
      "under [mechanism], change links.width_mm, links.thickness_mm, links.pin_diameter_mm, load.grip_mm "
      "or load.rests, and run kempe workspace; a new search may find other lengths. “With other lengths” "
      "stands beside a change with which these lengths would break another limit, so that parts touch, "
      "say.{}</p>\n",
      html_escaped(design.material->name), section_text(design.style),
      design.style.plate == PlateStyle::triangle
          ? "Triangular plates are taken as two arms: they are stiffer. "
          : "",
      !design.tolerance ? " The spec gives no tolerance: neither lengths nor play are in the table."
      : design.quality.copy_error_at_corner
          ? " A better length or pin by itself has no key: it is for the maker. Lengths and play are taken "
            "to the first "
            "order, which understates them here: see the tolerance budget."
          : " A better length or pin by itself has no key: it is for the maker.");
  const std::string html = verdict(design, *budget) + budget_table(design, *budget) + note +
                           error_pictures(design) + "<div class=\"columns\"><div>" +
                           forces_table(design, *used) + "</div><div>" + load_chart(design, *used) +
                           "</div></div>\n";
  return html_section("loads", "Will it be stiff enough?", html);
}

}  // namespace kempe::report_sections
