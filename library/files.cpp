// Specs in, designs out: kempe/validate.hpp and kempe/write.hpp.

#include "kempe/validate.hpp"
#include "kempe/verify.hpp"
#include "kempe/write.hpp"
#include "library/workings.hpp"
#include "reports/audit/design_audit.hpp"
#include "reports/certificate.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/data/design_json.hpp"
#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/parts_fault.hpp"
#include "reports/drawings/svg_writer.hpp"
#include "reports/earlier_design.hpp"
#include "reports/front_folder.hpp"
#include "reports/page/html_report.hpp"
#include "reports/page/studio_page.hpp"
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

Written write(const FinishedDesign& design, const std::filesystem::path& folder,
              const WriteOptions& options) {
  Design finished = Workings::inside(design);
  ReportExtras extras = extras_of(design, options.title);
  extras.paper = options.paper;
  std::string studio;
  if (!options.studio.empty()) {
    auto page = studio_page(options.studio, Workings::spec_text(design), options.title);
    if (const auto* fault = std::get_if<InputError>(&page)) return {{}, {}, fault->message()};
    studio = std::move(std::get<std::string>(page));
    extras.studio_page = studio_page_name;
  }
  FolderDraft draft(folder);
  const auto drafted = draft_design(finished, extras, draft);
  if (!drafted) return {{}, {}, drafted.error().sentence};
  if (!studio.empty())
    if (const auto added = draft.add({studio_page_name, studio}); !added) return {{}, {}, added.error()};
  const std::vector<std::string> files = draft.names(), earlier = design_files_in(folder);
  if (const auto placed = draft.put_in_place(); !placed) return {{}, {}, placed.error()};
  std::vector<std::string> left_out = drafted->left_out;
  if (const auto removed = remove_left_over(folder, earlier, files); !removed.empty())
    left_out.push_back(removed_sentence(removed));
  return {files, std::move(left_out), ""};
}

Written write(const Front& front, const std::filesystem::path& folder, const WriteOptions& options) {
  if (front.points.empty()) return {{}, {}, "a front without points has no files"};
  ReportExtras extras = extras_of(front.points.front().design, options.title);
  extras.paper = options.paper;
  FrontFolder files(folder, front.first, front.second, front.points.size(), std::move(extras));
  for (const FrontPoint& point : front.points)
    if (const auto added = files.add(Workings::inside(point.design), point.first, point.second); !added)
      return {{}, {}, added.error()};
  if (const auto placed = files.put_in_place(); !placed) return {{}, {}, placed.error()};
  return {files.names(), files.left_out(), ""};
}

Written write(const CalibratedInstrument& found, const std::filesystem::path& folder) {
  std::vector<OutputFile> files{{"calibration.json", found.json}, {"report.html", found.page}};
  if (!found.simulated.empty()) files.push_back({"simulated.toml", found.simulated});
  if (const auto written = write_whole(folder, files); !written) return {{}, {}, written.error()};
  Written told;
  for (const OutputFile& file : files) told.files.push_back(file.name.string());
  return told;
}

std::variant<std::string, InputError, NoProof> proof_of_none(const Spec& spec,
                                                             const std::function<bool()>& stop) {
  const auto checked = check_spec(spec);
  if (!checked) return checked.error();
  auto log = certificate_of_none(*checked, stop);
  if (!log) return NoProof{left_out_sentence(log.error())};
  return std::move(*log);
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
                                                 ClaimedBound bound, const std::function<bool()>& stop) {
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
  auto design = restored_design(*stored, name, stop);
  if (!design) return design.error();
  if (bound == ClaimedBound::prove && design->quality.proven_bound) {
    const auto certificate = certificate_of(*design, stop);
    design->quality.proven_bound = certificate ? certificate->bound : std::nullopt;
  }
  std::string spec_text = spec_as_toml(spec_of(*design));
  return Workings::finished(std::move(*design), std::move(spec_text));
}

}  // namespace kempe
