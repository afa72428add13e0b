// What the tolerances cost: the budget of the copy error, source by source, and its course over the opening.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/drawings/tolerance_words.hpp"
#include "reports/page/charts.hpp"
#include "reports/page/html_table.hpp"
#include "reports/page/sections.hpp"
#include "reports/pictures/html_text.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe::report_sections {
namespace {

/// The openings between the region's nearest and farthest place.
OpeningInterval openings_used(const Design& design) {
  if (design.region.empty()) return {};
  const DistanceRange reach = distance_range(design.region, design.linkage.pole());
  const auto one = design.linkage.opening_at(reach.nearest),
             other = design.linkage.opening_at(reach.farthest);
  if (!one || !other) return {};
  return {std::min(*one, *other), std::max(*one, *other)};
}

std::string course_over_opening(const Design& design, const CopyTolerance& tolerance) {
  const CopyErrorProfile profile = copy_error_profile(design.linkage, tolerance);
  CopyErrorChart chart{{}, openings_used(design), design.limits.copy_error};
  constexpr int steps = 120;
  for (int i = 0; i <= steps && design.opening.width() > 0; ++i) {
    const double opening = design.opening.lower + design.opening.width() * i / steps;
    const CopyErrorAt error = profile.at(opening);
    if (std::isfinite(error.worst)) chart.rows.push_back({opening, error.worst, error.rss});
  }
  return copy_error_chart(chart);
}

std::string budget_table(const CopyErrorOver& over) {
  std::vector<SourceContribution> sources = over.sources;
  std::erase_if(sources, [](const SourceContribution& source) { return source.tolerance == 0; });
  std::stable_sort(sources.begin(), sources.end(),
                   [](const auto& a, const auto& b) { return a.worst > b.worst; });
  std::vector<std::vector<std::string>> rows;
  for (const SourceContribution& source : sources)
    rows.push_back({html_escaped(source.name) + share_bar(source.worst / sources.front().worst),
                    "±" + figure_text(source.tolerance, 4), figure_text(source.worst, 4),
                    figure_text(source.distortion_worst, 4)});
  return html_table(
      "budget",
      {{"Source, and its share"}, {"Off by, mm", true}, {"Moves the pen, mm", true}, {"Distorts, mm", true}},
      rows);
}

/// Lengths and pins, whichever of them err.
std::string what_errs(const Tolerance& tolerance) {
  const std::string lengths = "Lengths to ±" + length_text(tolerance.length),
                    play = length_text(tolerance.play) + " of play (half of it to each side)";
  if (tolerance.play == 0) return tolerance.length == 0 ? "No tolerances" : lengths + ", pins without play";
  return tolerance.length == 0 ? "Lengths as drawn, pins with " + play : lengths + ", pins with " + play;
}

std::string what_is_absorbed(const CopyErrorOver& over) {
  return fmt::format(
      "<p class=\"note\">A slightly different scale (by up to {1}\u202f%), rotation (by up to {2}) and "
      "origin absorb part of the worst "
      "case of {0}; {3} are left as distortion. The worst place is with the tracer at ({4}, {5}).</p>\n",
      length_text(over.worst, 4), figure_text(100 * over.scale_worst, 3),
      figure_text(degrees(over.rotation_worst), 3) + "°", length_text(over.distortion_worst, 4),
      number_text(over.worst_at.x(), 1), number_text(over.worst_at.y(), 1));
}

}  // namespace

std::string tolerance(const Design& design) {
  if (!design.tolerance) return {};
  const CopyTolerance tolerance = CopyTolerance::uniform(*design.tolerance);
  std::string html = fmt::format(
      "<p class=\"note\">{}. Each source alone, at the place of the region where its effect is "
      "largest.</p>\n",
      what_errs(*design.tolerance));
  std::string beyond;
  for (const std::string& words : tolerance_words(design)) beyond += "<li>" + html_escaped(words) + "</li>";
  if (!beyond.empty()) html += "<ul class=\"note\">" + beyond + "</ul>\n";
  std::string table, absorbed;
  if (const auto over = copy_error_over(design.linkage, tolerance, design.region)) {
    table = budget_table(*over);
    absorbed = what_is_absorbed(*over);
  }
  html += "<div class=\"columns\"><div>" + table + "</div><div>" + course_over_opening(design, tolerance) +
          absorbed + "</div></div>\n";
  return html_section("tolerance", "Tolerance budget", html);
}

}  // namespace kempe::report_sections
