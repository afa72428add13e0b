#include "app/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/batch_journal.hpp"
#include "app/interrupt.hpp"
#include "app/output_check.hpp"
#include "app/ranks.hpp"
#include "reports/data/atomic_file.hpp"
#include "reports/data/csv_text.hpp"
#include "reports/drawings/parts_fault.hpp"
#include "specs/json_spec.hpp"
#include "specs/objective_unit.hpp"
#include "specs/spec_reader.hpp"
#include "specs/text/json_text.hpp"
#include "specs/text/printable.hpp"
#include "specs/text/text_file.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/search.hpp"
#include "synthesis/solvers/parallel.hpp"
#include "synthesis/verification/verification.hpp"

namespace kempe::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// JSON on one line; bytes that are no UTF-8, as a file's name may have, become U+FFFD.
std::string line_of(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::vector<BatchTask> folder_tasks(const fs::path& folder) {
  std::vector<BatchTask> tasks;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml")
      tasks.push_back(
          {entry.path().filename().string(), read_text_file(entry.path()), folder.string(), false});
  std::sort(tasks.begin(), tasks.end(),
            [](const BatchTask& a, const BatchTask& b) { return a.name < b.name; });
  return tasks;
}

tl::expected<std::vector<BatchTask>, InputError> line_tasks(const std::string& file) {
  std::vector<BatchTask> tasks;
  std::ifstream stream(file, std::ios::binary);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string name = fmt::format("line-{}", number);
    tasks.push_back({name, toml_from_json(line, name), fs::path(file).parent_path().string(), true});
  }
  return tasks;
}

Json figures(const Design& design) {
  const CopyingLinkage& l = design.linkage;
  Json line{{"vertex", std::string(name(l.grounding()))},
            {"assembly", l.assembly_mode()},
            {"VA_mm", l.VA()},
            {"VB_mm", l.VB()},
            {"pole_mm", {l.pole().x(), l.pole().y()}},
            {"layers", design.layers.of},
            {"size_mm", design.quality.size},
            {"transmission_deg", degrees(design.quality.transmission_min)},
            {"clearance_mm", design.quality.clearance_min},
            {"region_covered", design.map.coverage.covered},
            {"copy_error_max_mm", design.verification.copy_error_max}};
  if (const auto& search = design.search) {  // as in design.json
    line["objective"] = std::string(name(search->objective));
    line["value"] = in_file_unit(search->objective, search->value);
    if (const auto& bound = design.quality.proven_bound)
      line["lower_bound"] = in_file_unit(search->objective, *bound);
    if (!search->complete) line["complete"] = false;
  }
  return line;
}

std::string csv_of(const std::vector<std::string>& lines) {
  static const char* const columns[] = {"name",  "status",  "vertex",           "assembly",     "VA_mm",
                                        "VB_mm", "size_mm", "transmission_deg", "clearance_mm", "message"};
  std::string csv;
  for (const char* column : columns) csv += (csv.empty() ? "" : ",") + std::string(column);
  csv += "\n";
  for (const std::string& line : lines) {
    const Json object = Json::parse(line);
    std::string row;
    for (const char* column : columns) {
      std::string cell;
      if (object.contains(column))
        cell =
            object[column].is_string() ? csv_cell(object[column].get<std::string>()) : object[column].dump();
      row += (column == columns[0] ? "" : ",") + cell;
    }
    csv += row + "\n";
  }
  return csv;
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
  if (status == "bad input" || status == "no design" || status == "stopped") return holds("message", text);
  if (status != "design" && status != "verification failed") return false;
  return holds("vertex", text) && holds("VA_mm", number) && holds("VB_mm", number) &&
         holds("size_mm", number);
}

/// What a time limit leaves of a search is no result of another limit, or of none.
std::string limit_in_key(const BatchArguments& arguments) {
  return std::isfinite(arguments.time_limit) ? fmt::format(" within {} s", arguments.time_limit) : "";
}

/// By what a task is known to later runs: its name, the seed, and its text or why there is none.
std::string key_of(const BatchTask& task, const BatchArguments& arguments) {
  const std::string text = task.text ? *task.text : "no text: " + task.text.error().message();
  return text_key(fmt::format("{}\n{}{}\n{}", task.name, arguments.seed, limit_in_key(arguments), text));
}

