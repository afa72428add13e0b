#pragma once
// Everything that a design file states, checked anew from the file alone. What is looked at and how far a
// figure may be off: docs/verification.md.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "reports/data/design_json.hpp"

namespace kempe {

/// Something that the file states, or ought to, that was not looked at.
struct NotChecked {
  std::string key, why;
};

struct DesignAudit {
  Verification drive;                ///< of the general solver, from the eight lengths
  std::vector<std::string> checked;  ///< keys, in the order they were looked at
  std::vector<BrokenLimit> broken;   ///< one a key, of the keys in `checked`
  std::vector<NotChecked> not_checked;
  bool holds() const { return broken.empty(); }
};

/// Checks a stored design:
///  1. every limit, obstacle and figure of the file appears once: among `checked`, or among `not_checked`;
///  2. a limit that does not hold, and a figure that differs from the one computed anew by more than its
///     rounding, is in `broken`.
/// Refused, with the key: rings that are no region, limits that this version does not know.
tl::expected<DesignAudit, InputError> audit(const StoredDesign& design, const std::string& file);

/// The audit for a person: what holds, what is broken and where, what was not looked at.
std::string audit_text(const DesignAudit& audit);
/// One JSON object: docs/verification.md.
std::string audit_json(const DesignAudit& audit, const std::string& file);

}  // namespace kempe
