// A stored design against its limits, over every point of its region: closed forms and the map.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/fixed_text.hpp"
#include "geometry/region_reach.hpp"
#include "geometry/regions/region_algebra.hpp"
#include "reports/audit/record.hpp"
#include "reports/audit/slack.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "synthesis/tolerance/robust.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/contact/contact_scene.hpp"
#include "workspace/contact/self_contact.hpp"
#include "workspace/reach.hpp"
#include "workspace/slack.hpp"

namespace kempe {
namespace {

using namespace audit_slack;

/// The region's place nearest to the pole, in the edge of a hole if the pole stands in one, or its farthest corner.
Point extreme_place(const Region& region, const Point& pole, bool farthest) {
  const RegionReach reach(region);
  return farthest ? reach.hull()[reach.farthest(pole).corner] : reach.nearest(pole).place;
}

/// The end of the openings needed with the smaller transmission angle, and where the tracer then stands.
struct Weakest {
  double angle = 0;
  std::optional<Point> where;
};
Weakest weakest(const AuditTask& task) {
  const CopyingLinkage& linkage = task.linkage;
  const Region& region = task.design.region;
  const OpeningInterval& openings = region.empty() ? task.design.mechanism.opening : *task.needed;
  const double lower = linkage.transmission_angle(openings.lower);
  const double upper = linkage.transmission_angle(openings.upper);
  if (region.empty()) return {std::min(lower, upper), std::nullopt};
  const bool farthest = (upper < lower) == linkage.radius_grows_with_opening();
  return {std::min(lower, upper), extreme_place(region, linkage.pole(), farthest)};
}

void check_transmission(const AuditTask& task, double limit, AuditRecord& record) {
  const bool reached =
      task.design.region.empty() ? !task.design.mechanism.opening.empty() : task.needed.has_value();
  if (!reached)
    return record.not_checked("limits.transmission_deg",
                              "this assembly mode does not reach all of the region");
  const Weakest found = weakest(task);
  record.checked("limits.transmission_deg");
  if (found.angle < limit - angle_slack)
    record.broken(
        {.limit = "limits.transmission_deg",
         .attained = degrees(found.angle),
         .allowed = degrees(limit),
         .where = found.where,
         .sentence = fmt::format("the transmission angle falls to {:.6f} degrees; {:.6f} are required",
                                 degrees(found.angle), degrees(limit))});
}

BrokenLimit too_near(const std::string& key, const ClearanceFigure& figure, double clearance) {
  return {.limit = key,
          .attained = figure.gap,
          .allowed = clearance,
          .where = figure.at,
          .sentence = fmt::format(
              "{} {}; {:.6g} mm are required", figure.parts,
              figure.gap > 0 ? fmt::format("come within {:.6g} mm", figure.gap) : std::string("overlap"),
              clearance)};
}

/// What is looked at beside the linkage itself.
struct Beside {
  bool obstacles = false, bodies = false, table = false;
};

/// Over the region; without one over the opening stated, bodies and all but the pole's post left out: they bind at bearings.
std::optional<ClearanceFigure> clearance_of(const AuditTask& task, const Beside& beside) {
  MapTask mapped = task.map_task;
  if (!beside.obstacles) mapped.obstacles.clear();
  if (!beside.bodies) mapped.bodies.clear();
  if (!beside.table) mapped.table.reset();
  if (!mapped.region.empty()) return smallest_clearance(mapped);
  const OpeningInterval& openings = task.design.mechanism.opening;
  if (openings.empty()) return std::nullopt;
  const Tightest own = smallest_gap_over(mapped.linkage, mapped.style, mapped.layers, openings);
  ClearanceFigure figure{own.gap, own.pair ? name(*own.pair) : "", mapped.linkage.tracer_at(own.opening, 0),
                         true};
  if (const auto post = tightest(gaps_at_pole(mapped)))
    figure = {post->gap, post->post + " and " + post->obstacle, mapped.linkage.pole(), true};
  return figure;
}

/// One more kind of thing beside the linkage: broken if it brings the gap below `least` and below what it was without.
void check_beside(const AuditTask& task, const char* key, const Beside& beside, double least,
                  std::optional<ClearanceFigure>& without, AuditRecord& record) {
  const auto with = clearance_of(task, beside);
  if (!with) return record.not_checked(key, "no place of the region is reached");
  record.checked(key);
  const bool nearer = !without || with->gap < without->gap || task.design.region.empty();
  if (with->gap < least && nearer) {
    record.broken(too_near(key, *with, task.map_task.limits.clearance));
    record.broken(too_near("limits.clearance_mm", *with, task.map_task.limits.clearance));
  }
  without = with;
}

void check_clearance_limit(const AuditTask& task, AuditRecord& record) {
  const double clearance = task.map_task.limits.clearance;
  const double least = clearance - slack::touching * reachable_annulus(task.linkage).outer - task.slack;
  auto found = clearance_of(task, {});
  if (!found) {
    record.not_checked("limits.clearance_mm", "no place of the region is reached");
  } else {
    record.checked("limits.clearance_mm");
    if (found->gap < least) record.broken(too_near("limits.clearance_mm", *found, clearance));
  }
  const MapTask& mapped = task.map_task;
  if (!mapped.obstacles.empty()) check_beside(task, "obstacles", {.obstacles = true}, least, found, record);
  if (!mapped.bodies.empty())
    check_beside(task, "bodies", {.obstacles = true, .bodies = true}, least, found, record);
  if (mapped.table)
    check_beside(task, "table", {.obstacles = true, .bodies = true, .table = true}, least, found, record);
}

void check_coverage(const AuditTask& task, AuditRecord& record) {
  if (task.design.region.empty()) return;
  record.checked("region");
  const Coverage& coverage = task.map.coverage;
  if (coverage.covered) return;
  double lost = 0;
  for (const RegionLoss& loss : coverage.losses) lost += loss.share;
  record.broken({.limit = "region",
                 .attained = coverage.losses.empty() ? std::nullopt : std::optional(1 - std::min(lost, 1.0)),
                 .allowed = 1,
                 .where = coverage.witness,
                 .sentence = coverage.why_not});
}

void check_opening(const AuditTask& task, AuditRecord& record) {
  const OpeningInterval& stated = task.design.mechanism.opening;
  const OpeningInterval& found = task.map.certified_opening;
  record.checked("mechanism.opening_deg");
  if (stated.empty()) return;
  const MapTask& m = task.map_task;
  const auto free = contact_free_openings(m.linkage, m.style, m.layers, m.limits.clearance,
                                          m.linkage.openings_with_transmission(m.limits.transmission));
  if (std::any_of(free.begin(), free.end(), [&](const FreeOpenings& one) {
        return one.interval.lower - angle_slack <= stated.lower &&
               stated.upper <= one.interval.upper + angle_slack;
      }))
    return;
  const bool below = found.empty() || stated.lower < found.lower - angle_slack;
  record.broken(
      {.limit = "mechanism.opening_deg",
       .attained = degrees(below ? stated.lower : stated.upper),
       .allowed = found.empty() ? std::nullopt : std::optional(degrees(below ? found.lower : found.upper)),
       .sentence =
           found.empty()
               ? "no opening keeps transmission and clearance"
               : fmt::format(
                     "transmission and clearance are kept from {} to {} degrees, not all over {} .. {}",
                     fixed_text(degrees(found.lower), 6), fixed_text(degrees(found.upper), 6),
                     fixed_text(degrees(stated.lower), 6), fixed_text(degrees(stated.upper), 6))});
}

void check_copy_gap(const AuditTask& task, double gap, AuditRecord& record) {
  const Region& region = task.design.region;
  const auto nearest = nearest_places(region, similar_image(region, task.linkage.k(), task.linkage.pole()));
  if (!nearest) return record.not_checked("limits.sheets_gap_mm", "the file has no region");
  record.checked("limits.sheets_gap_mm");
  if (nearest->distance > 0 && nearest->distance >= gap - task.slack) return;
  if (nearest->distance == 0 &&
      are_apart(region, similar_image(region, task.linkage.k(), task.linkage.pole()), gap))
    return;
  record.broken(
      {.limit = "limits.sheets_gap_mm",
       .attained = nearest->distance,
       .allowed = gap,
       .where = nearest->on_one,
       .sentence = fmt::format("the original and its copy {}; {:.6g} mm are required",
                               nearest->distance > 0 ? fmt::format("are {:.6g} mm apart", nearest->distance)
                                                     : std::string("overlap or touch"),
                               gap)});
}

void check_copy_error(const AuditTask& task, double limit, AuditRecord& record) {
  if (!task.design.tolerance)
    return record.broken({.limit = "limits.copy_error_mm",
                          .allowed = limit,
                          .sentence = "the file states no tolerance under which it could be kept"});
  const auto error =
      copy_error_over(task.linkage, CopyTolerance::uniform(*task.design.tolerance), task.design.region);
  if (!error)
    return record.not_checked("limits.copy_error_mm", "this assembly mode does not reach all of the region");
  record.checked("limits.copy_error_mm");
  const auto& corner = task.design.quality.copy_error_at_corner;
  if (corner && *corner > limit)
    record.not_checked("limits.copy_error_mm",
                       fmt::format("beyond the first order: an instrument within the tolerances has an error "
                                   "of {:.6g} mm, more than the "
                                   "{:.6g} mm allowed",
                                   *corner, limit));
  if (error->worst <= limit * (1 + share_of_rounding)) return;
  record.broken(
      {.limit = "limits.copy_error_mm",
       .attained = error->worst,
       .allowed = limit,
       .where = error->worst_at,
       .sentence = fmt::format("the copy error under the tolerance reaches {:.6g} mm; {:.6g} mm are allowed",
                               error->worst, limit)});
}

/// True if the file says that every instrument within its tolerances is a design: that of a search must.
bool claims_to_be_robust(const StoredDesign& design) {
  const auto& stated = design.quality.robust;
  return design.allowed || design.objective || !stated || stated->holds;
}

void check_robust_claim(const AuditTask& task, AuditRecord& record) {
  const StoredDesign& design = task.design;
  if (!design.tolerance || !design.tolerance->robust) {
    if (design.quality.robust) record.not_checked("quality.robust", "tolerance.robust does not ask for it");
    return;
  }
  if (design.region.empty()) return record.not_checked("tolerance.robust", "the file has no region");
  record.checked("tolerance.robust");
  const RobustCheck found = check_robust(task.map_task, CopyTolerance::uniform(*design.tolerance));
  const bool holds = task.map.coverage.covered && found.keeps(task.map_task.limits.clearance - task.slack);
  if (!holds && claims_to_be_robust(design))
    record.broken({.limit = "tolerance.robust",
                   .attained = found.closes ? std::optional(found.clearance) : std::nullopt,
                   .allowed = task.map_task.limits.clearance,
                   .sentence = robust_fault(found, task.map_task.limits.clearance)});
  const auto& stated = design.quality.robust;
  if (!stated) return;
  record.checked("quality.robust.holds");
  // A search gives no design that does not hold; of a given mechanism one right at the limit may be stated either way.
  const bool holds_surely =
      holds &&
      (design.objective || found.keeps(task.map_task.limits.clearance + task.slack + found.sharpness));
  if (!stated->holds && holds_surely)
    record.broken({.limit = "quality.robust.holds",
                   .attained = found.clearance,
                   .allowed = task.map_task.limits.clearance,
                   .sentence = "it is stated not to hold, but it does"});
  if (stated->nominal_value)
    record.not_checked("quality.robust.nominal_value", "it is of another design, which need not be robust");
  if (!found.closes) return;
  const double rounding =
      found.sharpness + task.slack + (task.map_task.obstacles.empty() ? 0 : 2 * slack::certain_gap);
  record.figure("quality.robust.clearance_min_mm", stated->clearance, found.clearance, rounding);
  const bool unknown =
      std::isinf(stated->clearance_loss) && !design.map.map_tolerance;  // its map was stopped
  record.figure("quality.robust.clearance_loss_mm",
                unknown ? std::nullopt : std::optional(stated->clearance_loss),
                task.map.clearance_min - found.clearance, rounding);
}

/// The file of a given mechanism may say that the region is not covered; that of a search, which names what was sought or
/// allowed, may not.
bool claims_to_cover(const StoredDesign& design) {
  return design.region.empty() || design.region_covered || design.allowed || design.objective;
}

/// The free workspace keeps them, which the map shows; over a region that is not covered none is claimed.
void pass_over_region(const AuditTask& task, AuditRecord& record) {
  record.not_checked("region", "the file states that the mechanism, which was given, does not cover it");
  const char* why = "the file does not state that it is kept over the region, which is not covered";
  if (!task.design.obstacles.empty()) record.not_checked("obstacles", why);
  if (!task.design.bodies.empty()) record.not_checked("bodies", why);
  if (task.design.table) record.not_checked("table", why);
  const auto& limits = task.design.limits;
  if (!limits) return;
  record.not_checked("limits.clearance_mm", why);
  record.not_checked("limits.transmission_deg", why);
  if (limits->copy_gap) record.not_checked("limits.sheets_gap_mm", why);
  if (limits->copy_error) record.not_checked("limits.copy_error_mm", why);
  if (task.design.tolerance && task.design.tolerance->robust) record.not_checked("tolerance.robust", why);
  check_opening(task, record);
}

}  // namespace

void audit_limits(const AuditTask& task, AuditRecord& record) {
  if (!claims_to_cover(task.design)) return pass_over_region(task, record);
  check_coverage(task, record);
  check_clearance_limit(task, record);
  check_robust_claim(task, record);
  if (std::find(task.design.tables.begin(), task.design.tables.end(), "obstacles") ==
      task.design.tables.end())
    record.not_checked("obstacles", "the file does not say whether there are any");
  if (!task.design.limits)
    return record.not_checked("limits", "the file states none: transmission and clearance are taken as 0");
  check_opening(task, record);
  check_transmission(task, task.design.limits->transmission, record);
  if (task.design.limits->copy_gap) check_copy_gap(task, *task.design.limits->copy_gap, record);
  if (task.design.limits->copy_error) check_copy_error(task, *task.design.limits->copy_error, record);
}

}  // namespace kempe
