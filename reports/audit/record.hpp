#pragma once
// What an audit found so far. For the sources of the audit only.

#include <optional>
#include <string>

#include "reports/audit/design_audit.hpp"

namespace kempe {

class AuditRecord {
 public:
  explicit AuditRecord(DesignAudit& audit) : audit_(audit) {}

  /// The key was looked at; said once however often.
  void checked(const std::string& key);
  /// The key was looked at and does not hold; the first breach of a key is kept.
  void broken(BrokenLimit breach);
  void not_checked(std::string key, std::string why);

  /// A figure as stated and as found, in the key's unit; broken if they differ by more than `rounding`.
  /// Nothing is checked if the file states none.
  void figure(const std::string& key, std::optional<double> stated, double found, double rounding);

 private:
  DesignAudit& audit_;
};

/// What the exact checks share.
struct AuditTask {
  const StoredDesign& design;
  const CopyingLinkage& linkage;
  /// Without the gap between original and copy; with clearance and transmission 0 if the file has no limits.
  MapTask map_task;
  WorkspaceMap map;
  std::optional<OpeningInterval> needed;  ///< openings over the region; nothing if it is not reached
  double slack = 0;                       ///< mm: what rounding of lengths and coordinates may do
};

/// The linkage that the eight lengths, the ratio, the opening and the orientation agree on; nothing if they
/// do not, and then what is broken is recorded.
std::optional<CopyingLinkage> audit_mechanism(const StoredDesign& design, AuditRecord& record);

/// Lengths, layers, pole, grounding and holes against what the spec allowed.
void audit_allowed(const StoredDesign& design, const CopyingLinkage& linkage, double slack,
                   AuditRecord& record);

/// The limits over the whole region, obstacles, coverage, the certified opening.
void audit_limits(const AuditTask& task, AuditRecord& record);

/// Section, pins, holes, material, load and tolerance as the file states them; all else as a spec has it by itself.
Spec as_built(const StoredDesign& design);

/// Quality, workspace, search, tool and ratio error against what is computed anew.
void audit_figures(const AuditTask& task, AuditRecord& record);
/// Mass, forces, load error with and without pins and layers, and the limit on it.
void audit_loads(const AuditTask& task, AuditRecord& record);
/// The sag, and the limit on it.
void audit_sag(const AuditTask& task, AuditRecord& record);
/// What the file says of its own verification, and the bound, against the other figures.
void audit_claims(const StoredDesign& design, const Verification& drive, AuditRecord& record);

}  // namespace kempe
