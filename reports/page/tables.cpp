// The report's tables: figures with a line of explanation each.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/drawings/blank.hpp"
#include "reports/drawings/overload_words.hpp"
#include "reports/page/charts.hpp"
#include "reports/page/html_table.hpp"
#include "reports/page/sections.hpp"
#include "reports/pictures/html_text.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/design/error_budget.hpp"
#include "synthesis/loads/gravity.hpp"

namespace kempe::report_sections {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// A point of a front, with a link to its own report.
std::string linked_name(const ParetoRow& row) {
  return fmt::format("<a href=\"{}\">{}</a>", html_escaped(report_of(row)), html_escaped(row.name));
}

std::string objective_text(Objective objective) {
  switch (objective) {
    case Objective::size: return "smallest size";
    case Objective::transmission: return "largest transmission angle";
    case Objective::copy_error: return "smallest copy error";
    case Objective::footprint: return "smallest footprint";
    case Objective::load_error: return "smallest load error";
    case Objective::mass: return "smallest mass";
  }
  return {};
}

std::string objective_value(Objective objective, double value) {
  switch (objective) {
    case Objective::transmission: return angle_text(value, 4);
    case Objective::footprint: return area_text(value);
    case Objective::mass: return fmt::format("{:.4g} kg", value);
    default: return length_text(value, 4);
  }
}

/// A figure of merit beside what was asked for; in red if it falls short.
struct Requirement {
  std::string text = "–";
  bool met = true;
};
Requirement at_least(double value, double limit, const std::string& text) {
  return {"≥ " + text, value >= limit * (1 - 1e-9)};
}
Requirement at_most(double value, const std::optional<double>& limit) {
  return limit ? Requirement{"≤ " + limit_text(*limit), value <= *limit * (1 + 1e-9)} : Requirement{};
}

/// The bound as a sentence: how much better any design could be.
std::string bound_explanation(const Design& design, const std::string& proof_log) {
  if (!design.search) return "No design of any lengths can do better than this.";
  const double value = design.search->value, bound = *design.quality.proven_bound;
  const double share = value != 0 ? std::abs(value - bound) / std::abs(value) * 100 : 0;
  std::string text = fmt::format(
      "Proven: no design for this spec can do better than this figure{}. This one is within {}\u202f% of it.",
      design.limits.load_error ? ", whatever limits.load_error_mm is" : "",
      figure_text(share, share < 1 ? 3 : 1));
  if (!proof_log.empty())
    text += fmt::format(
        " The proof's log is <code>{}</code>; the program kempe_check.py checks it without Kempe.",
        html_escaped(proof_log));
  return text;
}

std::string clearance_explanation(const Design& design) {
  std::string text = "The narrowest gap between two parts while the tracer covers the region";
  if (!design.map.clearance_min_parts.empty())
    text += fmt::format(": {}, with the tracer at ({}, {})", html_escaped(design.map.clearance_min_parts),
                        number_text(design.map.clearance_min_at.x(), 2),
                        number_text(design.map.clearance_min_at.y(), 2));
  return text + ".";
}

/// What robustness promises, and what it costs.
std::string robust_explanation(const Design& design) {
  const Robustness& robust = *design.quality.robust;
  if (!robust.holds)
    return "Not proven: some instrument within the tolerances may not cover the region, or have parts nearer "
           "than required.";
  std::string text =
      "Proven: every instrument within the tolerances covers the region on its one assembly mode, and its "
      "parts keep this.";
  if (!robust.nominal_value || !design.search) return text;
  const double value = design.search->value, without = *robust.nominal_value;
  const bool angle = design.search->objective == Objective::transmission;
  return text + fmt::format(" It costs {}, {}\u202f%: the best design found that need not be robust has {}.",
                            angle ? angle_text(std::abs(value - without), 3)
                                  : objective_value(design.search->objective, std::abs(value - without)),
                            figure_text(100 * std::abs(value - without) / std::abs(without), 1),
                            objective_value(design.search->objective, without));
}

/// The rows of the table of quality, in the page's order.
class QualityRows {
 public:
  explicit QualityRows(const Design& design) : design_(design), quality_(design.quality) {}

  Rows all(const std::string& proof_log) {
    add_size();
    add_transmission();
    add_clearance();
    add_strip();
    add_copy_errors();
    add_load();
    add_mass();
    add_sag();
    add_robustness();
    add_distortion();
    add_footprint();
    add_bound(proof_log);
    return std::move(rows_);
  }

