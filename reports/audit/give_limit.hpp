#pragma once
// A figure of how far an instrument gives way or sinks, and the limit on it: what the audits of loads and sag share.

#include <optional>
#include <string>

#include "reports/audit/record.hpp"

namespace kempe {

struct GiveLimit {
  std::string figure;           ///< "quality.sag_max_mm"
  bool is_stated;               ///< the file states the figure
  std::string key;              ///< "limits.sag_mm"
  std::optional<double> limit;  ///< mm
  std::string words;            ///< "tracer or pen sinks by"

  /// Nothing to look at.
  bool is_absent() const { return !is_stated && !limit; }
  /// The figure cannot be computed, `why`: it is not checked. A limit then is broken if the region is reached (`without` goes on: what
  /// follows for the limit), else not checked.
  void cannot_tell(const AuditTask& task, const std::string& why, const std::string& without,
                   AuditRecord& record) const;
  /// The limit against what was found (mm), where the file claims to keep its limits.
  void check(const AuditTask& task, double found, AuditRecord& record) const;
};

}  // namespace kempe
