// kempe/verify.hpp.

#include "kempe/verify.hpp"

#include "library/workings.hpp"
#include "reports/audit/design_audit.hpp"
#include "specs/text/text_file.hpp"
#include "synthesis/verification/verification.hpp"

namespace kempe {

Verification verify(const FinishedDesign& design) {
  return verify(verification_task(Workings::inside(design)));
}

std::variant<Audit, InputError> verify(const std::filesystem::path& design_file) {
  const std::string name = design_file.string();
  const auto found = read_text_file(design_file)
                         .and_then([&](const std::string& text) { return read_design(text, name); })
                         .and_then([&](const StoredDesign& design) { return audit(design, name); });
  if (!found) return found.error();
  return Audit{found->holds(), found->broken};
}

}  // namespace kempe