/// One run over the tasks, on all threads of this process.
class BatchRun {
 public:
  BatchRun(const Session& session, const BatchArguments& arguments, const std::vector<BatchTask>& tasks,
           Ranks& ranks, BatchJournal& journal)
      : session_(session), arguments_(arguments), tasks_(tasks), ranks_(ranks), journal_(journal) {
    for (const BatchTask& task : tasks) keys_.push_back(key_of(task, arguments));
    for (const std::string& key : keys_) finished_before_.push_back(journal.result(key) != nullptr);
  }

  /// An error sentence if the journal cannot be written.
  std::optional<std::string> work() {
    run_parallel(static_cast<std::size_t>(arguments_.jobs), arguments_.jobs,
                 [this](std::size_t) { take_tasks(); });
    return failure_;
  }

  bool interrupted() const { return interrupt_.requested(); }

  /// The result lines in the order of the tasks; nothing if one is missing.
  std::optional<std::vector<std::string>> lines() const {
    std::vector<std::string> all;
    for (const std::string& key : keys_) {
      const std::string* line = journal_.result(key);
      if (line == nullptr) return std::nullopt;
      all.push_back(*line);
    }
    return all;
  }

 private:
  void take_tasks() {
    for (;;) {
      const long next = ranks_.next();
      if (next >= static_cast<long>(tasks_.size()) || interrupt_.requested() || failed_) return;
      const auto i = static_cast<std::size_t>(next);
      if (finished_before_[i]) continue;
      const std::string line = batch_result(tasks_[i], options());
      if (interrupt_.requested()) return;  // what a signal cut short is done again
      if (const auto recorded = journal_.record(keys_[i], line); !recorded) {
        if (!failed_.exchange(true)) failure_ = recorded.error();
        return;
      }
      tell(i, line);
    }
  }

  SearchOptions options() const {
    SearchOptions options;
    options.seed = arguments_.seed;
    options.time_limit = arguments_.time_limit;
    options.stop = &interrupt_.requested();
    return options;
  }

  void tell(std::size_t i, const std::string& line) const {
    if (session_.quiet) return;
    const Json object = Json::parse(line);
    const std::string text = fmt::format("[{}/{}] {}: {}\n", i + 1, tasks_.size(), printable(tasks_[i].name),
                                         object["status"].get<std::string>());
    std::fwrite(text.data(), 1, text.size(), stderr);
  }

  const Session& session_;
  const BatchArguments& arguments_;
  const std::vector<BatchTask>& tasks_;
  Ranks& ranks_;
  BatchJournal& journal_;
  std::vector<std::string> keys_;
  std::vector<bool> finished_before_;
  Interrupt interrupt_;
  std::atomic<bool> failed_{false};
  std::optional<std::string> failure_;
};

/// The batch's own file, or the folder's specs.
std::vector<fs::path> inputs_of(const std::string& source, const std::vector<BatchTask>& tasks) {
  std::error_code error;
  if (!fs::is_directory(source, error)) return {source};
  std::vector<fs::path> files;
  for (const BatchTask& task : tasks) files.push_back(fs::path(source) / task.name);
  return files;
}

void tell_passed_over(const BatchJournal& journal) {
  const auto& lines = journal.passed_over();
  if (lines.empty()) return;
  say(fmt::format(
      "note: {} is no record of a finished spec{}; its spec is done again", lines.front(),
      lines.size() > 1 ? fmt::format(", nor are {} other lines of the journals", lines.size() - 1) : ""));
}

}  // namespace

tl::expected<std::vector<BatchTask>, InputError> batch_tasks(const std::string& source) {
  std::error_code error;
  if (fs::is_directory(source, error)) return folder_tasks(source);
  if (fs::is_regular_file(source, error)) return line_tasks(source);
  return tl::unexpected(InputError{source, 0, "--batch", "neither a folder nor a file",
                                   "a folder of *.toml, or a .jsonl file"});
}

