#include "reports/page/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "reports/drawings/bench_space.hpp"
#include "reports/drawings/blank.hpp"
#include "reports/drawings/hardware_faults.hpp"
#include "reports/drawings/overload_words.hpp"
#include "reports/drawings/tolerance_words.hpp"
#include "reports/page/html_page.hpp"
#include "reports/page/html_table.hpp"
#include "reports/pictures/html_text.hpp"
#include "reports/pictures/mechanism_picture.hpp"
#include "reports/pictures/svg_element.hpp"
#include "synthesis/design/copy_overlap.hpp"
#include "synthesis/design/error_budget.hpp"
#include "synthesis/loads/gravity.hpp"

namespace kempe::report_sections {
namespace {

std::string ratio_text(const Design& design) {
  return design.scale >= 1 ? number_text(design.scale, 4) + "\u00a0:\u00a01"
                           : "1\u00a0:\u00a0" + number_text(1 / design.scale, 4);
}

std::string turn_text(double rotation) {
  if (rotation == 0) return "not turned";
  const std::string angle = angle_text(std::abs(rotation));
  if (std::abs(degrees(rotation)) > 179.9999) return "turned " + angle;
  return fmt::format("turned {} {}", angle, rotation > 0 ? "counter-clockwise" : "clockwise");
}

std::string point_text(const Point& at) {
  return fmt::format("({}, {})\u00a0mm", number_text(at.x(), 3), number_text(at.y(), 3));
}

std::string joint_of(const CopyingLinkage& linkage, std::string_view what) {
  for (const Joint joint : all_joints)
    if (role(linkage, joint) == what) return std::string(1, letter(joint));
  return {};
}

std::string notice(const std::string& sentence) {
  return sentence.empty() ? std::string()
                          : fmt::format("<p class=\"notice\">{}</p>\n", html_escaped(sentence));
}

std::string size_text(double scale) {
  return scale == 1 ? "at the same size" : number_text(scale, 4) + " times as large";
}

/// The note as a sentence of its own, after another; or nothing.
std::string overlap_sentence(const Design& design) {
  std::string note = overlap_note(design);
  if (note.empty()) return note;
  note.front() = 'T';
  return " " + html_escaped(note) + ".";
}

std::string change_link(const std::string& studio_page) {
  if (studio_page.empty()) return {};
  return fmt::format("<p class=\"change-link\"><a href=\"{}\">Change it in the studio</a></p>\n",
                     html_escaped(studio_page));
}

/// What the page's scripts bring to life; hidden until they run.
constexpr std::string_view controls =
    R"(<div id="controls" class="controls" hidden>
<div class="buttons">
<button type="button" id="play" aria-pressed="false">▶ Play</button>
<label>Speed <select id="speed"><option value="0.25">¼</option><option value="0.5">½</option>)"
    R"(<option value="1" selected>1</option><option value="2">2</option></select></label>
<label><input type="checkbox" id="draw" checked> Draw</label>
<button type="button" id="clear">Clear</button>
<span class="space"></span>
<span class="zoom"><button type="button" id="zoom-out" aria-label="Zoom out">−</button>
<button type="button" id="zoom-in" aria-label="Zoom in">+</button>
<button type="button" id="zoom-job" aria-label="Zoom to the job">Job</button>
<button type="button" id="zoom-all" aria-label="Zoom to the whole map">All</button></span>
</div>
</div>
)";

constexpr std::string_view help =
    R"(<p id="help" class="help" hidden>Drag the tracer or the pen, or tap a place; point at a place to ask about it. Keyboard: arrows move the tracer (Shift 10 mm, Alt 0.1 mm), space plays, Home goes back, a shows all of the map, 0 the job.</p>
)";

/// What is so with the tracer where it stands.
constexpr std::string_view readings = R"(<div id="readings" class="readings" hidden>
<h3>At the tracer</h3>
<p id="verdict" class="verdict" role="status"></p>
<dl>
<dt>Tracer, mm</dt><dd id="at-tracer"></dd>
<dt>Pen, mm</dt><dd id="at-pen"></dd>
<dt>Opening</dt><dd id="at-opening"></dd>
<dt>Transmission</dt><dd id="at-transmission"></dd>
<dt>Smallest gap</dt><dd><span id="at-gap"></span><small id="at-parts"></small></dd>
<dt>Copy error, worst</dt><dd id="at-error"></dd>
</dl>
</div>
)";

}  // namespace

std::string title(const Design& design) {
  if (!design.title.empty()) return design.title;
  return fmt::format("Copying linkage {}, {}", ratio_text(design), turn_text(design.rotation));
}

