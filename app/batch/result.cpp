#include "app/batch/result.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "app/batch/task_spec.hpp"
#include "kinematics/deadline.hpp"
#include "reports/data/csv_text.hpp"
#include "reports/drawings/parts_fault.hpp"
#include "specs/objective_unit.hpp"
#include "specs/spec_reader.hpp"
#include "specs/text/json_text.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/search_faults.hpp"
#include "synthesis/verification/verification.hpp"

namespace kempe::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* csv_columns[] = {"name",
                                       "status",
                                       "vertex",
                                       "assembly",
                                       "VA_mm",
                                       "VB_mm",
                                       "size_mm",
                                       "transmission_deg",
                                       "clearance_mm",
                                       "copy_error_worst_mm",
                                       "copy_error_at_corner_mm",
                                       "message"};

/// JSON on one line; bytes that are no UTF-8, as a file's name may have, become U+FFFD.
std::string line_of(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json figures(const Design& design) {
  const CopyingLinkage& l = design.linkage;
  Json line{{"vertex", std::string(name(l.grounding()))},
            {"assembly", l.assembly_mode().number},
            {"VA_mm", l.VA()},
            {"VB_mm", l.VB()},
            {"pole_mm", {l.pole().x(), l.pole().y()}},
            {"layers", design.layers.of},
            {"size_mm", design.quality.size},
            {"transmission_deg", degrees(design.quality.transmission_min)},
            {"clearance_mm", design.quality.clearance_min},
            {"region_covered", design.map.coverage.covered},
            {"copy_error_max_mm", design.verification.copy_error_max}};
  if (const auto& worst = design.quality.copy_error_worst) line["copy_error_worst_mm"] = *worst;
  if (const auto& found = design.quality.copy_error_at_corner) line["copy_error_at_corner_mm"] = *found;
  if (const auto& robust = design.quality.robust) line["robust_clearance_mm"] = robust->clearance;
  if (const auto& search = design.search) {  // as in design.json
    line["objective"] = std::string(name(search->objective));
    line["value"] = in_file_unit(search->objective, search->value);
    if (const auto& bound = design.quality.proven_bound)
      line["lower_bound"] = in_file_unit(search->objective, *bound);
    if (!search->complete) line["complete"] = false;
  }
  return line;
}

/// The topmost fault, and how many more there are.
std::string in_one_line(const InputError& error) {
  const std::size_t more = error.others.size();
  if (more == 0) return error.message();
  return fmt::format("{} (and {} more {})", error.message(), more, more == 1 ? "fault" : "faults");
}

}  // namespace

std::string batch_result(const BatchTask& task, const SearchOptions& given) {
  Json line{{"name", task.name}};
  const auto read = task_spec(task);
  const std::optional<InputError> fault = read ? search_fault(read->spec) : read.error();
  if (fault) {
    line["status"] = "bad input";
    line["message"] = in_one_line(*fault);
    return line_of(line);
  }
  const Spec& spec = read->spec;
  const Deadline deadline(given.time_limit);
  SearchOptions options = given;
  options.unit = unit_of_spec(read->text);
  options.diagnose = false;  // of thousands of specs: `kempe synthesize` on one of them says why
  const SearchOutcome outcome = synthesize(spec, options);
  const auto* found = std::get_if<FoundDesign>(&outcome);
  if (found == nullptr) {
    const auto* none = std::get_if<NoDesign>(&outcome);
    line["status"] = none == nullptr ? "stopped" : none->proven ? "no design" : "none found";
    line["message"] =
        none != nullptr ? none->sentence : "stopped before a design was found or proven impossible";
    if (none != nullptr) line["proven"] = none->proven;
    return line_of(line);
  }
  MapOptions map;
  map.largest_sheets = false;  // not among the figures of a batch
  map.stop = deadline.flag(given.stop, 1, time_to_map(given.time_limit));
  auto certified = certified_design(spec, *found, map, Detail::figures);
  if (!certified) {
    line["status"] = "none found";
    line["proven"] = false;
    line["message"] = certified.error();
    return line_of(line);
  }
  Design& design = *certified;
  if (design.search && !design.map.complete) design.search->complete = false;
  design.verification = run_verification(verification_task(design), {.stop = map.stop}).found;
  line["status"] = design.verification.holds ? "design" : "verification failed";
  line.update(figures(design));
  if (!design.verification.holds) line["message"] = design.verification.failure;
  if (const auto unfit = parts_fault(design, spec.cutting)) line["parts"] = unfit->sentence;
  return line_of(line);
}

/// Whether a text from a journal is a line that batch_result() writes: what follows relies on it.
bool is_batch_result(const std::string& line) {
  const auto object = parse_json(line, "journal");
  const auto holds = [&](const char* name, auto is_kind) {
    const auto found = object->find(name);
    return found != object->end() && is_kind(*found);
  };
  const auto text = [](const nlohmann::json& value) { return value.is_string(); };
  const auto number = [](const nlohmann::json& value) { return value.is_number(); };
  if (!object || !object->is_object() || !holds("name", text) || !holds("status", text)) return false;
  const std::string status = object->at("status");
  if (status == "bad input" || status == "no design" || status == "none found" || status == "stopped")
    return holds("message", text);
  if (status != "design" && status != "verification failed") return false;
  return holds("vertex", text) && holds("VA_mm", number) && holds("VB_mm", number) &&
         holds("size_mm", number);
}

std::string batch_status(const std::string& line) { return Json::parse(line)["status"]; }

std::string batch_csv_head() {
  std::string head;
  for (const char* column : csv_columns) head += (head.empty() ? "" : ",") + std::string(column);
  return head + "\n";
}

std::string batch_csv_row(const std::string& line) {
  const Json object = Json::parse(line);
  std::string row;
  for (const char* column : csv_columns) {
    const auto found = object.find(column);
    if (column != csv_columns[0]) row += ",";
    if (found != object.end())
      row += found->is_string() ? csv_cell(found->get<std::string>()) : found->dump();
  }
  return row + "\n";
}

}  // namespace kempe::app
