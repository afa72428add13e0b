#include "app/batch/batch.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/batch/index.hpp"
#include "app/batch/journal.hpp"
#include "app/batch/ranks.hpp"
#include "app/batch/result.hpp"
#include "app/batch/source.hpp"
#include "app/interrupt.hpp"
#include "app/output_check.hpp"
#include "app/words.hpp"
#include "kinematics/parallel.hpp"
#include "reports/data/atomic_file.hpp"
#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

const std::string lines_file = "results.jsonl", table_file = "results.csv";
const std::string stopped_sentence = "stopped; the same command continues";

/// What a time limit leaves of a search is no result of another limit, or of none.
std::string limit_in_key(const BatchArguments& arguments) {
  return std::isfinite(arguments.time_limit) ? fmt::format(" within {} s", arguments.time_limit) : "";
}

/// By what a task is known to later runs: its name, the seed, and its text or why there is none.
std::uint64_t key_of(const BatchTask& task, const BatchArguments& arguments) {
  const std::string text = task.text ? *task.text : "no text: " + task.text.error().message();
  return text_key(fmt::format("{}\n{}{}\n{}", task.name, arguments.seed, limit_in_key(arguments), text));
}

/// How many specs and designs were written.
struct Written {
  std::int64_t specs = 0, designs = 0;
};

/// One run over the tasks, on all threads of this process.
class BatchRun {
 public:
  BatchRun(const Session& session, const BatchArguments& arguments, BatchSource& source, Ranks& ranks,
           BatchJournal& journal, BatchIndex& index)
      : session_(session), arguments_(arguments), source_(source), ranks_(ranks), journal_(journal),
        index_(index) {}

  /// Looks up what earlier runs finished. An error sentence if that cannot be kept.
  std::optional<std::string> look_up() {
    for (std::int64_t i = 0; i < source_.size() && !interrupted(); ++i)
      index_.add(key_of(source_.task(i), arguments_));
    read_journals();
    return index_.failure();
  }

  /// An error sentence if the journal cannot be written.
  std::optional<std::string> work() {
    run_parallel(static_cast<std::size_t>(arguments_.jobs), arguments_.jobs,
                 [this](std::size_t) { take_tasks(); });
    const auto flushed = journal_.flush();
    if (!flushed && !failure_) failure_ = flushed.error();
    return failure_;
  }

  bool interrupted() const { return interrupt_.requested(); }

  /// Both files of results, in the order of the tasks. The error: the exit code and a sentence.
  tl::expected<Written, std::pair<ExitCode, std::string>> write_results() {
    read_journals();
    FolderDraft draft(arguments_.folder);
    Written written;
    auto begun = draft.begin(lines_file).and_then([&] { return draft.begin(table_file); }).and_then([&] {
      return draft.append(table_file, batch_csv_head());
    });
    for (; begun && written.specs < source_.size(); ++written.specs) {
      if (interrupted()) return tl::unexpected(std::pair(app::interrupted, stopped_sentence));
      const BatchTask task = source_.task(written.specs);
      const auto line = result_of(key_of(task, arguments_));
      if (!line)
        return tl::unexpected(std::pair(
            failed, index_.failure().value_or(printable(task.name) +
                                              " is not finished: another process stopped early, or the specs "
                                              "were changed meanwhile; the same command continues")));
      if (batch_status(*line) == "design") ++written.designs;
      begun = draft.append(lines_file, *line + "\n").and_then([&] {
        return draft.append(table_file, batch_csv_row(*line));
      });
    }
    const auto placed = begun.and_then([&] { return draft.put_in_place(); });
    if (!placed) return tl::unexpected(std::pair(cannot_write, placed.error()));
    return written;
  }

 private:
  /// A task, with the key under which its result is recorded.
  struct Taken {
    std::int64_t number;
    BatchTask task;
    std::uint64_t key;
  };

  void read_journals() {
    journal_.read_on([this](std::uint64_t key, const JournalPlace& place) { index_.set(key, place); });
  }

  std::optional<std::string> result_of(std::uint64_t key) {
    const auto place = index_.place(key);
    return place ? journal_.result_at(*place, key) : std::nullopt;
  }