std::string header(const Design& design, const ReportExtras& extras) {
  const CopyingLinkage& linkage = design.linkage;
  std::string badges = design.region.empty() ? html_badge(true, "Workspace mapped, no region given")
                                             : html_badge(design.map.coverage.covered,
                                                          design.map.coverage.covered ? "Region covered"
                                                                                      : "Region not covered");
  badges += html_badge(design.verification.holds,
                       design.verification.holds ? "Verified by a general solver" : "Not verified");
  if (!overload_words(design).empty())
    badges += html_badge(false, "Does not bear its load");
  else if (large_bending_words(design))
    badges += html_badge(false, "Bends too far for its figures");
  if (!hardware_faults(design).empty()) badges += html_badge(false, "Hardware needs a look: see the parts");
  if (breaks_copy_error_limit(design))
    badges += html_badge(false, "An instrument can exceed the limit on the copy error");
  if (design.search && !design.search->complete) badges += html_badge(false, "Search stopped early");
  const std::string lead = fmt::format(
      "What the tracer follows, the pen draws {}, {}. The pole <b>{}</b> is fixed to the table at {}, "
      "<b>{}</b> carries the tracer and <b>{}</b> the pen.{}",
      size_text(design.scale), turn_text(design.rotation), joint_of(linkage, "pole"),
      point_text(linkage.pole()), joint_of(linkage, "tracer"), joint_of(linkage, "pen"),
      overlap_sentence(design));
  return fmt::format(
      "<header class=\"head\">\n<div>\n{}</div>\n<div class=\"state\">\n<ul "
      "class=\"badges\">\n{}</ul>\n{}</div>\n{}{}</header>\n",
      html_heading(design.search ? "Kempe · design" : "Kempe · workspace of a given linkage", title(design),
                   lead),
      badges, change_link(extras.studio_page), notice(design.map.coverage.why_not),
      notice(design.verification.failure));
}

namespace {

/// What a saw has to be set to first: the longest of the four blanks.
std::string longest_piece(const Design& design) {
  Blank longest{0, 0};
  std::string_view of;
  for (const Link link : all_links)
    if (const Blank blank = blank_of(design, link); blank.length > longest.length) {
      longest = blank;
      of = name(link);
    }
  return html_key_figure(
      "Longest piece",
      fmt::format("{} × {}\u00a0mm", figure_text(longest.length, 1), figure_text(longest.width, 1)),
      fmt::format("link {}, {} thick", of, length_text(design.style.thickness)));
}

std::string bench_space(const Design& design) {
  const std::optional<Box> swept = swept_box(design);
  if (design.footprint.empty() || !swept) return {};
  const Point size = swept->upper - swept->lower;
  return html_key_figure("Bench space",
                         fmt::format("{} × {}\u00a0mm", number_text(std::ceil(size.x()), 0),
                                     number_text(std::ceil(size.y()), 0)),
                         "swept at work");
}

std::string copy_error_figure(const Design& design) {
  const Quality& q = design.quality;
  if (q.robust)
    return html_key_figure("Robust", q.robust->holds ? length_text(q.robust->clearance, 2) : "not proven",
                           "clearance of every instrument");
  if (!q.copy_error_worst) return {};
  const std::string limit = design.limits.copy_error ? "limit " + limit_text(*design.limits.copy_error) : "";
  if (!q.copy_error_at_corner)
    return html_key_figure("Copy error at worst", length_text(*q.copy_error_worst, 3),
                           limit.empty() ? "under the tolerances" : limit);
  const std::string found = length_text(*q.copy_error_at_corner, 3);
  return html_key_figure(
      "Copy error at worst", breaks_copy_error_limit(design) ? "<b class=\"bad\">" + found + "</b>" : found,
      (limit.empty() ? "" : limit + "; ") + length_text(*q.copy_error_worst, 3) + " to the first order");
}

std::string load_error_figure(const Design& design) {
  if (!design.quality.loads || !design.load) return {};
  const double links = design.quality.loads->error_max, whole = give_in_all(design.quality).value_or(links);
  std::string note = "under " + force_text(most_force_at_pen(*design.load)) + "; ";
  const std::string limit =
      design.limits.load_error ? "limit " + limit_text(*design.limits.load_error) : std::string();
  if (design.limits.load_error_in_all) note += limit + "; ";
  if (design.quality.layered) note += error_length(links) + " ";
  note += "by its links alone";
  if (!design.limits.load_error_in_all && !limit.empty()) note += ", " + limit;
  return html_key_figure("Gives way at worst", error_length(whole), note);
}

std::string sag_figure(const Design& design) {
  if (!design.quality.sag) return {};
  return html_key_figure(
      "Sinks at worst", error_length(*design.quality.sag),
      design.limits.sag ? "limit " + limit_text(*design.limits.sag) : "by weight and play");
}

/// What the load adds to the sag, up or down.
std::string rise_figure(const Design& design) {
  const auto& layered = design.quality.layered;
  if (!layered || !(layered->rise_max > no_drop)) return {};
  return html_key_figure("Lifted or lowered", error_length(layered->rise_max),
                         "by the load at worst, beside the sag");
}

}  // namespace

