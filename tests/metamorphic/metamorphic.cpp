// Random tasks, each changed in ways whose effect on the answer is known, and mechanisms against what is proven.
// usage: kempe_metamorphic COUNT [FIRST] [THREADS] [FOLDER] [SECONDS]
// Task number n is the same in every run. With SECONDS no search works longer (answers that were stopped are no measure for others). What is found goes to stderr, and into FOLDER as specs. Exit code 1 if a proof
// was false or a design did not hold, or if there is no FOLDER and a design was not as good as it had to be.

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <thread>

#include "tests/metamorphic/laws.hpp"

namespace kempe::metamorphic {
namespace {

struct Arguments {
  unsigned long count = 100, first = 0, threads = 1;
  std::string folder;
  AnswerOptions answer;
};

struct Total {
  std::mutex mutex;
  Counts counts;
  int false_proofs = 0, not_as_good = 0;
};

/// "task-17-1.toml" and so on; the mechanism at the end of the first.
void write_files(const std::string& folder, unsigned long number, std::size_t of, const Finding& finding) {
  for (std::size_t i = 0; i < finding.tasks.size(); ++i) {
    std::ofstream file(fmt::format("{}/task-{}-{}-{}.toml", folder, number, of, i + 1));
    file << "# " << finding.law << ": " << finding.sentence << "\n"
         << (finding.mechanism && i == 0 ? toml_of(finding.tasks[i], *finding.mechanism)
                                         : toml_of(finding.tasks[i]));
  }
}

void tell(const Arguments& arguments, unsigned long number, const std::vector<Finding>& findings) {
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Finding& finding = findings[i];
    std::fprintf(stderr, "task %lu, %s: %s%s\n", number, finding.law.c_str(),
                 finding.is_false_proof ? "FALSE: " : "", finding.sentence.c_str());
    if (!arguments.folder.empty()) write_files(arguments.folder, number, i, finding);
  }
}

void count_answer(const Answer& answer, bool searched, Counts& counts) {
  const std::string of = searched ? "searched: " : "bounded: ";
  if (answer.design)
    ++counts[of + "designs"];
  else if (answer.proven_none)
    ++counts[of + "no design, proven"];
  else
    ++counts[of + (searched && answer.complete ? "no design found" : "nothing known")];
  if (searched && !answer.complete) ++counts[of + "stopped"];
}

/// A change that fits the task, and every third time two; always relisted corners if an obstacle has many.
std::vector<std::pair<Change, ChangedTask>> draw_changes(const Task& task, Dice& dice) {
  std::vector<std::pair<Change, ChangedTask>> drawn;
  const auto has_corners = [](const TaskObstacle& obstacle) { return obstacle.rings[0].size() > 4; };
  if (std::any_of(task.obstacles.begin(), task.obstacles.end(), has_corners))
    drawn.emplace_back(changes()[0], *changes()[0].apply(task, dice));
  const std::size_t wanted = drawn.size() + (dice.percent(33) ? 2 : 1);
  for (int i = 0; i < 20 && drawn.size() < wanted; ++i) {
    const Change& change =
        changes()[static_cast<std::size_t>(dice.below(static_cast<int>(changes().size())))];
    if (auto changed = change.apply(task, dice)) drawn.emplace_back(change, std::move(*changed));
  }
  return drawn;
}

/// One task with all that is asked of it.
class Trial {
 public:
  Trial(const Arguments& arguments, unsigned long number) : options_(arguments.answer), dice_(number) {}

  void run() {
    options_.search = dice_.percent(3);
    ++counts_[options_.search ? "tasks searched" : "tasks bounded"];
    Task task = draw_task(dice_);
    Answer answer = answered(task);
    if (answer.design && dice_.percent(65)) put_an_obstacle_in_the_way(task, answer);
    add(check_mechanisms(task, answer, dice_, counts_));
    for (const auto& [change, changed] : draw_changes(task, dice_))
      compare(task, answer, change.name, changed, answered(changed.task));
  }

  const Counts& counts() const { return counts_; }
  const std::vector<Finding>& findings() const { return findings_; }

 private:
  Answer answered(const Task& task) {
    Answer answer = answer_of(task, options_);
    count_answer(answer, options_.search, counts_);
    add(check_alone(task, answer));
    return answer;
  }

  void put_an_obstacle_in_the_way(Task& task, Answer& answer) {
    auto changed = with_obstacle_in_the_way(task, answer.design->linkage, dice_);
    if (!changed) return;
    Answer other = answered(*changed);
    // Where the design keeps clear of it, the design is one of the new task too.
    const FoundDesign& design = *answer.design;
    const bool is_clear = limit_missed(other.spec, design.linkage, design.layers, 1e-9).empty();
    compare(task, answer, is_clear ? "obstacle beside the design" : "obstacle in the way",
            {*changed, is_clear ? Relation::equal : Relation::tighter}, other);
    task = std::move(*changed);
    answer = std::move(other);
  }

  void compare(const Task& task, const Answer& answer, const std::string& law, const ChangedTask& changed,
               const Answer& other) {
    ++counts_["law: " + law];
    add(check_pair(task, answer, law, changed, other));
  }

  void add(std::vector<Finding> more) { findings_.insert(findings_.end(), more.begin(), more.end()); }

  AnswerOptions options_;
  Dice dice_;
  Counts counts_;
  std::vector<Finding> findings_;
};

void try_task(const Arguments& arguments, unsigned long number, Total& total) {
  Trial trial(arguments, number);
  trial.run();
  const std::lock_guard lock(total.mutex);
  tell(arguments, number, trial.findings());
  for (const Finding& finding : trial.findings())
    ++(finding.is_false_proof ? total.false_proofs : total.not_as_good);
  for (const auto& [name, count] : trial.counts()) total.counts[name] += count;
}

void run(const Arguments& arguments, Total& total) {
  std::atomic<unsigned long> next{arguments.first};
  const auto work = [&] {
    for (unsigned long n = next++; n < arguments.first + arguments.count; n = next++)
      try_task(arguments, n, total);
  };
  std::vector<std::thread> workers;
  for (unsigned long i = 0; i < arguments.threads; ++i) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
}

}  // namespace
}  // namespace kempe::metamorphic

int main(int argc, char** argv) {
  using namespace kempe::metamorphic;
  Arguments arguments;
  const auto number = [&](int index, unsigned long otherwise) {
    return argc > index ? std::strtoul(argv[index], nullptr, 10) : otherwise;
  };
  arguments.count = number(1, arguments.count);
  arguments.first = number(2, arguments.first);
  arguments.threads = number(3, arguments.threads);
  if (argc > 4) arguments.folder = argv[4];
  if (argc > 5) arguments.answer.seconds = std::strtod(argv[5], nullptr);
  const auto began = std::chrono::steady_clock::now();
  Total total;
  run(arguments, total);
  const std::chrono::duration<double> lasted = std::chrono::steady_clock::now() - began;
  for (const auto& [name, count] : total.counts) std::printf("%8ld %s\n", count, name.c_str());
  std::printf(
      "%8d false proofs or designs that do not hold\n%8d designs not as good as they had to be\n%8.0f s\n",
      total.false_proofs, total.not_as_good, lasted.count());
  return total.false_proofs > 0 || (arguments.folder.empty() && total.not_as_good > 0) ? 1 : 0;
}
