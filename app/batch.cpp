#include "app/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "app/batch_journal.hpp"
#include "app/interrupt.hpp"
#include "app/ranks.hpp"
#include "reports/atomic_file.hpp"
#include "specs/spec_reader.hpp"
#include "specs/text_file.hpp"
#include "synthesis/assemble.hpp"
#include "synthesis/search.hpp"
#include "synthesis/verification.hpp"

namespace kempe::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// JSON on one line; bytes that are no UTF-8, as a file's name may have, become U+FFFD.
std::string line_of(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// A file that cannot be read is that spec's failure, not the batch's: it becomes a text the reader refuses.
std::string spec_text(const fs::path& path) {
  auto text = read_text_file(path);
  return text ? std::move(*text) : "# " + text.error().message() + "\n";
}

std::vector<BatchTask> folder_tasks(const fs::path& folder) {
  std::vector<BatchTask> tasks;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml")
      tasks.push_back({entry.path().filename().string(), spec_text(entry.path()), folder.string()});
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
    const auto text = toml_from_json(line);
    // A line that is no spec is that spec's failure, not the batch's: it becomes a text the reader refuses.
    tasks.push_back({fmt::format("line-{}", number), text ? *text : "# " + text.error() + "\n",
                     fs::path(file).parent_path().string()});
  }
  return tasks;
}

tl::expected<void, std::string> append_toml(std::string& text, const Json& value) {
  if (value.is_boolean() || value.is_number()) {
    text += value.dump();
  } else if (value.is_string()) {
    text += value.dump(-1, ' ', true);  // JSON's escapes are TOML's
  } else if (value.is_array()) {
    text += "[";
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i > 0) text += ", ";
      if (auto done = append_toml(text, value[i]); !done) return done;
    }
    text += "]";
  } else if (value.is_object()) {
    text += "{";
    bool first = true;
    for (const auto& [key, entry] : value.items()) {
      text += first ? "" : ", ";
      first = false;
      text += Json(key).dump(-1, ' ', true) + " = ";
      if (auto done = append_toml(text, entry); !done) return done;
    }
    text += "}";
  } else {
    return tl::unexpected(std::string("null, which a spec cannot hold"));
  }
  return {};
}

Json figures(const Design& design) {
  const CopyingLinkage& l = design.linkage;
  Json line{{"vertex", std::string(name(l.vertex()))},
            {"assembly", l.assembly()},
            {"VA_mm", l.VA()},
            {"VB_mm", l.VB()},
            {"pole_mm", {l.pole().x(), l.pole().y()}},
            {"layers", design.layers.of},
            {"size_mm", design.quality.size},
            {"transmission_deg", degrees(design.quality.transmission_min)},
            {"clearance_mm", design.quality.clearance_min},
            {"region_covered", design.map.coverage.covered},
            {"copy_error_max_mm", design.verification.copy_error_max}};
  if (design.search)
    line["objective"] = std::string(name(design.search->objective)), line["value"] = design.search->value;
  if (design.quality.lower_bound) line["lower_bound"] = *design.quality.lower_bound;
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
        cell = object[column].is_string() ? object[column].get<std::string>() : object[column].dump();
      if (cell.find_first_of(",\"\n\r") != std::string::npos) {
        std::string quoted = "\"";
        for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
        cell = quoted + "\"";
      }
      row += (column == columns[0] ? "" : ",") + cell;
    }
    csv += row + "\n";
  }
  return csv;
}

/// One run over the tasks, on all threads of this process.
class BatchRun {
 public:
  BatchRun(const Session& session, const BatchArguments& arguments, const std::vector<BatchTask>& tasks,
           Ranks& ranks, BatchJournal& journal)
      : session_(session), arguments_(arguments), tasks_(tasks), ranks_(ranks), journal_(journal) {
    for (const BatchTask& task : tasks)
      keys_.push_back(text_key(fmt::format("{}\n{}\n{}", task.name, arguments.seed, task.text)));
    for (const std::string& key : keys_) finished_before_.push_back(journal.result(key) != nullptr);
  }

