// "Will it be stiff enough?": what the load does to the pen, the hand, pins and links; the whole error in one table, with what would help.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/page/charts.hpp"
#include "reports/page/html_table.hpp"
#include "reports/page/error_pictures.hpp"
#include "reports/page/sections.hpp"
#include "reports/pictures/html_text.hpp"
#include "specs/hardware.hpp"
#include "synthesis/loads/pin_compliance.hpp"
#include "synthesis/loads/strength.hpp"
#include "synthesis/loads/top_over.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "workspace/reach.hpp"

namespace kempe::report_sections {
namespace {

/// One part of the error, and the change that takes most of it away.
struct BudgetRow {
  std::string source;
  double error = 0;  ///< mm, at worst
  std::string change{};
  double after = 0;  ///< mm, of this part once it is made
};

/// With three digits.
std::string force_text(double force) {
  const double grain = force > 0 ? std::pow(10, std::floor(std::log10(force)) - 2) : 1;
  return fmt::format("{}\u00a0N", number_text(std::round(force / grain) * grain, 3));
}

std::string small_length(double length) {
  return length_text(length, length < 0.01 ? 5 : length < 0.1 ? 4 : 3);
}

std::string section_text(const LinkStyle& style) {
  return fmt::format("{}\u00a0×\u00a0{}", number_text(style.width, 2), number_text(style.thickness, 2));
}

/// Widths of flat bars as the trade has them, mm (EN 10058, EN 10278).
constexpr double flat_bars[] = {6, 8, 10, 12, 15, 20, 25, 30, 40, 50, 60, 80, 100};

double next_width(double width) {
  const auto* wider = std::find_if(std::begin(flat_bars), std::end(flat_bars),
                                   [&](double one) { return one > 1.05 * width; });
  return wider != std::end(flat_bars) ? *wider : 1.5 * width;
}

double load_error_with(const Design& design, const LinkStyle& style, const OpeningInterval& openings) {
  const CopyingLinkage& linkage = design.linkage;
  return LoadErrorProfile(linkage.k(), linkage.grounding(), style, *design.material, design.load->pen_force)
      .over({linkage.VA(), linkage.VB()}, openings)
      .worst;
}

BudgetRow load_row(const Design& design, const OpeningInterval& openings) {
  LinkStyle wider = design.style;
  wider.width = next_width(wider.width);
  return {fmt::format("Load, {} at the pen", force_text(design.load->pen_force)),
          design.quality.loads->error_max,
          fmt::format("{} instead of {}", section_text(wider), section_text(design.style)),
          load_error_with(design, wider, openings)};
}

/// What pins give between their layers, beside the links.
BudgetRow pins_row(const Design& design, const OpeningInterval& openings) {
  const CopyingLinkage& linkage = design.linkage;
  const auto with_pins = [&](double thicker) {
    LinkStyle style = design.style;
    style.pin_diameter *= thicker;
    const JointHardware hardware = thicker == 1 ? design.hardware : JointHardware();
    const PinCompliance pins = pin_compliance(linkage.grounding(), design.layers, style, hardware);
    return LoadErrorProfile(linkage.k(), linkage.grounding(), style, *design.material, design.load->pen_force,
                            pins)
               .over({linkage.VA(), linkage.VB()}, openings)
               .worst -
           design.quality.loads->error_max;
  };
  constexpr double thicker = 1.25;
  return {"Pins, bent between their layers", with_pins(1),
          fmt::format("pins of {}", length_text(thicker * design.style.pin_diameter, 1)), with_pins(thicker)};
}

/// The worst copy error over the region under these tolerances; 0 where there are none.
double worst_error(const Design& design, const CopyTolerance& tolerance) {
  const auto over = copy_error_over(design.linkage, tolerance, design.region);
  return over ? over->worst : 0;
}

const SourceContribution* largest_of(const std::vector<SourceContribution>& sources, std::size_t from,
                                     std::size_t to) {
  const auto begin = sources.begin() + static_cast<std::ptrdiff_t>(from);
  const auto end = sources.begin() + static_cast<std::ptrdiff_t>(to);
  const auto best =
      std::max_element(begin, end, [](const auto& a, const auto& b) { return a.worst < b.worst; });
  return best == end || best->worst == 0 ? nullptr : &*best;
}

/// Lengths and play, each alone, as the tolerance says.
std::vector<BudgetRow> tolerance_rows(const Design& design) {
  if (!design.tolerance) return {};
  const CopyTolerance all = CopyTolerance::uniform(*design.tolerance);
  const auto over = copy_error_over(design.linkage, all, design.region);
  if (!over || over->sources.size() != error_source_count) return {};
  std::vector<BudgetRow> rows;
  if (const auto* worst = largest_of(over->sources, 0, 8); worst && design.tolerance->length > 0) {
    CopyTolerance better{all.length, {}};
    better.length[static_cast<std::size_t>(worst - over->sources.data())] *= 0.5;
    rows.push_back({fmt::format("Lengths, ±{}", length_text(design.tolerance->length)),
                    worst_error(design, {all.length, {}}),
                    fmt::format("{} to ±{}", worst->name, length_text(0.5 * design.tolerance->length)),
                    worst_error(design, better)});
  }
  if (const auto* worst = largest_of(over->sources, 8, error_source_count);
      worst && design.tolerance->play > 0) {
    CopyTolerance reamed{{}, all.play};
    reamed.play[static_cast<std::size_t>(worst - over->sources.data()) - 8] = 0;
    rows.push_back({fmt::format("Play, {} in each pin", length_text(design.tolerance->play)),
                    worst_error(design, {{}, all.play}),
                    fmt::format("no {}: ream the hole to its pin", worst->name),
                    worst_error(design, reamed)});
  }
  return rows;
}

std::vector<BudgetRow> budget(const Design& design, const OpeningInterval& openings) {
  std::vector<BudgetRow> rows = tolerance_rows(design);
  rows.push_back(load_row(design, openings));
  rows.push_back(pins_row(design, openings));
  std::stable_sort(rows.begin(), rows.end(),
                   [](const BudgetRow& a, const BudgetRow& b) { return a.error > b.error; });
  return rows;
}

double sum_of(const std::vector<BudgetRow>& rows) {
  double sum = 0;
  for (const BudgetRow& row : rows) sum += row.error;
  return sum;
}

const BudgetRow& most_helpful(const std::vector<BudgetRow>& rows) {
  return *std::max_element(rows.begin(), rows.end(), [](const BudgetRow& a, const BudgetRow& b) {
    return a.error - a.after < b.error - b.after;
  });
}

std::string change_text(const BudgetRow& row) {
  return fmt::format("{}: {} → {}", html_escaped(row.change), small_length(row.error),
                     small_length(row.after));
}

std::string load_budget_table(const std::vector<BudgetRow>& rows) {
  const double sum = sum_of(rows);
  std::vector<std::vector<std::string>> cells;
  for (const BudgetRow& row : rows)
    cells.push_back({html_escaped(row.source) + share_bar(row.error / sum), number_text(row.error, 5),
                     number_text(100 * row.error / sum, 1), change_text(row)});
  cells.push_back({"<b>All together, at worst</b>", "<b>" + number_text(sum, 4) + "</b>", "100", ""});
  return html_table(
      "budget",
      {{"Source, and its share"}, {"Moves the pen, mm", true}, {"Share, %", true}, {"What would help"}},
      cells);
}

/// Yes or no where there is a limit; else how much of the whole error it is.
std::string verdict(const Design& design, const std::vector<BudgetRow>& rows) {
  const double error = design.quality.loads->error_max;
  const std::string figure = fmt::format(
      "under {} at the pen it gives way by <b>{}</b> in the worst direction at the worst place of the region",
      force_text(design.load->pen_force), small_length(error));
  std::string text;
  if (const auto& limit = design.limits.load_error)
    text = fmt::format("<p class=\"lead\">{}: {}; {} are allowed.</p>\n",
                       error <= *limit * (1 + 1e-9) ? "Yes" : "No", figure, length_text(*limit));
  else
    text = fmt::format("<p class=\"lead\">U{}{}.</p>\n", figure.substr(1),
                       !design.tolerance ? std::string()
                                         : fmt::format(": {} % of the whole error, {} at worst",
                                                       number_text(100 * error / sum_of(rows), 1),
                                                       small_length(sum_of(rows))));
  const BudgetRow& help = most_helpful(rows);
  return text + fmt::format("<p>What would help most: {}.</p>\n", change_text(help));
}

std::string share_of_strength(double stress, double strength, const std::string& material) {
  if (!std::isfinite(stress)) return "the hole leaves nothing";
  const double times = strength / stress;
  return fmt::format("{} MPa; {} bears {} times as much", number_text(stress, stress < 10 ? 2 : 1), material,
                     number_text(times, times < 10 ? 1 : 0));
}

struct WorstForces {
  PinForces pins;
  LinkStresses stresses;
  double push = 0;  ///< N for each newton, in either bar
};

WorstForces worst_forces(const Design& design, const OpeningInterval& openings) {
  const CopyingLinkage& linkage = design.linkage;
  const double hole = widest_hole(design.style, design.hardware, design.cutting);
  const auto pins = [&](double opening) { return pin_forces(linkage.k(), linkage.grounding(), opening); };
  const auto stresses = [&](double opening) {
    return link_stresses(linkage.k(), linkage.grounding(), design.style, hole, {linkage.VA(), linkage.VB()},
                         opening);
  };
  const auto worst = [&](auto figure) { return figure(top_over(openings, figure)); };
  WorstForces all;
  all.pins = {.A = worst([&](double d) { return pins(d).A; }),
              .B = worst([&](double d) { return pins(d).B; }),
              .C = worst([&](double d) { return pins(d).C; }),
              .V = worst([&](double d) { return pins(d).V; }),
              .pole = pins(openings.lower).pole};
  all.stresses = {.VA = worst([&](double d) { return stresses(d).VA; }),
                  .VB = worst([&](double d) { return stresses(d).VB; }),
                  .ACX = worst([&](double d) { return stresses(d).ACX; }),
                  .BCY = worst([&](double d) { return stresses(d).BCY; })};
  all.push = std::max(all.pins.A, all.pins.B);
  return all;
}

std::string forces_table(const Design& design, const OpeningInterval& openings) {
  const WorstForces worst = worst_forces(design, openings);
  const double force = design.load->pen_force, strength = design.material->strength;
  std::vector<std::vector<std::string>> rows{
      {"Hand, at the tracer", force_text(design.quality.loads->hand_force_max), "the same everywhere"},
      {"Pole's post", force_text(force * worst.pins.pole), "the same everywhere"},
      {"Pins A and B", force_text(force * std::max(worst.pins.A, worst.pins.B)),
       "grows towards the change points"},
      {"Pin C", force_text(force * worst.pins.C), "grows towards the change points"}};
  const LinkStresses& stress = worst.stresses;
  for (const auto& [link, value] : {std::pair{"Link VA", stress.VA}, std::pair{"Link VB", stress.VB},
                                    std::pair{"Link ACX", stress.ACX}, std::pair{"Link BCY", stress.BCY}})
    rows.push_back(
        {link, "", share_of_strength(force * value, strength, html_escaped(design.material->name))});
  const double longest = std::max(design.linkage.VA(), design.linkage.VB());
  rows.push_back(
      {"Bars, pushed", force_text(force * worst.push),
       fmt::format("buckle at {}", force_text(buckling_load(design.style, *design.material, longest)))});
  return html_table("budget", {{"What bears"}, {"Force", true}, {"At worst"}}, rows);
}

std::string load_chart(const Design& design, const OpeningInterval& used) {
  const CopyingLinkage& linkage = design.linkage;
  const LoadErrorProfile profile(linkage.k(), linkage.grounding(), design.style, *design.material,
                                 design.load->pen_force);
  CopyErrorChart chart{{}, used, design.limits.load_error};
  chart.title = "Load error over the opening";
  chart.y_name = "load error, mm";
  chart.worst_name = "worst direction";
  chart.rss_name = "stiffest direction";
  constexpr int steps = 120;
  for (int i = 0; i <= steps && design.opening.width() > 0; ++i) {
    const double opening = design.opening.lower + design.opening.width() * i / steps;
    const LoadErrorAt error = profile.at({linkage.VA(), linkage.VB()}, opening);
    if (std::isfinite(error.worst)) chart.rows.push_back({opening, error.worst, error.least});
  }
  return copy_error_chart(chart);
}

}  // namespace

std::string loads(const Design& design) {
  if (!design.quality.loads || !design.load || !design.material) return {};
  const auto used = openings_over(design.linkage, design.region);
  if (!used) return {};
  const std::vector<BudgetRow> rows = budget(design, *used);
  std::string note = fmt::format(
      "<p class=\"note\">Links of {}, {} mm, as slender beams, pins of steel; in the plane, with pole and "
      "tracer held. "
      "{}Each source alone at its worst place, so the sum is never exceeded.{}</p>\n",
      html_escaped(design.material->name), section_text(design.style),
      design.style.plate == PlateStyle::triangle
          ? "Triangular plates are taken as two arms: they are stiffer. "
          : "",
      design.tolerance ? "" : " The spec gives no tolerance: neither lengths nor play are in the table.");
  const std::string html = verdict(design, rows) + load_budget_table(rows) + note +
                           "<div class=\"columns\"><div>" + error_pictures(design) + "</div><div>" +
                           load_chart(design, *used) + "</div></div>\n" + forces_table(design, *used);
  return html_section("loads", "Will it be stiff enough?", html);
}

}  // namespace kempe::report_sections
