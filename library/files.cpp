// Specs in, designs out: kempe/validate.hpp and kempe/write.hpp.

#include "kempe/validate.hpp"
#include "kempe/write.hpp"
#include "library/workings.hpp"
#include "reports/publication.hpp"
#include "specs/spec_check.hpp"
#include "specs/spec_reader.hpp"

namespace kempe {

std::optional<InputError> validate(const Spec& spec) {
  const auto checked = check_spec(spec);
  return checked ? std::nullopt : std::optional(checked.error());
}

std::variant<Spec, InputError> load(const std::filesystem::path& file) {
  auto spec = read_spec_file(file);
  if (!spec) return spec.error();
  return std::move(*spec);
}

std::string toml_text(const Spec& spec) { return spec_as_toml(spec); }

Written write(const FinishedDesign& design, const std::filesystem::path& folder, const std::string& title) {
  Design finished = Workings::inside(design);
  ReportExtras extras;
  extras.program_version = KEMPE_VERSION;
  extras.spec_name = title;
  extras.spec_text = Workings::spec_text(design);
  FolderDraft draft(folder);
  const auto drafted = draft_design(finished, extras, draft);
  if (!drafted) return {{}, {}, drafted.error().sentence};
  const std::vector<std::string> files = draft.names();
  if (const auto placed = draft.put_in_place(); !placed) return {{}, {}, placed.error()};
  return {files, drafted->left_out, ""};
}

}  // namespace kempe
