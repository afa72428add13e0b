// The sag over the region, recomputed from the stored lengths by the same formulas as the search's, and the limit on it.

#include "synthesis/loads/sag.hpp"

#include <fmt/format.h>

#include "reports/audit/record.hpp"
#include "reports/audit/slack.hpp"

namespace kempe {
namespace {

using namespace audit_slack;

/// What the file says of material, load, play, section and pins.
Spec of_sag(const StoredDesign& design) {
  Spec spec;
  spec.links.style = design.style;
  spec.links.hardware = design.hardware;
  spec.material = design.material;
  spec.load = design.load;
  spec.tolerance = design.tolerance;
  return spec;
}

void check_sag_limit(double limit, double attained, AuditRecord& record) {
  const std::string key = "limits.sag_mm";
  record.checked(key);
  if (attained <= limit * (1 + share_of_copy_error)) return;
  record.broken(
      {.limit = key,
       .attained = attained,
       .allowed = limit,
       .sentence = fmt::format("tracer or pen sinks by {:.6g} mm; {:.6g} mm are allowed", attained, limit)});
}

}  // namespace

void audit_sag(const AuditTask& task, AuditRecord& record) {
  const StoredDesign& design = task.design;
  const std::optional<double> none;
  const std::optional<double>& limit = design.limits ? design.limits->sag : none;
  if (!design.quality.sag && !limit) return;
  const char* why = !design.material ? "the file states no material"
                    : !task.needed   ? "this assembly mode does not reach all of the region"
                                     : nullptr;
  if (why != nullptr) {
    if (design.quality.sag) record.not_checked("quality.sag_max_mm", why);
    if (limit && task.needed)
      record.broken({.limit = "limits.sag_mm",
                     .allowed = limit,
                     .sentence = std::string(why) + ", without which it cannot be kept"});
    else if (limit)
      record.not_checked("limits.sag_mm", why);
    return;
  }
  const double found =
      largest_sag(task.linkage, sag_conditions(of_sag(design), design.layers), *task.needed).sag.most();
  record.figure("quality.sag_max_mm", design.quality.sag, found, share_of_copy_error * found);
  const bool claimed = design.region_covered || design.allowed || design.objective;
  if (limit && claimed) check_sag_limit(*limit, found, record);
}

}  // namespace kempe
