// Specs in, designs out: kempe/validate.hpp and kempe/write.hpp.

#include "kempe/validate.hpp"
#include "kempe/verify.hpp"
#include "kempe/write.hpp"
#include "library/workings.hpp"
#include "reports/audit/design_audit.hpp"
#include "reports/certificate.hpp"
#include "reports/data/design_json.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/parts_fault.hpp"
#include "reports/drawings/svg_writer.hpp"
#include "reports/page/html_report.hpp"
#include "reports/publication.hpp"
#include "reports/restored_design.hpp"
#include "specs/spec_check.hpp"
#include "specs/spec_reader.hpp"

namespace kempe {
namespace {

ReportExtras extras_of(const FinishedDesign& design, const std::string& title) {
  ReportExtras extras;
  extras.program_version = KEMPE_VERSION;
  extras.spec_name = title;
  extras.spec_text = Workings::spec_text(design);
  return extras;
}

/// What does not hold, as a fault of the file.
InputError fault_of(const BrokenLimit& broken, const std::string& file) {
  return {file, 0, broken.limit, broken.sentence, "a design that holds"};
}

}  // namespace

std::optional<InputError> validate(const Spec& spec) {
  const auto checked = check_spec(spec);
  return checked ? std::nullopt : std::optional(checked.error());
}

std::variant<Spec, InputError> load(const std::filesystem::path& file) {
  auto spec = read_spec_file(file);
  if (!spec) return spec.error();
  return std::move(*spec);
}

std::variant<Spec, InputError> parse(std::string_view text, const std::string& name,
                                     const std::filesystem::path& folder) {
  auto spec = read_spec(text, name, folder);
  if (!spec) return spec.error();
  return std::move(*spec);
}

std::string toml_text(const Spec& spec) { return spec_as_toml(spec); }

Written write(const FinishedDesign& design, const std::filesystem::path& folder, const std::string& title) {
  Design finished = Workings::inside(design);
  FolderDraft draft(folder);
  const auto drafted = draft_design(finished, extras_of(design, title), draft);
  if (!drafted) return {{}, {}, drafted.error().sentence};
  const std::vector<std::string> files = draft.names();
  if (const auto placed = draft.put_in_place(); !placed) return {{}, {}, placed.error()};
  return {files, drafted->left_out, ""};
}

std::string report(const FinishedDesign& design, const std::string& title) {
  Design finished = Workings::inside(design);
  finished.verification = verify(design);
  ReportExtras extras = extras_of(design, title);
  if (const auto fault = parts_fault(finished, finished.cutting)) extras.why_no_parts = fault->sentence;
  return html_report(finished, extras);
}

std::string drawing(const FinishedDesign& design) {
  const Design& inside = Workings::inside(design);
  return svg_text(design_drawing(inside, inside.cutting), drawing_title(inside));
}

std::string verified_json(const FinishedDesign& design) {
  Design finished = Workings::inside(design);
  finished.verification = verify(design);
  return design_json(finished);
}

std::variant<FinishedDesign, InputError> restore(std::string_view json, const std::string& name,
                                                 ClaimedBound bound) {
  const auto stored = read_design(json, name);
  if (!stored) return stored.error();
  const auto found = audit(*stored, name);
  if (!found) return found.error();
  if (!found->holds()) {
    InputError faults = fault_of(found->broken.front(), name);
    for (auto other = found->broken.begin() + 1; other != found->broken.end(); ++other)
      faults.others.push_back(fault_of(*other, name));
    return faults;
  }
  auto design = restored_design(*stored, name);
  if (!design) return design.error();
  if (bound == ClaimedBound::prove && design->quality.proven_bound && !certificate_of(*design))
    design->quality.proven_bound.reset();
  std::string spec_text = spec_as_toml(spec_of(*design));
  return Workings::finished(std::move(*design), std::move(spec_text));
}

}  // namespace kempe
