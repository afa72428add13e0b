#include "reports/data/stored/parts.hpp"
#include "reports/data/stored/values.hpp"
#include "specs/file_kind.hpp"
#include "specs/text/json_text.hpp"

namespace kempe {
namespace {

StoredDesign design_in(const JsonField& root) {
  StoredDesign design;
  if (root["format"].text() != "kempe-design/1") root["format"].refuse("\"kempe-design/1\"");
  if (root.faults() > 0) return design;  // another file
  stored::read_copy(root["copy"], design);
  design.region = stored::region(root["region"]);
  stored::read_mechanism(root["mechanism"], design);
  stored::read_claims(root, design);
  stored::read_task(root, design);
  stored::read_search(root, design);
  stored::read_allowed(root, design);
  stored::note_keys(root, design);
  return design;
}

}  // namespace

tl::expected<StoredDesign, InputError> read_design(std::string_view text, const std::string& file) {
  const auto json = parse_json(text, file);
  if (!json) return tl::unexpected(or_other_kind(json.error(), text, FileKind::design));
  JsonField::Log log{file};
  StoredDesign design = design_in(JsonField(*json, log));
  if (log.faults.empty()) return design;
  InputError faults = log.faults.front();
  faults.others.assign(log.faults.begin() + 1, log.faults.end());
  return tl::unexpected(or_other_kind(std::move(faults), text, FileKind::design));
}

}  // namespace kempe