 private:
  void add(const char* what, const std::string& value, const Requirement& required, std::string why) {
    rows_.push_back(
        {what, required.met ? value : "<b class=\"bad\">" + value + "</b>", required.text, std::move(why)});
  }

  void add_size() {
    add("Size", length_text(quality_.size, 3), {},
        "Sum over the four moving links of half the perimeter round their joints; a bar counts its length. "
        "Small is stiff, cheap and light.");
  }

  void add_transmission() {
    add("Smallest transmission angle",
        quality_.transmission_min > 0 ? angle_text(quality_.transmission_min, 3) : "not reached",
        at_least(quality_.transmission_min, design_.limits.transmission,
                 angle_text(design_.limits.transmission)),
        std::string("How far the linkage stays from the positions where it jams or folds over, at the worst "
                    "place of ") +
            (design_.region.empty() ? "its certified opening" : "the region") +
            ". 90° is best, 0° cannot be driven.");
  }

  void add_clearance() {
    if (!std::isfinite(quality_.clearance_min)) return;
    add("Smallest clearance", length_text(quality_.clearance_min, 3),
        at_least(quality_.clearance_min, design_.limits.clearance, limit_text(design_.limits.clearance)),
        clearance_explanation(design_));
  }

  void add_strip() {
    if (!design_.limits.longest_strip) return;
    const double strip = longest_over_ends(design_);
    add("Longest link over its ends", length_text(strip, 2), at_most(strip, design_.limits.longest_strip),
        "The strip that it is cut from: its farthest joints and half its width beyond each.");
  }

  void add_copy_errors() {
    const auto &worst = quality_.copy_error_worst, &at_corner = quality_.copy_error_at_corner;
    if (worst)
      add("Copy error, worst case", length_text(*worst, 4),
          at_most(at_corner.value_or(*worst), design_.limits.copy_error),
          "How far the pen can be off if all lengths and pins err in the worst direction together" +
              (at_corner ? ", to the first order. An instrument within the tolerances has <b>" +
                               length_text(*at_corner, 4) + "</b>."
                         : std::string(".")));
    if (quality_.copy_error_rss)
      add("Copy error, typical", length_text(*quality_.copy_error_rss, 4), {},
          "The same with independent errors: root of the sum of squares.");
  }

  void add_load() {
    const auto& loads = quality_.loads;
    if (!loads || !design_.load) return;
    const Limits& limits = design_.limits;
    const auto in_all = give_in_all(quality_);
    if (in_all)
      add("Pen gives way, worst", error_length(*in_all),
          limits.load_error_in_all ? at_most(*in_all, limits.load_error) : Requirement{},
          "With " + beside_the_links(design_) + ": see the error budget.");
    add("Load error of the links, worst", error_length(loads->error_max),
        limits.load_error_in_all ? Requirement{} : at_most(loads->error_max, limits.load_error),
        fmt::format("How far the links let the pen give way under {} at the worst place of the region. "
                    "Pins and layers add to it{}: see the error budget.",
                    force_text(most_force_at_pen(*design_.load)),
                    loads->weight_error_max ? ", and so does the links' own weight along the table" : ""));
    add("Largest force in a pin", force_text(loads->pin_force_max), {},
        fmt::format(
            "The hand holds {} against the pen's force; weight and friction come on top: see weight, balance "
            "and feel.",
            force_text(loads->hand_force_max)));
  }

  void add_mass() {
    if (!quality_.mass || !design_.material) return;
    add("Mass", fmt::format("{:.4g} kg", *quality_.mass), {},
        "The four links of " + html_escaped(design_.material->name) + ", without pins and tools.");
  }

  void add_sag() {
    if (!quality_.sag) return;
    add("Sag", error_length(*quality_.sag), at_most(*quality_.sag, design_.limits.sag),
        "How far tracer or pen sinks at most, by weight and by the play of the pins.");
  }

  void add_robustness() {
    const auto& robust = quality_.robust;
    if (!robust) return;
    add("Robust clearance", std::isfinite(robust->clearance) ? length_text(robust->clearance, 3) : "none",
        {"≥ " + limit_text(design_.limits.clearance), robust->holds}, robust_explanation(design_));
  }

  void add_distortion() {
    if (!quality_.distortion_worst) return;
    add("Distortion, worst case", length_text(*quality_.distortion_worst, 4), {},
        "What remains of the error when a slightly different scale, rotation and origin are allowed: the "
        "part that is seen.");
  }