  /// An error sentence if the journal cannot be written.
  std::optional<std::string> work() {
    std::vector<std::thread> threads;
    for (int i = 0; i < arguments_.jobs; ++i) threads.emplace_back([this] { take_tasks(); });
    for (std::thread& thread : threads) thread.join();
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
      const std::string line = batch_result(tasks_[i], arguments_.seed);
      if (const auto recorded = journal_.record(keys_[i], line); !recorded) {
        if (!failed_.exchange(true)) failure_ = recorded.error();
        return;
      }
      tell(i, line);
    }
  }

  void tell(std::size_t i, const std::string& line) const {
    if (session_.quiet) return;
    const Json object = Json::parse(line);
    const std::string text = fmt::format("[{}/{}] {}: {}\n", i + 1, tasks_.size(), tasks_[i].name,
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

}  // namespace

tl::expected<std::string, std::string> toml_from_json(const std::string& json) {
  const Json object = Json::parse(json, nullptr, false);
  if (!object.is_object()) return tl::unexpected(std::string("the line is no JSON object"));
  std::string text;
  for (const auto& [key, value] : object.items()) {
    text += Json(key).dump(-1, ' ', true) + " = ";
    if (const auto done = append_toml(text, value); !done) return tl::unexpected(key + ": " + done.error());
    text += "\n";
  }
  return text;
}

tl::expected<std::vector<BatchTask>, InputError> batch_tasks(const std::string& source) {
  std::error_code error;
  if (fs::is_directory(source, error)) return folder_tasks(source);
  if (fs::is_regular_file(source, error)) return line_tasks(source);
  return tl::unexpected(InputError{source, 0, "--batch", "neither a folder nor a file",
                                   "a folder of *.toml, or a .jsonl file"});
}

std::string batch_result(const BatchTask& task, std::uint64_t seed) {
  Json line{{"name", task.name}};
  const auto spec = read_spec(task.text, task.name, task.folder);
  if (!spec) {
    line["status"] = "bad input";
    line["message"] = spec.error().message();
    return line_of(line);
  }
  SearchOptions options;
  options.seed = seed;
  options.diagnose = false;  // of thousands of specs: `kempe synthesize` on one of them says why
  const SearchOutcome outcome = synthesize(*spec, options);
  const auto* found = std::get_if<FoundDesign>(&outcome);
  if (found == nullptr) {
    const auto* none = std::get_if<NoDesign>(&outcome);
    line["status"] = "no design";
    line["message"] = none != nullptr ? none->sentence : "stopped";
    line["proven"] = none != nullptr && none->proven;
    return line_of(line);
  }
  MapOptions map;
  map.largest_sheets = false;  // not among the figures of a batch
  Design design = assemble_design(*spec, *found, map);
  design.verification = verify(verification_task(design));
  if (!design.map.coverage.covered) {
    line["status"] = "no design";
    line["proven"] = false;
    line["message"] = design.map.coverage.why_not;
    return line_of(line);
  }
  line["status"] = design.verification.certified ? "design" : "verification failed";
  line.update(figures(design));
  if (!design.verification.certified) line["message"] = design.verification.failure;
  return line_of(line);
}

int run_batch(const Session& session, const BatchArguments& arguments) {
  const auto tasks = batch_tasks(arguments.source);
  if (!tasks) return fail(tasks.error());
  auto ranks = Ranks::join();
  if (!ranks) return fail(failed, ranks.error());
  auto journal = BatchJournal::open(arguments.folder, fmt::format("{}", ranks->rank()));
  // Either all processes go on or none: one that left alone would keep the others waiting.
  if (ranks->anyone(!journal)) return journal ? cannot_write : fail(cannot_write, journal.error());
  BatchRun run(session, arguments, *tasks, *ranks, *journal);
  ranks->wait_for_all();  // nobody writes before everybody has read what earlier runs finished
  const auto failure = run.work();
  const bool someone_failed = ranks->anyone(failure.has_value());
  if (failure) return fail(cannot_write, *failure);
  if (someone_failed) return cannot_write;
  if (run.interrupted()) return fail(interrupted, "stopped; the same command goes on from here");
  if (ranks->rank() != 0) return done;
  journal->read_all();
  const auto lines = run.lines();
  if (!lines) return fail(failed, "another process stopped early; the same command goes on from here");
  std::string text;
  for (const std::string& line : *lines) text += line + "\n";
  const auto written = write_whole(fs::path(arguments.folder), {OutputFile{"results.jsonl", text},
                                                                OutputFile{"results.csv", csv_of(*lines)}});
  if (!written) return fail(cannot_write, written.error());
  const auto designs = std::count_if(lines->begin(), lines->end(), [](const std::string& line) {
    return Json::parse(line)["status"] == "design";
  });
  const Json summary{{"specs", lines->size()}, {"designs", designs}, {"folder", arguments.folder}};
  print(session.json ? line_of(summary) + "\n"
                     : fmt::format("{} specs, {} designs: {}/results.jsonl, results.csv\n", lines->size(),
                                   designs, arguments.folder));
  return done;
}

}  // namespace kempe::app