namespace {

/// The fault without its line where that is a line of the text made from one of JSON, which nobody sees.
InputError as_told(InputError error, const BatchTask& task) {
  if (task.is_one_line && error.file == task.name) error.line = 0;
  return error;
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
  const auto spec =
      task.text.and_then([&](const std::string& text) { return read_spec(text, task.name, task.folder); });
  if (!spec) {
    line["status"] = "bad input";
    line["message"] = in_one_line(as_told(spec.error(), task));
    return line_of(line);
  }
  SearchOptions options = given;
  options.diagnose = false;  // of thousands of specs: `kempe synthesize` on one of them says why
  const SearchOutcome outcome = synthesize(*spec, options);
  const auto* found = std::get_if<FoundDesign>(&outcome);
  if (found == nullptr) {
    const auto* none = std::get_if<NoDesign>(&outcome);
    line["status"] = none != nullptr ? "no design" : "stopped";
    line["message"] =
        none != nullptr ? none->sentence : "stopped before a design was found or proven impossible";
    if (none != nullptr) line["proven"] = none->proven;
    return line_of(line);
  }
  MapOptions map;
  map.largest_sheets = false;  // not among the figures of a batch
  map.stop = given.stop;
  auto certified = certified_design(*spec, *found, map);
  if (!certified) {
    line["status"] = "no design";
    line["proven"] = false;
    line["message"] = certified.error();
    return line_of(line);
  }
  Design& design = *certified;
  design.verification = verify(verification_task(design));
  line["status"] = design.verification.certified ? "design" : "verification failed";
  line.update(figures(design));
  if (!design.verification.certified) line["message"] = design.verification.failure;
  if (const auto fault = parts_fault(design, spec->cutting)) line["parts"] = fault->sentence;
  return line_of(line);
}

int run_batch(const Session& session, const BatchArguments& arguments) {
  const auto tasks = batch_tasks(arguments.source);
  if (!tasks) return fail(session, tasks.error());
  if (const auto clash = output_clash(inputs_of(arguments.source, *tasks), arguments.folder,
                                      {"results.jsonl", "results.csv"}))
    return fail(session, *clash);
  auto ranks = Ranks::join();
  if (!ranks) return fail(session, failed, ranks.error());
  auto journal =
      BatchJournal::open(arguments.folder, fmt::format("{}", ranks->rank()), KEMPE_VERSION, is_batch_result);
  // Either all processes go on or none: one that left alone would keep the others waiting.
  if (ranks->anyone(!journal)) return journal ? cannot_write : fail(session, cannot_write, journal.error());
  if (ranks->anyone(journal->foreign_line().has_value()))
    return journal->foreign_line() ? fail(session, *journal->foreign_line()) : bad_input;
  if (ranks->rank() == 0) tell_passed_over(*journal);
  BatchRun run(session, arguments, *tasks, *ranks, *journal);
  ranks->wait_for_all();  // nobody writes before everybody has read what earlier runs finished
  const auto failure = run.work();
  const bool someone_failed = ranks->anyone(failure.has_value());
  if (failure) return fail(session, cannot_write, *failure);
  if (someone_failed) return cannot_write;
  if (run.interrupted()) return fail(session, interrupted, "stopped; the same command continues");
  if (ranks->rank() != 0) return done;
  journal->read_all();
  const auto lines = run.lines();
  if (!lines) return fail(session, failed, "another process stopped early; the same command continues");
  std::string text;
  for (const std::string& line : *lines) text += line + "\n";
  const auto written = write_whole(fs::path(arguments.folder), {OutputFile{"results.jsonl", text},
                                                                OutputFile{"results.csv", csv_of(*lines)}});
  if (!written) return fail(session, cannot_write, written.error());
  const auto designs = std::count_if(lines->begin(), lines->end(), [](const std::string& line) {
    return Json::parse(line)["status"] == "design";
  });
  const Json summary{{"specs", lines->size()}, {"designs", designs}, {"folder", arguments.folder}};
  print(session.json ? line_of(summary) + "\n"
                     : fmt::format("{} specs, {} designs: {}/results.jsonl, results.csv\n", lines->size(),
                                   designs, printable(arguments.folder)));
  return done;
}

}  // namespace kempe::app