  void add_footprint() {
    if (design_.region.empty()) return;
    add("Footprint",
        std::isfinite(quality_.footprint) ? area_text(quality_.footprint) : "not measured: stopped early", {},
        design_.bodies.empty()
            ? "Area that all links sweep while the tracer covers the region: keep it clear."
            : "Area that all links sweep while the tracer covers the region: keep it "
              "clear. Bodies sweep more.");
  }

  void add_bound(const std::string& proof_log) {
    if (!quality_.proven_bound) return;
    add("Best possible",
        design_.search ? objective_value(design_.search->objective, *quality_.proven_bound)
                       : figure_text(*quality_.proven_bound, 4),
        {}, bound_explanation(design_, proof_log));
  }

  const Design& design_;
  const Quality& quality_;
  Rows rows_;
};

}  // namespace

std::string quality(const Design& design, const ReportExtras& extras) {
  return html_section(
      "quality", "Quality",
      html_table("explained", {{"Figure"}, {"Value", true}, {"Required", true}, {"What it says"}},
                 QualityRows(design).all(extras.proof_log)));
}

/// "the obstacles", "obstacles, bodies and the table's edge".
std::string what_is_in_the_way(const Design& design) {
  if (!design.bodies.empty())
    return design.table ? "obstacles, bodies and the table's edge" : "obstacles and bodies";
  return design.table ? "obstacles and the table's edge" : "the obstacles";
}

std::string in_the_way(const Design& design) {
  const bool obstacles_alone = design.bodies.empty() && !design.table;
  return obstacles_alone ? "Too near an obstacle: " : "Too near: ";
}

std::string workspace(const Design& design) {
  const WorkspaceMap& map = design.map;
  const AreaUnit areas(area(map.reachable));
  Rows rows;
  rows.push_back({"Reachable", areas.text(area(map.reachable)), "Within reach in the chosen assembly mode."});
  rows.push_back({"Usable", areas.text(area(map.usable)),
                  fmt::format("Reachable with a transmission angle of {} or more.",
                              angle_text(design.limits.transmission))});
  rows.push_back({"Collision-free", areas.text(area(map.collision_free)),
                  fmt::format("Usable, and every part certainly keeps {} from every other and from {}.",
                              length_text(design.limits.clearance), what_is_in_the_way(design))});
  rows.push_back(
      design.opening.empty()
          ? std::vector<std::string>{"Certified opening", "none",
                                     "The angle between the bars VA and VB: none keeps transmission angle "
                                     "and clearance."}
          : std::vector<std::string>{
                "Certified opening", angle_text(design.opening.width(), 1),
                fmt::format("From {} to {}: the angle between the bars VA and VB over which the limits on "
                            "transmission "
                            "angle and clearance are kept.",
                            angle_text(design.opening.lower, 1), angle_text(design.opening.upper, 1))});
  if (!map.uncertain.empty())
    rows.push_back({"Uncertain", areas.text(area(map.uncertain)),
                    "A band neither proven free nor proven in contact. Treat it as lost."});
  for (const LostArea& lost : map.lost) {
    if (lost.area.empty() || lost.parts.empty()) continue;
    std::string names;
    for (const std::string& part : lost.parts) names += (names.empty() ? "" : " and ") + html_escaped(part);
    rows.push_back({"Lost", areas.text(area(lost.area)),
                    (lost.cause == Cause::obstacle_contact ? in_the_way(design) : "Too near each other: ") +
                        names + "."});
  }
  for (const FittingSheet& sheet : map.largest_sheets)
    rows.push_back({"Largest sheet",
                    figure_text(sheet.width, 1) + " × " + figure_text(sheet.height, 1) + "\u00a0mm",
                    fmt::format("{}, centred at ({}, {}), turned by {}.", html_escaped(sheet.name),
                                number_text(sheet.centre.x(), 1), number_text(sheet.centre.y(), 1),
                                angle_text(sheet.turn, 1))});
  return html_section(
      "workspace", "Workspace",
      html_table("explained", {{"Part of the plane"}, {"Size", true}, {"What it says"}}, rows));
}