std::string key_figures(const Design& design) {
  const Quality& q = design.quality;
  const Point& pole = design.linkage.pole();
  std::string html =
      longest_piece(design) + bench_space(design) +
      html_key_figure("Pole at", fmt::format("{}, {}", number_text(pole.x(), 2), number_text(pole.y(), 2)),
                      "x, y in mm") +
      html_key_figure("Smallest transmission",
                      q.transmission_min > 0 ? angle_text(q.transmission_min, 1) : "none",
                      "limit " + angle_text(design.limits.transmission, 1));
  if (std::isfinite(q.clearance_min))
    html += html_key_figure("Smallest clearance", length_text(q.clearance_min, 2),
                            "limit " + limit_text(design.limits.clearance));
  return "<dl class=\"keys\">\n" + html + copy_error_figure(design) + load_error_figure(design) +
         sag_figure(design) + rise_figure(design) + "</dl>\n";
}

namespace {

/// A layer as the map draws it, for the legend.
std::string swatch(const MapLayer& layer) {
  const SvgElement patch = SvgElement("rect")
                               .with("class", layer.group == "lost" ? "lost" : "area")
                               .at("x", "y", {1, 1})
                               .with("width", 22)
                               .with("height", 14)
                               .with("rx", 2);
  return SvgElement("svg")
      .with("class", "swatch m-" + layer.id)
      .with("viewBox", view_box(0, 0, 24, 16))
      .with("aria-hidden", "true")
      .holding(patch.text())
      .text();
}

}  // namespace

std::string map(const MapPicture& picture, bool live) {
  static constexpr std::array<std::array<std::string_view, 2>, 3> groups{
      {{"things", "Shown"}, {"map", "Where the tracer can be"}, {"lost", "Lost, and why"}}};
  std::string things, areas;  // beside the picture, and below it where the page is wide
  for (const auto& [group, heading] : groups) {
    std::string entries;
    for (const MapLayer& layer : picture.layers)
      if (layer.group == group)
        entries += fmt::format(
            "<li><label><input type=\"checkbox\" id=\"layer-{}\"{}>{}<span>{}</span><span "
            "class=\"figure\">{}</span></label></li>\n",
            layer.id, layer.shown ? " checked" : "", swatch(layer), html_escaped(layer.label), layer.figure);
    if (!entries.empty())
      (group == "things" ? things : areas) +=
          fmt::format("<section>\n<h3>{}</h3>\n<ul>\n{}</ul>\n</section>\n", heading, entries);
  }
  const std::string board = "<div class=\"board\" id=\"board\">\n" + picture.svg +
                            (live ? "<div id=\"tip\" class=\"tip\" hidden></div>\n" : "") + "</div>\n";
  return fmt::format(
      "<figure class=\"map-figure\" id=\"map-figure\">\n<div class=\"stage\">\n{}{}{}</div>\n"
      "<aside class=\"legend\" aria-label=\"Legend\">\n<div class=\"things\">\n{}{}</div>\n"
      "<div class=\"areas\">\n{}</div>\n</aside>\n</figure>\n",
      live ? controls : "", board, live ? help : "", live ? readings : "", things, areas);
}

std::string footer(const ReportExtras& extras, bool live) {
  std::string html = fmt::format(
      "<footer>\n<p>Made by Kempe {}. Lengths in millimetres, angles counter-clockwise, seen from "
      "above. Full precision: <code>design.json</code>.</p>\n",
      html_escaped(extras.program_version));
  html += live ? "<p>The moving picture uses JSXGraph 1.13, copyright its authors (University of Bayreuth), "
                 "under the MIT licence "
                 "or the LGPL, at your choice; its notice stands in this page's source.</p>\n"
               : "<p class=\"not-live\">This build of Kempe has no moving picture (it was configured with "
                 "<code>-DKEMPE_WITH_LIVE_REPORT=OFF</code>).</p>\n";
  return html + "</footer>\n";
}

}  // namespace kempe::report_sections
