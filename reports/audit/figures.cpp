// The figures of a stored design against the same figures computed anew.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/regions/region_algebra.hpp"
#include "reports/audit/record.hpp"
#include "reports/audit/slack.hpp"
#include "specs/text/printable.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "synthesis/tolerance/corner_error.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/footprint.hpp"
#include "workspace/map/copy_gap.hpp"
#include "workspace/map/largest_sheet.hpp"
#include "workspace/reach.hpp"
#include "workspace/slack.hpp"

namespace kempe {
namespace {

using namespace audit_slack;

double rounding(double value) { return share_of_rounding * std::abs(value); }

void check_size_and_transmission(const AuditTask& task, AuditRecord& record) {
  const Quality& stated = task.design.quality;
  record.figure("quality.size_mm", stated.size, task.linkage.size(), rounding(task.linkage.size()));
  const bool anywhere = task.design.region.empty() && !task.map.certified_opening.empty();
  const auto openings = anywhere ? std::optional(task.map.certified_opening) : task.needed;
  const double transmission = openings ? std::min(task.linkage.transmission_angle(openings->lower),
                                                  task.linkage.transmission_angle(openings->upper))
                                       : 0;
  record.figure("quality.transmission_min_deg", degrees(stated.transmission_min), degrees(transmission),
                degrees_of_rounding);
}

void check_clearance(const AuditTask& task, AuditRecord& record) {
  const double found = task.map.clearance_min, stated = task.design.quality.clearance_min;
  if (std::isinf(stated) && !task.design.map.map_tolerance)
    return record.not_checked("quality.clearance_min_mm", "the map was stopped before the gap was known");
  if (std::isinf(found) || std::isinf(stated)) {
    record.checked("quality.clearance_min_mm");
    if (found != stated)
      record.broken({.limit = "quality.clearance_min_mm",
                     .attained = std::isinf(stated) ? std::nullopt : std::optional(stated),
                     .allowed = std::isinf(found) ? std::nullopt : std::optional(found),
                     .sentence = "the stated parts are not those that come nearest to each other"});
    return;
  }
  const double outer = reachable_annulus(task.linkage).outer;
  const bool obstacles = has_obstructions(task.map_task);
  record.figure(
      "quality.clearance_min_mm", stated, found,
      task.slack + (obstacles ? std::min(slack::certain_gap, slack::certain_gap_share * outer) : 0));
}

/// The worst instrument found within the tolerances, where the first order understates the copy error.
void check_corner(const AuditTask& task, const CopyTolerance& tolerance, double worst, AuditRecord& record) {
  constexpr const char* key = "quality.copy_error_at_corner_mm";
  const auto& stated = task.design.quality.copy_error_at_corner;
  const auto corner = corner_error_over(task.linkage, tolerance, RegionReach(task.design.region));
  if (!corner) return;
  if (stated) return record.figure(key, stated, corner->worst, share_of_corner * corner->worst);
  if (first_order_understates(worst, corner->worst * (1 - share_of_corner)))
    record.not_checked(key,
                       fmt::format("the file states none, and the first order understates the copy error: an "
                                   "instrument within the tolerances has an error of {:.6g} mm",
                                   corner->worst));
}

void check_copy_errors(const AuditTask& task, AuditRecord& record) {
  const Quality& stated = task.design.quality;
  if (!stated.copy_error_worst && !stated.copy_error_rss && !stated.distortion_worst &&
      !stated.copy_error_at_corner)
    return;
  const CopyTolerance tolerance = CopyTolerance::uniform(task.design.tolerance.value_or(Tolerance{}));
  const auto error = task.design.tolerance ? copy_error_over(task.linkage, tolerance, task.design.region)
                                           : tl::unexpected(Unreachable::too_far);
  if (!error) {
    const char* why = task.design.tolerance ? "this assembly mode does not reach all of the region"
                                            : "the file states no tolerance";
    for (const char* key :
         {"quality.copy_error_worst_mm", "quality.copy_error_rss_mm", "quality.distortion_worst_mm"})
      record.not_checked(key, why);
    if (stated.copy_error_at_corner) record.not_checked("quality.copy_error_at_corner_mm", why);
    return;
  }
  const auto figure = [&](const char* key, const std::optional<double>& claimed, double found) {
    record.figure(key, claimed, found, share_of_copy_error * error->worst);
  };
  figure("quality.copy_error_worst_mm", stated.copy_error_worst, error->worst);
  figure("quality.copy_error_rss_mm", stated.copy_error_rss, error->rss);
  figure("quality.distortion_worst_mm", stated.distortion_worst, error->distortion_worst);
  check_corner(task, tolerance, error->worst, record);
}

void check_footprint(const AuditTask& task, AuditRecord& record) {
  if (!task.design.footprint) return;
  const double found = footprint(task.linkage, task.design.style, task.design.region).area;
  record.figure("quality.footprint_mm2", task.design.footprint, found, share_of_grid * found);
}

/// True if the gap between original and copy is kept too, as the map counts it.
bool is_covered(const AuditTask& task) {
  if (!task.map.coverage.covered) return false;
  MapTask mapped = task.map_task;
  mapped.limits.copy_gap = task.design.limits ? task.design.limits->copy_gap : std::nullopt;
  return !copy_overlap(mapped, OverlapArea::left_out);
}

void check_coverage_claim(const AuditTask& task, AuditRecord& record) {
  record.checked("workspace.region_covered");
  if (task.design.region_covered == is_covered(task) || (!task.design.limits && !task.design.region_covered))
    return;
  record.broken({.limit = "workspace.region_covered",
                 .attained = task.design.region_covered,
                 .allowed = !task.design.region_covered,
                 .where = task.map.coverage.witness,
                 .sentence = task.design.region_covered
                                 ? "the file says that the region is covered, which it is not"
                                 : "the file says that the region is not covered, which it is"});
}

/// Free and uncertain together hold the true area: two maps of one linkage, however fine, overlap in it.
void check_free_area(const AuditTask& task, AuditRecord& record) {
  const StoredMap& stated = task.design.map;
  const double free = area(task.map.collision_free), uncertain = area(task.map.uncertain);
  const double slack = share_of_grid * (free + uncertain);
  if (stated.map_tolerance) {
    record.checked("workspace.map_tolerance");
    record.figure("workspace.collision_free_mm2", stated.collision_free, free, slack);
    record.figure("workspace.uncertain_mm2", stated.uncertain, uncertain, slack);
    return;
  }
  if (!stated.collision_free || !stated.uncertain) return;
  record.checked("workspace.collision_free_mm2");
  record.checked("workspace.uncertain_mm2");
  const double least = std::max(free, *stated.collision_free);
  const double most = std::min(free + uncertain, *stated.collision_free + *stated.uncertain);
  if (least > most + slack)
    record.broken({.limit = "workspace.collision_free_mm2",
                   .attained = stated.collision_free,
                   .allowed = free,
                   .sentence = fmt::format("the free area lies between {:.6g} and {:.6g} mm2", free,
                                           free + uncertain)});
}

ArcRegion corners_of(const FittingSheet& sheet, double margin) {
  const Complex turn = std::polar(1.0, sheet.turn);
  Ring ring;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
    ring.push_back(sheet.centre + as_point(turn * Complex(2 * x * (0.5 * sheet.width - margin),
                                                          2 * y * (0.5 * sheet.height - margin))));
  return as_arcs({{Polygon{ring, {}}}});
}

double area_of(const FittingSheet& sheet) { return sheet.width * sheet.height; }

/// The file lists them as the map does, and the largest of them once more.
void check_none_larger(const AuditTask& task, AuditRecord& record) {
  const auto& stated = task.design.map.sheets;
  const auto& found = task.map.largest_sheets;
  const auto compare = [&](const std::string& key, const FittingSheet& one, const FittingSheet& larger) {
    if (area_of(larger) > area_of(one) * (1 + share_of_sheet))
      record.broken({.limit = key,
                     .attained = area_of(one),
                     .allowed = area_of(larger),
                     .where = larger.centre,
                     .sentence = fmt::format(
                         "a sheet of {:.6g} x {:.6g} mm fits, larger than \"{}\" of {:.6g} x {:.6g} mm",
                         larger.width, larger.height, one.name, one.width, one.height)});
  };
  for (std::size_t i = 0; i < std::min(stated.size(), found.size()); ++i)
    compare("workspace.sheets", stated[i], found[i]);
  const auto largest =
      std::max_element(found.begin(), found.end(),
                       [](const FittingSheet& a, const FittingSheet& b) { return area_of(a) < area_of(b); });
  if (largest != found.end()) compare("workspace.largest_sheet", stated.back(), *largest);
}

void check_sheets(const AuditTask& task, AuditRecord& record) {
  if (task.design.map.sheets.empty()) return;
  record.checked("workspace.sheets");
  record.checked("workspace.largest_sheet");
  check_none_larger(task, record);
  for (const FittingSheet& sheet : task.design.map.sheets) {
    const auto format = format_size(sheet.name);
    if (format && !(std::abs(sheet.width - format->x()) <= rounding(format->x()) &&
                    std::abs(sheet.height - format->y()) <= rounding(format->y())))
      record.broken(
          {.limit = "workspace.sheets",
           .attained = sheet.width * sheet.height,
           .allowed = format->x() * format->y(),
           .where = sheet.centre,
           .sentence = fmt::format("a sheet called {} is {:.6g} x {:.6g} mm, not {:g} x {:g}", sheet.name,
                                   sheet.width, sheet.height, format->x(), format->y())});
    const double margin = share_of_grid * std::min(sheet.width, sheet.height);
    if (contains(task.map.collision_free, corners_of(sheet, margin))) continue;
    record.broken(
        {.limit = "workspace.sheets",
         .attained = sheet.width * sheet.height,
         .where = sheet.centre,
         .sentence = fmt::format("the sheet \"{}\", {:.6g} x {:.6g} mm, does not fit the free workspace",
                                 sheet.name, sheet.width, sheet.height)});
  }
}

void check_map(const AuditTask& task, AuditRecord& record) {
  const StoredMap& stated = task.design.map;
  check_coverage_claim(task, record);
  const double reach = area(reachable_annulus(task.linkage));
  record.figure("workspace.reachable_mm2", stated.reachable, area(task.map.reachable), rounding(reach));
  if (!task.design.limits) {
    for (const char* key :
         {"workspace.usable_mm2", "workspace.collision_free_mm2", "workspace.uncertain_mm2"})
      record.not_checked(key, "it depends on limits, which the file does not state");
    return;
  }
  record.figure("workspace.usable_mm2", stated.usable, area(task.map.usable), rounding(reach));
  check_free_area(task, record);
  check_sheets(task, record);
}

void check_ratio_error(const AuditTask& task, AuditRecord& record) {
  const auto& wanted = task.design.wanted;
  if (!wanted) return;
  const double found = std::abs(task.linkage.k() - copy_ratio(wanted->scale, wanted->rotation));
  record.figure("copy.ratio_error", wanted->error, found, ratio_rounding * std::abs(task.linkage.k()));
}

void check_tool(const AuditTask& task, AuditRecord& record) {
  const auto& stated = task.design.tool;
  if (!stated) return;
  const ToolAdvice found =
      tool_advice({stated->follower_radius, stated->cutter_radius}, std::abs(task.linkage.k()))
          .value_or(ToolAdvice{});
  const auto figure = [&](const char* key, const std::optional<double>& claimed,
                          const std::optional<double>& is) {
    const double size =
        std::abs(is.value_or(0)) + stated->cutter_radius.value_or(0) + stated->follower_radius.value_or(0);
    if (is) record.figure(key, claimed, *is, ratio_rounding * size);
    if (claimed && !is) record.not_checked(key, "the file states neither follower nor cutter for it");
  };
  figure("tool.exact_follower_radius_mm", stated->exact_follower_radius, found.exact_follower_radius);
  figure("tool.exact_cutter_radius_mm", stated->exact_cutter_radius, found.exact_cutter_radius);
  figure("tool.cut_outside_mm", stated->cut_outside, found.cut_outside);
  figure("tool.template_offset_mm", stated->template_offset, found.template_offset);
}

/// The quality that a search for this objective makes as good as it can be, in the file's unit.
std::optional<double> quality_of(const StoredDesign& design, Objective objective) {
  switch (objective) {
    case Objective::size: return design.quality.size;
    case Objective::transmission: return degrees(design.quality.transmission_min);
    case Objective::copy_error: return design.quality.copy_error_worst;
    case Objective::load_error:
      return design.quality.loads ? std::optional(design.quality.loads->error_max) : std::nullopt;
    case Objective::mass: return design.quality.mass;
    case Objective::footprint: break;
  }
  return design.footprint;
}

void check_search(const StoredDesign& design, AuditRecord& record) {
  if (!design.objective || !design.value) return;
  const auto quality = quality_of(design, *design.objective);
  if (!quality) return record.not_checked("search.value", "the file does not state the figure searched for");
  record.figure("search.value", design.value, *quality,
                std::max(*design.objective == Objective::transmission ? degrees_of_rounding : 0.0,
                         share_of_copy_error * std::abs(*quality)));
}

/// A bound on the wrong side of the value is refuted by the design itself.
void check_bound(const StoredDesign& design, AuditRecord& record) {
  const auto& bound = design.quality.proven_bound;
  if (!bound) return;
  record.not_checked(
      "quality.lower_bound",
      "it is compared with the value, not proven here; its log, if there is one, is checked by the program "
      "kempe_check.py");
  if (!design.objective || !design.value) return;
  record.checked("quality.lower_bound");
  const double slack = share_of_copy_error * std::abs(*design.value);
  const double excess = is_maximized(*design.objective) ? *design.value - *bound : *bound - *design.value;
  if (excess > slack)
    record.broken({.limit = "quality.lower_bound",
                   .attained = design.value,
                   .allowed = bound,
                   .sentence = fmt::format(
                       "the file says that no design is {} than {:.9g}; this one has {:.9g}",
                       is_maximized(*design.objective) ? "larger" : "smaller", *bound, *design.value)});
}

}  // namespace

void audit_figures(const AuditTask& task, AuditRecord& record) {
  check_size_and_transmission(task, record);
  check_clearance(task, record);
  check_copy_errors(task, record);
  check_footprint(task, record);
  check_map(task, record);
  check_ratio_error(task, record);
  check_tool(task, record);
}

void audit_claims(const StoredDesign& design, const Verification& drive, AuditRecord& record) {
  check_search(design, record);
  check_bound(design, record);
  const Verification& stated = design.verification;
  double size = 0;
  for (const double length : design.mechanism.lengths.values()) size += length;
  record.checked("verification.certified");
  if (!stated.holds && drive.holds)
    record.broken({.limit = "verification.certified",
                   .sentence = "the file states that its verification failed" +
                               (stated.failure.empty() ? std::string() : ": " + printable(stated.failure)) +
                               "; it holds"});
  record.figure("verification.flips", stated.flips, drive.flips, 0);
  record.figure("verification.scale", stated.scale, drive.scale, ratio_rounding * (1 + drive.scale));
  record.figure("verification.rotation_deg",
                drive.rotation * 180 / pi + std::remainder(degrees(stated.rotation - drive.rotation), 360),
                degrees(drive.rotation), degrees_of_rounding);
  record.figure("verification.copy_error_max_mm", stated.copy_error_max, drive.copy_error_max,
                share_of_rounding * size);
  record.figure("verification.loop_residual_max_mm", stated.loop_residual_max, drive.loop_residual_max,
                share_of_rounding * size);
  record.not_checked("verification.samples", "the number of positions does not affect the result");
  record.not_checked("search", "how the design was found cannot be checked; its value is");
}

}  // namespace kempe