std::string verification(const Design& design) {
  const Verification& v = design.verification;
  Rows rows;
  rows.push_back({"Result", v.holds ? "<b class=\"good\">holds</b>" : "<b class=\"bad\">does not hold</b>",
                  v.holds ? fmt::format("Driven over {} by a solver that shares no formula with the design.",
                                        v.over_workspace ? "the free workspace" : "the region")
                          : html_escaped(v.failure)});
  rows.push_back({"Positions driven", count_text(v.samples),
                  v.over_workspace
                      ? "Along the outline of the largest part of the free workspace and inside it."
                      : "Along the region's outline and inside it."});
  rows.push_back({"Greatest copy error", residual_text(v.copy_error_max),
                  "Distance between the pen and the exact image of the tracer, with exact lengths."});
  rows.push_back({"Greatest loop residual", residual_text(v.loop_residual_max),
                  "Largest gap of the closed loops; should be rounding only."});
  rows.push_back({"Scale found", number_text(v.scale, 9),
                  fmt::format("Of the similarity fitted to the driven pairs; wanted {}.",
                              number_text(design.scale, 9))});
  rows.push_back({"Rotation found", angle_text(v.rotation, 9),
                  fmt::format("Wanted {}.", angle_text(design.rotation, 9))});
  rows.push_back({"Changes of assembly mode", std::to_string(v.flips),
                  "How often the linkage changed to another assembly mode; must be 0."});
  return html_section("verification", "Verification",
                      html_table("explained", {{"Check"}, {"Found", true}, {"What it says"}}, rows));
}

namespace {

/// All of a few names, or the first of many.
std::string names_text(const std::vector<std::string>& names) {
  constexpr std::size_t most = 200;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (i > 0 ? ", " : "") + html_escaped(names[i]);
  if (names.size() > most) text += fmt::format(" and {} more, which design.json names", names.size() - most);
  return text;
}

}  // namespace

std::string search(const Design& design) {
  if (!design.search) return {};
  const SearchRecord& s = *design.search;
  std::string solvers;
  for (const std::string& solver : s.solvers) solvers += (solvers.empty() ? "" : ", ") + html_escaped(solver);
  Rows rows;
  rows.push_back({"Searched for", objective_text(s.objective),
                  s.complete ? "The search ran to its end."
                             : "The search was stopped early: a better design may exist."});
  rows.push_back({"Value reached", objective_value(s.objective, s.value),
                  "Computed again at the design, not taken from a solver."});
  if (!s.obstacles_out_of_reach.empty())
    rows.push_back({"Obstacles out of reach", count_text(s.obstacles_out_of_reach.size()),
                    "No permitted instrument can touch them, so the search left them out: " +
                        names_text(s.obstacles_out_of_reach) + "."});
  rows.push_back({"Evaluations", count_text(s.evaluations), "Mechanisms tried."});
  rows.push_back({"Solvers", solvers, "In the order of use."});
  rows.push_back({"Seed", std::to_string(s.seed), "The same seed gives the same design."});
  return html_section("search", "Search",
                      html_table("explained", {{"Item"}, {"Value", true}, {"What it says"}}, rows));
}

std::string pareto(const ReportExtras& extras) {
  if (!extras.pareto || extras.pareto->rows.empty()) return {};
  const ParetoFront& front = *extras.pareto;
  Rows rows;
  for (const ParetoRow& row : front.rows)
    rows.push_back({linked_name(row) + (row.is_this_design ? " <b>(shown below)</b>" : ""),
                    number_text(row.first, 4), number_text(row.second, 4)});
  const std::string table = html_table(
      "pareto",
      {{"Design"},
       {fmt::format("{}, {}", html_escaped(front.first_name), html_escaped(front.first_unit)), true},
       {fmt::format("{}, {}", html_escaped(front.second_name), html_escaped(front.second_unit)), true}},
      rows);
  return html_section(
      "pareto", "What one figure costs in the other",
      "<div class=\"columns\"><div>" + pareto_chart(front) + "</div><div>" + table + "</div></div>\n");
}

std::string spec(const ReportExtras& extras) {
  if (extras.spec_text.empty()) return {};
  constexpr std::size_t head = 16000, tail = 2000;
  std::string_view text = extras.spec_text;
  std::string shown;
  if (text.size() > head + tail + 1000) {
    const auto at_line = [&](std::size_t from) {
      const auto end = text.find('\n', from);
      return end == text.npos || end > from + 400 ? from : end + 1;
    };
    const std::size_t first = at_line(head), second = at_line(text.size() - tail);
    shown =
        html_escaped(text.substr(0, first)) +
        fmt::format("<i class=\"left-out\">… {} bytes left out here …\n</i>", count_text(second - first)) +
        html_escaped(text.substr(second));
  } else {
    shown = html_escaped(text);
  }
  const std::string name = extras.spec_name.empty() ? ""
                                                    : fmt::format("<p class=\"note\"><code>{}</code></p>\n",
                                                                  html_escaped(extras.spec_name));
  return html_section("spec", "The spec", name + "<pre tabindex=\"0\">" + shown + "</pre>\n");
}

}  // namespace kempe::report_sections