  /// The next task that nobody has taken and no earlier run has finished. One thread at a time: so the source is read in
  /// rising order.
  std::optional<Taken> next() {
    const std::lock_guard lock(taking_);
    for (;;) {
      const std::int64_t number = ranks_.next(source_.size());
      if (number >= source_.size() || interrupt_.requested() || failed_) return std::nullopt;
      BatchTask task = source_.task(number);
      const std::uint64_t key = key_of(task, arguments_);
      if (!index_.place(key)) return Taken{number, std::move(task), key};
    }
  }

  void take_tasks() {
    while (const auto taken = next()) {
      const std::string line = batch_result(taken->task, options());
      if (interrupt_.requested()) return;  // what a signal cut short is done again
      if (const auto recorded = journal_.record(taken->key, line); !recorded) {
        if (!failed_.exchange(true)) failure_ = recorded.error();
        return;
      }
      tell(*taken, line);
    }
  }

  SearchOptions options() const {
    SearchOptions options;
    options.seed = arguments_.seed;
    options.time_limit = arguments_.time_limit;
    options.stop = &interrupt_.requested();
    return options;
  }

  void tell(const Taken& taken, const std::string& line) const {
    if (session_.quiet) return;
    const std::string text = fmt::format("[{}/{}] {}: {}\n", taken.number + 1, source_.size(),
                                         printable(taken.task.name), batch_status(line));
    std::fwrite(text.data(), 1, text.size(), stderr);
  }

  const Session& session_;
  const BatchArguments& arguments_;
  BatchSource& source_;
  Ranks& ranks_;
  BatchJournal& journal_;
  BatchIndex& index_;
  std::mutex taking_;
  Interrupt interrupt_;
  std::atomic<bool> failed_{false};
  std::optional<std::string> failure_;
};

void tell_passed_over(const BatchJournal& journal) {
  if (journal.passed_over() == 0) return;
  const int others = journal.passed_over() - 1;
  say(fmt::format("note: {} is no record of a finished spec{}; its spec is done again",
                  journal.first_passed_over(),
                  others > 0 ? fmt::format(", nor are {} other lines of the journals", others) : ""));
}

}  // namespace

int run_batch(const Session& session, const BatchArguments& arguments) {
  const auto source = BatchSource::open(arguments.source);
  if (!source) return fail(session, source.error());
  if (const auto clash = output_clash((*source)->inputs(), arguments.folder, {lines_file, table_file}))
    return fail(session, *clash);
  auto ranks = Ranks::join();
  if (!ranks) return fail(session, failed, ranks.error());
  auto journal =
      BatchJournal::open(arguments.folder, fmt::format("{}", ranks->rank()), KEMPE_VERSION, is_batch_result);
  // Either all processes go on or none: one that left alone would keep the others waiting.
  if (ranks->anyone(!journal)) return journal ? cannot_write : fail(session, cannot_write, journal.error());
  auto index = BatchIndex::make(arguments.folder, (*source)->size());
  if (ranks->anyone(!index)) return index ? cannot_write : fail(session, cannot_write, index.error());
  BatchRun run(session, arguments, **source, *ranks, *journal, *index);
  const auto lost = run.look_up();
  if (ranks->anyone(lost.has_value())) return lost ? fail(session, cannot_write, *lost) : cannot_write;
  // Nobody writes before everybody has read what earlier runs finished.
  if (ranks->anyone(journal->foreign_line().has_value()))
    return journal->foreign_line() ? fail(session, *journal->foreign_line()) : bad_input;
  if (ranks->rank() == 0) tell_passed_over(*journal);
  const auto failure = run.work();
  const bool someone_failed = ranks->anyone(failure.has_value());
  if (failure) return fail(session, cannot_write, *failure);
  if (someone_failed) return cannot_write;
  if (run.interrupted()) return fail(session, interrupted, stopped_sentence);
  if (ranks->rank() != 0) return done;
  const auto written = run.write_results();
  if (!written) return fail(session, written.error().first, written.error().second);
  const nlohmann::ordered_json summary{
      {"specs", written->specs}, {"designs", written->designs}, {"folder", arguments.folder}};
  print(session.json
            ? summary.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n"
            : fmt::format("{}, {}: {}/{}, {}\n", counted(static_cast<std::size_t>(written->specs), "spec"),
                          counted(static_cast<std::size_t>(written->designs), "design"),
                          printable(arguments.folder), lines_file, table_file));
  return done;
}

}  // namespace kempe::app
