#include "reports/audit/give_limit.hpp"

#include <fmt/format.h>

#include "reports/audit/slack.hpp"

namespace kempe {

void GiveLimit::cannot_tell(const AuditTask& task, const std::string& why, const std::string& without,
                            AuditRecord& record) const {
  if (is_stated) record.not_checked(figure, why);
  if (limit && task.needed)
    record.broken({.limit = key, .allowed = limit, .sentence = why + without});
  else if (limit)
    record.not_checked(key, why);
}

void GiveLimit::check(const AuditTask& task, double found, AuditRecord& record) const {
  const StoredDesign& design = task.design;
  const bool claimed = design.region_covered || design.allowed || design.objective;
  if (!limit || !claimed) return;
  record.checked(key);
  if (found <= *limit * (1 + audit_slack::share_of_copy_error)) return;
  record.broken({.limit = key,
                 .attained = found,
                 .allowed = limit,
                 .sentence = fmt::format("{} {:.6g} mm; {:.6g} mm are allowed", words, found, *limit)});
}

}  // namespace kempe
