#include "reports/audit/design_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/fixed_text.hpp"
#include "geometry/regions/region_checks.hpp"
#include "kinematics/grounding.hpp"
#include "kinematics/links.hpp"
#include "reports/audit/record.hpp"
#include "reports/audit/slack.hpp"
#include "workspace/reach.hpp"

namespace kempe {

void AuditRecord::checked(const std::string& key) {
  if (std::find(audit_.checked.begin(), audit_.checked.end(), key) == audit_.checked.end())
    audit_.checked.push_back(key);
}

void AuditRecord::broken(BrokenLimit breach) {
  checked(breach.limit);
  if (std::none_of(audit_.broken.begin(), audit_.broken.end(),
                   [&](const BrokenLimit& one) { return one.limit == breach.limit; }))
    audit_.broken.push_back(std::move(breach));
}

void AuditRecord::not_checked(std::string key, std::string why) {
  audit_.not_checked.push_back({std::move(key), std::move(why)});
}

void AuditRecord::figure(const std::string& key, std::optional<double> stated, double found,
                         double rounding) {
  if (!stated) return;
  checked(key);
  // Where nothing finite is found, none agrees.
  if (*stated == found || (std::isfinite(found) && std::abs(*stated - found) <= rounding)) return;
  broken({.limit = key,
          .attained = stated,
          .allowed = found,
          .sentence = fmt::format("the file states {:.9g}; recomputed it is {:.9g}", *stated, found)});
}

namespace {

/// Limits stand in these tables: a key of theirs that is not known cannot be passed over.
bool is_limit(const std::string& key) {
  constexpr std::string_view tables[] = {"limits.", "tolerance.", "obstacles[", "bodies[",
                                         "table.",  "pole.",      "links.",     "objective."};
  return std::any_of(std::begin(tables), std::end(tables),
                     [&](std::string_view table) { return key.starts_with(table); });
}

/// The region as its invariant wants it, or what is wrong with its rings.
tl::expected<Region, InputError> checked_region(const Region& region, const std::string& key,
                                                const std::string& file) {
  if (region.empty()) return region;
  std::vector<Ring> outers, holes;
  for (const Polygon& polygon : region.polygons) {
    outers.push_back(polygon.outer);
    holes.insert(holes.end(), polygon.holes.begin(), polygon.holes.end());
  }
  auto assembled = assemble_region(outers, holes);
  if (assembled) return std::move(*assembled);
  return tl::unexpected(InputError{file, 0, key, assembled.error().found, assembled.error().allowed});
}

/// What is wrong with an outline of a body or of the table: one simple ring is wanted.
std::optional<InputError> outline_fault(const Polygon& shape, const std::string& key,
                                        const std::string& file) {
  if (!shape.holes.empty()) return InputError{file, 0, key, "an outline with holes", "one without"};
  if (const auto fault = shape_fault(without_repeated_corners(shape.outer)))
    return InputError{file, 0, key, fault->found, fault->allowed};
  auto checked = checked_region(Region{{shape}}, key, file);
  return checked ? std::nullopt : std::optional(std::move(checked.error()));
}

/// A body that turns with a link that does not have its point.
std::optional<InputError> turning_fault(const StoredDesign& design, std::size_t number,
                                        const std::string& file) {
  const Body& body = design.bodies[number];
  if (!body.turns_with) return std::nullopt;
  const JointRoles roles = roles_of(design.grounding);
  const Joint at = body.at == Carrier::tracer ? roles.tracer : roles.pen;
  if (has_joint(*body.turns_with, at)) return std::nullopt;
  std::string names;
  for (const Link link : all_links)
    if (has_joint(link, at)) names += (names.empty() ? "" : " or ") + std::string(name(link));
  return InputError{file, 0, fmt::format("bodies[{}].turns_with", number),
                    std::string(name(*body.turns_with)), names};
}

std::optional<InputError> unfit_surroundings(const StoredDesign& design, const std::string& file) {
  if (design.tolerance && design.tolerance->robust && (!design.bodies.empty() || design.table))
    return InputError{file, 0, "tolerance.robust", "true beside bodies or a table",
                      "false there: what is robust is known without them alone"};
  for (std::size_t i = 0; i < design.bodies.size(); ++i)
    if (auto fault = turning_fault(design, i, file)) return fault;
  for (std::size_t i = 0; i < design.bodies.size(); ++i)
    if (const auto* polygon = std::get_if<Polygon>(&design.bodies[i].shape))
      if (auto fault = outline_fault(*polygon, fmt::format("bodies[{}].shape", i), file)) return fault;
  return design.table ? outline_fault(*design.table, "table", file) : std::nullopt;
}

/// What makes a file unfit to be judged.
std::optional<InputError> unfit(const StoredDesign& design, const std::string& file) {
  for (const std::string& key : design.unknown_keys)
    if (is_limit(key))
      return InputError{file, 0, key, "a limit that this version does not know",
                        "the keys of docs/design-file.md"};
  for (std::size_t i = 0; i < design.obstacles.size(); ++i) {
    const Polygon& shape = design.obstacles[i].shape;
    if (const auto fault = shape_fault(without_repeated_corners(shape.outer)))
      return InputError{file, 0, fmt::format("obstacles[{}].shape", i), fault->found, fault->allowed};
  }
  return unfit_surroundings(design, file);
}

double magnitude(const StoredDesign& design) {
  double most = design.mechanism.pole_position.cwiseAbs().maxCoeff();
  if (design.region.empty()) return most;
  const Box box = bounding_box(design.region);
  return std::max({most, box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff()});
}

/// Filled by hand from the file: a limit that map_task() forgot would be forgotten here too.
AuditTask audit_task(const StoredDesign& design, const CopyingLinkage& linkage) {
  MapTask mapped{.linkage = linkage, .style = design.style, .layers = design.layers};
  if (design.limits) {
    mapped.limits = *design.limits;
    mapped.limits.copy_gap.reset();  // asked apart, of the copy
  }
  mapped.obstacles = design.obstacles;
  mapped.bodies = design.bodies;
  mapped.table = design.table;
  mapped.region = design.region;
  WorkspaceMap map =
      map_workspace(mapped, {.map_tolerance = design.map.map_tolerance.value_or(MapOptions{}.map_tolerance),
                             .largest_sheets = !design.map.sheets.empty()});
  return {.design = design,
          .linkage = linkage,
          .map_task = std::move(mapped),
          .map = std::move(map),
          .needed = openings_over(linkage, design.region),
          .slack = audit_slack::share_of_rounding * linkage.size() +
                   audit_slack::share_of_coordinates * magnitude(design)};
}

void look_at(const StoredDesign& design, DesignAudit& result) {
  AuditRecord record(result);
  for (const std::string& key : design.unknown_keys) record.not_checked(key, "this version does not know it");
  record.checked("mechanism.lengths_mm");
  record.checked("copy");
  if (const auto linkage = audit_mechanism(design, record)) {
    const AuditTask task = audit_task(design, *linkage);
    audit_allowed(design, *linkage, task.slack, record);
    audit_limits(task, record);
    audit_figures(task, record);
    audit_loads(task, record);
    audit_sag(task, record);
  } else {
    const char* why = "the mechanism's figures contradict each other";
    for (const char* key : {"region", "obstacles", "bodies", "table", "limits", "links", "pole", "objective",
                            "cutting", "quality", "workspace", "tool"})
      record.not_checked(key, why);
  }
  audit_claims(design, result.drive, record);
  for (const BrokenLimit& breach : result.drive.broken) record.broken(breach);
  if (!result.drive.holds && result.broken.empty())
    record.broken({.limit = "verification.certified", .sentence = result.drive.failure});
}

}  // namespace

tl::expected<DesignAudit, InputError> audit(const StoredDesign& stored, const std::string& file) {
  if (auto fault = unfit(stored, file)) return tl::unexpected(std::move(*fault));
  StoredDesign design = stored;
  auto region = checked_region(design.region, "region", file);
  if (!region) return tl::unexpected(std::move(region.error()));
  design.region = std::move(*region);
  DesignAudit result;
  result.drive = verify(verification_task(design));
  look_at(design, result);
  return result;
}

namespace {

std::string place(const BrokenLimit& breach) {
  if (!breach.where || breach.sentence.find("tracer at") != std::string::npos) return "";
  return fmt::format(" (at {}, {})", fixed_text(breach.where->x(), 3), fixed_text(breach.where->y(), 3));
}

}  // namespace

std::string audit_text(const DesignAudit& audit) {
  std::string text = audit.holds() ? "holds        everything that was checked\n"
                                   : fmt::format("DOES NOT HOLD: {} broken\n", audit.broken.size());
  for (const BrokenLimit& breach : audit.broken)
    text += fmt::format("broken       {}: {}{}\n", breach.limit, breach.sentence, place(breach));
  text += fmt::format(
      "driven       {} positions{} by the general solver: copy error {:.2g} mm, loop residual {:.2g} mm, {} "
      "changes of assembly mode\n",
      audit.drive.samples, audit.drive.over_workspace ? " of the free workspace" : "",
      audit.drive.copy_error_max, audit.drive.loop_residual_max, audit.drive.flips);
  text +=
      fmt::format("checked      {} statements of the file; --json lists their keys\n", audit.checked.size());
  for (const NotChecked& one : audit.not_checked)
    text += fmt::format("not checked  {}: {}\n", one.key, one.why);
  return text;
}

std::string audit_json(const DesignAudit& audit, const std::string& file) {
  using Json = nlohmann::ordered_json;
  const auto number = [](const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
  };
  const Verification& drive = audit.drive;
  Json object{{"file", file},
              {"certified", audit.holds()},
              {"samples", drive.samples},
              {"driven_over", drive.over_workspace ? "workspace" : "region"},
              {"copy_error_max_mm", drive.copy_error_max},
              {"loop_residual_max_mm", drive.loop_residual_max},
              {"scale", drive.scale},
              {"rotation_deg", degrees(drive.rotation)},
              {"flips", drive.flips},
              {"checked", audit.checked},
              {"broken", Json::array()},
              {"not_checked", Json::array()}};
  for (const BrokenLimit& breach : audit.broken)
    object["broken"].push_back(
        {{"limit", breach.limit},
         {"attained", number(breach.attained)},
         {"allowed", number(breach.allowed)},
         {"where_mm", breach.where ? Json::array({breach.where->x(), breach.where->y()}) : Json(nullptr)},
         {"sentence", breach.sentence}});
  for (const NotChecked& one : audit.not_checked)
    object["not_checked"].push_back({{"key", one.key}, {"why", one.why}});
  if (!audit.holds()) object["failure"] = audit.broken.front().limit + ": " + audit.broken.front().sentence;
  return object.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace kempe
