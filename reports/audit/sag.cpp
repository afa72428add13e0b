// The sag over the region, recomputed from the stored lengths by the same formulas as the search's, and the limit on it.

#include "synthesis/loads/sag.hpp"

#include <algorithm>

#include "reports/audit/give_limit.hpp"
#include "reports/audit/record.hpp"
#include "reports/audit/slack.hpp"
#include "synthesis/design/error_budget.hpp"

namespace kempe {

void audit_sag(const AuditTask& task, AuditRecord& record) {
  const StoredDesign& design = task.design;
  const GiveLimit limit{.figure = "quality.sag_max_mm",
                        .is_stated = design.quality.sag.has_value(),
                        .key = "limits.sag_mm",
                        .limit = design.limits ? design.limits->sag : std::nullopt,
                        .words = "tracer or pen sinks by"};
  if (limit.is_absent()) return;
  const char* why = !design.material ? "the file states no material"
                    : !task.needed   ? "this assembly mode does not reach all of the region"
                                     : nullptr;
  if (why != nullptr) return limit.cannot_tell(task, why, ", without which it cannot be kept", record);
  const double found =
      largest_sag(task.linkage, sag_conditions(as_built(design), design.layers), *task.needed).sag.most();
  record.figure(limit.figure, design.quality.sag, found,
                std::max(audit_slack::share_of_copy_error * found, no_drop));
  limit.check(task, found, record);
}

}  // namespace kempe
